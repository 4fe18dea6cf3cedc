#include "atomistic/cell/clamp_margins.hpp"

#include <Eigen/Dense>
#include <Eigen/Sparse>
#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <memory>
#include <numbers>
#include <stdexcept>
#include <vector>

#include "atomistic/cell/homogeneous_cell.hpp"
#include "atomistic/lammps/lammps.hpp"

namespace atomistic {
namespace {

using Eigen::MatrixXd;
using Eigen::Vector2d;
using Eigen::VectorXd;
using std::numbers::pi;

/// Cell and sublattice. The origin is the middle of a hexagon.
using Place = std::array<int, 3>;

struct Honeycomb {
  double a;
  Vector2d position(const Place& p) const {
    return {a * (p[0] + 0.5 * p[1]), a / std::numbers::sqrt3 * (1.5 * p[1] + 1 + p[2])};
  }
  /// Cells between an atom of one sublattice and one of another.
  Place difference(const Vector2d& away, int from, int to) const {
    const double rows = (away.y() * std::numbers::sqrt3 / a - (to - from)) / 1.5;
    return {static_cast<int>(std::lround(away.x() / a - rows / 2)), static_cast<int>(std::lround(rows)), to};
  }
};

struct Neighbour {
  Place away;
  Eigen::Matrix3d stiffness;  // −∂(its force)/∂(the atom's position)
};
using ForceConstants = std::array<std::vector<Neighbour>, 2>;  // about an atom of each sublattice

ForceConstants force_constants(const Potential& potential, double a, const std::string& log_file) {
  constexpr double small = 1e-3;
  const double range = potential.interaction_range_A, row = a * std::numbers::sqrt3;
  const Supercell cell{static_cast<int>(std::ceil(2 * range / a)) + 1, static_cast<int>(std::ceil(2 * range / row)) + 1,
                       a};
  const Vector2d period(cell.along_x * a, cell.along_y * row);
  const VectorXd flat = cell.positions();
  ForceField forces(potential, cell.box(), flat, log_file);
  ForceConstants found;
  for (int atom : {0, 1}) {
    MatrixXd columns(flat.size(), 3);
    for (int axis : {0, 1, 2}) {
      VectorXd x = flat, forward, backward;
      x[3 * atom + axis] += small;
      forces.evaluate(x, forward, true);
      x[3 * atom + axis] -= 2 * small;
      forces.evaluate(x, backward, true);
      columns.col(axis) = (backward - forward) / (2 * small);
    }
    for (int i = 0; i < cell.atoms(); ++i) {
      Vector2d away = flat.segment<2>(3 * i) - flat.segment<2>(3 * atom);
      away -= (away.array() / period.array()).round().matrix().cwiseProduct(period);
      if (away.norm() <= range)
        found[static_cast<std::size_t>(atom)].push_back(
            {Honeycomb{a}.difference(away, atom, Supercell::sublattice(i)), columns.middleRows<3>(3 * i)});
    }
  }
  return found;
}

/// Deflection of a clamped plate at r under a unit load on the ring s, times κ.
double clamped_plate(double a, double r, double s) {
  const double in = std::min(r, s) / a, out = std::max(r, s) / a;
  return a * a / (16 * pi) * ((1 + in * in) * (1 - out * out) + 2 * (in * in + out * out) * std::log(out));
}

class Disc {
 public:
  Disc(const ForceConstants& constants, const Card& card, double radius_A) : card_(card), radius_A_(radius_A) {
    const Honeycomb lattice{card.a0_A};
    const int reach = static_cast<int>(2 * radius_A / card.a0_A) + 2;
    for (int i = -reach; i <= reach; ++i)
      for (int k = -reach; k <= reach; ++k)
        for (int s : {0, 1})
          if (const Vector2d place = lattice.position({i, k, s}); place.norm() <= radius_A) {
            index_[{i, k, s}] = static_cast<int>(places_.size());
            places_.push_back(place);
          }
    stiffen(constants);
  }

  double free_radius_A() const { return std::sqrt(places_.size() * card_.area_per_atom_A2() / pi); }

