// All that a command can produce: one tree, from which every document is a walk. Base units Å, eV; the N/m twins are
// made where a document is written.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "compare/base/describe.hpp"
#include "compare/base/words.hpp"
#include "compare/input/case.hpp"
#include "compare/results/card.hpp"
#include "compare/results/checks.hpp"
#include "compare/results/design.hpp"
#include "compare/results/many.hpp"
#include "compare/results/measured.hpp"
#include "compare/results/provenance.hpp"
#include "compare/results/published.hpp"
#include "compare/results/recording.hpp"
#include "compare/results/run.hpp"
#include "compare/results/verdict.hpp"

namespace validate {

/// Number of the documents' form, in every one of them.
inline constexpr int document_schema = 2;

enum class Command { indentation, bulge, fit, potential, figure, verify, batch, published, curve, design };
constexpr auto words(Command) {
  return std::array{Word{Command::indentation, "indentation"},
                    Word{Command::bulge, "bulge"},
                    Word{Command::fit, "fit"},
                    Word{Command::potential, "potential"},
                    Word{Command::figure, "figure"},
                    Word{Command::verify, "verify"},
                    Word{Command::batch, "batch"},
                    Word{Command::published, "published"},
                    Word{Command::curve, "curve"},
                    Word{Command::design, "design"}};
}

/// The sheet of atoms.
struct SheetSummary {
  double radius_A = 0, effective_radius_A = 0;
  double slope_margin_A = 0;  ///< by which the slope of a sheet that bends is held farther out
  double clamp_radius_error_A = 0, slope_margin_error_A = 0, tip_radius_error_A = 0;  ///< standard errors
  double flat_tension_eV_per_A2 =
      not_known;                            ///< of a pulled rim: inside the flat sheet, the edge's own stress included
  double edge_stress_eV_per_A = not_known;  ///< force of the free edge unstretched; negative: it pushes outwards
  double edge_stiffness_eV_per_A = not_known;  ///< and its growth with the edge's strain
  int atoms = 0, free_atoms = 0, loaded_disc_atoms = 0;
};

void describe(SameStruct<SheetSummary> auto& sheet, auto&& visit) {
  visit(Field{"radius", unit::length, "nominal radius of the free sheet"}, sheet.radius_A);
  visit(Field{"effective_radius", unit::length, "clamp radius of the paired continuum"}, sheet.effective_radius_A);
  visit(Field{"slope_margin", unit::length, "by which the slope of a sheet that bends is held farther out"},
        sheet.slope_margin_A);
  visit(Field{"clamp_radius_error", unit::length, "standard error of the effective radius"},
        sheet.clamp_radius_error_A);
  visit(Field{"slope_margin_error", unit::length, "standard error of that margin"}, sheet.slope_margin_error_A);
  visit(Field{"tip_radius_error", unit::length, "standard error of a loaded disc's radius"}, sheet.tip_radius_error_A);
  visit(Field{"flat_tension", unit::membrane_force,
              "of a pulled rim: inside the flat sheet, the edge's own stress included"}
            .where_known(),
        sheet.flat_tension_eV_per_A2);
  visit(Field{"edge_stress", unit::force, "force of the free edge, unstretched; negative: it pushes the rim outwards"}
            .where_known(),
        sheet.edge_stress_eV_per_A);
  visit(Field{"edge_stiffness", unit::force, "growth of that force with the edge's strain, beyond the sheet's own"}
            .where_known(),
        sheet.edge_stiffness_eV_per_A);
  visit(Field{"atoms", unit::none, "atoms, clamped ring included", positive()}, sheet.atoms);
  visit(Field{"free_atoms", unit::none, "atoms that move"}, sheet.free_atoms);
  visit(Field{"loaded_disc_atoms", unit::none, "atoms that carry the disc load"}, sheet.loaded_disc_atoms);
}

struct Result;

/// One case of a batch.
struct CaseOutcome {
  std::string potential;
  double radius_A = not_known;
  std::string folder;                     ///< below the batch's
  int exit_code = 0;                      ///< as if it had been run alone
  std::shared_ptr<const Result> summary;  ///< null where it failed before there was one
};

void describe(SameStruct<CaseOutcome> auto& one, auto&& visit) {
  visit(Field{"potential", unit::none, "potential of the case"}, one.potential);
  visit(Field{"radius", unit::length, "radius of the case"}, one.radius_A);
  visit(Field{"folder", unit::none, "of the case, below the batch's"}, one.folder);
  visit(Field{"exit_code", unit::none, "of the case, as if it had been run alone"}, one.exit_code);
  visit(Field{"summary", unit::none, "the case's own document; null where it failed before there was one"},
        one.summary);
}

struct Result {
  int schema = document_schema;
  Command command = Command::indentation;
  int exit_code = 0;        ///< as the program ends; see the README's table
  std::string exit_reason;  ///< of any but 0, in words

  // indentation, bulge
  Case resolved;
  std::optional<SheetSummary> sheet;  ///< absent where no atoms were asked for
  std::optional<CardSummary> card;
  std::vector<WarmSheet> warm;  ///< where a temperature was asked for
  std::optional<LawSummary> law;
  std::string law_missing;  ///< why there is none
  std::vector<Run> runs;
  std::optional<Agreement> agreement;
  std::string agreement_skipped;          ///< why there is no verdict
  std::vector<Comparison> comparisons;    ///< one per load that both models computed
  std::vector<Explanation> explanations;  ///< one per load that has the calibrated sheet
  std::vector<Unloading> unloading;
  Timing timing;

  // potential, with card and law
  PotentialSummary potential;
  std::vector<StressCurve> stress_curves;
  StrainStates states;
  std::vector<LawForm> law_forms;

