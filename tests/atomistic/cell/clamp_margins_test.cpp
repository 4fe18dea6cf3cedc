// Where a held lattice ends for its continuum, from the Hessians of flat discs of atoms: the constants of the pairing.
#include <gtest/gtest.h>

#include <Eigen/Sparse>
#include <cmath>
#include <map>
#include <numbers>

#include "atomistic/lattice/sheet.hpp"
#include "compare/pairing/sheet.hpp"
#include "tests/atomistic/support/lammps_session.hpp"

namespace {

using namespace atomistic;
using Eigen::VectorXd;
using std::numbers::pi;

/// Groups of free atoms so far from each other that no atom feels two of one group.
std::vector<std::vector<int>> far_apart(const Sheet& sheet, double range_A) {
  std::vector<std::vector<int>> groups;
  for (int i = 0; i < sheet.free_atoms; ++i) {
    const auto clear = [&](const std::vector<int>& group) {
      return std::ranges::all_of(group,
                                 [&](int k) { return (sheet.position(i) - sheet.position(k)).norm() > 2 * range_A; });
    };
    const auto room = std::ranges::find_if(groups, clear);
    if (room == groups.end())
      groups.push_back({i});
    else
      room->push_back(i);
  }
  return groups;
}

/// Second derivatives of the energy by the free atoms' positions, by central differences of the forces.
Eigen::SparseMatrix<double> hessian(ForceField& forces, const Sheet& sheet, double range_A) {
  constexpr double small = 1e-3;
  std::vector<Eigen::Triplet<double>> entries;
  for (const std::vector<int>& group : far_apart(sheet, range_A))
    for (int axis : {0, 1, 2}) {
      VectorXd x = sheet.positions, forward, backward;
      for (int i : group) x[3 * i + axis] += small;
      forces.evaluate(x, forward, true);
      for (int i : group) x[3 * i + axis] -= 2 * small;
      forces.evaluate(x, backward, true);
      const VectorXd column = (backward - forward) / (2 * small);
      for (int i : group)
        for (int k = 0; k < sheet.free_atoms; ++k)
          if ((sheet.position(i) - sheet.position(k)).norm() <= range_A)
            for (int row : {0, 1, 2}) entries.emplace_back(3 * k + row, 3 * i + axis, column[3 * k + row]);
    }
  Eigen::SparseMatrix<double> K(3 * sheet.free_atoms, 3 * sheet.free_atoms);
  K.setFromTriplets(entries.begin(), entries.end());
  return K;
}

/// Deflection of a clamped plate at r under a unit load on the ring s, times κ.
double clamped_plate(double a, double r, double s) {
  const double in = std::min(r, s) / a, out = std::max(r, s) / a;
  const double logarithm = out > 0 ? 2 * (in * in + out * out) * std::log(out) : 0;
  return a * a / (16 * pi) * ((1 + in * in) * (1 - out * out) + logarithm);
}

struct Margins {
  double clamp_bonds, slope_bonds;
};

class Disc {
 public:
  Disc(const std::string& name, double radius_A)
      : potential_(potential(name)),
        card_(compute_card(potential_, "none")),
        sheet_(make_sheet(radius_A, card_.a0_A, 0, potential_.interaction_range_A)) {
    Eigen::Vector3d far(radius_A + 30, radius_A + 30, 30);
    ForceField forces(potential_, {.low = -far, .high = far}, sheet_.positions, "none");
    solver_.compute(hessian(forces, sheet_, potential_.interaction_range_A));
    EXPECT_EQ(solver_.info(), Eigen::Success);
  }

  /// The plate's is of the card's clamp, not of this disc's own.
  Margins margins() const {
    const double bond = sheet_.bond_A, free = std::sqrt(sheet_.free_atoms * card_.area_per_atom_A2() / pi);
    return {(clamp_A() - free) / bond, slope_margin_A(free + card_.clamp_margin_bonds * bond) / bond};
  }

 private:
  double r(int atom) const { return sheet_.position(atom).norm(); }
  double smooth(int atom, double reach) const {
    return r(atom) < reach ? std::pow(1 - std::pow(r(atom) / reach, 2), 2) : 0;
  }

