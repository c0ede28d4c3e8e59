NEEDS_errors :=
