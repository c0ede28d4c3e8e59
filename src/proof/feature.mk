NEEDS_proof :=
