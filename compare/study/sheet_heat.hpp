// What a temperature does to the calibrated sheet: by its cell's phonons, and by its own long waves.
#pragma once

#include "compare/pairing/pairing.hpp"
#include "compare/potential/warm_sheet.hpp"

namespace validate {

/// The strains whose vibrations are asked for.
std::vector<atomistic::StrainState> warm_strains(const PotentialCard& card);

/// The vibrations' free energy per area as a polynomial of the strain's invariants, Σ c I^a q^b; odd powers of q for
/// potentials whose forces have a knot at the flat sheet's angles.
class VibrationLaw {
 public:
  /// Least squares over the strains under which no vibration is unstable. Throws std::invalid_argument where these are
  /// too few.
  explicit VibrationLaw(const WarmPotential& warm);
  double operator()(double E1, double E2) const;  ///< eV/Å², less the unstrained sheet's
  double misfit() const { return misfit_; }       ///< root mean square over the range of the free energies

 private:
  struct Term {
    int a, b;
  };
  std::vector<Term> terms_;
  std::vector<double> coefficients_;
  double misfit_ = 0;
};

/// Fills the sheet's columns of the atoms' `thermal` of a load: the shifts of the conjugate depth at the atoms' depths,
/// each a central difference of the free energy along the sheet's own path, and the atoms' force over the sheet's at
/// the temperature. Nothing without atoms that were heated with a static rim, or without a calibrated sheet.
void heat_sheet(PairedLoad& load, const PotentialCard& card, const WarmPotential& warm, const atomistic::Heat& heat);

}  // namespace validate
