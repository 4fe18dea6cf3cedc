// The case: what the user asks for, in base units, after the input file and the flags have been merged.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "compare/base/describe.hpp"
#include "compare/base/field_value.hpp"
#include "compare/base/paper.hpp"
#include "compare/base/words.hpp"
#include "compare/input/membrane_law.hpp"

namespace validate {

enum class LoadKind { point, disc, sphere, pressure };
constexpr auto words(LoadKind) {
  return std::array{Word{LoadKind::point, "point"}, Word{LoadKind::disc, "disc"}, Word{LoadKind::sphere, "sphere"},
                    Word{LoadKind::pressure, "pressure"}};
}

enum class Shape { disc, square };
constexpr auto words(Shape) { return std::array{Word{Shape::disc, "disc"}, Word{Shape::square, "square"}}; }

enum class Edge { clamped, sliding };
constexpr auto words(Edge) { return std::array{Word{Edge::clamped, "clamped"}, Word{Edge::sliding, "sliding"}}; }

/// A disc's rim. A clamped one of a sheet at a temperature is where it is at T = 0, or at the lattice constant of the
/// temperature.
enum class Rim { clamped, sliding, at_rest, thermal };
constexpr auto words(Rim) {
  return std::array{Word{Rim::clamped, "clamped"}, Word{Rim::sliding, "sliding"}, Word{Rim::at_rest, "static"},
                    Word{Rim::thermal, "thermal"}};
}

/// Part of the sheet that is meshed.
enum class Extent { quarter, full };
constexpr auto words(Extent) { return std::array{Word{Extent::quarter, "quarter"}, Word{Extent::full, "full"}}; }

enum class Models { membrane, atomistic, both };
constexpr auto words(Models) {
  return std::array{Word{Models::membrane, "membrane"}, Word{Models::atomistic, "atomistic"},
                    Word{Models::both, "both"}};
}

/// What the atoms are held against. Sheet: the potential's own law, with bending; membrane: the case's law, the paper's
/// if none is named, with the card's constants.
enum class Against { sheet, membrane };
constexpr auto words(Against) { return std::array{Word{Against::sheet, "sheet"}, Word{Against::membrane, "membrane"}}; }

/// In which units people are shown depths and forces: Å and eV/Å, nm and nN, or those in which they asked.
enum class Units { automatic, atomic, laboratory };
constexpr auto words(Units) {
  return std::array{Word{Units::automatic, "auto"}, Word{Units::atomic, "atomic"},
                    Word{Units::laboratory, "laboratory"}};
}

/// What the axis goes through.
enum class Centre { hexagon, atom };
constexpr auto words(Centre) { return std::array{Word{Centre::hexagon, "hexagon"}, Word{Centre::atom, "atom"}}; }

/// What inverts the metric of the atoms' minimiser. Automatic: by the number of atoms.
enum class Preconditioner { automatic, factor, multigrid };
constexpr auto words(Preconditioner) {
  return std::array{Word{Preconditioner::automatic, "auto"}, Word{Preconditioner::factor, "factor"},
                    Word{Preconditioner::multigrid, "multigrid"}};
}

/// Of the atoms' vibrations.
enum class Statistics { classical, quantum };
constexpr auto words(Statistics) {
  return std::array{Word{Statistics::classical, "classical"}, Word{Statistics::quantum, "quantum"}};
}

struct Case {
  Shape shape = Shape::disc;
  double radius_A = paper::radius_A;  ///< of the free disc, half the side of a square
  std::optional<double> size_A;       ///< the same in other words, see settle_size
  Edge edge = Edge::clamped;
  std::optional<Rim> rim;                       ///< of a disc, see settle_rim
  std::optional<double> rim_tension_eV_per_A2;  ///< dead force on a length of a rim that slides, outwards
  std::string potential = "airebo";             ///< empty: a membrane of given constants alone
  std::vector<LoadKind> loads = {LoadKind::point, LoadKind::disc};
  double tip_radius_A = paper::tip_A;
  std::optional<double> depth_max_A;        ///< absent: 0.22 × radius
  std::optional<double> depth_step_A;       ///< absent: 2 Å; radius / 55 for a membrane of given constants
  std::vector<double> forces_eV_per_A;      ///< replaces the depth list when not empty
  std::vector<double> pressures_eV_per_A3;  ///< levels of the load "pressure", in the order of the path
  double pretension_eV_per_A2 = 0;
  Models models = Models::both;
  Units units = Units::automatic;  ///< settled by settle_units

  // [membrane] constants given by the user: E and nu with the thickness, or none; the thickness alone is what stresses
  // are over
  std::optional<double> E_eV_per_A3, thickness_A, nu;
  MembraneLaw law;  ///< of the membrane with given constants, or with the card's
  Extent extent = Extent::quarter;
  std::optional<double>
      cells;  ///< rings of a disc, cells along a side of the meshed part of a square; absent: the solver's own
  bool unrelaxed = false;  ///< the sheet bears compression
  bool relaxed = false;    ///< the tension field alone, where the sheet that bears compression would stand beside it

