NEEDS_pictures := rows chance sweeps
