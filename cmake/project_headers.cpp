// Holds nothing: the headers that every room precompiles once are made for it.
