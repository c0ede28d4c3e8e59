NEEDS_sweeps_pictures := sweeps pictures
