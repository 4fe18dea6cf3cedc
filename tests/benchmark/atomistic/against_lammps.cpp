// Side by side with LAMMPS's own minimisers: same potential, atoms, dead disc load and start (the continuum's shape),
// down to the same largest force.
//
//   atomistic_against_lammps [POTENTIAL] [RADIUS_A] [FORCE_eV_per_A] [STYLE[,…]]
//                                        exit code 1 unless cg needs 200 times the evaluations and 50 times the time
#include <fmt/format.h>

#include <chrono>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <string>

#include "atomistic/loads/load_term.hpp"
#include "atomistic/protocol/data_file.hpp"
#include "tests/atomistic/support/plain_lammps.hpp"
#include "tests/benchmark/atomistic/support.hpp"

namespace {

using namespace atomistic;
using namespace benchmark_support;
using Eigen::VectorXd;
namespace fs = std::filesystem;

struct Outcome {
  long evaluations;
  double wall_s, max_force, depth_A, rim_force;
};

double largest_norm(const VectorXd& forces) {
  return Eigen::Map<const Eigen::Matrix3Xd>(forces.data(), 3, forces.size() / 3).colwise().norm().maxCoeff();
}

double mean_depth(const std::vector<int>& atoms, const VectorXd& x) {
  double sum = 0;
  for (int atom : atoms) sum -= x[3 * atom + 2];
  return sum / static_cast<double>(atoms.size());
}

/// Clamped atoms feel no force; the loaded ones share F along −z with its potential, so that the line searches know it.
void hold_and_load(PlainLammps& lammps, const Sheet& sheet, const std::vector<int>& loaded, double force) {
  std::string ids;
  for (int atom : loaded) ids += fmt::format(" {}", atom + 1);
  lammps.command(fmt::format("group clamped id > {}", sheet.free_atoms));
  lammps.command("fix hold clamped setforce 0 0 0");
  lammps.command("group loaded id" + ids);
  lammps.command(fmt::format("variable share equal {:.17g}", force / static_cast<double>(loaded.size())));
  lammps.command("variable down equal -v_share");
  lammps.command("variable work atom v_share*z");
  lammps.command("fix tip loaded addforce 0 0 v_down energy v_work");
  lammps.command("fix_modify tip energy yes");
}

Outcome lammps_alone(const Problem& problem, const std::string& style, double force, double max_force) {
  const Sheet sheet = make_sheet(problem);
  const std::vector<int> loaded = loaded_atoms(problem.load, sheet);
  const auto load = make_load(problem, sheet);
  load->set_level(force);
  VectorXd start = sheet.positions;
  start.head(3 * sheet.free_atoms) += load->first_guess();
  const fs::path file = fs::temp_directory_path() / "against_lammps.data";
  std::ofstream(file) << data_file(problem.potential, start);
  PlainLammps lammps(problem.potential, file);
  hold_and_load(lammps, sheet, loaded, force);
  const auto begin = std::chrono::steady_clock::now();
  Outcome outcome{};
  if (style == "cg") {
    lammps.command("min_style cg");
    lammps.command("min_modify norm max");
    lammps.command(fmt::format("minimize 0 {} 1000000 1000000", max_force));
  } else {
    lammps.minimise(style,
                    max_force * std::sqrt(3.0 * sheet.free_atoms) / 10);  // the 2-norm of forces of a tenth of it
  }
  outcome.wall_s = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  outcome.evaluations = lammps.evaluations();
  lammps.command("unfix tip");
  lammps.command("unfix hold");
  lammps.command("run 0");
  VectorXd forces = lammps.gather("f", sheet.atoms());
  double rim = 0;
  for (int atom = sheet.free_atoms; atom < sheet.atoms(); ++atom) rim -= forces[3 * atom + 2];
  for (int atom : loaded) forces[3 * atom + 2] -= force / static_cast<double>(loaded.size());
  outcome.max_force = largest_norm(forces.head(3 * sheet.free_atoms));
  outcome.depth_A = mean_depth(loaded, lammps.gather("x", sheet.atoms()));
  outcome.rim_force = rim;
  fs::remove(file);
  return outcome;
}

Outcome ours(Problem problem, const MpiSession& session) {
  const Path path = follow(problem, session);
  const Step& step = path.steps.front();
  return {step.evaluations, path.wall_s, step.max_force_eV_per_A, step.conjugate_depth_A,
          step.force_eV_per_A * (1 + step.balance_relative)};
}

void print(const std::string& name, const Outcome& o) {
  fmt::print("{:8} {:8} {:9.2f} {:10.2e} {:10.4f} {:12.5f}\n", name, o.evaluations, o.wall_s, o.max_force, o.depth_A,
             o.rim_force);
  std::fflush(stdout);
}

}  // namespace

int main(int argc, char** argv) {
  const MpiSession session(&argc, &argv);
  const auto word = [&](int k, const char* otherwise) { return std::string(argc > k ? argv[k] : otherwise); };
  const double force = std::stod(word(3, "2"));
  Problem problem = disc_problem(word(1, "tersoff"), std::stod(word(2, "110")), "disc");
  problem.guides.clear();  // the same start as LAMMPS's own
  problem.control = Control::force;
  problem.levels = {force};
  fmt::print("{}, R = {} Å, disc, {} eV/Å; the force that the rim carries should be the load\n", problem.potential.name,
             problem.radius_A, force);
  fmt::print("          evals.    wall s     max|f|    depth Å   rim force\n");
  const Outcome own = ours(problem, session);
  print("ours", own);
  bool good = true;
  for (const std::string& style : split(word(4, "cg,hftn"))) {
    const Outcome theirs = lammps_alone(problem, style, force, own.max_force);
    print(style, theirs);
    const double evaluations = static_cast<double>(theirs.evaluations) / static_cast<double>(own.evaluations);
    const double time = theirs.wall_s / own.wall_s;
    const double stiffer = 3 * (own.depth_A / theirs.depth_A - 1);  // F ~ d³: what the depths say of the force
    fmt::print("         {:.0f} times the evaluations, {:.0f} times the time; force at equal depth off by {:.2f} %\n",
               evaluations, time, 100 * stiffer);
    if (style == "cg") good = evaluations >= 200 && time >= 50;
  }
  return good ? 0 : 1;
}
