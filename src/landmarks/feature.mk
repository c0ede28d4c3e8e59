# Names of heights need the shell alone.
NEEDS_landmarks :=
