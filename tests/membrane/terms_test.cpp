// Every term of the total energy: patch test, consistency of energy, gradient and Hessian, objectivity.
#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <functional>
#include <memory>
#include <random>

#include "membrane/laws/prestress.hpp"
#include "membrane/laws/tension_field.hpp"
#include "membrane/sheets/sheet.hpp"
#include "membrane/terms/obstacles.hpp"
#include "membrane/terms/pressure.hpp"
#include "membrane/terms/stretching.hpp"
#include "membrane/terms/total_energy.hpp"
#include "taylor.hpp"

namespace membrane::testing {
namespace {

const StVenantKirchhoff law{8.03368, 0.19};

Mesh small_sheet() { return make_mesh(DiscSheet{.radius_A = 10, .rings = 8}, {3, 0}); }

Eigen::VectorXd affine(const Mesh& mesh, const Eigen::Matrix<double, 3, 2>& F) {
  Eigen::VectorXd u(3 * mesh.node_count());
  for (int n = 0; n < mesh.node_count(); ++n)
    u.segment<3>(3 * n) = F * mesh.nodes[n] - Eigen::Vector3d(mesh.nodes[n].x(), mesh.nodes[n].y(), 0);
  return u;
}

Eigen::VectorXd random_vector(Eigen::Index size, unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> any(-1, 1);
  Eigen::VectorXd v(size);
  for (double& x : v) x = any(random);
  return v;
}

struct PatchCase {
  const char* name;
  Eigen::Matrix<double, 3, 2> F;
};

std::vector<PatchCase> patch_cases() {
  const Eigen::Matrix3d turn = Eigen::AngleAxisd(0.9, Eigen::Vector3d(1, 2, -0.5).normalized()).matrix();
  const auto in_space = [&](double a, double b, double c, double d) -> Eigen::Matrix<double, 3, 2> {
    Eigen::Matrix<double, 3, 2> flat;
    flat << a, b, c, d, 0, 0;
    return turn * flat;
  };
  return {{"taut", in_space(1.05, 0.02, 0.01, 1.03)},
          {"wrinkled", in_space(1.08, 0.03, -0.02, 0.8)},
          {"slack", in_space(0.9, 0.02, 0.01, 0.8)}};
}

const Voigt prestress(0.1, 0.04, -0.03);

Material material(bool relaxed) { return {law, offset_strain(law, prestress), relaxed}; }

/// A sheet of one term, an indenter's node included so that any term may use it.
struct Single {
  const Mesh mesh = small_sheet();
  std::unique_ptr<EnergyTerm> term;
  std::unique_ptr<TotalEnergy> total;

