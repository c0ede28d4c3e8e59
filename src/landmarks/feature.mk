NEEDS_landmarks :=
