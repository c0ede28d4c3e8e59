NEEDS_fit := sweeps tables