  std::vector<FittedCurve> curves;      ///< fit
  std::vector<UnfittedCurve> unfitted;  ///< fit
  std::optional<ManyCurves> many;       ///< fit, of more than one curve
  std::optional<Design> design;         ///< design
  std::vector<FigureResult> figures;    ///< figure
  int passed = 0, failed = 0;           ///< verify
  int outside = 0, itself = 0;          ///< verify: rows by the basis of their reference
  std::vector<VerificationRow> rows;    ///< verify
  std::vector<CaseOutcome> cases;       ///< batch
  std::vector<PublishedRow> beside;     ///< published
  std::vector<Recording> recordings;    ///< curve

  Provenance provenance;

  /// Whether the command pairs atoms and continua.
  bool is_experiment() const { return command == Command::indentation || command == Command::bulge; }
};

namespace detail {

template <class Self, class Visitor>
void describe_experiment(Self& r, Visitor&& visit) {
  visit(Field{"case", unit::none, "what was asked for, after the input file and the flags were merged"}, r.resolved);
  visit(Field{"sheet", unit::none, "the sheet of atoms; null where none was asked for"}, r.sheet);
  visit(Field{"card", unit::none, "the potential's linear response (T = 0, flat, relaxed inside the cell)"}, r.card);
  visit(Field{"warm", unit::none, "the flat sheet at the temperature"}.where_known(), r.warm);
  visit(Field{"law", unit::none, "made from the potential's homogeneous response, as used"}, r.law);
  visit(Field{"law_missing", unit::none, "why there is no law"}.where_known(), r.law_missing);
  visit(Field{"runs", unit::none, "one curve each; the arrays of a run are equally long"}, r.runs);
  visit(Field{"agreement", unit::none, "the verdict; null where there is none"}, r.agreement);
  visit(Field{"agreement_skipped", unit::none, "why there is no verdict"}.where_known(), r.agreement_skipped);
  visit(Field{"comparison", unit::none, "atoms / like-for-like membrane, depth by depth, per load"}, r.comparisons);
  visit(Field{"explanation", unit::none, "what the plain membrane lacks to be the atoms, per load"}, r.explanations);
  visit(Field{"unloading", unit::none, "the way back of each atomistic curve, where it was asked for"}.where_known(),
        r.unloading);
  visit(Field{"timing", unit::none, "sums over curves that run side by side"}, r.timing);
}

template <class Self, class Visitor>
void describe_potential(Self& r, Visitor&& visit) {
  visit(Field{"potential", unit::none, "which, and how it is described"}, r.potential);
  if constexpr (!std::is_const_v<Self>) r.card.emplace();
  if (r.card) describe(*r.card, visit);
  visit(Field{"warm", unit::none, "the flat sheet at the temperature"}.where_known(), r.warm);
  visit(Field{"curves", unit::none, "stress under large homogeneous strain"}, r.stress_curves);
  visit(Field{"states", unit::none, "homogeneous states that the law is made from"}, r.states);
  visit(Field{"law", unit::none, "made from them; null where there is none"}, r.law);
  visit(Field{"law_missing", unit::none, "why there is no law"}.where_known(), r.law_missing);
  visit(Field{"law_forms", unit::none, "other forms that it can take"}, r.law_forms);
}

}  // namespace detail

/// What a document of the command holds.
void describe(SameStruct<Result> auto& r, auto&& visit) {
  visit(Field{"schema", unit::none, "number of the documents' form"}, r.schema);
  visit(Field{"command", unit::none, "of the program"}, r.command);
  visit(Field{"exit_code", unit::none, "as the program ended"}, r.exit_code);
  visit(Field{"exit_reason", unit::none, "of any exit code but 0, in words"}.where_known(), r.exit_reason);
  switch (r.command) {
    case Command::indentation:
    case Command::bulge:
      detail::describe_experiment(r, visit);
      break;
    case Command::fit:
      visit(Field{"curves", unit::none, "measured curves and what was found in them"}, r.curves);
      visit(Field{"unfitted", unit::none, "curves and files of which nothing could be fitted"}, r.unfitted);
      visit(Field{"many", unit::none, "what more than one curve say together"}.where_known(), r.many);
      break;
    case Command::potential:
      detail::describe_potential(r, visit);
      break;
    case Command::figure:
      visit(Field{"figures", unit::none, "the paper's figures: ours beside the reference"}, r.figures);
      break;
    case Command::verify:
      visit(Field{"passed", unit::none, "rows within their tolerance"}, r.passed);
      visit(Field{"failed", unit::none, "rows beyond it"}, r.failed);
      visit(Field{"outside", unit::none, "rows whose reference is a closed form, a publication or other code"},
            r.outside);
      visit(Field{"itself", unit::none, "rows that check the code against itself"}, r.itself);
      visit(Field{"rows", unit::none, "computed beside its reference"}, r.rows);
      break;
    case Command::batch:
      visit(Field{"cases", unit::none, "one entry per case"}, r.cases);
      break;
    case Command::published:
      visit(Field{"rows", unit::none, "published numbers, ours beside them"}, r.beside);
      break;
    case Command::curve:
      visit(Field{"curves", unit::none, "as the instruments recorded them"}, r.recordings);
      break;
    case Command::design:
      visit(Field{"design", unit::none, "what the experiment will tell"}, r.design);
      break;
  }
  visit(Field{"provenance", unit::none, "program, libraries and files behind the numbers"}, r.provenance);
}

/// The potential's artefact length, Å; that of most carbon potentials where there is no card.
double artefact_bond_of(const Result& result);

}  // namespace validate
