#include "membrane/laws/prestress.hpp"

#include <Eigen/LU>
#include <limits>

namespace membrane {
namespace {

constexpr int most_iterations = 50;
constexpr double last = 1e-8;  // of the prestress: Newton's next step leaves the square of it: rounding
constexpr double noise = 1e-15;

}  // namespace

OffsetSearch::OffsetSearch(const Voigt& prestress_eV_per_A2, double sheet_modulus_eV_per_A2)
    : prestress_(prestress_eV_per_A2),
      tolerance_(last * prestress_eV_per_A2.norm() + noise * sheet_modulus_eV_per_A2) {}

void OffsetSearch::improve(const Response& at_strain) {
  const Voigt missing = prestress_ - at_strain.force_eV_per_A2;
  ended_ = missing.norm() <= tolerance_;
  strain_ += at_strain.tangent_eV_per_A2.inverse() * missing;
  if (ended_ || ++iterations_ < most_iterations) return;
  strain_.setConstant(std::numeric_limits<double>::quiet_NaN());
  ended_ = true;
}

}  // namespace membrane
