#include "atomistic/protocol/preconditioning.hpp"

namespace atomistic {

bool has_multigrid() {
#ifdef VALIDATE_HYPRE
  return true;
#else
  return false;
#endif
}

Preconditioning preconditioning_for(Preconditioning asked, int free_atoms) {
  if (asked != Preconditioning::automatic) return asked;
  return has_multigrid() && free_atoms >= multigrid_from_atoms ? Preconditioning::multigrid : Preconditioning::factor;
}

}  // namespace atomistic
