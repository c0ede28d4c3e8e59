NEEDS_engine := rows
