// The threads of CHOLMOD and of the BLAS that it calls, in both programs: one, and the BLAS's name.
#pragma once

#include <string>

namespace atomistic {

/// OpenBLAS starts a thread per core unless told before its first call, and CHOLMOD opens four OpenMP threads for every
/// supernode, whatever OMP_NUM_THREADS says. On cores that other work shares both cost more than they bring. Holds for
/// the calling thread. Throws std::bad_alloc where there is no room for the BLAS's buffer.
void use_one_math_thread();

/// The library file that the process has really loaded; empty if none is found.
std::string loaded_blas();

}  // namespace atomistic
