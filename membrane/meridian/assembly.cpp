#include "membrane/meridian/assembly.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <numeric>
#include <utility>

#include "membrane/meridian/setup.hpp"
#include "membrane/meridian/tuning.hpp"

namespace membrane::meridian {
namespace {

/// Gauss–Legendre on [0, 1].
struct Gauss {
  double at, weight;
};
constexpr std::array<Gauss, 4> gauss{{{0.06943184420297371, 0.17392742256872693},
                                      {0.33000947820757187, 0.32607257743127307},
                                      {0.66999052179242813, 0.32607257743127307},
                                      {0.93056815579702629, 0.17392742256872693}}};

std::vector<QuadraturePoint> quadrature(const std::vector<double>& nodes) {
  std::vector<QuadraturePoint> points;
  for (std::size_t e = 0; e + 1 < nodes.size(); ++e)
    for (const auto& [t, weight] : gauss) {
      const double length = nodes[e + 1] - nodes[e];
      const double radius = nodes[e] + t * length;
      const double area = 2 * std::numbers::pi * radius * weight * length;
      points.push_back({static_cast<int>(e), {radius, area}, interpolation(length, t)});
    }
  return points;
}

/// Every node but the last, and every middle, up to a radius, with the area half way to the next ones.
std::vector<QuadraturePoint> watched(const std::vector<double>& nodes, double farthest) {
  std::vector<QuadraturePoint> points;
  for (std::size_t e = 0; e + 1 < nodes.size(); ++e)
    for (double t : {0.0, 0.5}) {
      const double length = nodes[e + 1] - nodes[e];
      const double radius = nodes[e] + t * length;
      if (radius > farthest) return points;
      const double inner = t > 0 ? nodes[e] + 0.25 * length : e > 0 ? nodes[e] - 0.25 * (nodes[e] - nodes[e - 1]) : 0;
      const double outer = radius + 0.25 * length;
      const double area = std::numbers::pi * (outer * outer - inner * inner);
      points.push_back({static_cast<int>(e), {radius, area}, interpolation(length, t)});
    }
  return points;
}

}  // namespace

Assembly::Assembly(std::vector<double> nodes, std::vector<int> held, std::vector<EnergyTerm> terms,
                   std::optional<SphereContact> contact, double rim_spring_eV, double rim_pull_eV_per_A,
                   double rim_stiffness_eV_per_A2)
    : nodes_(std::move(nodes)),
      held_(std::move(held)),
      terms_(std::move(terms)),
      contact_(contact),
      rim_spring_eV_(rim_spring_eV),
      rim_pull_eV_per_A_(rim_pull_eV_per_A),
      rim_stiffness_eV_per_A2_(rim_stiffness_eV_per_A2),
      points_(quadrature(nodes_)) {
  if (contact_) contact_points_ = watched(nodes_, ContactTuning::watched_share * contact_->radius_A);
}

void Assembly::release_held(Eigen::VectorXd& vector) const {
  for (int dof : held_) vector[dof] = 0;
}

double Assembly::energy(const Eigen::VectorXd& x, Eigen::VectorXd& gradient) {
  ++passes_;
  parts_.assign(terms_.size() + 1, 0);
  gradient.setZero(dof_count());
  const auto add = [&](const QuadraturePoint& point, const LocalState& density) {
    gradient.segment<2 * dofs_per_node>(dofs_per_node * point.element) +=
        point.ring.area_A2 * point.B.transpose() * density;
  };
  for (const QuadraturePoint& point : points_) {
    const LocalState y = state(point, x);
    LocalState sum = LocalState::Zero();
    for (std::size_t k = 0; k < terms_.size(); ++k) {
      const Density density = std::visit([&](const auto& term) { return term(point.ring, y); }, terms_[k]);
      parts_[k] += point.ring.area_A2 * density.value;
      sum += density.gradient;
    }
    add(point, sum);
  }
  if (rim_spring_eV_ > 0) {
    const Eigen::Index slope = dof_count() - 1;
    parts_[bending_term] += rim_spring_eV_ * x[slope] * x[slope] / 2;
    gradient[slope] += rim_spring_eV_ * x[slope];
  }
  if (rim_pull_eV_per_A_ != 0) {
    const Eigen::Index outward = dof_count() - dofs_per_node;
    const double force = rim_stiffness_eV_per_A2_ * x[outward] / 2 - rim_pull_eV_per_A_;
    parts_[pressure_term] += force * x[outward];
    gradient[outward] += force + rim_stiffness_eV_per_A2_ * x[outward] / 2;
  }
  for (const QuadraturePoint& point : pressed()) {
    const Density density = (*contact_)(point.ring, state(point, x));
    parts_.back() += point.ring.area_A2 * density.value;
    add(point, density.gradient);
  }
  full_gradient_ = gradient;
  release_held(gradient);
  return std::accumulate(parts_.begin(), parts_.end(), 0.0);
}

double Assembly::magnitude() const {
  double sum = 0;
  for (double part : parts_) sum += std::abs(part);
  for (const EnergyTerm& term : terms_)  // the energy of the flat sheet is taken off
    if (const auto* stretching = std::get_if<Stretching>(&term))
      sum += std::abs(stretching->flat_energy) * std::numbers::pi * nodes_.back() * nodes_.back();
  return sum;
}

void Assembly::add(const QuadraturePoint& point, const Eigen::Matrix<double, 6, 6>& density, BlockTridiagonal& K) {
  const Interpolation right = point.ring.area_A2 * density * point.B;
  const ElementMatrix k = point.B.transpose() * right;
  K.diagonal[point.element] += k.topLeftCorner<dofs_per_node, dofs_per_node>();
  K.diagonal[point.element + 1] += k.bottomRightCorner<dofs_per_node, dofs_per_node>();
  K.below[point.element] += k.bottomLeftCorner<dofs_per_node, dofs_per_node>();
}

void Assembly::hessian(const Eigen::VectorXd& x, BlockTridiagonal& K) const {
  ++passes_;
  K.set_zero();
  for (const QuadraturePoint& point : points_) {
    const LocalState y = state(point, x);
    Eigen::Matrix<double, 6, 6> sum = Eigen::Matrix<double, 6, 6>::Zero();
    for (const EnergyTerm& any : terms_)
      sum += std::visit([&](const auto& term) { return term(point.ring, y).hessian; }, any);
    add(point, sum, K);
  }
  for (std::size_t i = 0; i < pressed().size(); ++i) {
    const QuadraturePoint& point = pressed()[i];
    add(point, (*contact_)(point.ring, state(point, x), pressures_[i]).hessian, K);
  }
  K.diagonal.back()(dofs_per_node - 1, dofs_per_node - 1) += rim_spring_eV_;
  K.diagonal.back()(0, 0) += rim_stiffness_eV_per_A2_;
  for (int dof : held_) K.hold(dof);
}

void Assembly::start_pressures(const Eigen::VectorXd& x) {
  pressures_.clear();
  for (const QuadraturePoint& point : pressed())
    pressures_.push_back(contact_->barrier_eV_per_A2 / contact_->gap(point.ring, state(point, x)));
}

double Assembly::longest_share(const Eigen::VectorXd& x, const Eigen::VectorXd& step) const {
  double share = 1;
  for (const QuadraturePoint& point : pressed()) {
    const LocalState y = state(point, x);
    const double gap = contact_->gap(point.ring, y);
    const double change = contact_->normal(point.ring, y).dot(state(point, step));
    if (share * change < -ContactTuning::boundary_share * gap) share = -ContactTuning::boundary_share * gap / change;
  }
  return share;
}

void Assembly::advance_pressures(const Eigen::VectorXd& x, const Eigen::VectorXd& step) {
  for (std::size_t i = 0; i < pressed().size(); ++i) {
    const QuadraturePoint& point = pressed()[i];
    const LocalState y = state(point, x);
    const double gap = contact_->gap(point.ring, y);
    const double change = contact_->normal(point.ring, y).dot(state(point, step));
    const double barrier = contact_->barrier_eV_per_A2;
    const double next = barrier / gap - pressures_[i] * change / gap;
    const double from_barrier = barrier / contact_->gap(point.ring, state(point, x + step));
    pressures_[i] =
        std::clamp(std::max(next, (1 - ContactTuning::boundary_share) * pressures_[i]),
                   from_barrier / ContactTuning::farthest_pressure, from_barrier * ContactTuning::farthest_pressure);
  }
}

LocalState Assembly::state_at(double radius, const Eigen::VectorXd& x) const {
  const auto above = std::upper_bound(nodes_.begin() + 1, nodes_.end() - 1, radius);
  const int e = static_cast<int>(above - nodes_.begin()) - 1;
  const double length = nodes_[e + 1] - nodes_[e];
  return interpolation(length, (radius - nodes_[e]) / length) * x.segment<2 * dofs_per_node>(dofs_per_node * e);
}

}  // namespace membrane::meridian
