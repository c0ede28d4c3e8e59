NEEDS_explain :=
