# What this feature needs besides the shell and the train.
NEEDS_proof :=
# Its model computes in double only.
IN_DOUBLE += proof
