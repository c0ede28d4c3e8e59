NEEDS_train := 
