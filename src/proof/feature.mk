NEEDS_proof := 
