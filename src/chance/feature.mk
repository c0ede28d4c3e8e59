NEEDS_chance := rows
PARAMETERS_chance := seed placement error_place error_thickness error_mass error_lean error_radius error_friction error_slope error_floor error_push
