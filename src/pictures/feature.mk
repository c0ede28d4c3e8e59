# Half of the pictures are of rows.
NEEDS_pictures := rows
