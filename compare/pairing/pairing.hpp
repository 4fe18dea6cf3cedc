// What makes the models the same experiment: radius, tip, clamp, pretension, constants, zero of depth. One place for
// every assumption; what to compute at which levels, and with what it is compared, follows elsewhere.
#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "atomistic/problem.hpp"
#include "compare/input/case.hpp"
#include "compare/input/potential_file.hpp"
#include "compare/pairing/sheet.hpp"
#include "compare/potential/law/calibrated_law.hpp"
#include "compare/potential/potential_card.hpp"
#include "compare/results/run.hpp"
#include "membrane/problem.hpp"

namespace validate {

/// Distance of the layers in graphite: the thickness that is usual for stresses in a sheet that has none of
/// its own.
inline constexpr double graphite_spacing_A = 3.35;

/// Why a continuum is computed. The first six are curves of the result; the last three lie on the way from a plain
/// membrane to the calibrated sheet, each with one piece of physics more, and explain the difference.
enum class Purpose {
  given,                ///< the case's own law and constants, no atoms
  like_for_like,        ///< the case's law (the paper's if none is named) with the card's constants, the atoms' radii
  paper,                ///< the paper's constants on nominal radii
  compression_borne,    ///< of a pulled rim: the same sheet round and not relaxed, to show what wrinkles relieve
  calibrated_membrane,  ///< the potential's own law, relaxed, without bending
  calibrated_sheet,     ///< the potential's own law with bending, not relaxed, since bending is what limits compression
  nominal_radii,        ///< St Venant–Kirchhoff's membrane of nominal radii
  paired_radii,         ///< the same on the atoms' radii
  bending               ///< and with bending
};

/// A curve to compute: what the leaf is asked, and the run that will hold the answer (radii and constants filled in).
/// Levels come later.
struct ContinuumExperiment {
  Purpose purpose = Purpose::given;
  Run run;
  membrane::Problem problem;
  double thickness_A = graphite_spacing_A;  ///< that stresses are over
  std::optional<LongestBond> longest_bond;  ///< where the law knows it
  double stretch = 1;                       ///< of the flat sheet, which the bond's strains must count
  double law_holds_to_A = 0;                ///< longest bond that the law is calibrated to
  double last_bond_A = 0;                   ///< the curve need not go on from there
};

struct AtomisticExperiment {
  Run run;
  atomistic::Problem problem;
};

/// One load of the case: the atoms, and the continua beside them.
struct PairedLoad {
  LoadKind load = LoadKind::disc;
  std::optional<AtomisticExperiment> atoms;
  std::vector<ContinuumExperiment> continua;
  std::optional<ContinuumExperiment>
      guide;  ///< a continuum whose shapes the atoms start from; rings do not describe defects

  /// The continuum of a purpose; null where there is none.
  const ContinuumExperiment* find(Purpose purpose) const;
};

/// What a case with a potential rests on.
struct Material {
  const PotentialFile& file;
  const PotentialCard& card;
  const PairedSheet& sheet;
};

/// Every load of a case with given constants: one membrane each.
std::vector<PairedLoad> pair(const Case& c);

/// Every load of a case with a potential: the atoms, if asked for, and the continua, if asked for.
///   Clamp: the continuum's radius is that of the free atoms' area and a margin of the lattice's, beyond which a sheet
///   that bends is held in its slope; the nominal radius where no atoms are matched.
///   Tip: a disc with the area of the loaded atoms; a rigid sphere is the same sphere.
///   Depth of record: at one bond from the axis, where the atoms' central hexagon is; at the centre of a continuum
///   alone. Constants: E·h, ν, κ from the potential's card, or its whole law. Pretension: a biaxial strain of the
///   atoms, its answer in the continuum.
std::vector<PairedLoad> pair(const Case& c, const Material& material);

}  // namespace validate
