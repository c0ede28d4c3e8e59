NEEDS_engine := 
