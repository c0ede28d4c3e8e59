NEEDS_explain := 
