# What this feature needs besides the shell and the train.
NEEDS_parallel :=
