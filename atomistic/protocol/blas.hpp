// The BLAS that CHOLMOD calls, in both programs: kept to one thread, and named.
#pragma once

#include <string>

namespace atomistic {

/// OpenBLAS starts a thread per core unless told before its first call; does nothing with another BLAS.
void use_one_blas_thread();

/// The library file that the process has really loaded; empty if none is found.
std::string loaded_blas();

}  // namespace atomistic
