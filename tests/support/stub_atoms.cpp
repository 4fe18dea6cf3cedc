// Speaks validate-atoms' protocol without LAMMPS: a sheet of a known law, and faults where they are asked for. The
// job's pair style says which: "stub linear 0.5 cubic 0.01" is the force c1 d + c3 d³ at the depth d; further pairs of
// a word and a number are
//   sleep MS      before every level
//   kill N        itself, by signal 9, instead of level N
//   exit N        with status 7 instead of level N
//   lammps N      what LAMMPS does of itself instead of level N: an ERROR line in its log, status 1
//   broken N      says why instead of level N
//   file N        the same, as a file that cannot be written
//   style N       the same, as a pair style that does not exist; 0: in the card already
//   lost N        level N does not converge
#include <signal.h>
#include <unistd.h>

#include <chrono>
#include <cmath>
#include <fstream>
#include <iostream>
#include <map>
#include <numbers>
#include <sstream>
#include <thread>

#include "atomistic/protocol/event.hpp"
#include "atomistic/protocol/job.hpp"
#include "atomistic/protocol/step_file.hpp"

namespace {

using namespace atomistic;

constexpr double bond_A = 1.42;

void tell(const Event& event) { std::cout << to_line(event) << std::endl; }

class Orders {
 public:
  explicit Orders(const Potential& potential) {
    std::istringstream in(potential.pair_style);
    std::string word;
    double number = 0;
    for (in >> word; in >> word >> number;) numbers_[word] = number;
  }
  double value(const std::string& word) const { return numbers_.contains(word) ? numbers_.at(word) : 0; }
  bool at(const std::string& word, int level) const {
    return numbers_.contains(word) && static_cast<int>(numbers_.at(word)) == level;
  }

 private:
  std::map<std::string, double> numbers_;
};

[[noreturn]] void fail(const std::string& message, Fault fault) {
  tell(ErrorEvent{message, fault});
  std::exit(1);
}

void misbehave(const Orders& orders, int level, const std::string& log_file) {
  if (orders.at("kill", level)) ::kill(::getpid(), SIGKILL);
  if (orders.at("exit", level)) {
    std::cerr << "stub: said on standard error\n";
    std::exit(7);
  }
  if (orders.at("lammps", level)) {
    std::ofstream(log_file) << "units metal\npair_style stub\nERROR: Lost atoms: original 100 current 99\n";
    std::exit(1);
  }
  if (orders.at("broken", level)) fail("stub: broken as asked", Fault::program);
  if (orders.at("file", level)) fail("stub: cannot write", Fault::file);
  if (orders.at("style", level)) fail("stub: no such pair style", Fault::bad_input);
}

Card card() {
  Card c;
  c.a0_A = bond_A * std::numbers::sqrt3;
  c.energy_per_atom_eV = -7.4;
  c.C11_eV_per_A2 = 20;
  c.C12_eV_per_A2 = 5;
  c.C66_eV_per_A2 = 7.5;
  c.bending_modulus_zigzag_eV = c.bending_modulus_armchair_eV = 1;
  c.sublattice_stiffness_eV_per_A2 = 10;
  c.clamp_margin_bonds = 0.44;
  c.slope_margin_bonds = 0.37;
  return c;
}

/// Linear in Green–Lagrange strain; a bond along the larger strain.
HomogeneousState answer(const Card& c, const StrainState& strain) {
  HomogeneousState s;
  s.strain = strain;
  s.S11_eV_per_A2 = c.C11_eV_per_A2 * strain.E11 + c.C12_eV_per_A2 * strain.E22;
  s.S22_eV_per_A2 = c.C12_eV_per_A2 * strain.E11 + c.C11_eV_per_A2 * strain.E22;
  s.energy_eV_per_A2 = (s.S11_eV_per_A2 * strain.E11 + s.S22_eV_per_A2 * strain.E22) / 2;
  s.longest_bond_A = bond_A * std::sqrt(1 + 2 * std::max(strain.E11, strain.E22));
  s.converged = true;
  return s;
}

struct Work {
  const std::string& log_file;

  void operator()(const CardJob& job) const {
    misbehave(Orders(job.potential), 0, log_file);
    tell(CardEvent{card()});
    tell(EndEvent{});
  }

  void operator()(const ResponseJob& job) const {
    Response response;
    for (const StrainState& strain : job.strains) response.states.push_back(answer(job.card, strain));
    tell(ResponseEvent{response});
    tell(EndEvent{});
  }

  /// Springs to where the atoms are first.
  void operator()(const ForcesJob& job) const {
    ForcesEvent event;
    for (const Eigen::VectorXd& x : job.positions) {
      const Eigen::VectorXd off = x - job.positions.front();
      event.states.push_back({off.squaredNorm() / 2, -off});
    }
    tell(event);
    tell(EndEvent{});
  }

  void operator()(const CurveJob& job) const {
    const Orders orders(job.problem.potential);
    const auto levels = static_cast<int>(job.problem.levels.size());
    for (auto level = static_cast<int>(read_finished_steps(job.steps_folder).size()); level < levels; ++level) {
      std::this_thread::sleep_for(std::chrono::duration<double, std::milli>(orders.value("sleep")));
      misbehave(orders, level, log_file);
      const double d = job.problem.levels[static_cast<std::size_t>(level)];
      Step step;
      step.level = level;
      step.target = step.depth_A = step.conjugate_depth_A = d;
      step.converged = !orders.at("lost", level);
      step.force_eV_per_A = orders.value("linear") * d + orders.value("cubic") * d * d * d;
      step.energy_eV = orders.value("linear") * d * d / 2 + orders.value("cubic") * d * d * d * d / 4;
      step.longest_bond_A = bond_A + 1e-3 * d * d;
      step.evaluations = 10;
      write_step(step, job.steps_folder);
      tell(ProgressEvent{level, step.evaluations, 1e-6});
      tell(StepEvent{level, step_file_name(level).string()});
      if (step.converged) continue;
      tell(EndEvent{{.ended = Ended::not_converged, .reason = "lost as asked", .contact = {}}});
      return;
    }
    tell(EndEvent{{.ended = Ended::depth_max, .reason = "every level reached", .contact = {}}});
  }

  /// Of a temperature it knows nothing.
  template <class Other>
  void operator()(const Other&) const {
    tell(ErrorEvent{"the stub has no vibrations", Fault::program});
  }
};

}  // namespace

int main(int argc, char** argv) {
  if (argc != 2) return 2;
  if (std::string(argv[1]) == "--version") {
    std::cout << "20210929\n";
    return 0;
  }
  const Job job = read_job(argv[1]);
  tell(StartEvent{20210929, 1, 0});
  std::visit(Work{job.log_file}, job.work);
}
