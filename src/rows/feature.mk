NEEDS_rows := 
