# What this feature needs besides the shell and the train.
NEEDS_rows := tables parallel
