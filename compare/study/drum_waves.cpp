#include "compare/study/drum_waves.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "atomistic/vibration.hpp"

namespace validate {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;
using membrane::MeridianPoint;
using std::numbers::pi;

constexpr double least_weight = 1e-4;

/// What the second variation needs of the state at a radius.
struct Local {
  double stretch_r = 1, slope = 0, hoop = 1;  ///< R', z', R/r
  double S_r = 0, S_h = 0;
  double C_rr = 0, C_rh = 0, C_hh = 0, G = 0;
};

/// The state between its points, and its derivatives by parabolas through three of them.
class State {
 public:
  State(const Drum& drum, const std::vector<MeridianPoint>& points) : law_(*drum.law) {
    constexpr double apart_A = 1e-6;  // neighbours in an element's two ends are one
    for (const MeridianPoint& p : points)
      if (points_.empty() || p.radius_A > points_.back().radius_A + apart_A) points_.push_back(p);
  }

  Local at(double r) const {
    Local local;
    double E_r = 0, E_h = 0;
    if (!points_.empty()) {
      const auto above = std::ranges::lower_bound(points_, r, {}, &MeridianPoint::radius_A);
      const std::size_t k =
          std::clamp<std::size_t>(static_cast<std::size_t>(above - points_.begin()), 1, points_.size() - 1);
      const MeridianPoint &p = points_[k - 1], &q = points_[k];
      const double t = std::clamp((r - p.radius_A) / (q.radius_A - p.radius_A), 0.0, 1.0);
      const auto between = [&](double MeridianPoint::*member) { return std::lerp(p.*member, q.*member, t); };
      local.stretch_r =
          1 + std::lerp(slope(&MeridianPoint::displacement_A, k - 1), slope(&MeridianPoint::displacement_A, k), t);
      local.slope = -std::lerp(slope(&MeridianPoint::depth_A, k - 1), slope(&MeridianPoint::depth_A, k), t);
      E_r = between(&MeridianPoint::radial_strain);
      E_h = between(&MeridianPoint::hoop_strain);
      local.hoop = std::sqrt(1 + 2 * E_h);
      local.S_r = between(&MeridianPoint::radial_force_eV_per_A2);
      local.S_h = between(&MeridianPoint::hoop_force_eV_per_A2);
    }
    add_moduli(E_r, E_h, local);
    return local;
  }

 private:
  double slope(double MeridianPoint::*member, std::size_t k) const {
    const std::size_t middle = std::clamp<std::size_t>(k, 1, points_.size() - 2);
    const MeridianPoint &a = points_[middle - 1], &b = points_[middle], &c = points_[middle + 1];
    const double left = (b.*member - a.*member) / (b.radius_A - a.radius_A);
    const double right = (c.*member - b.*member) / (c.radius_A - b.radius_A);
    const double curvature = (right - left) / (c.radius_A - a.radius_A);
    return left + curvature * (2 * points_[k].radius_A - a.radius_A - b.radius_A);
  }

  void add_moduli(double E_r, double E_h, Local& local) const {
    constexpr double small = 1e-5;
    const auto force = [&](double r, double h, double shear) { return law_({r, h, shear}).force_eV_per_A2; };
    const membrane::Voigt along_r = (force(E_r + small, E_h, 0) - force(E_r - small, E_h, 0)) / (2 * small);
    const membrane::Voigt along_h = (force(E_r, E_h + small, 0) - force(E_r, E_h - small, 0)) / (2 * small);
    local.C_rr = along_r[0];
    local.C_rh = (along_r[1] + along_h[0]) / 2;
    local.C_hh = along_h[1];
    local.G = (force(E_r, E_h, small)[2] - force(E_r, E_h, -small)[2]) / (2 * small);
  }

