// What makes the two models the same experiment: radius, tip, clamp, pretension, constants, zero of depth.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "atomistic/lattice/sheet.hpp"
#include "atomistic/problem.hpp"
#include "compare/input/case.hpp"
#include "compare/potential/law/calibrated_law.hpp"
#include "compare/results/result.hpp"
#include "membrane/meridian/sheet.hpp"
#include "membrane/problem.hpp"

namespace validate {

/// Distance of the layers in graphite: the thickness that is usual for stresses in a sheet that has none of
/// its own.
inline constexpr double graphite_spacing_A = 3.35;

/// A curve to compute: what the leaf is asked, and the run that will hold the answer (radii and constants
/// filled in).
struct MembraneExperiment {
  Run run;
  membrane::Problem problem;
  double thickness_A = graphite_spacing_A;  ///< that stresses are over
};
/// The same in one dimension.
struct SheetExperiment {
  Run run;
  membrane::axisymmetric::SheetProblem problem;
  std::optional<LongestBond> longest_bond;  ///< where the law knows it
  double stretch = 1;                       ///< of the flat sheet, which the bond's strains must count
  double last_bond_A = 0;                   ///< the curve need not go on from there
};
struct AtomisticExperiment {
  Run run;
  atomistic::Problem problem;
};

/// The sheet that the atoms of a case form, and the continuum's radii that belong to it.
class PairedSheet {
 public:
  PairedSheet(const Case& c, const atomistic::Potential& potential, const atomistic::Card& card);

  const atomistic::Sheet& sheet() const { return sheet_; }

  /// Clamp radius of the continuum, a = R + 0.75 bond: the slope clamp of the discrete bending energy lies half a bond
  /// beyond the first fixed atoms.
  double effective_radius_A() const { return sheet_.radius_A + 0.75 * sheet_.bond_A; }

  /// Radius of the continuum's disc with the area of the loaded atoms, c = √(N A_atom / π).
  double effective_tip_A(const atomistic::Load& load) const;

  double biaxial_strain() const { return strain_; }

 private:
  double strain_;
  atomistic::Sheet sheet_;
};

atomistic::Load atomistic_load(const Case& c, const std::string& load);

AtomisticExperiment atomistic_experiment(const Case& c, const atomistic::Potential& potential,
                                         const atomistic::Card& card, const PairedSheet& pair, const std::string& load,
                                         const std::vector<double>& levels);

/// The like-for-like membrane: the card's constants, the paired radii, the depth of record at one bond from the axis.
MembraneExperiment card_membrane(const Case& c, const atomistic::Card& card, const PairedSheet& pair,
                                 const std::string& load, const std::vector<double>& levels);

/// The paper's membrane: its constants (case 2) and the nominal radii, depth at the centre.
MembraneExperiment paper_membrane(const Case& c, const std::string& load, const std::vector<double>& levels);

/// A membrane with the case's own E, thickness and ν and the nominal radii, depth at the centre.
MembraneExperiment given_membrane(const Case& c, const std::string& load, const std::vector<double>& levels);

/// The potential's own law on the paired radii: Model::sheet with bending and not relaxed, since bending is what limits
/// compression; Model::membrane relaxed and without. The
/// curves end a little beyond the potential's artefact length.
SheetExperiment calibrated_experiment(const Case& c, const atomistic::Card& card, const CalibratedLaw& law,
                                      const PairedSheet& pair, const std::string& load,
                                      const std::vector<double>& levels, Model model, double artefact_bond_A);

/// Makes a sheet one of the potential's own law that bends. `stretch` is that of the flat sheet: the law counts from
/// the lattice at rest, and the prestress is its answer.
void set_calibrated(membrane::axisymmetric::SheetProblem& problem, const CalibratedLaw& law, double bending_modulus_eV,
                    double stretch);

/// St Venant–Kirchhoff's sheet with the card's constants on its way to the atoms: a membrane of nominal radii, one of
/// the paired radii, and a sheet that bends. The depth of record is the atoms' in all.
std::array<SheetExperiment, 3> plain_experiments(const Case& c, const atomistic::Card& card, const PairedSheet& pair,
                                                 const std::string& load, const std::vector<double>& levels);

/// The shapes of a continuum at its levels, as far as it goes, for the atoms to start from.
std::vector<atomistic::Guide> guides_from(const membrane::axisymmetric::SheetProblem& problem);

CardSummary summary_of(const atomistic::Card& card, double artefact_bond_A);
LawSummary summary_of(const CalibratedLaw& law, double bending_modulus_eV);

}  // namespace validate
