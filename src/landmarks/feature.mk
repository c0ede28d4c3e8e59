NEEDS_landmarks :=
# The names of heights, which are entries of a table: name, another name or NULL, height.
NAMES_landmarks = $(shell sed -n 's/^    {"\([a-z0-9_]*\)", [^,]*, "[0-9].*/\1/p' src/landmarks/*.c)
