#include "membrane/laws/cauchy.hpp"

#include <cmath>

namespace membrane {

Voigt cauchy_force(const Voigt& S, const Voigt& strain, double thickness_stretch) {
  if (S.isZero(0)) return Voigt::Zero();
  const Eigen::Matrix2d C{{1 + 2 * strain[0], strain[2]}, {strain[2], 1 + 2 * strain[1]}};
  const double J = std::sqrt(C(0, 0) * C(1, 1) - C(0, 1) * C(1, 0));
  const Eigen::Matrix2d U = (C + J * Eigen::Matrix2d::Identity()) / std::sqrt(C.trace() + 2 * J);
  const Eigen::Matrix2d force{{S[0], S[2]}, {S[2], S[1]}};
  const Eigen::Matrix2d pushed = U * force * U / (J * thickness_stretch);
  return {pushed(0, 0), pushed(1, 1), pushed(0, 1)};
}

}  // namespace membrane