  /// Where displacements in the plane end.
  double clamp_A() const {
    const double load = 0.45 * radius_A_;
    VectorXd f(2 * atoms()), r(2 * atoms());
    for (int i = 0; i < atoms(); ++i) {
      r.segment<2>(2 * i) = places_[i];
      f.segment<2>(2 * i) = smooth(i, load) * places_[i];
    }
    const VectorXd u = in_plane_.solve(f);
    const double k = f.dot(r) / (4 * pi * card_.C11_eV_per_A2);
    double sum = 0, squares = 0;
    constexpr double edge_A = 4;  // what the edge does to its atoms has decayed
    for (int i = 0; i < atoms(); ++i) {
      const double distance = places_[i].norm();
      if (distance < load || distance > radius_A_ - edge_A) continue;
      sum += k - u.segment<2>(2 * i).dot(places_[i]);
      squares += distance * distance;
    }
    return std::sqrt(k * squares / sum);
  }

  /// Of a plate clamped at `a`.
  double slope_margin_A(double a) const {
    const double kappa = card_.bending_modulus_eV();
    VectorXd f(atoms());
    for (int i = 0; i < atoms(); ++i) f[i] = smooth(i, 0.6 * radius_A_);
    double clamped = 0, moment = 0;
    for (int i = 0; i < atoms(); ++i) {
      if (f[i] == 0) continue;
      moment += f[i] * (1 - places_[i].squaredNorm() / (a * a));
      for (int k = 0; k < atoms(); ++k)
        if (f[k] != 0) clamped += f[i] * f[k] * clamped_plate(a, places_[i].norm(), places_[k].norm()) / kappa;
    }
    const double more = f.dot(out_of_plane_.solve(f).eval()) - clamped;
    return 2 * a * kappa / (moment * moment * a * a / (4 * pi) / more - 4 * kappa);
  }

 private:
  using Solver = Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>>;

  int atoms() const { return static_cast<int>(places_.size()); }
  double smooth(int atom, double reach) const {
    const double r = places_[atom].norm();
    return r < reach ? std::pow(1 - r * r / (reach * reach), 2) : 0;
  }

  void stiffen(const ForceConstants& constants) {
    std::vector<Eigen::Triplet<double>> plane, out;
    for (const auto& [place, atom] : index_)
      for (const auto& [away, stiffness] : constants[static_cast<std::size_t>(place[2])]) {
        const auto other = index_.find({place[0] + away[0], place[1] + away[1], away[2]});
        if (other == index_.end()) continue;
        for (int row : {0, 1})
          for (int column : {0, 1})
            plane.emplace_back(2 * other->second + row, 2 * atom + column, stiffness(row, column));
        out.emplace_back(other->second, atom, stiffness(2, 2));
      }
    factorise(in_plane_, plane, 2 * atoms());
    factorise(out_of_plane_, out, atoms());
  }

  static void factorise(Solver& solver, const std::vector<Eigen::Triplet<double>>& entries, int size) {
    Eigen::SparseMatrix<double> K(size, size);
    K.setFromTriplets(entries.begin(), entries.end());
    solver.compute(K);
    if (solver.info() != Eigen::Success || !(solver.vectorD().minCoeff() > 0))
      throw std::runtime_error("a flat disc of atoms is not stable with this potential");
  }

  const Card& card_;
  double radius_A_;
  std::vector<Vector2d> places_;
  std::map<Place, int> index_;
  Solver in_plane_, out_of_plane_;
};

}  // namespace

ClampMargins clamp_margins(const Potential& potential, const Card& card, const std::string& log_file) {
  constexpr int discs = 12;  // a margin scatters by 0.04 from size to size
  constexpr double smallest = 7.1, step = 0.73;
  const ForceConstants constants = force_constants(potential, card.a0_A, log_file);
  std::vector<std::unique_ptr<Disc>> all;
  for (int k = 0; k < discs; ++k)
    all.push_back(std::make_unique<Disc>(constants, card, (smallest + k * step) * card.a0_A));
  const double bond = card.bond_A();
  ClampMargins mean;
  for (const auto& disc : all) mean.clamp_bonds += (disc->clamp_A() - disc->free_radius_A()) / bond / discs;
  for (const auto& disc : all)
    mean.slope_bonds += disc->slope_margin_A(disc->free_radius_A() + mean.clamp_bonds * bond) / bond / discs;
  if (!(std::abs(mean.clamp_bonds) < 2 && mean.slope_bonds > 0 && mean.slope_bonds < 2))
    throw std::runtime_error("flat discs of atoms do not end near their first held atoms with this potential");
  return mean;
}

}  // namespace atomistic
