#include "atomistic/cell/warm_card.hpp"

#include <Eigen/Dense>
#include <cmath>
#include <limits>
#include <numbers>
#include <stdexcept>

#include "atomistic/cell/homogeneous_cell.hpp"
#include "atomistic/cell/phonons.hpp"

namespace atomistic {
namespace {

using Eigen::Matrix2d;

constexpr int mesh = 24;
constexpr double small = 5e-4;       // strain of second differences …
constexpr double very_small = 2e-4;  // … and of first ones: a compressed sheet has no long waves
constexpr double smooth = 0.02;      // second differences over twice the strain differ by no more of the stiffness

/// Energy and free energy of a cell under homogeneous strain.
class WarmCell {
 public:
  WarmCell(const Potential& potential, const Card& card, const Heat& heat, const std::string& log_file)
      : potential_(potential),
        card_(card),
        heat_(heat),
        log_file_(log_file),
        cell_(potential, {6, 4, card.a0_A}, log_file) {}

  double vibrations(const Matrix2d& strain) const {
    return phonon_free_energy(phonons(potential_, card_, strain, mesh, log_file_), card_, potential_.mass, heat_,
                              2 * std::numbers::pi / longest_cell_wave_A);
  }

  /// Second Piola–Kirchhoff force of the cell without vibrations.
  Matrix2d force(const Matrix2d& strain) {
    const Matrix2d f = gradient_of_strain(strain);
    return pulled_back(f, cell_.relaxed(f));
  }

 private:
  const Potential& potential_;
  const Card& card_;
  Heat heat_;
  std::string log_file_;
  HomogeneousCell cell_;
};

Matrix2d isotropic(double strain) { return strain * Matrix2d::Identity(); }

/// W'' of energy and vibrations along a direction. NaN where it depends on the step: a potential whose forces have a
/// knot at the flat sheet's angles has vibrations with a kink there.
double stiffness(WarmCell& cell, const Matrix2d& at, const Matrix2d& along) {
  const Matrix2d slope = (cell.force(at + small * along) - cell.force(at - small * along)) / (2 * small);
  const double middle = cell.vibrations(at);
  const auto of_vibrations = [&](double step) {
    return (cell.vibrations(at + step * along) - 2 * middle + cell.vibrations(at - step * along)) / (step * step);
  };
  const double found = of_vibrations(small), wider = of_vibrations(2 * small), stiff = slope.cwiseProduct(along).sum();
  return std::abs(found - wider) <= smooth * stiff ? stiff + found : std::numeric_limits<double>::quiet_NaN();
}

/// tr S / 2 of energy and vibrations.
double tension(WarmCell& cell, double strain) {
  const double vibrations =
      (cell.vibrations(isotropic(strain + very_small)) - cell.vibrations(isotropic(strain - very_small))) /
      (2 * very_small);
  return cell.force(isotropic(strain)).trace() / 2 + vibrations / 2;
}

/// NaN where there is none.
double strain_at_rest(WarmCell& cell, const Card& card) {
  constexpr double farthest = 0.02, enough = 1e-8;
  double previous = 0, t_previous = tension(cell, 0);
  double strain = -t_previous / (card.C11_eV_per_A2 + card.C12_eV_per_A2);
  for (int i = 0; i < 20 && std::abs(strain - previous) > enough; ++i) {
    if (!(std::abs(strain) < farthest)) break;
    const double t = tension(cell, strain), next = strain - t * (strain - previous) / (t - t_previous);
    previous = strain;
    t_previous = t;
    strain = next;
  }
  return std::abs(strain) < farthest ? strain : std::numeric_limits<double>::quiet_NaN();
}

}  // namespace

WarmCard compute_warm_card(const Potential& potential, const Card& card, const Heat& heat,
                           const std::string& log_file) {
  WarmCell cell(potential, card, heat, log_file);
  WarmCard warm{.temperature_K = heat.temperature_K,
                .statistics = heat.statistics,
                .lattice_constant_A = std::numeric_limits<double>::quiet_NaN(),
                .C11_eV_per_A2 = std::numeric_limits<double>::quiet_NaN(),
                .C12_eV_per_A2 = std::numeric_limits<double>::quiet_NaN(),
                .longest_wave_A = longest_cell_wave_A};
  const double strain = strain_at_rest(cell, card), square = 1 + 2 * strain;
  if (!std::isfinite(strain)) return warm;
  const Matrix2d at = isotropic(strain), stretch = Matrix2d::Identity();
  const Matrix2d shear = (Matrix2d() << 1, 0, 0, -1).finished();
  // W'' along (1, 1) is 2 (C11 + C12), along (1, −1) 2 (C11 − C12); per area of the stretched sheet, of its own strain.
  const double bulk = square * stiffness(cell, at, stretch) / 2, deviatoric = square * stiffness(cell, at, shear) / 2;
  warm.lattice_constant_A = card.a0_A * std::sqrt(square);
  warm.C11_eV_per_A2 = (bulk + deviatoric) / 2;
  warm.C12_eV_per_A2 = (bulk - deviatoric) / 2;
  return warm;
}

std::vector<double> vibrations_under_strain(const Potential& potential, const Card& card, const Heat& heat,
                                            const std::vector<StrainState>& strains, const std::string& log_file) {
  const WarmCell cell(potential, card, heat, log_file);
  const double unstrained = cell.vibrations(Matrix2d::Zero());
  std::vector<double> found;
  for (const StrainState& s : strains) {
    Matrix2d strain;
    strain << s.E11, s.E12, s.E12, s.E22;
    const Matrix2d turn = Eigen::Rotation2Dd(s.orientation_deg * std::numbers::pi / 180).toRotationMatrix();
    found.push_back(cell.vibrations(turn * strain * turn.transpose()) - unstrained);
  }
  return found;
}

}  // namespace atomistic
