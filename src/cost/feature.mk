NEEDS_cost :=