  const membrane::CauchyBorn& law_;
  std::vector<MeridianPoint> points_;
};

/// Values, first and second derivatives of an element's four cubics at t in [0, 1].
struct Cubics {
  std::array<double, 4> value, first, second;
  Cubics(double t, double h)
      : value{1 - 3 * t * t + 2 * t * t * t, h * t * (1 - t) * (1 - t), 3 * t * t - 2 * t * t * t, h * t * t * (t - 1)},
        first{(-6 * t + 6 * t * t) / h, 1 - 4 * t + 3 * t * t, (6 * t - 6 * t * t) / h, 3 * t * t - 2 * t},
        second{(-6 + 12 * t) / (h * h), (-4 + 6 * t) / h, (6 - 12 * t) / (h * h), (6 * t - 2) / h} {}
};

/// Second variation and mass of one harmonic, cubics in u, v, z; unknowns u0 u0' u1 u1' … of each.
class Harmonic {
 public:
  Harmonic(const Drum& drum, const State& state, int m) : drum_(drum), m_(m) {
    constexpr double element_A = 2.5;
    elements_ = std::max(8, static_cast<int>(std::ceil(drum.a_A / element_A)));
    size_ = 2 * (elements_ + 1);
    K_ = MatrixXd::Zero(3 * size_, 3 * size_);
    M_ = MatrixXd::Zero(size_, size_);
    const double h = drum.a_A / elements_;
    constexpr std::array<double, 4> place = {0.0694318442029737, 0.3300094782075719, 0.6699905217924281,
                                             0.9305681557970263};
    constexpr std::array<double, 4> weight = {0.1739274225687269, 0.3260725774312731, 0.3260725774312731,
                                              0.1739274225687269};
    for (int e = 0; e < elements_; ++e)
      for (std::size_t g = 0; g < place.size(); ++g) {
        const double r = (e + place[g]) * h;
        add(e, Cubics(place[g], h), r, weight[g] * h * r, state.at(r));
      }
    if (drum.slope_margin_A > 0)
      K_(2 * size_ + size_ - 1, 2 * size_ + size_ - 1) += drum.bending_modulus_eV / drum.slope_margin_A * drum.a_A;
  }

  /// Rising, with what is in the plane condensed.
  std::vector<double> eigenvalues() const {
    const std::vector<int> plane = plane_unknowns(), out = out_unknowns(2 * size_), mass = out_unknowns(0);
    MatrixXd K = K_(out, out);
    if (m_ > 0 || !plane.empty()) {
      const MatrixXd across = K_(plane, out);
      K -= across.transpose() * K_(plane, plane).ldlt().solve(across);
    }
    const MatrixXd M = M_(mass, mass);
    const Eigen::GeneralizedSelfAdjointEigenSolver<MatrixXd> solver((K + K.transpose()) / 2, M, Eigen::EigenvaluesOnly);
    const VectorXd& values = solver.eigenvalues();
    return {values.data(), values.data() + values.size()};
  }

 private:
  void add(int element, const Cubics& c, double r, double weight, const Local& s) {
    // Rows: e_rr, e_hh, γ, and what the forces act on: u', v', z' and the three of the hoop direction; ∇²z, z.
    Eigen::Matrix<double, 10, 12> B = Eigen::Matrix<double, 10, 12>::Zero();
    for (int i = 0; i < 4; ++i) {
      const auto k = static_cast<std::size_t>(i);
      const double f = c.value[k], d = c.first[k], dd = c.second[k];
      const int u = i, v = 4 + i, z = 8 + i;
      B(0, u) = s.stretch_r * d, B(0, z) = s.slope * d;
      B(1, u) = s.hoop * f / r, B(1, v) = s.hoop * m_ * f / r;
      B(2, u) = -s.stretch_r * m_ * f / r, B(2, v) = -s.stretch_r * f / r + s.hoop * d, B(2, z) = -s.slope * m_ * f / r;
      B(3, u) = d, B(4, v) = d, B(5, z) = d;
      B(6, u) = -m_ * f / r, B(6, v) = -f / r;
      B(7, u) = f / r, B(7, v) = m_ * f / r;
      B(8, z) = m_ * f / r;
      B(9, z) = dd + d / r - m_ * m_ * f / (r * r);
    }
    Eigen::Matrix<double, 10, 10> D = Eigen::Matrix<double, 10, 10>::Zero();
    D(0, 0) = s.C_rr, D(1, 1) = s.C_hh, D(0, 1) = D(1, 0) = s.C_rh, D(2, 2) = s.G;
    D(3, 3) = D(4, 4) = D(5, 5) = s.S_r;
    D(6, 6) = D(7, 7) = D(8, 8) = s.S_h;
    D(9, 9) = drum_.bending_modulus_eV;
    const Eigen::Matrix<double, 12, 12> K = weight * B.transpose() * D * B;
    for (int i = 0; i < 12; ++i)
      for (int k = 0; k < 12; ++k) K_(unknown(element, i), unknown(element, k)) += K(i, k);
    for (int i = 0; i < 4; ++i)
      for (int k = 0; k < 4; ++k)
        M_(2 * element + i, 2 * element + k) +=
            weight * c.value[static_cast<std::size_t>(i)] * c.value[static_cast<std::size_t>(k)];
  }

