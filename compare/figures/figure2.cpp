// Figure 2: a sheet of 110 Å as atoms, membrane, plates and Eq. 16.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <iterator>
#include <optional>

#include "compare/base/errors.hpp"
#include "compare/base/paper.hpp"
#include "compare/base/paths.hpp"
#include "compare/base/units.hpp"
#include "compare/figures/paper_figure.hpp"
#include "compare/fitting/curve.hpp"
#include "compare/fitting/models/eq16.hpp"
#include "compare/fitting/models/foeppl.hpp"
#include "compare/fitting/sheet_table.hpp"
#include "compare/input/case_file.hpp"
#include "compare/input/potential_file.hpp"
#include "compare/process/atoms.hpp"
#include "compare/study/study.hpp"
#include "compare/verdict/agreement.hpp"

namespace validate {
namespace {

using paper::radius_A, paper::tip_A;
// Duan & Wang's thickness for a plate of the card's E·h (the paper's reference [47]).
constexpr double duan_wang_thickness_A = 0.52;

std::vector<double> plate_depths() {
  std::vector<double> d;
  for (int i = 1; i <= 24; ++i) d.push_back(i);
  return d;
}

/// Clamped von Kármán plate: force at each depth.
std::vector<double> plate(double a, double Eh, double nu, double bending_eV, double tip) {
  std::vector<double> force;
  const FoepplDisc disc{nu, tip / a, bending_eV / (Eh * a * a)};
  for (const double d : plate_depths()) force.push_back(Eh * a * force_at(disc, d / a, 0));
  return force;
}

StudyOutcome study(const std::string& potential, const FigureContext& context) {
  Case c;
  read_case(inputs_folder() / "indentation.toml", c);
  c.potential = potential;
  c.radius_A = radius_A;
  c.tip_radius_A = tip_A;
  const std::optional<PotentialFile> file = read_potential(potential, inputs_folder() / "potentials", "--potential");
  const std::filesystem::path folder = context.work / std::filesystem::path(potential).stem();
  std::filesystem::create_directories(folder / "work");
  const AtomsLaunch launch{.program = atoms_program(), .launcher = {}, .cores = available_cores()};
  StudyOutcome outcome = run_study(Command::indentation, c, file, {launch, 0, folder}, context.progress);
  if (!outcome.failure.empty()) throw Error(ExitCode::atomistic_failed, outcome.failure);
  return outcome;
}

PlotCurve curve_of(const Run& run, const std::string& name, Colour colour) {
  PlotCurve curve{.name = name, .x = {}, .y = {}, .colour = colour};
  for (const std::size_t i : usable_points(run)) {
    curve.x.push_back(run.depth_A[i]);
    curve.y.push_back(run.force_eV_per_A[i]);
  }
  return curve;
}

PlotCurve as_line(PlotCurve curve, Line line, bool in_legend = true) {
  curve.line = line;
  curve.in_legend = in_legend;
  return curve;
}

/// A potential's atoms as markers of its own.
PlotCurve as_points(PlotCurve curve, std::size_t potential) {
  curve.points = Points{.marker = nth_marker(potential), .size = 0.9};
  return curve;
}

/// The panels of one load, in the order of the argument: what the paper compares, then every potential with continua of
/// its own constants, then what is left.
struct LoadPanels {
  Panel paper, own, ratio;
};

/// The potential's atoms, the membrane with its constants and the sheet of its own law; the lines are named once.
void add_runs(LoadPanels& panels, LoadKind load, const Result& result, const std::string& potential,
              std::size_t number) {
  const Colour colour = nth_colour(number);
  std::vector<PlotCurve>& curves = panels.own.curves;
  for (const Run& run : result.runs) {
    if (run.load != load) continue;
    if (run.is_atomistic())
      curves.push_back(as_points(curve_of(run, "atoms, " + potential, colour), number));
    else if (run.model == Model::sheet)
      curves.push_back(as_line(curve_of(run, "sheet: own law, bending", colour), {.width = 1.5}, number == 0));
    else if (run.constants == Constants::card)
      curves.push_back(
          as_line(curve_of(run, "membrane, E·h and ν of the potential", colour), {Dash::dashed, 1.2}, number == 0));
  }
}

void add_ratio(Panel& panel, LoadKind load, const Result& result, const std::string& potential, std::size_t number) {
  for (const Comparison& c : result.comparisons) {
    if (c.load != load) continue;
    PlotCurve curve{.name = potential, .x = {}, .y = {}, .colour = nth_colour(number)};
    curve.line = Line{.width = 1.2};
    curve.points = Points{.marker = nth_marker(number), .size = 0.6};
    for (std::size_t i = 0; i < c.depth_A.size(); ++i) {
      if (c.regime[i] == Regime::artefact) continue;
      curve.x.push_back(c.depth_A[i]);
      curve.y.push_back(c.force_ratio[i]);
    }
    panel.curves.push_back(std::move(curve));
  }
}

/// The paper's own comparison: its constants as membrane, shell and Eq. 16, plates of the first potential, whose atoms
/// stand beside.
void add_paper(Panel& panel, LoadKind load, const Result& result, const std::string& potential, double tip) {
  const auto add = [&](const std::string& name, const std::vector<double>& force, Colour colour, Line line) {
    panel.curves.push_back({.name = name, .x = plate_depths(), .y = force, .colour = colour, .line = line});
  };
  for (const Run& run : result.runs)
    if (run.load == load && run.constants == Constants::paper)
      panel.curves.push_back(
          as_line(curve_of(run, "membrane, the paper's constants", Colour::black), {Dash::dashed, 2}));
  std::vector<double> eq16;
  for (const double d : plate_depths()) eq16.push_back(Eq16{radius_A, paper::nu}.force(d, paper::Eh_eV_per_A2, 0));
  add("Eq. 16, the paper's constants", eq16, Colour::black, {.width = 0.8});
  add("shell, the same and κ = 1.30 eV", plate(radius_A, paper::Eh_eV_per_A2, paper::nu, paper::shell_bending_eV, tip),
      Colour::orange, {Dash::dash_dotted, 1.5});
  const CardSummary& card = *result.card;
  const double a = result.sheet->effective_radius_A;
  const double thin = card.Eh_eV_per_A2 * std::pow(duan_wang_thickness_A, 2) / (12 * (1 - card.nu * card.nu));
  add(fmt::format("plate, E·h and κ of {}", potential),
      plate(a, card.Eh_eV_per_A2, card.nu, card.bending_modulus_eV, tip), Colour::green, {.width = 1.5});
  add("plate, the same E·h, h = 0.52 Å", plate(a, card.Eh_eV_per_A2, card.nu, thin, tip), Colour::purple,
      {Dash::long_dashed, 1.5});
  for (const Run& run : result.runs)
    if (run.load == load && run.is_atomistic())
      panel.curves.push_back(as_points(curve_of(run, "atoms, " + potential, nth_colour(0)), 0));
}

void add_numbers(PaperFigure& figure) {
  constexpr double force = 20;  // eV/Å
  const std::string separate = "one-dimensional solver written separately";
  const auto depth = [&](double tip) {
    std::vector<double> d;
    for (int i = 1; i <= 40; ++i) d.push_back(0.85 * i);
    return Curve(membrane_forces({radius_A, paper::nu, tip, 0}, paper::Eh_eV_per_A2, 0, d), d).at(force).value_or(NAN);
  };
  figure.numbers.push_back(
      {"membrane, paper's constants, point: depth at 20 eV/Å", "Å", separate, 31.62, depth(0), 1e-3, ""});
  figure.numbers.push_back(
      {"membrane, paper's constants, disc of 10 Å: depth at 20 eV/Å", "Å", separate, 28.113, depth(tip_A), 1e-3, ""});
  std::vector<double> d, eq16;
  for (int i = 1; i <= 400; ++i) {
    d.push_back(0.1 * i);
    eq16.push_back(Eq16{radius_A, paper::nu}.force(d.back(), paper::Eh_eV_per_A2, 0));
  }
  figure.numbers.push_back({"Eq. 16, paper's constants: depth at 20 eV/Å", "Å", "the formula itself", 31.604,
                            Curve(eq16, d).at(force).value_or(NAN), 1e-4, ""});
}

void add_moduli(PaperFigure& figure, const Result& result, const std::string& potential) {
  figure.numbers.push_back({potential + ": E·h", "N/m", "Gil et al. 2010 (from their reference [30])",
                            paper::Eh_eV_per_A2 * N_per_m_per_eV_per_A2,
                            result.card->Eh_eV_per_A2 * N_per_m_per_eV_per_A2, 0,
                            "the paper's constants were fitted to an older molecular-mechanics curve"});
}

LoadPanels panels_of(const char* load) {
  const Axis depth{.label = "depth", .unit = "Å", .key = "depth_A", .low = 0, .high = 25};
  const Panel forces{.title = {},
                     .x = depth,
                     .y = {.label = "force", .unit = "eV/Å", .key = "force_eV_per_A", .low = 0},
                     .legend = Legend::left_top};
  LoadPanels panels{forces, forces, {}};
  panels.paper.title = load;
  panels.ratio = {.title = {},
                  .x = depth,
                  .y = {.label = "atoms / that membrane", .unit = {}, .key = "force_ratio", .low = 0.8, .high = 1.5},
                  .legend = Legend::right_top,
                  .marks = {{.along = Along::y, .at = 1}}};
  return panels;
}

}  // namespace

PaperFigure figure2(const FigureContext& context) {
  PaperFigure figure;
  figure.number = 2;
  figure.title = "a sheet of R = 110 Å: the paper's comparison, and atoms beside continua of their own constants";
  const LoadKind loads[] = {LoadKind::point, LoadKind::disc};
  LoadPanels panels[] = {panels_of("point load"), panels_of("disc of 10 Å")};
  for (std::size_t i = 0; i < context.potentials.size(); ++i) {
    const std::string& potential = context.potentials[i];
    const std::string name = std::filesystem::path(potential).stem().string();
    const StudyOutcome outcome = study(potential, context);
    for (std::size_t l = 0; l < std::size(loads); ++l) {
      add_runs(panels[l], loads[l], outcome.result, name, i);
      add_ratio(panels[l].ratio, loads[l], outcome.result, name, i);
      if (i == 0) add_paper(panels[l].paper, loads[l], outcome.result, name, loads[l] == LoadKind::disc ? tip_A : 0);
    }
    add_moduli(figure, outcome.result, name);
  }
  add_numbers(figure);
  figure.remarks.push_back(
      "the paper's constants, E = 5.864 eV/Å³ and h = 1.37 Å, are those of its reference [30]; the shell is the same "
      "with κ = E h³/12(1 − ν²); plates are von Kármán's, clamped");
  figure.panels = {panels[0].paper, panels[1].paper, panels[0].own, panels[1].own, panels[0].ratio, panels[1].ratio};
  figure.row_shares = {0.36, 0.36, 0.28};
  return figure;
}

}  // namespace validate
