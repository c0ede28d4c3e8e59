NEEDS_sweeps := 