  explicit Single(std::function<std::unique_ptr<EnergyTerm>(const Mesh&)> make) : term(make(mesh)) {
    Held held = mesh.held;
    held.push_back({true, true, false});
    total = std::make_unique<TotalEnergy>(held, std::vector{term.get()});
  }
};

struct NamedTerm {
  const char* name;
  std::function<std::unique_ptr<EnergyTerm>(const Mesh&)> make;
  bool needs_closed_boundary = false;  ///< it has a potential only where the boundary keeps to its planes
};

/// Every term, the obstacles with contact forces from an earlier round.
const NamedTerm terms[] = {
    {"stretching, relaxed", [](const Mesh& mesh) { return std::make_unique<Stretching>(mesh, material(true)); }},
    {"stretching, unrelaxed", [](const Mesh& mesh) { return std::make_unique<Stretching>(mesh, material(false)); }},
    {"pressure",
     [](const Mesh& mesh) {
       auto term = std::make_unique<Pressure>(mesh);
       term->set(0.03);
       return term;
     },
     true},
    {"sphere",
     [](const Mesh& mesh) {
       auto term = std::make_unique<SphereObstacle>(mesh, 6, 20);
       Eigen::VectorXd earlier = Eigen::VectorXd::Zero(3 * mesh.node_count() + 3);
       earlier[earlier.size() - 1] = -0.7;
       term->update_multipliers(earlier);
       return term;
     }},
    {"mirror planes",
     [](const Mesh& mesh) {
       auto term = std::make_unique<MirrorPlanes>(mesh, 20);
       Eigen::VectorXd earlier = Eigen::VectorXd::Constant(3 * mesh.node_count() + 3, -2.5);
       term->update_multipliers(earlier);
       return term;
     }},
};

/// A state in which every term acts: one of the patch cases, roughened, with the sphere pressed in.
Eigen::VectorXd state(const Mesh& mesh, const Eigen::Matrix<double, 3, 2>& F, double roughness) {
  Eigen::VectorXd u = Eigen::VectorXd::Zero(3 * mesh.node_count() + 3);
  u.head(3 * mesh.node_count()) = affine(mesh, F) + roughness * random_vector(3 * mesh.node_count(), 1);
  u[u.size() - 1] = -1.5;
  return u;
}

class Term : public ::testing::TestWithParam<NamedTerm> {
 protected:
  Single one{GetParam().make};
  Eigen::VectorXd v = random_vector(3 * one.mesh.node_count() + 3, 2);
};

TEST_P(Term, GradientIsThatOfTheEnergy) {
  Eigen::VectorXd u = state(one.mesh, patch_cases()[0].F, 0.2);  // all three states of the sheet occur
  if (GetParam().needs_closed_boundary) one.total->release_held(u);
  one.total->release_held(v);
  Eigen::VectorXd gradient, unused;
  const double energy = one.total->energy(u, gradient);
  EXPECT_GT(gradient.norm(), 1e-3);
  expect_order([&](double t) { return std::abs(one.total->energy(u + t * v, unused) - energy - t * gradient.dot(v)); },
               1e-4, 2, 1e-12 * (1 + std::abs(energy)));
}

TEST_P(Term, HessianIsThatOfTheEnergy) {
  one.total->release_held(v);
  for (const auto& [name, F] : patch_cases()) {  // away from the borders, where there is no Hessian
    SCOPED_TRACE(name);
    Eigen::VectorXd u = state(one.mesh, F, 1e-3);
    if (GetParam().needs_closed_boundary) one.total->release_held(u);
    Eigen::VectorXd gradient, there;
    const double energy = one.total->energy(u, gradient);
    Eigen::VectorXd Hv = one.total->hessian(u).selfadjointView<Eigen::Lower>() * v;
    one.total->release_held(Hv);
    expect_order(
        [&](double t) {
          one.total->energy(u + t * v, there);
          Eigen::VectorXd remainder = there - gradient - t * Hv;
          one.total->release_held(remainder);
          return remainder.norm();
        },
        1e-4, 2, 1e-12);
    expect_order(
        [&](double t) {
          return std::abs(one.total->energy(u + t * v, there) - energy - t * gradient.dot(v) - 0.5 * t * t * v.dot(Hv));
        },
        4e-3, 3, 1e-12 * (1 + std::abs(energy)));
  }
}

TEST_P(Term, WithoutItsNegativeCurvatureIsPositive) {
  const Eigen::VectorXd u = state(one.mesh, patch_cases()[2].F, 0.2);
  const Eigen::MatrixXd H = Eigen::MatrixXd(one.total->hessian(u, 1)).selfadjointView<Eigen::Lower>();
  EXPECT_GE(Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(H).eigenvalues().minCoeff(), -1e-12);
}

TEST_P(Term, HeldRowsAreThoseOfTheUnitMatrix) {
  const Eigen::VectorXd u = state(one.mesh, patch_cases()[0].F, 1e-3);
  const Eigen::MatrixXd H = Eigen::MatrixXd(one.total->hessian(u)).selfadjointView<Eigen::Lower>();
  const Eigen::MatrixXd unit = Eigen::MatrixXd::Identity(H.rows(), H.cols());
  for (int dof = 0; dof < 3 * one.mesh.node_count(); ++dof)
    if (one.mesh.held[dof / 3][dof % 3]) {
      EXPECT_EQ(H.row(dof), unit.row(dof));
    }
}

INSTANTIATE_TEST_SUITE_P(Energies, Term, ::testing::ValuesIn(terms), [](const auto& tested) {
  std::string name = tested.param.name;
  std::erase_if(name, [](char c) { return !std::isalnum(c); });
  return name;
});

TEST(Patch, UniformStrainIsInEquilibriumInEveryState) {
  for (const auto& [name, F] : patch_cases()) {
    SCOPED_TRACE(name);
    Single one([](const Mesh& mesh) { return std::make_unique<Stretching>(mesh, material(true)); });
    const Mesh& mesh = one.mesh;
    const Eigen::VectorXd u = state(mesh, F, 0);
    const Eigen::Matrix2d E = 0.5 * (F.transpose() * F - Eigen::Matrix2d::Identity());
    const Voigt strain(E(0, 0), E(1, 1), 2 * E(0, 1));
    const Response expected = tension_field(law, Voigt(strain + material(true).offset_strain));
    for (const Triangle& triangle : mesh.triangles) {
      EXPECT_LE((strain_of(triangle, u) - strain).norm(), 1e-14);
      EXPECT_LE((membrane_force(material(true), strain_of(triangle, u)) - expected.force_eV_per_A2).norm(), 1e-13);
    }
    Eigen::VectorXd gradient;
    const double energy = one.total->energy(u, gradient);
    const double flat = law(material(true).offset_strain).energy_eV_per_A2;
    EXPECT_NEAR(energy, mesh.area_A2() * (expected.energy_eV_per_A2 - flat), 1e-12);
    for (int n = 0; n < mesh.node_count(); ++n) {
      const bool inside = mesh.nodes[n].minCoeff() > 0 && mesh.nodes[n].norm() < 10 * (1 - 1e-9);
      if (inside) {
        EXPECT_LE(gradient.segment<3>(3 * n).norm(), 1e-13);
      }
    }
  }
}

TEST(Stretching, RelaxedHessianNeverIsNegativeAndTheUnrelaxedOneIs) {
  for (bool relaxed : {true, false}) {
    Single one([&](const Mesh& mesh) {
      return std::make_unique<Stretching>(mesh, Material{law, Voigt::Zero(), relaxed});
    });
    const Eigen::VectorXd u = state(one.mesh, patch_cases()[2].F, 0.2);
    const Eigen::MatrixXd H = Eigen::MatrixXd(one.total->hessian(u)).selfadjointView<Eigen::Lower>();
    const double lowest = Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(H).eigenvalues().minCoeff();
    if (relaxed)
      EXPECT_GE(lowest, -1e-12);
    else
      EXPECT_LT(lowest, -1e-3);
  }
}

TEST(Stretching, DoesNotSeeRigidMotion) {
  Single one([](const Mesh& mesh) { return std::make_unique<Stretching>(mesh, material(true)); });
  const Mesh& mesh = one.mesh;
  const Eigen::VectorXd u = state(mesh, patch_cases()[0].F, 0.2);
  const Eigen::Matrix3d turn = Eigen::AngleAxisd(1.1, Eigen::Vector3d(0.3, -1, 2).normalized()).matrix();
  Eigen::VectorXd moved = u;
  for (int n = 0; n < mesh.node_count(); ++n) {
    const Eigen::Vector3d X(mesh.nodes[n].x(), mesh.nodes[n].y(), 0);
    moved.segment<3>(3 * n) = turn * (X + u.segment<3>(3 * n)) + Eigen::Vector3d(1, -2, 3) - X;
  }
  Eigen::VectorXd gradient, turned;
  const double energy = one.total->energy(u, gradient);
  EXPECT_NEAR(one.total->energy(moved, turned), energy, 1e-12 * std::abs(energy));
  for (int n = 0; n < mesh.node_count(); ++n)
    EXPECT_LE((turned.segment<3>(3 * n) - turn * gradient.segment<3>(3 * n)).norm(), 1e-11);
}

TEST(Pressure, IsTheFollowerLoadOnEveryTriangle) {
  // p n dA shared by the corners of each triangle: inside the sheet the sum over the triangles is the same.
  Single one(terms[2].make);
  const Mesh& mesh = one.mesh;
  const Eigen::VectorXd u = state(mesh, patch_cases()[0].F, 0.2);
  Eigen::VectorXd gradient;
  one.total->energy(u, gradient);
  Eigen::VectorXd expected = Eigen::VectorXd::Zero(gradient.size());
  const auto at = [&](int n) -> Eigen::Vector3d {
    return Eigen::Vector3d(mesh.nodes[n].x(), mesh.nodes[n].y(), 0) + u.segment<3>(3 * n);
  };
  for (const Triangle& t : mesh.triangles) {
    const Eigen::Vector3d normal_area = 0.5 * (at(t.nodes[1]) - at(t.nodes[0])).cross(at(t.nodes[2]) - at(t.nodes[0]));
    for (int node : t.nodes) expected.segment<3>(3 * node) += 0.03 / 3 * normal_area;
  }
  for (int n = 0; n < mesh.node_count(); ++n) {
    const bool inside = mesh.nodes[n].minCoeff() > 0 && mesh.nodes[n].norm() < 10 * (1 - 1e-9);
    if (inside) {
      EXPECT_LE((gradient + expected).segment<3>(3 * n).norm(), 1e-13);
    }
  }
}

TEST(Pressure, VolumeOfAPyramid) {
  const Mesh mesh = make_mesh(RectangleSheet{.length_x_A = 2, .length_y_A = 4, .cells_x = 1, .cells_y = 1});
  Eigen::VectorXd u = Eigen::VectorXd::Zero(3 * mesh.node_count());
  u[2] = 3;  // the apex over the middle
  EXPECT_NEAR(4 * Pressure(mesh).volume(u), 2.0 * 4 * 3 / 3, 1e-14);
}

}  // namespace
}  // namespace membrane::testing
