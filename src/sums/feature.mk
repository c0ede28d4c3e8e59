NEEDS_sums :=
