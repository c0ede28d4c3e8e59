NEEDS_chance := rows
