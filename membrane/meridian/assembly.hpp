// The sum of the energy's terms over a meridian, its gradient and its Hessian.
#pragma once

#include <Eigen/Core>
#include <optional>
#include <span>
#include <vector>

#include "membrane/meridian/block_tridiagonal.hpp"
#include "membrane/meridian/terms.hpp"

namespace membrane::meridian {

/// A Gauss point of an element.
struct QuadraturePoint {
  int element = 0;
  Ring ring;
  Interpolation B;
};

/// Degrees of freedom x: [u, u', w, w'] of every node, zero where held. The terms are integrated with four
/// points an element. Contact is watched at the nodes and between them: as many places as there are degrees
/// of freedom across the sheet, since with more the constraints would contradict each other.
class Assembly {
 public:
  /// `rim_spring_eV`: moment over angle of a rim that turns, counted as bending. `rim_pull_eV_per_A`: dead force on the
  /// whole rim, outwards, and `rim_stiffness_eV_per_A2` against its displacement: their potential is counted with the
  /// pressure's.
  Assembly(std::vector<double> nodes, std::vector<int> held, std::vector<EnergyTerm> terms,
           std::optional<SphereContact> contact, double rim_spring_eV = 0, double rim_pull_eV_per_A = 0,
           double rim_stiffness_eV_per_A2 = 0);

  /// Total energy (eV) and gradient (zero at held degrees of freedom).
  double energy(const Eigen::VectorXd& x, Eigen::VectorXd& gradient);
  /// Hessian, held rows and columns those of the unit matrix.
  void hessian(const Eigen::VectorXd& x, BlockTridiagonal& K) const;

  /// Of each term at the last energy(), contact last, eV.
  const std::vector<double>& parts() const { return parts_; }
  /// Of what the energy is the sum and difference of: eV. Its rounding is a share of that.
  double magnitude() const;
  /// Gradient without its zeros: at held degrees of freedom the reaction.
  const Eigen::VectorXd& full_gradient() const { return full_gradient_; }

  /// Σ f(Ring, LocalState) over the rings of the terms.
  template <class F>
  double sum(const Eigen::VectorXd& x, F f) const {
    double total = 0;
    for (const QuadraturePoint& point : points_) total += f(point.ring, state(point, x));
    return total;
  }
  /// f(Ring, LocalState) at every place where contact is watched.
  template <class F>
  void over_contact(const Eigen::VectorXd& x, F f) const {
    for (const QuadraturePoint& point : contact_points_) f(point.ring, state(point, x));
  }
  /// Local state at any radius.
  LocalState state_at(double radius, const Eigen::VectorXd& x) const;
  /// Consistent weights of a density per reference area, up to r <= radius, with unit total: the conjugate
  /// depth is their product with x.
  template <class F>
  Eigen::VectorXd pattern(F density, double radius) const {
    Eigen::VectorXd weights = Eigen::VectorXd::Zero(dof_count());
    double total = 0;
    for (const QuadraturePoint& point : points_) {
      if (point.ring.radius_A > radius) continue;
      const double share = point.ring.area_A2 * density(point.ring.radius_A);
      weights.segment<2 * dofs_per_node>(dofs_per_node * point.element) += share * point.B.row(W).transpose();
      total += share;
    }
    release_held(weights);
    return weights / total;
  }

  /// Makes the held components zero.
  void release_held(Eigen::VectorXd& vector) const;

  /// How often energies or Hessians were summed up so far.
  int passes() const { return passes_; }

  int dof_count() const { return dofs_per_node * static_cast<int>(nodes_.size()); }
  int element_count() const { return static_cast<int>(nodes_.size()) - 1; }
  const std::vector<double>& nodes() const { return nodes_; }
  std::vector<EnergyTerm>& terms() { return terms_; }
  const std::vector<EnergyTerm>& terms() const { return terms_; }

  std::optional<SphereContact>& contact() { return contact_; }
  const std::optional<SphereContact>& contact() const { return contact_; }
  /// Gives every watched ring the pressure that the barrier has across its gap.
  void start_pressures(const Eigen::VectorXd& x);
  /// The largest share of a step, at most 1, that leaves each gap some of what it is.
  double longest_share(const Eigen::VectorXd& x, const Eigen::VectorXd& step) const;
  /// Takes the pressures along with a step from x, as Newton's method on gap × pressure = µ does.
  void advance_pressures(const Eigen::VectorXd& x, const Eigen::VectorXd& step);

 private:
  using ElementMatrix = Eigen::Matrix<double, 2 * dofs_per_node, 2 * dofs_per_node>;

  LocalState state(const QuadraturePoint& point, const Eigen::VectorXd& x) const {
    return point.B * x.segment<2 * dofs_per_node>(dofs_per_node * point.element);
  }
  static void add(const QuadraturePoint& point, const Eigen::Matrix<double, 6, 6>& density, BlockTridiagonal& K);

  std::vector<double> nodes_;
  std::vector<int> held_;
  std::vector<EnergyTerm> terms_;
  std::optional<SphereContact> contact_;
  double rim_spring_eV_, rim_pull_eV_per_A_, rim_stiffness_eV_per_A2_;
  /// Where the contact acts: nowhere without a barrier.
  std::span<const QuadraturePoint> pressed() const {
    return contact_ && contact_->barrier_eV_per_A2 > 0 ? std::span(contact_points_)
                                                       : std::span<const QuadraturePoint>();
  }

  std::vector<QuadraturePoint> points_, contact_points_;
  std::vector<double> pressures_;  ///< of the contact's rings, eV/Å³
  std::vector<double> parts_;
  Eigen::VectorXd full_gradient_;
  mutable int passes_ = 0;
};

}  // namespace membrane::meridian
