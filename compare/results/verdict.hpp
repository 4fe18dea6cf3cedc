// What is said of two models' curves: the verdict, the comparison depth by depth, and what a plain membrane lacks.
#pragma once

#include <array>
#include <cmath>
#include <string>
#include <vector>

#include "compare/base/describe.hpp"
#include "compare/base/words.hpp"
#include "compare/results/known.hpp"
#include "compare/results/run.hpp"

namespace validate {

/// Whether the atoms are shown to agree with the continuum within the tolerance, shown not to, or neither: what is left
/// of the tolerance is less than the uncertainty.
enum class Outcome { agree, disagree, undecided };
constexpr auto words(Outcome) {
  return std::array{Word{Outcome::agree, "agree"}, Word{Outcome::disagree, "disagree"},
                    Word{Outcome::undecided, "undecided"}};
}

/// Standard uncertainties of a ratio by source, relative.
struct RatioShares {
  double mesh = 0, minimiser = 0;                              ///< numerical
  double clamp_radius = 0, slope_margin = 0, tip_radius = 0;   ///< of the pairing
  double bending_modulus = 0, elastic_constants = 0, law = 0;  ///< of the card
};

void describe(SameStruct<RatioShares> auto& shares, auto&& visit) {
  visit(Field{"mesh", unit::none, "elements of the continuum"}, shares.mesh);
  visit(Field{"minimiser", unit::none, "forces left on the atoms"}, shares.minimiser);
  visit(Field{"clamp_radius", unit::none, "radius at which a lattice is clamped"}, shares.clamp_radius);
  visit(Field{"slope_margin", unit::none, "radius at which its slope is"}, shares.slope_margin);
  visit(Field{"tip_radius", unit::none, "radius of the loaded disc"}, shares.tip_radius);
  visit(Field{"bending_modulus", unit::none, "of the card"}, shares.bending_modulus);
  visit(Field{"elastic_constants", unit::none, "of the card"}, shares.elastic_constants);
  visit(Field{"law", unit::none, "misfit of the calibrated law"}, shares.law);
}

/// One depth judged.
struct JudgedRatio {
  double depth_A = not_known, ratio = not_known;
  double u_numerical = 0, u_input = 0;  ///< standard uncertainties of the ratio
  RatioShares shares;

  /// Half width of the 95 % band: twice the standard uncertainty.
  double expanded() const { return 2 * std::hypot(u_numerical, u_input); }
};

void describe(SameStruct<JudgedRatio> auto& judged, auto&& visit) {
  visit(Field{"depth", unit::length, "atoms' depth of record"}, judged.depth_A);
  visit(Field{"ratio", unit::none, "F_atoms / F_continuum at that depth"}, judged.ratio);
  visit(Field{"u_numerical", unit::none, "its standard uncertainty from meshes and the minimiser"}, judged.u_numerical);
  visit(Field{"u_input", unit::none, "its standard uncertainty from what the continuum is given"}, judged.u_input);
  visit(Field{"shares", unit::none, "standard uncertainties by source"}, judged.shares);
}

struct Agreement {
  LoadKind load = LoadKind::disc;
  Model against = Model::sheet;
  std::array<double, 2> window{};  ///< depth / effective radius
  double max_relative_difference = 0, tolerance = 0;
  double expanded_uncertainty = 0;  ///< largest half width of the 95 % bands of the ratios
  std::string dominant;             ///< the source that makes most of it
  Outcome outcome = Outcome::disagree;
  std::vector<JudgedRatio> ratios;
  std::optional<Breaking> breaking;  ///< of the load judged
};

void describe(SameStruct<Agreement> auto& agreement, auto&& visit) {
  visit(Field{"outcome", unit::none,
              "agree: difference and uncertainty within the tolerance at every depth judged; disagree: the difference "
              "exceeds both at some; else undecided"},
        agreement.outcome);
  visit(Field{"load", unit::none, "load judged"}, agreement.load);
  visit(Field{"against", unit::none, "model of the continuum that the atoms are compared with"}, agreement.against);
  visit(Field{"window", unit::none, "range judged, depth / effective radius"}, agreement.window);
  visit(Field{"max_relative_difference", unit::none, "largest |F_atoms / F_continuum − 1|"},
        agreement.max_relative_difference);
  visit(Field{"tolerance", unit::none, "largest difference that passes"}, agreement.tolerance);
  visit(Field{"expanded_uncertainty", unit::none, "largest half width of the ratios' 95 % bands"},
        agreement.expanded_uncertainty);
  visit(Field{"dominant", unit::none, "the source that makes most of it"}.where_known(), agreement.dominant);
  visit(Field{"ratios", unit::none, "one entry per depth judged"}, agreement.ratios);
  visit(Field{"breaking", unit::none, "where the atoms broke, and the sheet beside them"}.where_known(),
        agreement.breaking);
}

/// What parts a sheet of atoms from the like-for-like membrane at the same depth: nothing (membrane), the largest of
/// bending and the law's softening or hardening, or two of them that cancel each other.
enum class Regime { bending, membrane, softening, hardening, cancellation, artefact };
constexpr auto words(Regime) {
  return std::array{Word{Regime::bending, "bending"},           Word{Regime::membrane, "membrane"},
                    Word{Regime::softening, "softening"},       Word{Regime::hardening, "hardening"},
                    Word{Regime::cancellation, "cancellation"}, Word{Regime::artefact, "artefact"}};
}

/// One load's atoms against the like-for-like membrane, at every depth that both have. Ratios are atoms / membrane:
/// force and energy at equal depth, depth at equal force.
struct Comparison {
  LoadKind load = LoadKind::disc;
  std::vector<double> depth_A, depth_relative, force_ratio, depth_ratio, energy_ratio;
  std::vector<double> calibrated_membrane_ratio, sheet_ratio;  ///< force over that of the calibrated continua
  std::vector<double> sheet_depth_ratio;                       ///< depth over the calibrated sheet's at equal force
  std::vector<Regime> regime;

