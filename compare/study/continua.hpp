// The continuum curves of a study, solved in a thread of their own while the atoms run.
#pragma once

#include <exception>
#include <map>
#include <thread>
#include <vector>

#include "compare/pairing/pairing.hpp"
#include "compare/verdict/explanation.hpp"

namespace validate {

/// Solves a curve as far as it goes, or until an interrupt. Of a sheet of triangles the fields of its last converged
/// level are kept, or of every one; under a pressure of every one, and their extremes become columns. `to_the_end`:
/// look for the place where a calibrated sheet tears between the levels (meridian_curve.hpp).
void solve(ContinuumExperiment& experiment, bool all_fields, bool to_the_end = true);

class Continua {
 public:
  /// Solves the continua of these loads, which must outlive it. `law`: the potential's, for the part of the explanation
  /// that the lattice's directions are; null where there is none.
  Continua(std::vector<PairedLoad>& loads, const CalibratedLaw* law, bool all_fields);
  ~Continua() {
    if (thread_.joinable()) thread_.join();
  }
  Continua(const Continua&) = delete;
  Continua& operator=(const Continua&) = delete;

  /// Waits; the seconds it took. What was thrown comes out here.
  double join();

  /// After join(): the forces of the lattice's directions, per load.
  const std::map<LoadKind, Anisotropy>& anisotropies() const { return anisotropies_; }

 private:
  void solve_all();

  std::vector<PairedLoad>& loads_;
  const CalibratedLaw* law_;
  bool all_fields_;
  std::map<LoadKind, Anisotropy> anisotropies_;
  std::exception_ptr failure_;
  double elapsed_s_ = 0;
  std::thread thread_;
};

}  // namespace validate
