NEEDS_save :=
