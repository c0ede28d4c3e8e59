# What the lines of the lesson use.
NEEDS_lesson := rows chance sweeps pictures
