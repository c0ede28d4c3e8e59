NEEDS_chance_pictures := chance pictures
