// What makes the two models the same experiment: radius, tip, clamp, pretension, constants, zero of depth.
#pragma once

#include <string>
#include <vector>

#include "atomistic/problem.hpp"
#include "atomistic/sheet.hpp"
#include "compare/case.hpp"
#include "compare/result.hpp"
#include "membrane/problem.hpp"

namespace compare {

/// A curve to compute: what the leaf is asked, and the run that will hold the answer (radii and constants filled in).
struct MembraneExperiment {
  Run run;
  membrane::Problem problem;
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

CardSummary summary_of(const atomistic::Card& card);

}  // namespace compare
