// The continuum curves of a study, solved in a thread of their own while the atoms run.
#pragma once

#include <array>
#include <exception>
#include <string>
#include <thread>
#include <vector>

#include "compare/pairing/pairing.hpp"
#include "compare/results/result.hpp"
#include "compare/verdict/explanation.hpp"

namespace validate {

/// Solves a curve as far as it goes, or until an interrupt. Keeps the fields of its last converged depth, or of every
/// one.
void solve(MembraneExperiment& experiment, bool all_fields = false);

/// The same in one dimension. A law that knows its longest bond ends where the potential's artefact zone is well
/// entered: beyond, it stands for nothing.
void solve(SheetExperiment& experiment);

class Continua {
 public:
  Continua() = default;
  ~Continua() {
    if (thread_.joinable()) thread_.join();
  }
  Continua(const Continua&) = delete;
  Continua& operator=(const Continua&) = delete;

  void add(MembraneExperiment experiment) { membranes_.push_back(std::move(experiment)); }
  /// Curves of the result, and those on the way of the explanation: `law` for the part of the lattice's directions.
  void add_calibrated(std::array<SheetExperiment, 3> stages, SheetExperiment membrane, SheetExperiment sheet,
                      const CalibratedLaw& law);

  /// all_fields: keep the membranes' triangles at every depth.
  void start(bool all_fields);
  /// Waits; the seconds it took. What was thrown comes out here.
  double join();

  /// Hands the curves over to the result, and what the atoms' curves there are made of.
  void collect(Result& result);

 private:
  struct Calibrated {
    std::array<SheetExperiment, 3> stages;
    SheetExperiment membrane, sheet;
    CalibratedLaw law;
    Anisotropy anisotropy;
  };

  void solve_all(bool all_fields);

  std::vector<MembraneExperiment> membranes_;
  std::vector<Calibrated> calibrated_;
  std::exception_ptr failure_;
  double elapsed_s_ = 0;
  std::thread thread_;
};

/// Controlled levels with one more before the first and one a little beyond the last: a continuum then covers the
/// atoms' depths, although a level's depth of record is not the same in both.
std::vector<double> enclosing(const std::vector<double>& levels);

/// The same with one more between each two: curves that are cheap are known better.
std::vector<double> with_halves(const std::vector<double>& levels);

}  // namespace validate
