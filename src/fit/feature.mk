NEEDS_fit := rows sweeps tables
