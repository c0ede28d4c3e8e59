NEEDS_log :=
