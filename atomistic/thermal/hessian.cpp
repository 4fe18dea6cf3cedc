#include "atomistic/thermal/hessian.hpp"

#include <algorithm>
#include <random>

namespace atomistic {

using Eigen::VectorXd;
using Matrix = Eigen::SparseMatrix<double>;

namespace {

/// Finds what lies within some bonds of an atom.
class Walker {
 public:
  explicit Walker(const Sheet& sheet) : sheet_(sheet), seen_(static_cast<std::size_t>(sheet.atoms()), 0) {}

  /// Free atoms, in order.
  std::vector<int> within(int atom, int reach_bonds) {
    ++walk_;
    std::vector<int> found;
    take(atom, found);
    std::size_t begin = 0;
    for (int bonds = 0; bonds < reach_bonds; ++bonds) {
      const std::size_t end = found.size();
      for (std::size_t k = begin; k < end; ++k)
        for (const int next : sheet_.neighbours[static_cast<std::size_t>(found[k])]) take(next, found);
      begin = end;
    }
    std::erase_if(found, [&](int other) { return other >= sheet_.free_atoms; });
    std::sort(found.begin(), found.end());
    return found;
  }

 private:
  void take(int atom, std::vector<int>& found) {
    if (atom < 0 || seen_[static_cast<std::size_t>(atom)] == walk_) return;
    seen_[static_cast<std::size_t>(atom)] = walk_;
    found.push_back(atom);
  }

  const Sheet& sheet_;
  std::vector<int> seen_;  // by the number of the walk that saw an atom last
  int walk_ = 0;
};

/// The pattern's matrix, its values zero.
Matrix empty_matrix(const Coupling& coupling) {
  const int n = 3 * coupling.atoms();
  Eigen::Index entries = 0;
  for (int j = 0; j < coupling.atoms(); ++j) entries += 9 * static_cast<Eigen::Index>(coupling.coupled(j).size());
  Matrix matrix(n, n);
  matrix.resizeNonZeros(entries);
  int* outer = matrix.outerIndexPtr();
  int* inner = matrix.innerIndexPtr();
  int* at = inner;
  for (int j = 0; j < coupling.atoms(); ++j)
    for (int c = 0; c < 3; ++c) {
      *outer++ = static_cast<int>(at - inner);
      for (const int i : coupling.coupled(j))
        for (int r = 0; r < 3; ++r) *at++ = 3 * i + r;
    }
  *outer = static_cast<int>(entries);
  std::fill_n(matrix.valuePtr(), entries, 0.0);
  return matrix;
}

/// Columns of all atoms of a colour along an axis, out of the difference of gradients that moving them made.
void fill(Matrix& matrix, const Coupling& coupling, int colour, int axis, const VectorXd& slope) {
  for (int j = 0; j < coupling.atoms(); ++j) {
    if (coupling.colour(j) != colour) continue;
    double* value = matrix.valuePtr() + matrix.outerIndexPtr()[3 * j + axis];
    for (const int i : coupling.coupled(j))
      for (int r = 0; r < 3; ++r) *value++ = slope[3 * i + r];
  }
}

}  // namespace

Coupling::Coupling(const Sheet& sheet, int reach_bonds) : reach_bonds_(reach_bonds) {
  Walker walker(sheet);
  colour_.assign(static_cast<std::size_t>(sheet.free_atoms), -1);
  std::vector<int> taken;  // of each colour: the last atom that could not have it
  for (int atom = 0; atom < sheet.free_atoms; ++atom) {
    coupled_.push_back(walker.within(atom, reach_bonds));
    for (const int other : walker.within(atom, 2 * reach_bonds))
      if (const int colour = colour_[static_cast<std::size_t>(other)]; colour >= 0)
        taken[static_cast<std::size_t>(colour)] = atom;
    const auto free = std::find_if(taken.begin(), taken.end(), [&](int by) { return by != atom; });
    colour_[static_cast<std::size_t>(atom)] = static_cast<int>(free - taken.begin());
    if (free == taken.end()) taken.push_back(-1);
  }
  colours_ = static_cast<int>(taken.size());
}

Hessian hessian(const Gradient& gradient, const Coupling& coupling, const VectorXd& positions, double difference_A) {
  Matrix columns = empty_matrix(coupling);
  for (int colour = 0; colour < coupling.colours(); ++colour)
    for (int axis = 0; axis < 3; ++axis) {
      VectorXd step = VectorXd::Zero(positions.size());
      for (int j = 0; j < coupling.atoms(); ++j)
        if (coupling.colour(j) == colour) step[3 * j + axis] = difference_A;
      const VectorXd ahead = gradient(positions + step), behind = gradient(positions - step);
      fill(columns, coupling, colour, axis, (ahead - behind) / (2 * difference_A));
    }
  const Matrix transposed = columns.transpose();
  Hessian made;
  made.asymmetry_relative = (columns - transposed).norm() / columns.norm();
  made.matrix = (columns + transposed) / 2;
  return made;
}

double missed_by(const Hessian& hessian, const Gradient& gradient, const VectorXd& positions, double difference_A) {
  std::mt19937 random(1);
  std::normal_distribution<double> normal;
  VectorXd v(positions.size());
  for (double& component : v) component = normal(random);
  const VectorXd slope =
      (gradient(positions + difference_A * v) - gradient(positions - difference_A * v)) / (2 * difference_A);
  const VectorXd product = hessian.matrix * v;
  return (product - slope).norm() / product.norm();
}

}  // namespace atomistic
