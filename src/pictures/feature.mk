NEEDS_pictures :=
