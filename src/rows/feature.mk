NEEDS_rows := tables parallel
