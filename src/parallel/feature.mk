NEEDS_parallel :=
