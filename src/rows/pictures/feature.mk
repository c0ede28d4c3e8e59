NEEDS_rows_pictures := rows pictures