  /// Depths where the force ratio crosses the regime tolerance: force ratio down to 1 + tolerance, down to 1 −
  /// tolerance, longest bond in the artefact zone.
  double bending_to_A = not_known, softening_from_A = not_known, artefact_from_A = not_known;
  double predicted_artefact_from_A = not_known;  ///< by the calibrated sheet's strains
};

void describe(SameStruct<Comparison> auto& comparison, auto&& visit) {
  visit(Field{"load", unit::none, "load of both curves"}, comparison.load);
  visit(Field{"bending_to", unit::length, "up to this depth the force ratio is above 1 + tolerance"},
        comparison.bending_to_A);
  visit(Field{"softening_from", unit::length, "from this depth the force ratio is below 1 − tolerance"},
        comparison.softening_from_A);
  visit(Field{"artefact_from", unit::length, "first depth in the potential's artefact zone"},
        comparison.artefact_from_A);
  visit(Field{"predicted_artefact_from", unit::length, "where the calibrated sheet's strains put its beginning"},
        comparison.predicted_artefact_from_A);
  visit(Column{"depth", unit::length, "atoms' depth of record"}, comparison.depth_A);
  visit(Column{"depth_relative", unit::none, "the same over the effective radius"}, comparison.depth_relative);
  visit(Column{"force_ratio", unit::none, "F_atoms / F_membrane at this depth"}, comparison.force_ratio);
  visit(Column{"depth_ratio", unit::none, "d_atoms / d_membrane at the atoms' force"}, comparison.depth_ratio);
  visit(Column{"energy_ratio", unit::none, "W_atoms / W_membrane at this depth"}, comparison.energy_ratio);
  visit(Column{"calibrated_membrane_ratio", unit::none, "F_atoms / F_calibrated membrane at this depth"},
        comparison.calibrated_membrane_ratio);
  visit(Column{"sheet_ratio", unit::none, "F_atoms / F_calibrated sheet with bending at this depth"},
        comparison.sheet_ratio);
  visit(Column{"sheet_depth_ratio", unit::none, "d_atoms / d_calibrated sheet at the atoms' force"},
        comparison.sheet_depth_ratio);
  visit(Column{"regime", unit::none, "bending, membrane, softening, hardening, cancellation or artefact"},
        comparison.regime);
}

/// What makes up the difference between the atoms' force and that of a plain membrane (St Venant–Kirchhoff, nominal
/// radii) at the same depth: shares of that membrane's force that add up to the whole.
struct Explanation {
  LoadKind load = LoadKind::disc;
  std::vector<double> depth_A, depth_relative;
  std::vector<double> plain_force_eV_per_A;  ///< of the membrane that is explained away
  std::vector<double> geometry;              ///< radii of clamp and tip as the atoms have them
  std::vector<double> bending;
  std::vector<double> large_strain;  ///< the potential's own response for St Venant–Kirchhoff's
  std::vector<double> anisotropy;    ///< its sixfold part; not known for a sphere, and part of the remainder there
  std::vector<double> remainder;     ///< what no continuum here has
};

void describe(SameStruct<Explanation> auto& explanation, auto&& visit) {
  visit(Field{"load", unit::none, "load explained"}, explanation.load);
  visit(Column{"depth", unit::length, "depth of record"}, explanation.depth_A);
  visit(Column{"depth_relative", unit::none, "the same over the effective radius"}, explanation.depth_relative);
  visit(Column{"plain_force", unit::force, "of the St Venant-Kirchhoff membrane with nominal radii"},
        explanation.plain_force_eV_per_A);
  visit(Column{"geometry", unit::none, "radii of clamp and tip as the atoms have them"}, explanation.geometry);
  visit(Column{"bending", unit::none, "resistance to bending"}, explanation.bending);
  visit(Column{"large_strain", unit::none, "the potential's own response at large strain"}, explanation.large_strain);
  visit(Column{"anisotropy", unit::none, "the lattice's directions"}, explanation.anisotropy);
  visit(Column{"remainder", unit::none, "what is left to the atoms' force"}, explanation.remainder);
}

/// The way back of an atomistic curve.
struct Unloading {
  LoadKind load = LoadKind::disc;
  double hysteresis_relative = not_known;  ///< work lost on the way there and back over the work put in
  std::vector<double> depth_A, conjugate_depth_A, force_eV_per_A;
};

void describe(SameStruct<Unloading> auto& unloading, auto&& visit) {
  visit(Field{"load", unit::none, "name of the load"}, unloading.load);
  visit(Field{"hysteresis_relative", unit::none, "work lost there and back, over the work put in"},
        unloading.hysteresis_relative);
  visit(Column{"depth", unit::length, "depth of record on the way back"}, unloading.depth_A);
  visit(Column{"conjugate_depth", unit::length, "depth that is work-conjugate to the force"},
        unloading.conjugate_depth_A);
  visit(Column{"force", unit::force, "total force on the full sheet"}, unloading.force_eV_per_A);
}

}  // namespace validate
