#include "membrane/laws/list.hpp"

namespace membrane {

bool is_isotropic(const Law& law) {
  return std::visit([]<class L>(const L&) { return IsotropicLaw<L>; }, law);
}

double sheet_modulus(const Law& law) {
  return std::visit([](const auto& any) { return any.sheet_modulus_eV_per_A2; }, law);
}

}  // namespace membrane
