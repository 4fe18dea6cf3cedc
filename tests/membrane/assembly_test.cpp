// The assembled sheet: patch test, consistency of energy, gradient and Hessian, objectivity.
#include "membrane/assembly.hpp"

#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <random>

#include "membrane/grading.hpp"
#include "membrane/laws/prestress.hpp"
#include "membrane/laws/tension_field.hpp"
#include "membrane/loads/pattern.hpp"
#include "membrane/quarter_disc.hpp"
#include "taylor.hpp"

namespace membrane::testing {
namespace {

const StVenantKirchhoff law{8.03368, 0.19};

Mesh small_sheet() { return quarter_disc(graded_radii({10, 3, 0, 8})).mesh; }

Eigen::VectorXd affine(const Mesh& mesh, const Eigen::Matrix<double, 3, 2>& F) {
  Eigen::VectorXd u(mesh.dof_count());
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

void hold(const Mesh& mesh, Eigen::VectorXd& v) {
  for (int n = 0; n < mesh.node_count(); ++n)
    for (int c = 0; c < 3; ++c)
      if (mesh.held[n][c]) v[3 * n + c] = 0;
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

TEST(Patch, UniformStrainIsInEquilibriumInEveryState) {
  const Mesh mesh = small_sheet();
  for (const auto& [name, F] : patch_cases()) {
    SCOPED_TRACE(name);
    const Voigt prestress(0.1, 0.04, -0.03);
    Assembly sheet(mesh, {law, offset_strain(law, prestress), true});
    const Eigen::VectorXd u = affine(mesh, F);
    const Eigen::Matrix2d E = 0.5 * (F.transpose() * F - Eigen::Matrix2d::Identity());
    const Response expected =
        tension_field(law, Voigt(Voigt(E(0, 0), E(1, 1), 2 * E(0, 1)) + offset_strain(law, prestress)));
    for (int t = 0; t < static_cast<int>(mesh.triangles.size()); ++t)
      EXPECT_LE((sheet.membrane_force(u, t) - expected.force_eV_per_A2).norm(), 1e-13);

    Eigen::VectorXd gradient;
    const double energy = sheet.energy(u, gradient);
    double area = 0;
    for (const Triangle& triangle : mesh.triangles) area += triangle.area_A2;
    const double flat = law(offset_strain(law, prestress)).energy_eV_per_A2;
    EXPECT_NEAR(energy, area * (expected.energy_eV_per_A2 - flat), 1e-12);
    for (int n = 0; n < mesh.node_count(); ++n) {
      const bool inside = mesh.nodes[n].minCoeff() > 0 && mesh.nodes[n].norm() < 10 * (1 - 1e-9);
      if (inside) {
        EXPECT_LE(gradient.segment<3>(3 * n).norm(), 1e-13);
      }
    }
  }
}

TEST(Assembly, GradientIsThatOfTheEnergyWithTheLoad) {
  const Mesh mesh = small_sheet();
  const Eigen::VectorXd load = 0.7 * disc_pattern(mesh, 3).direction();
  const Eigen::VectorXd v = random_vector(mesh.dof_count(), 2);
  for (bool relaxed : {true, false}) {
    Assembly sheet(mesh, {law, offset_strain(law, Voigt(0.1, 0.04, -0.03)), relaxed});
    const Eigen::VectorXd u = 0.2 * random_vector(mesh.dof_count(), 1);  // all three states occur
    Eigen::VectorXd gradient, unused;
    const double energy = sheet.energy(u, gradient) - load.dot(u);
    gradient -= load;
    expect_order(
        [&](double t) {
          const Eigen::VectorXd at = u + t * v;
          return std::abs(sheet.energy(at, unused) - load.dot(at) - energy - t * gradient.dot(v));
        },
        1e-4, 2, 1e-12);
  }
}

TEST(Assembly, HessianIsThatOfTheEnergy) {
  const Mesh mesh = small_sheet();
  Eigen::VectorXd v = random_vector(mesh.dof_count(), 2);
  hold(mesh, v);
  for (const auto& [name, F] : patch_cases()) {  // away from the borders, where there is no Hessian
    SCOPED_TRACE(name);
    for (bool relaxed : {true, false}) {
      Assembly sheet(mesh, {law, offset_strain(law, Voigt(0.1, 0.04, -0.03)), relaxed});
      const Eigen::VectorXd u = affine(mesh, F) + 1e-3 * random_vector(mesh.dof_count(), 1);
      Eigen::VectorXd gradient, there;
      const double energy = sheet.energy(u, gradient);
      Eigen::VectorXd Hv = sheet.hessian(u).selfadjointView<Eigen::Lower>() * v;
      hold(mesh, Hv);
      expect_order(
          [&](double t) {
            sheet.energy(u + t * v, there);
            Eigen::VectorXd remainder = there - gradient - t * Hv;
            hold(mesh, remainder);
            return remainder.norm();
          },
          1e-4, 2, 1e-13);
      expect_order(
          [&](double t) {
            return std::abs(sheet.energy(u + t * v, there) - energy - t * gradient.dot(v) -
                            0.5 * t * t * v.dot(Hv));
          },
          4e-3, 3, 1e-12);
    }
  }
}

TEST(Assembly, HeldRowsAreThoseOfTheUnitMatrix) {
  const Mesh mesh = small_sheet();
  Assembly sheet(mesh, {law, Voigt::Zero(), true});
  const Eigen::MatrixXd H =
      Eigen::MatrixXd(sheet.hessian(affine(mesh, patch_cases()[0].F))).selfadjointView<Eigen::Lower>();
  const Eigen::MatrixXd unit = Eigen::MatrixXd::Identity(H.rows(), H.cols());
  for (int dof = 0; dof < mesh.dof_count(); ++dof)
    if (mesh.held[dof / 3][dof % 3]) {
      EXPECT_EQ(H.row(dof), unit.row(dof));
    }
}

TEST(Assembly, RelaxedHessianNeverIsNegative) {
  const Mesh mesh = small_sheet();
  Assembly sheet(mesh, {law, Voigt::Zero(), true});
  const Eigen::VectorXd u = 0.2 * random_vector(mesh.dof_count(), 1);
  const Eigen::MatrixXd H = Eigen::MatrixXd(sheet.hessian(u)).selfadjointView<Eigen::Lower>();
  EXPECT_GE(Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(H).eigenvalues().minCoeff(), -1e-12);
}

TEST(Assembly, ConvexHessianOfTheUnrelaxedLawNeverIsNegative) {
  const Mesh mesh = small_sheet();
  Assembly sheet(mesh, {law, Voigt::Zero(), false});
  const Eigen::VectorXd u = 0.2 * random_vector(mesh.dof_count(), 1);
  const auto lowest = [](const Eigen::SparseMatrix<double>& lower) {
    const Eigen::MatrixXd H = Eigen::MatrixXd(lower).selfadjointView<Eigen::Lower>();
    return Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(H).eigenvalues().minCoeff();
  };
  EXPECT_LT(lowest(sheet.hessian(u)), -1e-3);
  EXPECT_GE(lowest(sheet.convex_hessian(u, 1)), -1e-12);
}

TEST(Assembly, DoesNotSeeRigidMotion) {
  const Mesh mesh = small_sheet();
  Assembly sheet(mesh, {law, offset_strain(law, Voigt(0.1, 0.04, -0.03)), true});
  const Eigen::VectorXd u = 0.2 * random_vector(mesh.dof_count(), 1);
  const Eigen::Matrix3d turn = Eigen::AngleAxisd(1.1, Eigen::Vector3d(0.3, -1, 2).normalized()).matrix();
  Eigen::VectorXd moved(u.size());
  for (int n = 0; n < mesh.node_count(); ++n) {
    const Eigen::Vector3d X(mesh.nodes[n].x(), mesh.nodes[n].y(), 0);
    moved.segment<3>(3 * n) = turn * (X + u.segment<3>(3 * n)) + Eigen::Vector3d(1, -2, 3) - X;
  }
  Eigen::VectorXd gradient, turned;
  const double energy = sheet.energy(u, gradient);
  EXPECT_NEAR(sheet.energy(moved, turned), energy, 1e-12 * std::abs(energy));
  for (int n = 0; n < mesh.node_count(); ++n)
    EXPECT_LE((turned.segment<3>(3 * n) - turn * gradient.segment<3>(3 * n)).norm(), 1e-11);
}

}  // namespace
}  // namespace membrane::testing