  /// Outward forces near the axis: outside, u = k/r − c r with k = Σ r·f / (4π C11).
  double clamp_A() const {
    const double reach = 0.45 * sheet_.radius_A;
    VectorXd f = VectorXd::Zero(3 * sheet_.free_atoms);
    for (int i = 0; i < sheet_.free_atoms; ++i) f.segment<3>(3 * i) = smooth(i, reach) * sheet_.position(i);
    const VectorXd u = solver_.solve(f);
    const double k = f.dot(sheet_.positions.head(3 * sheet_.free_atoms)) / (4 * pi * card_.C11_eV_per_A2);
    double sum = 0, squares = 0;
    for (int i = 0; i < sheet_.free_atoms; ++i) {
      if (r(i) < reach || r(i) > sheet_.radius_A - 4) continue;
      sum += k - u.segment<3>(3 * i).dot(sheet_.position(i));
      squares += r(i) * r(i);
    }
    return std::sqrt(k * squares / sum);
  }

  /// Compliance beyond the clamped plate's: (Σ f (1 − r²/a²))² a²/4π / (2 a κ/h + 4 κ).
  double slope_margin_A(double a) const {
    VectorXd f = VectorXd::Zero(3 * sheet_.free_atoms);
    for (int i = 0; i < sheet_.free_atoms; ++i) f[3 * i + 2] = smooth(i, 0.6 * sheet_.radius_A);
    const double kappa = card_.bending_modulus_eV();
    double clamped = 0, moment = 0;
    for (int i = 0; i < sheet_.free_atoms; ++i) {
      if (f[3 * i + 2] == 0) continue;
      moment += f[3 * i + 2] * (1 - std::pow(r(i) / a, 2));
      for (int k = 0; k < sheet_.free_atoms; ++k)
        clamped += f[3 * i + 2] * f[3 * k + 2] * clamped_plate(a, r(i), r(k)) / kappa;
    }
    const double more = f.dot(solver_.solve(f).eval()) - clamped;
    const double stiffness = moment * moment * a * a / (4 * pi) / more;
    return 2 * a * kappa / (stiffness - 4 * kappa);
  }

  Potential potential_;
  Card card_;
  Sheet sheet_;
  Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> solver_;
};

/// Every derivative of a real sheet's forces, held ring and all, instead of the lattice's force constants. Three sizes
/// scatter about the card's mean.
TEST(ClampMargins, AreThoseOfSheetsWithTheirHeldRing) {
  for (const char* name : {"tersoff", "rebo"}) {
    Margins mean{};
    const Card card = compute_card(potential(name), "none");
    for (const double radius_A : {20.0, 25.0, 30.0}) {
      const Margins found = Disc(name, radius_A).margins();
      mean.clamp_bonds += found.clamp_bonds / 3;
      mean.slope_bonds += found.slope_bonds / 3;
    }
    EXPECT_NEAR(mean.clamp_bonds, card.clamp_margin_bonds, 2 * validate::clamp_margin_error_bonds) << name;
    EXPECT_NEAR(mean.slope_bonds, card.slope_margin_bonds, 2 * validate::slope_margin_error_bonds) << name;
  }
}

/// Computed by a program written separately from this project (finite differences of LAMMPS's forces over whole discs
/// of 18 to 45 Å; airebo and lcbop six of them, to 30 Å): means over sizes, which scatter by 0.05.
TEST(ClampMargins, MatchTheReference) {
  const std::map<std::string, Margins> references = {{"airebo", {0.431, 0.541}},
                                                     {"rebo", {0.396, 0.448}},
                                                     {"tersoff", {0.458, 0.281}},
                                                     {"tersoff-1989", {0.424, 0.327}},
                                                     {"lcbop", {0.497, 0.260}}};
  for (const auto& [name, reference] : references) {
    const Card card = compute_card(potential(name), "none");
    EXPECT_NEAR(card.clamp_margin_bonds, reference.clamp_bonds, 0.05) << name;
    EXPECT_NEAR(card.slope_margin_bonds, reference.slope_bonds, 0.05) << name;
  }
}

}  // namespace
