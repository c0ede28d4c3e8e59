NEEDS_engine := rows
# A parameter of chance, which needs the feet of the engine.
NAMES_engine := error_floor
