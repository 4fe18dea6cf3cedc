// Our states and forces before LAMMPS's own means: `run 0`, `fix indent` and `min_style hftn` on a written data file.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "atomistic/loads/load_term.hpp"
#include "atomistic/protocol/data_file.hpp"
#include "tests/atomistic/support/paths.hpp"
#include "tests/atomistic/support/plain_lammps.hpp"

namespace {

using namespace atomistic;
using Eigen::VectorXd;
namespace fs = std::filesystem;

/// LAMMPS alone on the atoms of a state; the data file lives as long.
class Judge {
 public:
  Judge(const Potential& potential, const VectorXd& positions)
      : file_(written(potential, positions)), lammps_(potential, file_) {}
  ~Judge() { fs::remove(file_); }
  PlainLammps& lammps() { return lammps_; }

 private:
  static fs::path written(const Potential& potential, const VectorXd& positions) {
    const fs::path file = fs::temp_directory_path() / fmt::format("judge-{}-{}.data", potential.name, ::getpid());
    std::ofstream(file) << data_file(potential, positions);
    return file;
  }
  fs::path file_;
  PlainLammps lammps_;
};

std::string ids(const std::vector<int>& atoms) {
  std::string list;
  for (int atom : atoms) list += fmt::format(" {}", atom + 1);
  return list;
}

class JudgedBy : public testing::TestWithParam<std::string> {};

TEST_P(JudgedBy, RunZeroOnTheWrittenFile) {
  const Problem p = problem_of(GetParam(), 20, DiscLoad{6}, {3});
  const Step step = follow(p).steps[0];
  Judge judge(p.potential, step.positions);
  judge.lammps().command("run 0");
  const int atoms = static_cast<int>(step.positions.size()) / 3;
  EXPECT_LT((judge.lammps().gather("f", atoms) - step.forces).cwiseAbs().maxCoeff(), 1e-9);
  const Sheet sheet = make_sheet(p);
  Judge flat(p.potential, sheet.positions);
  flat.lammps().command("run 0");
  EXPECT_NEAR(judge.lammps().thermo("pe") - flat.lammps().thermo("pe"), step.energy_eV,
              1e-8 * std::abs(step.energy_eV) + 1e-7);
}

INSTANTIATE_TEST_SUITE_P(Shipped, JudgedBy, testing::ValuesIn(shipped_potentials()), test_name);

/// A converged state is a minimum: LAMMPS's Hessian-free truncated Newton, started from it with the loaded atoms'
/// depths and the ring held, hardly moves energy or force.
class MinimumOf : public testing::TestWithParam<std::string> {};

TEST_P(MinimumOf, HessianFreeNewtonStays) {
  const Problem p = problem_of(GetParam(), 30, DiscLoad{6}, {1, 2, 3});
  const Path path = follow(p);
  const Step& step = path.steps.back();
  const Sheet sheet = make_sheet(p);
  Judge judge(p.potential, step.positions);
  PlainLammps& lammps = judge.lammps();
  lammps.command(fmt::format("group clamped id > {}", sheet.free_atoms));
  lammps.command("fix hold clamped setforce 0 0 0");
  lammps.command("group loaded id" + ids(loaded_atoms(p.load, sheet)));
  lammps.command("fix depth loaded setforce NULL NULL 0");
  lammps.command("run 0");
  const double before = lammps.thermo("pe");
  lammps.minimise("hftn", 1e-5);
  lammps.command("unfix depth");
  lammps.command("run 0");
  EXPECT_LT(std::abs(lammps.thermo("pe") - before), 1e-8 * sheet.free_atoms);
  const VectorXd forces = lammps.gather("f", sheet.atoms());
  double tip = 0;
  for (int atom : loaded_atoms(p.load, sheet)) tip += forces[3 * atom + 2];
  EXPECT_NEAR(tip, step.force_eV_per_A, 1e-3 * step.force_eV_per_A);
}

INSTANTIATE_TEST_SUITE_P(Some, MinimumOf, testing::Values("airebo", "tersoff"), test_name);

/// Our sphere is LAMMPS's: at our converged state `fix indent` leaves no force on a free atom, and the same tip force.
TEST(Sphere, IsFixIndent) {
  const Problem p = problem_of("tersoff", 20, SphereLoad{.radius_A = 8}, {1, 2});
  const Path path = follow(p);
  ASSERT_EQ(path.steps.size(), 2u) << path.report.reason;
  const Step& step = path.steps.back();
  Judge judge(p.potential, step.positions);
  PlainLammps& lammps = judge.lammps();
  const SphereLoad& sphere = std::get<SphereLoad>(p.load);
  lammps.command(fmt::format("fix tip all indent {} sphere 0 0 {:.17g} {} units box", sphere.stiffness_eV_per_A3,
                             sphere.radius_A - step.conjugate_depth_A, sphere.radius_A));
  lammps.command("variable tip equal f_tip[3]");
  lammps.command("run 0");
  const int free_dofs = 3 * make_sheet(p).free_atoms;
  EXPECT_LT(lammps.gather("f", static_cast<int>(step.positions.size()) / 3).head(free_dofs).cwiseAbs().maxCoeff(),
            1e-5);
  EXPECT_NEAR(lammps.variable("tip"), step.force_eV_per_A, 1e-9 * step.force_eV_per_A);
}

}  // namespace
