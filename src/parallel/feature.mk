NEEDS_parallel :=
PARAMETERS_parallel := threads
