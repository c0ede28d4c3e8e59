NEEDS_planning := chance pictures
