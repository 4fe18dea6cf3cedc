// Uniform strain on an irregular mesh, and the derivatives of every energy of the sheet.
#include <fmt/format.h>

#include <Eigen/Geometry>
#include <cmath>
#include <limits>
#include <memory>
#include <random>

#include "compare/base/paper.hpp"
#include "compare/verify/groups.hpp"
#include "compare/verify/solved.hpp"
#include "compare/verify/taylor.hpp"
#include "membrane/laws/cauchy.hpp"
#include "membrane/laws/prestress.hpp"
#include "membrane/laws/tension_field.hpp"
#include "membrane/sheets/sheet.hpp"
#include "membrane/terms/obstacles.hpp"
#include "membrane/terms/pressure.hpp"
#include "membrane/terms/stretching.hpp"
#include "membrane/terms/total_energy.hpp"

namespace validate::verify {
namespace {

using namespace membrane;
using Gradient = Eigen::Matrix<double, 3, 2>;

using paper::nu;
constexpr double Eh = paper::Eh_eV_per_A2;
const StVenantKirchhoff law{Eh, nu};
const Voigt prestress(0.1, 0.04, -0.03);

Mesh small_disc() { return make_mesh(DiscSheet{.radius_A = 10, .rings = 8}, {3, 0}); }

/// A deformation gradient within the plane of a sheet that is turned in space.
Gradient in_space(double xx, double xy, double yx, double yy) {
  Gradient flat;
  flat << xx, xy, yx, yy, 0, 0;
  return Eigen::AngleAxisd(0.9, Eigen::Vector3d(1, 2, -0.5).normalized()).matrix() * flat;
}

struct State {
  const char* name;
  Gradient F;
};

std::vector<State> states() {
  return {{"taut", in_space(1.05, 0.02, 0.01, 1.03)},
          {"wrinkled", in_space(1.08, 0.03, -0.02, 0.8)},
          {"slack", in_space(0.9, 0.02, 0.01, 0.8)}};
}

Eigen::VectorXd affine(const Mesh& mesh, const Gradient& F, Eigen::Index dofs) {
  Eigen::VectorXd u = Eigen::VectorXd::Zero(dofs);
  for (int n = 0; n < mesh.node_count(); ++n) {
    u.segment<3>(3 * n) = F * mesh.nodes[n];
    u.segment<2>(3 * n) -= mesh.nodes[n];
  }
  return u;
}

/// Nodes inside a quarter disc: all forces on them balance.
bool inside(const Mesh& mesh, int n) { return mesh.nodes[n].minCoeff() > 0 && mesh.nodes[n].norm() < 10 * (1 - 1e-9); }

void patch(Ledger& ledger, const State& state) {
  const Material material{law, offset_strain(law, prestress), true};
  const Mesh mesh = small_disc();
  const Eigen::VectorXd u = affine(mesh, state.F, 3 * mesh.node_count());
  const Eigen::Matrix2d C = state.F.transpose() * state.F;
  const Voigt E(0.5 * (C(0, 0) - 1), 0.5 * (C(1, 1) - 1), C(0, 1));
  double strain_error = 0, unbalanced = 0;
  for (const Triangle& triangle : mesh.triangles)
    strain_error = std::max(strain_error, (strain_of(triangle, u) - E).norm());
  Eigen::VectorXd gradient = Eigen::VectorXd::Zero(u.size());
  Stretching(mesh, material).add_gradient(u, gradient);
  for (int n = 0; n < mesh.node_count(); ++n)
    if (inside(mesh, n)) unbalanced = std::max(unbalanced, gradient.segment<3>(3 * n).norm());
  ledger.begin(fmt::format("patch test, {}", state.name));
  ledger.equal("|E - (F^T F - 1)/2|", strain_error, identity(0, "affine displacements have one strain"), 1e-13);
  ledger.equal("largest force inside, eV/A", unbalanced, identity(0, "uniform stress is in equilibrium"), 1e-12);
}

/// Membrane force of all triangles under an in-plane gradient; they must agree.
Principal uniform_force(Ledger& ledger, const Eigen::Matrix2d& in_plane, bool relaxed) {
  Gradient F = Gradient::Zero();
  F.topRows<2>() = in_plane;
  const Mesh mesh = small_disc();
  const Eigen::VectorXd u = affine(mesh, F, 3 * mesh.node_count());
  const Material material{law, Voigt::Zero(), relaxed};
  const Voigt first = membrane_force(material, strain_of(mesh.triangles.front(), u));
  double spread = 0;
  for (const Triangle& triangle : mesh.triangles)
    spread = std::max(spread, (membrane_force(material, strain_of(triangle, u)) - first).norm());
  ledger.equal("spread over the mesh / Eh", spread / Eh, identity(0, "uniform strain"), 1e-13);
  return principal_forces(first);
}

void homogeneous(Ledger& ledger) {
  ledger.begin("simple shear 0.1, wrinkled");
  const Principal shear = uniform_force(ledger, Eigen::Matrix2d{{1, 0.1}, {0, 1}}, true);
  ledger.equal("S1/Eh", shear.larger / Eh, tabulated("simple_shear_force.shear_0.1"), 1e-12);
  ledger.equal("S2/Eh", shear.smaller / Eh, identity(0, "wrinkled"), 1e-15);

  ledger.begin("uniaxial, stretch 1.1 at the natural width");
  const double e = 0.105;  // (1.1² − 1)/2
  const Principal pulled =
      uniform_force(ledger, Eigen::Vector2d(1.1, std::sqrt(1 - 2 * nu * e)).asDiagonal().toDenseMatrix(), false);
  ledger.equal("S1/Eh", pulled.larger / Eh, closed_form(e, "(l1^2-1)/2 at l2^2 = 1 - nu (l1^2-1)"), 1e-13);
  const double natural = 1 - 2 * nu * e;  // the square of the other two stretches
  ledger.equal("h sigma1/Eh",
               principal_forces(cauchy_force(law, Voigt(e, -nu * e, 0), Voigt::Zero(), false)).larger / Eh,
               closed_form(1.1 * e / natural, "l1^2 S1/(l1 l2 l3), l3 = l2"), 1e-13);
  ledger.equal("S2/Eh", pulled.smaller / Eh, identity(0, "no force across"), 1e-14);
}

/// Eq. 15 through the mesh: a strip under uniaxial prestress is let go until it hangs loose.
void slack_threshold(Ledger& ledger) {
  const double s1 = 0.12, s2 = 0.05;
  const Mesh mesh = small_disc();
  const Material material{law, offset_strain(law, Voigt(s1, s2, 0)), true};
  const auto force = [&](double stretch) {
    const Eigen::VectorXd u = affine(mesh, Gradient{{stretch, 0}, {0, 0.8}, {0, 0}}, 3 * mesh.node_count());
    return membrane_force(material, strain_of(mesh.triangles.back(), u))[0];
  };
  double slack = 0.9, taut = 1.0;
  while (taut - slack > 1e-13) (force(0.5 * (slack + taut)) > 0 ? taut : slack) = 0.5 * (slack + taut);
  ledger.begin("slack threshold, prestress 0.12 | 0.05 eV/A^2");
  ledger.equal("stretch", slack,
               closed_form(std::sqrt(1 - 2 * (s1 - nu * s2) / Eh), "Eq. 15: l1^2 = 1 - 2 (s1 - nu s2)/E"), 1e-12);
}

/// Solved, not imposed: a strip between two clamps, nu = 0, is in uniaxial tension everywhere.
void pulled_strip(Ledger& ledger) {
  Problem problem;
  problem.sheet = RectangleSheet{.length_x_A = 100,
                                 .length_y_A = 40,
                                 .cells_x = 10,
                                 .cells_y = 6,
                                 .extent = Extent::full,
                                 .left = Support::clamped,
                                 .right = Support::clamped,
                                 .bottom = Support::free,
                                 .top = Support::free};
  problem.law = StVenantKirchhoff{Eh, 0};
  problem.load = EdgeMotion{.edge = Edge::right, .translation_A = {5, 0, 0}};
  problem.levels = {1};
  ledger.begin("strip of 100 x 40 A pulled by 5 %, nu = 0");
  const double l = 1.05;
  ledger.equal("edge force, eV/A", solved_last(problem).edge_force_eV_per_A.x(),
               closed_form(Eh * 40 * l * (l * l - 1) / 2, "Eh H l (l^2-1)/2"), 1e-8);
}

/// Whether the boundary follows the deformation, or stays where supports and symmetry planes hold it.
enum class Boundary { moves, held };

/// A sheet of one energy, an indenter's node included so that any may use it.
void term_orders(Ledger& ledger, const char* name, const Mesh& mesh, EnergyTerm& term,
                 Boundary boundary = Boundary::moves) {
  Held held = mesh.held;
  held.push_back({true, true, false});
  TotalEnergy total(held, {&term});
  std::mt19937 random(2);
  std::uniform_real_distribution<double> any(-1, 1);
  Eigen::VectorXd v(total.dof_count()), rough(total.dof_count());
  for (double& x : v) x = any(random);
  for (double& x : rough) x = any(random);
  total.release_held(v);
  double of_energy = std::numeric_limits<double>::infinity(), of_gradient = of_energy;
  for (const State& state : states()) {
    Eigen::VectorXd u = affine(mesh, state.F, total.dof_count()) + 1e-3 * rough;
    if (boundary == Boundary::held) total.release_held(u);
    u[u.size() - 1] = -1.5;
    Eigen::VectorXd gradient, there;
    const double energy = total.energy(u, gradient);
    Eigen::VectorXd Hv = total.hessian(u).selfadjointView<Eigen::Lower>() * v;
    total.release_held(Hv);
    const auto energy_rest = [&](double t) {
      return std::abs(total.energy(u + t * v, there) - energy - t * gradient.dot(v));
    };
    const auto gradient_rest = [&](double t) {
      total.energy(u + t * v, there);
      Eigen::VectorXd rest = there - gradient - t * Hv;
      total.release_held(rest);
      return rest.norm();
    };
    of_energy = std::min(of_energy, observed_order(energy_rest, 1e-4, 1e-12 * (1 + std::abs(energy))));
    of_gradient = std::min(of_gradient, observed_order(gradient_rest, 1e-4, 1e-12));
  }
  ledger.begin(fmt::format("energy of {}", name));
  const char* where = "least over taut, wrinkled, slack";
  ledger.equal("order of its remainder", of_energy, identity(2, "U(u+tv) - U - t dU.v = O(t^2)"), 0.075, where);
  ledger.equal("order of the gradient's remainder", of_gradient, identity(2, "dU(u+tv) - dU - t H v = O(t^2)"), 0.075,
               where);
}

void every_term(Ledger& ledger) {
  const Mesh mesh = small_disc();
  const Voigt offset = offset_strain(law, prestress);
  Stretching relaxed(mesh, {law, offset, true}), unrelaxed(mesh, {law, offset, false});
  term_orders(ledger, "stretching, relaxed", mesh, relaxed);
  term_orders(ledger, "stretching, unrelaxed", mesh, unrelaxed);
  Pressure pressure(mesh);
  pressure.set(0.03);
  // -p V belongs to the follower load where the boundary stays in its planes.
  term_orders(ledger, "pressure", mesh, pressure, Boundary::held);
  SphereObstacle sphere(mesh, 6, 20);
  Eigen::VectorXd earlier = Eigen::VectorXd::Zero(3 * mesh.node_count() + 3);
  earlier[earlier.size() - 1] = -0.7;
  sphere.update_multipliers(earlier);
  term_orders(ledger, "contact with a sphere", mesh, sphere);
}

}  // namespace

void verify_patch(Ledger& ledger) {
  for (const State& state : states()) patch(ledger, state);
  homogeneous(ledger);
  slack_threshold(ledger);
  pulled_strip(ledger);
  every_term(ledger);
}

}  // namespace validate::verify
