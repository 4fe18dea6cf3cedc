#include "atomistic/protocol/data_file.hpp"

#include <fmt/format.h>

namespace atomistic {

std::string data_file(const Potential& potential, const Eigen::VectorXd& positions) {
  const Eigen::Map<const Eigen::Matrix3Xd> x(positions.data(), 3, positions.size() / 3);
  const Eigen::Vector3d low = x.rowwise().minCoeff().array() - 5, high = x.rowwise().maxCoeff().array() + 5;
  std::string text = fmt::format("graphene for {} (Å)\n\n{} atoms\n1 atom types\n\n", potential.name, x.cols());
  for (int c = 0; c < 3; ++c) text += fmt::format("{:.17g} {:.17g} {}lo {}hi\n", low[c], high[c], "xyz"[c], "xyz"[c]);
  text += fmt::format("\nMasses\n\n1 {}\n\nAtoms # atomic\n\n", potential.mass);
  for (Eigen::Index i = 0; i < x.cols(); ++i)
    text += fmt::format("{} 1 {:.17g} {:.17g} {:.17g}\n", i + 1, x(0, i), x(1, i), x(2, i));
  return text;
}

}  // namespace atomistic
