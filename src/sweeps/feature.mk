# What this feature needs besides the shell and the train.
NEEDS_sweeps := parallel
