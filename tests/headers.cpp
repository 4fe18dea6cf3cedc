// Holds nothing: the headers that every test binary precompiles once are made for it.
