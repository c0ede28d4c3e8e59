NEEDS_sweeps := parallel
