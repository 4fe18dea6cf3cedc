// One force–depth curve: what was computed, its columns, and the fits of it.
#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "compare/base/describe.hpp"
#include "compare/base/words.hpp"
#include "compare/input/case.hpp"
#include "compare/results/fit.hpp"
#include "compare/results/known.hpp"
#include "compare/results/thermal.hpp"

namespace validate {

struct SheetPicture;

enum class Model { membrane, atomistic, sheet };  ///< sheet: a membrane that resists bending
constexpr auto words(Model) {
  return std::array{Word{Model::membrane, "membrane"}, Word{Model::atomistic, "atomistic"},
                    Word{Model::sheet, "sheet"}};
}

/// Where a continuum's constants come from. Calibrated: the potential's own law.
enum class Constants { card, paper, given, calibrated };
constexpr auto words(Constants) {
  return std::array{Word{Constants::card, "card"}, Word{Constants::paper, "paper"}, Word{Constants::given, "given"},
                    Word{Constants::calibrated, "calibrated"}};
}

/// What a continuum does with compression: wrinkles relieve it (tension field), or the sheet bears it.
enum class Compression { relieved, borne };
constexpr auto words(Compression) {
  return std::array{Word{Compression::relieved, "relieved"}, Word{Compression::borne, "borne"}};
}

/// calibration_end: a calibrated law was left; rupture: atoms that have come apart, or a sheet that has no equilibrium
/// beyond although its law holds there.
enum class Ended { depth_max, artefact, calibration_end, rupture, not_converged };
constexpr auto words(Ended) {
  return std::array{Word{Ended::depth_max, "depth_max"}, Word{Ended::artefact, "artefact"},
                    Word{Ended::calibration_end, "calibration_end"}, Word{Ended::rupture, "rupture"},
                    Word{Ended::not_converged, "not_converged"}};
}

/// In a table, also for a curve whose program failed.
inline std::string_view to_string(const std::optional<Ended>& ended) { return ended ? to_string(*ended) : "failed"; }

/// What a four times stiffer contact changes at the last depth of a sphere that presses on atoms.
struct ContactSensitivity {
  double force_change_relative = not_known;                 ///< at equal travel of the sphere
  double depth_change_A = not_known;                        ///< of the depth of record, at equal travel
  double force_change_at_equal_depth_relative = not_known;  ///< what a comparison of curves sees
  double deepest_penetration_A = not_known;                 ///< of an atom into the sphere
};

void describe(SameStruct<ContactSensitivity> auto& contact, auto&& visit) {
  visit(Field{"force_change_relative", unit::none, "force at equal travel, contact four times stiffer"},
        contact.force_change_relative);
  visit(Field{"depth_change", unit::length, "depth of record at equal travel"}, contact.depth_change_A);
  visit(Field{"force_change_at_equal_depth_relative", unit::none, "force at equal depth of record"},
        contact.force_change_at_equal_depth_relative);
  visit(Field{"deepest_penetration", unit::length, "of an atom into the sphere, at the stiffness of the run"},
        contact.deepest_penetration_A);
}

/// Places and heights along a line through the deformed sheet, in order of the place.
struct CrossSection {
  std::vector<double> x_A, z_A;
};

void describe(SameStruct<CrossSection> auto& section, auto&& visit) {
  visit(Column{"x", unit::length, "place along a line through the centre"}, section.x_A);
  visit(Column{"z", unit::length, "height there; the load presses down"}, section.z_A);
}

/// Where a sheet of atoms broke: at a force of the bracket, which is that of the deepest state it bore and what the
/// force can have grown to, along its slope, at the next depth, where it was broken.
struct Breaking {
  double force_eV_per_A = not_known;                            ///< the largest that was borne
  double depth_A = not_known;                                   ///< depth of record of the deepest state that was borne
  std::array<double, 2> bracket{not_known, not_known};          ///< forces, eV/Å
  std::array<double, 2> depth_bracket_A{not_known, not_known};  ///< depths of record
  bool past_artefact = false;                                   ///< in the artefact zone: the force is the cut-off's
  std::optional<double> sheet_force_eV_per_A, sheet_depth_A;    ///< where the calibrated sheet tears
};

void describe(SameStruct<Breaking> auto& breaking, auto&& visit) {
  visit(Field{"force", unit::force, "largest force that was borne"}, breaking.force_eV_per_A);
  visit(Field{"depth", unit::length, "depth of record of the deepest state that was borne"}, breaking.depth_A);
  visit(Field{"bracket", unit::none, "forces that the breaking force lies between, eV/Å"}, breaking.bracket);
  visit(Field{"depth_bracket", unit::length, "depths of record that the break lies between"}, breaking.depth_bracket_A);
  visit(Field{"past_artefact", unit::none, "whether it broke in the artefact zone, where forces are the cut-off's"},
        breaking.past_artefact);
  visit(Field{"sheet_force", unit::force, "at which the calibrated sheet tears; not known where its law ends before"},
        breaking.sheet_force_eV_per_A);
  visit(Field{"sheet_depth", unit::length, "depth of record at which it does"}, breaking.sheet_depth_A);
}

/// What a curve of atoms has beside the columns of every curve.
struct AtomsPart {
  std::vector<double> max_force_eV_per_A, balance_relative, force_error_relative;
  std::vector<bool> artefact;
  std::vector<int> force_evaluations, factorisations, solves;
  std::optional<Preconditioner> preconditioner;  ///< that was used; nothing where the program failed
  std::optional<ContactSensitivity> contact;     ///< for a sphere
  std::optional<Breaking> breaking;              ///< where the path broke
};

void describe(SameStruct<AtomsPart> auto& part, auto&& visit) {
  visit(Column{"artefact", unit::none, "longest bond in the potential's switching range"}, part.artefact);
  visit(Column{"max_force", unit::force, "largest force left on a free atom"}, part.max_force_eV_per_A);
  visit(Column{"balance_relative", unit::none, "the load plus the rim's reaction, over the load"},
        part.balance_relative);
  visit(Column{"force_error_relative", unit::none, "estimated error of the force, over the force"},
        part.force_error_relative);
  visit(Column{"force_evaluations", unit::none, "LAMMPS force computations for this depth"}, part.force_evaluations);
  visit(Column{"factorisations", unit::none,
               "preconditioner factorisations, or set-ups of its multigrid, for this depth"},
        part.factorisations);
  visit(Column{"solves", unit::none, "solutions with the preconditioner's factor, or multigrid cycles, for this depth"},
        part.solves);
  visit(Field{"preconditioner", unit::none, "factor or multigrid; unknown where the program failed"},
        part.preconditioner);
  visit(Field{"contact", unit::none, "what a stiffer contact changes; spheres only"}.where_known(), part.contact);
  visit(Field{"breaking", unit::none, "where the atoms broke"}.where_known(), part.breaking);
}

/// What a continuum's curve has beside the columns of every curve.
struct ContinuumPart {
  int triangles = 0;  ///< 0: solved in one dimension
  int factorisations = 0;
  std::vector<int> newton_iterations;
  // of a sheet under a pressure, or whose rim is pulled
  std::vector<double> wrinkled_area_fraction, slack_area_fraction;
  std::vector<double> compressed_area_fraction, least_membrane_force_eV_per_A2;  ///< where a rim is pulled
  std::vector<double> softest_eV_per_A2;  ///< of a sheet of triangles that bends: negative at a saddle
  std::vector<int> saddles_left;
  std::vector<double> edge_pull_in_A;  ///< of the middle of an edge, towards the centre; sliding edges
  std::vector<double> stress_1_max_eV_per_A3, stress_2_min_eV_per_A3, stress_2_max_eV_per_A3;
  std::shared_ptr<const std::vector<SheetPicture>> pictures;  ///< the solved triangles at the last depth, or every one
};

void describe(SameStruct<ContinuumPart> auto& part, auto&& visit) {
  visit(Field{"triangles", unit::none, "triangles of the mesh; 0: solved in one dimension"}, part.triangles);
  visit(Field{"factorisations", unit::none, "of the Hessian, all depths; 0 where they are not counted"},
        part.factorisations);
  visit(Column{"newton_iterations", unit::none, "Newton iterations of this depth"}, part.newton_iterations);
  visit(Column{"wrinkled_area_fraction", unit::none, "share of the area in uniaxial tension"}.where_known(),
        part.wrinkled_area_fraction);
  visit(Column{"slack_area_fraction", unit::none, "share of the area without tension"}.where_known(),
        part.slack_area_fraction);
  visit(Column{"compressed_area_fraction", unit::none, "share of the area in which a sheet bears compression"}
            .where_known(),
        part.compressed_area_fraction);
  visit(
      Column{"least_membrane_force", unit::membrane_force, "smallest principal membrane force anywhere"}.where_known(),
      part.least_membrane_force_eV_per_A2);
  visit(Column{"softest", unit::membrane_force, "second derivative of the energy along the softest direction"}
            .where_known(),
        part.softest_eV_per_A2);
  visit(Column{"saddles_left", unit::none, "states at this depth that were saddles and were left for lower ones"}
            .where_known(),
        part.saddles_left);
  visit(Column{"edge_pull_in", unit::length, "way of an edge's middle towards the centre"}.where_known(),
        part.edge_pull_in_A);
  visit(Column{"stress_1_max", unit::stress, "largest larger principal Cauchy stress"}.where_known(),
        part.stress_1_max_eV_per_A3);
  visit(Column{"stress_2_min", unit::stress, "least smaller principal Cauchy stress"}.where_known(),
        part.stress_2_min_eV_per_A3);
  visit(Column{"stress_2_max", unit::stress, "largest smaller principal Cauchy stress"}.where_known(),
        part.stress_2_max_eV_per_A3);
  visit(Field{"fields", unit::none, "the solved sheets"}.where_known(), part.pictures);
}

/// The columns are equally long, those of the part included.
struct Run {
  Model model = Model::membrane;
  LoadKind load = LoadKind::disc;
  std::optional<Constants> constants;               ///< of a continuum
  std::string law;                                  ///< by its name; empty: of atoms, or the potential's own
  double a_A = not_known, tip_A = not_known;        ///< radii as used (pairing radii where paired)
  double Eh_eV_per_A2 = not_known, nu = not_known;  ///< as used; for atoms those of the card
  double pretension_eV_per_A2 = 0;
  double record_radius_A = 0;                ///< where the depth of record is taken; 0: the centre
  double rim_tension_eV_per_A2 = not_known;  ///< dead force on a length of a rim that slides
  std::optional<Compression> compression;    ///< of a continuum whose rim is pulled
  std::optional<Ended> ended;                ///< nothing where the program that computed the curve failed
  std::string ended_reason;                  ///< in words, for the table and the log