  // [atomistic]
  double force_tolerance_eV_per_A = 1e-5;
  bool past_artefact = false;
  bool unloading = false;                 ///< back through the depths that were reached
  std::optional<double> switch_length_A;  ///< absent: the potential as it is
  Centre centre = Centre::hexagon;
  double rotation_deg = 0;                         ///< of the lattice
  std::vector<double> vacancies_A, stone_wales_A;  ///< places x, y, x, y, …
  Preconditioner preconditioner = Preconditioner::automatic;

  // [thermal]
  std::optional<double> temperature_K;  ///< absent: T = 0
  Statistics statistics = Statistics::classical;
  double modes = 0;                 ///< softest vibrations to write at the deepest level
  std::optional<double> sample_ps;  ///< dynamics of a level, at most; absent: none
  double error = 0.01;              ///< of the mean depth, at which it ends earlier
  double seed = 1;                  ///< of the dynamics

  // [agreement]
  LoadKind judged_load = LoadKind::disc;
  Against against = Against::sheet;
  std::vector<double> window = {0.03, 0.5};  ///< depth / effective radius
  double window_bond_A = 1.65;               ///< the window ends where the atoms' longest bond is this, if earlier
  double tolerance = 0.01;
  double regime_tolerance = 0.06;  ///< force ratio beyond which bending or softening is spoken of
};

template <class Self, class Visitor>
requires SameStruct<Self, Case>
void describe(Self& c, Visitor&& visit) {
  visit(Field{"shape", {}, "shape of the sheet"}, c.shape);
  visit(Field{"radius", unit::length, "radius of the free sheet, half the side of a square", positive()}, c.radius_A);
  visit(Field{"size", unit::length, "the same in other words: diameter of a disc, side of a square", positive()},
        c.size_A);
  visit(Field{"edge", {}, "clamped, or sliding in its plane"}, c.edge);
  visit(Field{"rim",
              {},
              "the same of a disc's rim; clamped at a temperature: static, as at T = 0, or thermal, at its "
              "lattice constant"},
        c.rim);
  visit(Field{"rim-tension", unit::membrane_force, "dead force on a length of a rim that slides, outwards", positive()}
            .with_unit(),
        c.rim_tension_eV_per_A2);
  visit(
      Field{"potential", {}, "name in inputs/potentials, or path to a TOML file; its constants are the membrane's too"},
      c.potential);
  visit(Field{.name = "loads", .meaning = "loads to run, separated by commas"}, c.loads);
  visit(Field{"tip-radius", unit::length, "radius of the loaded disc and of the sphere", positive()}, c.tip_radius_A);
  visit(Field{"depth-max", unit::length, "largest depth (0.22 of the radius if not given)", positive()}, c.depth_max_A);
  visit(Field{"depth-step", unit::length, "distance between depths (2 Å; radius/55 for given constants)", positive()},
        c.depth_step_A);
  visit(Field{"forces", unit::force, "dead-load levels instead of depths", positive()}, c.forces_eV_per_A);
  visit(Field{"pressures", unit::stress, "follower pressures of the load 'pressure', in the order of the path",
              positive()},
        c.pressures_eV_per_A3);
  visit(Field{"pretension", unit::membrane_force, "isotropic membrane force of the flat sheet", not_negative()},
        c.pretension_eV_per_A2);
  visit(Field{.name = "models", .meaning = "which models to run"}, c.models);
  visit(Field{.name = "units", .meaning = "of what is shown: Å and eV/Å, nm and nN, or as the flags' values are given"},
        c.units);

  visit(Field{"E", unit::stress, "Young's modulus of a membrane with given constants", positive(), "membrane"}
            .at_top_too(),
        c.E_eV_per_A3);
  visit(
      Field{"thickness", unit::length, "thickness that goes with E, and that stresses are over", positive(), "membrane"}
          .at_top_too(),
      c.thickness_A);
  visit(Field{"nu", {}, "Poisson's ratio that goes with E", from_to(-0.95, 0.95), "membrane"}.at_top_too(), c.nu);
  describe_law(c.law, visit);
  visit(Field{"extent", {}, "part that is meshed", {}, "membrane"}.at_top_too(), c.extent);
  visit(Field{"cells", {}, "rings of a disc, cells along a side of a square's meshed part", from_to(8, 500), "membrane"}
            .at_top_too(),
        c.cells);
  visit(Field{"unrelaxed", {}, "let the sheet bear compression: what the paper's relaxation removes", {}, "membrane"}
            .at_top_too(),
        c.unrelaxed);
  visit(Field{"relaxed",
              {},
              "under a rim tension: the tension field alone, without the sheet that bears compression",
              {},
              "membrane"}
            .at_top_too(),
        c.relaxed);

  visit(Field{"force-tolerance", unit::force, "largest force left on a free atom", from_to(1e-9, 1e-2), "atomistic"},
        c.force_tolerance_eV_per_A);
  visit(Field{"past-artefact", {}, "go on past the bond length where forces are an artefact", {}, "atomistic"},
        c.past_artefact);

  visit(Field{"unloading", {}, "go back through the depths that were reached", {}, "atomistic"}, c.unloading);
  visit(Field{"switch-length", unit::length, "move the C-C switch of AIREBO or REBO there, in a copy of its file",
              from_to(1.70, 1.99), "atomistic"},
        c.switch_length_A);
  visit(Field{"centre", {}, "what the axis goes through", {}, "atomistic"}, c.centre);
  visit(Field{"rotation-deg", {}, "turns the lattice, degrees", from_to(-360, 360), "atomistic"}, c.rotation_deg);
  visit(Field{"vacancies", unit::length, "places x,y,x,y,... whose nearest atom is missing", {}, "atomistic"},
        c.vacancies_A);
  visit(Field{"stone-wales",
              unit::length,
              "places x,y,x,y,... whose nearest bond is turned by 90 degrees",
              {},
              "atomistic"},
        c.stone_wales_A);
  visit(Field{"preconditioner", {}, "of the minimiser; auto: a factor, multigrid for large sheets", {}, "atomistic"},
        c.preconditioner);

  visit(Field{"temperature", unit::kelvin, "of the atoms; T = 0 if not given", not_negative(), "thermal"}.at_top_too(),
        c.temperature_K);
  visit(Field{"statistics", {}, "of the atoms' vibrations", {}, "thermal"}.at_top_too(), c.statistics);
  visit(Field{"modes", {}, "softest vibrations to write", from_to(0, 1000), "thermal"}.at_top_too(), c.modes);
  visit(Field{"sample", unit::picosecond, "dynamics of each level, at most", positive(), "thermal"}.at_top_too(),
        c.sample_ps);
  visit(Field{"error", unit::share, "standard error of the mean depth at which the dynamics of a level ends earlier",
              between(0, 1), "thermal"}
            .at_top_too(),
        c.error);
  visit(Field{"seed", {}, "of the dynamics", from_to(1, 1e6), "thermal"}.at_top_too(), c.seed);

  visit(Field{"judged-load", {}, "load whose curves the verdict compares", {}, "agreement"}, c.judged_load);
  visit(Field{"against", {}, "continuum that the atoms are held against", {}, "agreement"}, c.against);
  visit(Field{"window", {}, "judged range of depth / effective radius", between(0, 1), "agreement"}, c.window);
  visit(Field{"window-bond", unit::length, "longest bond at which the judged range ends, if before its upper end",
              from_to(1.3, 3), "agreement"},
        c.window_bond_A);
  visit(Field{"tolerance", {}, "largest relative force difference that passes", positive(), "agreement"}, c.tolerance);
  visit(Field{"regime-tolerance",
              {},
              "force ratio to the membrane beyond which bending or softening begins",
              positive(),
              "agreement"},
        c.regime_tolerance);
}

/// What `validate bulge` starts from: a square with sliding edges under a pressure, the paper's figure 4.
Case bulge_defaults();

/// Takes the size for the radius where a size is given. A flag wins over a file. Throws Error (bad input) where both
/// are given in the same way.
void settle_size(Case&, const Origins&);

/// Takes laboratory units where one of the user's values is in them and for drums (a membrane of given constants of
/// 0.1 µm or more); else atomic ones.
void settle_units(Case&, const std::vector<std::string>& values_given);
/// Takes the rim for the edge where one is given. Throws Error (bad input) where they say different things.
void settle_rim(Case&, const Origins&);

/// The sheet's rim slides in its plane under a dead tension.
bool has_pulled_rim(const Case&);

/// True when E, thickness and nu are given: a membrane alone, without card, atoms or verdict.
bool has_given_constants(const Case&);

bool has_load(const Case&, LoadKind);

/// Largest controlled depth: the one given, else 0.22 × radius. Å.
double largest_depth_A(const Case&);

/// Distance between controlled depths: the one given, else 2 Å, and for a membrane of given constants, which may be of
/// any size, what that is at 110 Å: radius / 55. Å.
double depth_step_A(const Case&);

/// Controlled depths in Å: step, 2 step, … and the largest depth itself as the last one. Not used with
/// forces.
std::vector<double> depth_levels(const Case&);

/// Relations between fields, which a field's own range cannot express. Returns warnings; an impossible case
/// throws Error (bad input) that names the key and, from the origins, its file and line or its flag.
std::vector<std::string> check(const Case&, const Origins& origins = {});

}  // namespace validate
