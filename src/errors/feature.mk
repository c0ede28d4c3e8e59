NEEDS_errors :=
PARAMETERS_errors := errors
