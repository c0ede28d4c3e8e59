NEEDS_rows := tables parallel
FAST_rows  := windows.c floor.c
