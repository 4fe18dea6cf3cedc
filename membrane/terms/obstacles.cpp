#include "membrane/terms/obstacles.hpp"

#include <cmath>

namespace membrane {
namespace {

constexpr double cone_from = 0.98;  // of the sphere's radius

/// The correction of a gap that an update of the multiplier stands for.
double update(Contact& contact, double gap) {
  const double force = contact.force(gap);
  const double correction = std::abs(force - contact.multiplier) / contact.stiffness;
  contact.multiplier = force;
  return correction;
}

}  // namespace

SphereObstacle::SphereObstacle(const Mesh& mesh, double radius_A, double stiffness_eV_per_A2)
    : mesh_(mesh), radius_A_(radius_A), indenter_(mesh.node_count()) {
  for (int n = 0; n < mesh.node_count(); ++n)
    if (mesh.nodes[n].norm() < radius_A && !mesh.held[n][2]) candidates_.push_back({n, {stiffness_eV_per_A2, 0}, {}});
}

void SphereObstacle::couple(NodePairs& pairs) const {
  for (const Candidate& at : candidates_) pairs.emplace_back(indenter_, at.node);
}

void SphereObstacle::locate(const Hessian& hessian) {
  for (Candidate& at : candidates_) at.place = hessian.place(indenter_, at.node);
}

/// g = z_indenter + h(r) − z with h the lower hemisphere's height over its lowest point.
SphereObstacle::Gap SphereObstacle::gap(const Candidate& at, const Eigen::VectorXd& u) const {
  const Eigen::Vector2d x = mesh_.nodes[at.node] + u.segment<2>(3 * at.node);
  const double lift = u[3 * indenter_ + 2] - u[3 * at.node + 2];
  const double r = x.norm();
  const double on_sphere = std::min(r, cone_from * radius_A_);
  const double root = std::sqrt(radius_A_ * radius_A_ - on_sphere * on_sphere);
  const double slope = on_sphere / root;
  const double height = radius_A_ - root + slope * (r - on_sphere);
  if (r == 0) return {lift, -Eigen::Vector3d::UnitZ(), Eigen::Matrix2d::Identity() / radius_A_};
  const Eigen::Vector2d out = x / r;
  const Eigen::Matrix2d radial = out * out.transpose();
  const double bend = r > on_sphere ? 0 : radius_A_ * radius_A_ / (root * root * root);
  return {lift + height,
          {slope * out.x(), slope * out.y(), -1},
          bend * radial + slope / r * (Eigen::Matrix2d::Identity() - radial)};
}

double SphereObstacle::add_gradient(const Eigen::VectorXd& u, Eigen::VectorXd& gradient) {
  double energy = 0;
  for (const Candidate& at : candidates_) {
    const Gap g = gap(at, u);
    const double force = at.contact.force(g.value);
    energy += at.contact.energy(force);
    gradient.segment<3>(3 * at.node) -= force * g.gradient;
    gradient[3 * indenter_ + 2] -= force;
  }
  return energy;
}

/// k ∇g ∇gᵀ − ⟨λ − k g⟩ ∇²g: the second part is the node's way off a convex obstacle.
void SphereObstacle::add_hessian(const Eigen::VectorXd& u, double share, Hessian& hessian) {
  for (const Candidate& at : candidates_) {
    const Gap g = gap(at, u);
    const double force = at.contact.force(g.value);
    if (force == 0) continue;
    const auto& held = mesh_.held[at.node];
    Eigen::Matrix3d block = at.contact.stiffness * g.gradient * g.gradient.transpose();
    block.topLeftCorner<2, 2>() -= (1 - share) * force * g.curvature;
    release_held(held, held, block);
    hessian.add_diagonal(at.node, block);
    block.setZero();
    block(2, 2) = at.contact.stiffness;
    hessian.add_diagonal(indenter_, block);
    block.setZero();
    block.row(2) = at.contact.stiffness * g.gradient.transpose();
    release_held({false, false, false}, held, block);
    hessian.add(at.place, block);
  }
}

double SphereObstacle::update_multipliers(const Eigen::VectorXd& u) {
  double largest = 0;
  for (Candidate& at : candidates_) largest = std::max(largest, update(at.contact, gap(at, u).value));
  return largest;
}

double SphereObstacle::penetration(const Eigen::VectorXd& u) const {
  double deepest = 0;
  for (const Candidate& at : candidates_) {
    const Gap g = gap(at, u);
    deepest = std::max(deepest, -g.value / g.gradient.norm());
  }
  return deepest;
}

MirrorPlanes::MirrorPlanes(const Mesh& mesh, double stiffness_eV_per_A2) : mesh_(mesh) {
  double size = 0;
  for (int n = 0; n < mesh.node_count(); ++n) {
    size = std::max(size, mesh.nodes[n].lpNorm<Eigen::Infinity>());
    for (int c : {0, 1})
      if (mesh.mirrored[c] && !mesh.held[n][c]) candidates_.push_back({n, c, {stiffness_eV_per_A2, 0}});
  }
  tolerance_A_ = 1e-7 * size;
}

double MirrorPlanes::gap(const Candidate& at, const Eigen::VectorXd& u) const {
  return mesh_.nodes[at.node][at.component] + u[3 * at.node + at.component];
}

double MirrorPlanes::add_gradient(const Eigen::VectorXd& u, Eigen::VectorXd& gradient) {
  double energy = 0;
  for (const Candidate& at : candidates_) {
    const double force = at.contact.force(gap(at, u));
    energy += at.contact.energy(force);
    gradient[3 * at.node + at.component] -= force;
  }
  return energy;
}

void MirrorPlanes::add_hessian(const Eigen::VectorXd& u, double, Hessian& hessian) {
  for (const Candidate& at : candidates_) {
    if (at.contact.force(gap(at, u)) == 0) continue;
    Eigen::Matrix3d block = Eigen::Matrix3d::Zero();
    block(at.component, at.component) = at.contact.stiffness;
    hessian.add_diagonal(at.node, block);
  }
}

double MirrorPlanes::update_multipliers(const Eigen::VectorXd& u) {
  double largest = 0;
  for (Candidate& at : candidates_) largest = std::max(largest, update(at.contact, gap(at, u)));
  return largest;
}

double MirrorPlanes::penetration(const Eigen::VectorXd& u) const {
  double deepest = 0;
  for (const Candidate& at : candidates_) deepest = std::max(deepest, -gap(at, u));
  return deepest;
}

}  // namespace membrane
