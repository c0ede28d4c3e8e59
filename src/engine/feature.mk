NEEDS_engine := rows
PARAMETERS_engine := method feet bounce error_floor
