NEEDS_tables :=