  std::vector<double> depth_A, conjugate_depth_A, force_eV_per_A, energy_eV;
  std::vector<double> pressure_eV_per_A3,
      volume_A3;                           ///< of the load "pressure": force and conjugate depth by the flat area
  std::vector<double> rim_displacement_A;  ///< of a pulled rim, outwards
  std::vector<int> wrinkle_count;          ///< of atoms and of a sheet of triangles whose rim is pulled
  std::vector<double> wrinkle_wavelength_A, wrinkle_amplitude_A;
  std::vector<bool> converged;
  std::vector<double> longest_bond_A;  ///< atomistic: measured; calibrated: predicted from the strain

  std::variant<ContinuumPart, AtomsPart> part;

  std::optional<Thermal> thermal;           ///< of atoms, where a temperature was asked for
  std::vector<Fit> fits;                    ///< of the closed form, then of the continuum itself
  std::string fit_skipped;                  ///< why there is none
  std::vector<std::string> models_skipped;  ///< of the models that could be fitted: which was not, and why
  CrossSection cross_section;               ///< at the last level, where one is drawn

  bool is_atomistic() const { return std::holds_alternative<AtomsPart>(part); }
  AtomsPart& atoms() { return std::get<AtomsPart>(part); }
  const AtomsPart& atoms() const { return std::get<AtomsPart>(part); }
  ContinuumPart& continuum() { return std::get<ContinuumPart>(part); }
  const ContinuumPart& continuum() const { return std::get<ContinuumPart>(part); }
};

/// Gives a run the part of its model. Keeps one that fits.
void settle_part(Run& run);

template <class Self, class Visitor>
requires SameStruct<Self, Run>
void describe(Self& run, Visitor&& visit) {
  visit(Field{"model", unit::none, "membrane, atomistic or sheet (a membrane that resists bending)"}, run.model);
  if constexpr (!std::is_const_v<Self>) settle_part(run);  // what is read next depends on it
  visit(Field{"load", unit::none, "name of the load"}, run.load);
  visit(Field{"constants", unit::none,
              "where a continuum's E·h and nu come from: card, paper, given; calibrated: the potential's own law"},
        run.constants);
  visit(Field{"law", unit::none, "law of a continuum by its name; not of the potential's own"}.where_known(), run.law);
  visit(Field{"a", unit::length, "clamp radius as used"}, run.a_A);
  visit(Field{"tip", unit::length, "radius of the loaded disc or of the sphere as used"}, run.tip_A);
  visit(Field{"Eh", unit::membrane_force, "sheet modulus as used; for atoms the card's"}, run.Eh_eV_per_A2);
  visit(Field{"nu", unit::none, "Poisson's ratio as used; for atoms the card's"}, run.nu);
  visit(Field{"pretension", unit::membrane_force, "membrane force of the flat sheet"}, run.pretension_eV_per_A2);
  visit(Field{"record_radius", unit::length, "where the depth of record is taken; 0: the centre"}, run.record_radius_A);
  visit(
      Field{"rim_tension", unit::membrane_force, "dead force on a length of a rim that slides, outwards"}.where_known(),
      run.rim_tension_eV_per_A2);
  visit(
      Field{"compression", unit::none, "of a continuum: relieved by wrinkles (tension field), or borne"}.where_known(),
      run.compression);
  visit(Field{"ended", unit::none,
              "depth_max; artefact: of the atoms' potential; calibration_end: a law's; rupture: no equilibrium beyond; "
              "not_converged; unknown where its program failed"},
        run.ended);
  visit(Field{"ended_reason", unit::none, "the same in words"}, run.ended_reason);
  visit(Column{"depth", unit::length, "depth of record"}, run.depth_A);
  visit(Column{"conjugate_depth", unit::length, "depth that is work-conjugate to the force"}, run.conjugate_depth_A);
  visit(Column{"force", unit::force, "total force on the full sheet"}, run.force_eV_per_A);
  visit(Column{"pressure", unit::stress, "follower pressure"}.where_known(), run.pressure_eV_per_A3);
  visit(Column{"volume", unit::volume, "under the bulge, full sheet"}.where_known(), run.volume_A3);
  visit(Column{"energy", unit::energy, "energy relative to the flat sheet"}, run.energy_eV);
  visit(Column{"rim_displacement", unit::length, "of a pulled rim, outwards, from where it is without a load"}
            .where_known(),
        run.rim_displacement_A);
  visit(Column{"wrinkle_count", unit::none, "waves around the axis; 0: none that are told from noise"}.where_known(),
        run.wrinkle_count);
  visit(Column{"wrinkle_wavelength", unit::length, "of the wrinkles where they are highest"}.where_known(),
        run.wrinkle_wavelength_A);
  visit(Column{"wrinkle_amplitude", unit::length, "of the wrinkles there, half of crest to trough"}.where_known(),
        run.wrinkle_amplitude_A);
  visit(Column{"converged", unit::none, "equilibrium reached"}, run.converged);
  visit(Column{"longest_bond", unit::length, "longest bond of the atoms, or predicted from a calibrated law's strains"}
            .where_known(),
        run.longest_bond_A);
  visit(Field{"part", unit::none, "of the model"}, run.part);
  visit(Field{"thermal", unit::none, "what the temperature does to the curve"}.where_known(), run.thermal);
  visit(Field{"fits", unit::none, "models fitted to this curve"}, run.fits);
  visit(Field{"fit_skipped", unit::none, "why there is no fit"}.where_known(), run.fit_skipped);
  visit(Field{"models_skipped", unit::none, "which of the models was not fitted, and why"}.where_known(),
        run.models_skipped);
  visit(Field{"cross_section", unit::none, "of the sheet at the last level"}.where_known(), run.cross_section);
}

/// One run per alternative of its part, to describe them all.
std::vector<Run> prototypes(const Run&);

/// Indices of the points that fits, curves and the verdict use: converged, outside the artefact zone, with a
/// finite force at a finite, positive depth (every curve passes through the origin, so depth 0 says nothing).
std::vector<std::size_t> usable_points(const Run& run);

/// What the load is told by, point by point: the force, or the pressure.
const std::vector<double>& load_values(const Run& run);

/// Index of the first point in the artefact zone, if any.
std::optional<std::size_t> first_artefact(const Run& run);

}  // namespace validate
