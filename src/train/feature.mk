NEEDS_train :=
