NEEDS_rows := tables parallel
PARAMETERS_rows := row floor
