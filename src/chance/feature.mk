NEEDS_chance := rows
FAST_chance := verdict.c