  int unknown(int element, int local) const { return local / 4 * size_ + 2 * element + local % 4; }

  /// At the axis a scalar of harmonic m has no value but for m = 0 and no slope but for m = 1; u and v are the parts of
  /// a vector, which are equal and opposite there for m = 1 and nothing else.
  std::vector<int> plane_unknowns() const {
    std::vector<int> free;
    for (int i = 1; i < size_ - 2; ++i) {
      if (i == 1 && m_ == 1) continue;
      free.push_back(i);
      if (m_ > 0) free.push_back(size_ + i);
    }
    free.push_back(size_ - 1);
    if (m_ > 0) free.push_back(2 * size_ - 1);
    return free;
  }

  std::vector<int> out_unknowns(int offset) const {
    std::vector<int> free;
    for (int i = 0; i < size_ - 2; ++i) {
      if (i == 0 && m_ != 0) continue;
      if (i == 1 && m_ != 1) continue;
      free.push_back(offset + i);
    }
    if (drum_.slope_margin_A > 0) free.push_back(offset + size_ - 1);
    return free;
  }

  const Drum& drum_;
  int m_, elements_ = 0, size_ = 0;
  MatrixXd K_, M_;
};

double weight_of(double wave_number, double shortest_wave_A) {
  return std::exp(-std::pow(wave_number * shortest_wave_A / (2 * pi), 8));
}

}  // namespace

std::vector<double> flexural_eigenvalues(const Drum& drum, const std::vector<MeridianPoint>& state, int m) {
  std::vector<double> values = Harmonic(drum, State(drum, state), m).eigenvalues();
  for (double& value : values) value *= drum.area_per_atom_A2;
  return values;
}

std::vector<double> flat_wave_numbers(const Drum& drum, int m) {
  std::vector<double> numbers;
  for (const double value : flexural_eigenvalues(drum, {}, m))
    numbers.push_back(std::pow(value / (drum.bending_modulus_eV * drum.area_per_atom_A2), 0.25));
  return numbers;
}

DrumWaves::DrumWaves(const Drum& drum, const atomistic::Heat& heat) : drum_(drum), heat_(heat) {
  for (int m = 0;; ++m) {
    std::vector<double> weights;
    for (const double k : flat_wave_numbers(drum_, m))
      if (const double weight = weight_of(k, drum_.shortest_wave_A); weight > least_weight) weights.push_back(weight);
    if (weights.empty()) return;
    weights_.push_back(std::move(weights));
  }
}

double DrumWaves::operator()(const std::vector<MeridianPoint>& state) const {
  double sum = 0;
  for (std::size_t m = 0; m < weights_.size(); ++m) {
    const std::vector<double> values = flexural_eigenvalues(drum_, state, static_cast<int>(m));
    for (std::size_t n = 0; n < weights_[m].size(); ++n)
      sum += (m == 0 ? 1 : 2) * weights_[m][n] * atomistic::oscillator_free_energy_eV(values[n], drum_.mass_u, heat_);
  }
  return sum;
}

}  // namespace validate
