#include "membrane/triangles/model.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "membrane/base/refusal.hpp"
#include "membrane/laws/prestress.hpp"
#include "membrane/laws/principal.hpp"
#include "membrane/triangles/tuning.hpp"

namespace membrane {
namespace {

/// A round sheet of an isotropic law under a round load looks the same from every side: the prestress is
/// turned to its own axes, which makes the two planes of the quarter planes of symmetry for any prestress.
Voigt prestress_on_axes(const Problem& problem, const Mesh& mesh) {
  const Eigen::Matrix2d& p = problem.prestress_eV_per_A2;
  if (mesh.rings.empty() || mesh.copies == 1 || !is_isotropic(problem.law)) return {p(0, 0), p(1, 1), p(0, 1)};
  const Principal principal(p(0, 0), p(1, 1), p(0, 1));
  return {principal.smaller, principal.larger, 0};
}

/// What a mesh and its model want to know of a load.
struct Traits {
  double edge_A = 0;           ///< radius where it ends, or is likely to end; 0: nowhere
  bool at_centre = false;      ///< it ends in the very centre
  bool in_plane = false;       ///< leaves a sheet in its plane that nothing else pulls out of it
  double sphere_radius_A = 0;  ///< 0: no sphere
};

struct TraitsOf {
  Traits operator()(const CentreForce&) const { return {.at_centre = true}; }
  Traits operator()(const SpreadForce& spread) const { return {.edge_A = spread.radius_A}; }
  Traits operator()(const RigidSphere& sphere) const {
    return {.edge_A = ContactTuning::likely_radius * sphere.radius_A, .sphere_radius_A = sphere.radius_A};
  }
  Traits operator()(const FollowerPressure&) const { return {}; }
  Traits operator()(const EdgeMotion& motion) const { return {.in_plane = motion.in_plane()}; }
};

Traits traits_of(const Load& load) { return std::visit(TraitsOf{}, action_of(load)); }

struct PatternOf {
  const Mesh& mesh;
  Pattern operator()(const CentreForce&) const { return {mean_on_circle(mesh, 0)}; }
  Pattern operator()(const SpreadForce& load) const { return radial_pattern(mesh, load.radius_A, load.density); }
  Pattern operator()(const RigidSphere&) const { return point_pattern(mesh.node_count() + 1, mesh.node_count()); }
  Pattern operator()(const FollowerPressure&) const { return {Eigen::VectorXd::Zero(mesh.node_count())}; }
  Pattern operator()(const EdgeMotion&) const { return {Eigen::VectorXd::Zero(mesh.node_count())}; }
};

bool may_cross_planes(const Problem& problem) {
  const auto* rectangle = std::get_if<RectangleSheet>(&problem.sheet);
  return rectangle && rectangle->extent == Extent::quarter;
}

Held all_held(const Mesh& mesh, bool with_indenter, const BendingTerm* bending) {
  Held held = mesh.held;
  if (with_indenter) held.push_back({true, true, false});
  if (!bending) return held;
  const Held rotations = bending->held_rotations();
  held.insert(held.end(), rotations.begin(), rotations.end());
  return held;
}

/// Length over which a sheet that is stretched as much as it can be still bends, √(κ/E·h), Å; 0 where it does not bend.
double layer_A(const Problem& problem) {
  return problem.bending ? std::sqrt(problem.bending->mean_eV / sheet_modulus(problem.law)) : 0;
}

}  // namespace

Material material_of(const Problem& problem, const Mesh& mesh) {
  const Voigt prestress = prestress_on_axes(problem, mesh);
  const Voigt offset =
      std::visit([&]<MaterialLaw L>(const L& law) { return offset_strain(law, prestress); }, problem.law);
  if (!offset.allFinite()) refuse("prestress_eV_per_A2", prestress.transpose(), "the law cannot carry this prestress");
  return {problem.law, offset, problem.relaxed};
}

double load_radius_A(const Load& load) { return traits_of(load).edge_A; }

Mesh mesh_of(const Problem& problem) {
  const Traits load = traits_of(problem.load);
  Mesh mesh = make_mesh(problem.sheet, {load.edge_A, problem.record_radius_A, layer_A(problem), load.at_centre});
  if (load.in_plane && problem.pressure_eV_per_A3 == 0)
    for (auto& held : mesh.held) held[2] = true;  // nothing pulls it out of its plane
  return mesh;
}

Model::Model(const Problem& problem)
    : mesh_(mesh_of(problem)),
      stretching_(mesh_, material_of(problem, mesh_)),
      pressure_(mesh_),
      edge_(mesh_, problem.edge_tension_eV_per_A2),
      line_(mesh_, problem.edge),
      sphere_radius_A_(traits_of(problem.load).sphere_radius_A) {
  const double stiffness = ContactTuning::stiffness * sheet_modulus(problem.law);
  std::vector<EnergyTerm*> terms{&stretching_, &pressure_, &edge_, &line_};
  if (sphere_radius_A_ > 0) {
    sphere_ = std::make_unique<SphereObstacle>(mesh_, sphere_radius_A_, stiffness);
    obstacles_.push_back(sphere_.get());
  }
  if (problem.bending) {
    bending_ = std::make_unique<BendingTerm>(mesh_, *problem.bending, first_rotation_node());
    terms.push_back(bending_.get());
  }
  if (may_cross_planes(problem)) {
    planes_ = std::make_unique<MirrorPlanes>(mesh_, stiffness);
    obstacles_.push_back(planes_.get());
  }
  terms.insert(terms.end(), obstacles_.begin(), obstacles_.end());
  energy_ = std::make_unique<TotalEnergy>(all_held(mesh_, sphere_ != nullptr, bending_.get()), terms);
  pattern_ = std::visit(PatternOf{mesh_}, action_of(problem.load)).padded(energy_->dof_count() / 3);
}

void Model::move_edge(const EdgeMotion& motion, double level, Eigen::VectorXd& u) const {
  const Eigen::Rotation2Dd turn(level * motion.rotation_rad);
  for (int node : mesh_.edges.at(motion.edge)) {
    const Eigen::Vector2d arm = mesh_.nodes[node] - motion.pivot_A;
    u.segment<3>(3 * node) = level * motion.translation_A;
    u.segment<2>(3 * node) += turn * arm - arm;
  }
}

double Model::stretching_energy(const Eigen::VectorXd& u) {
  Eigen::VectorXd unused = Eigen::VectorXd::Zero(u.size());
  return stretching_.add_gradient(u, unused);
}

double Model::bending_energy(const Eigen::VectorXd& u) {
  Eigen::VectorXd unused = Eigen::VectorXd::Zero(u.size());
  return bending_ ? bending_->add_gradient(u, unused) : 0;
}

void Model::park_indenter(Eigen::VectorXd& u) const {
  if (sphere_) u[indenter_dof()] = 2 * mesh_.rings.back().radius_A;
}

void Model::clear_sphere(Eigen::VectorXd& u) const {
  if (!sphere_) return;
  const double lowest = u[indenter_dof()];
  for (int n = 0; n < mesh_.node_count(); ++n) {
    const double r = (mesh_.nodes[n] + u.segment<2>(3 * n)).norm();
    if (r >= sphere_radius_A_ || mesh_.held[n][2]) continue;
    const double surface = lowest + sphere_radius_A_ - std::sqrt(sphere_radius_A_ * sphere_radius_A_ - r * r);
    u[3 * n + 2] = std::min(u[3 * n + 2], surface);
  }
}

}  // namespace membrane
