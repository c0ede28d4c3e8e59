NEEDS_chance := rows
# error_place and others, whose names a macro makes.
NAMES_chance = $(shell sed -n 's/.*{SIZED.\([a-z]*\),.*/error_\1/p' src/chance/*.c)
