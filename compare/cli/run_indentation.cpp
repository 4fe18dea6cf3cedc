#include "compare/cli/run_indentation.hpp"

#include <algorithm>
#include <exception>
#include <nlohmann/json.hpp>

#include "atomistic/protocol/math_threads.hpp"
#include "compare/base/errors.hpp"
#include "compare/base/interrupt.hpp"
#include "compare/cli/atoms_options.hpp"
#include "compare/cli/plan.hpp"
#include "compare/documents/atoms_files.hpp"
#include "compare/documents/outputs.hpp"
#include "compare/documents/texts/report_html.hpp"
#include "compare/documents/texts/summary_json.hpp"
#include "compare/documents/texts/table.hpp"
#include "compare/potential/switch_length.hpp"
#include "compare/process/run_folder.hpp"
#include "compare/study/study.hpp"

namespace validate {
namespace {

std::string folder_name(const Case& c) {
  const std::string potential =
      has_given_constants(c) ? "membrane" : std::filesystem::path(c.potential).stem().string();
  return fmt::format("indentation-{}-R{:g}", potential, c.radius_A);
}

/// A calibrated law may lose its stability before the atoms do: that ends its curve, and is no failure.
bool any_solver_gave_up(const Result& result) {
  return std::any_of(result.runs.begin(), result.runs.end(), [](const Run& run) {
    return run.ended == Ended::not_converged && run.constants != Constants::calibrated;
  });
}

ExitCode verdict(const StudyOutcome& outcome) {
  if (!outcome.failure.empty()) return outcome.failure_code;
  if (any_solver_gave_up(outcome.result)) return ExitCode::not_converged;
  const auto& agreement = outcome.result.agreement;
  return agreement && !agreement->passed ? ExitCode::disagreement : ExitCode::success;
}

void write_documents(const StudyOutcome& outcome, const atomistic::Potential& potential, const RunOptions& options,
                     const RunFolder& folder) {
  const std::filesystem::path drafts = folder.drafts();
  write_all(outcome.result, drafts);
  write_lammps_log(folder.work(), drafts);
  if (outcome.sheet)
    for (const std::string& load : outcome.result.resolved.loads)
      write_deepest_sheet(potential, load, *outcome.sheet, folder.work(), drafts);
  const bool table_on_stdout = !options.json || *options.json != "-";
  if (table_on_stdout && !outcome.result.runs.empty()) print_table(outcome.result, stdout);
  write_report(outcome.result, drafts, drafts / "report.html");  // last: it shows the sheets
  if (options.json) write_json(outcome.result, options.json->string());
}

/// What one document fails at does not take the others away.
void report(const StudyOutcome& outcome, const atomistic::Potential& potential, const RunOptions& options,
            RunFolder& folder) {
  try {
    write_documents(outcome, potential, options, folder);
  } catch (const std::exception&) {
    folder.publish();
    throw;
  }
  folder.publish();
}

/// What decides the numbers of a run: the case, and what the potential's name stands for.
nlohmann::ordered_json identity_of(const Case& c, const std::optional<PotentialFile>& potential) {
  nlohmann::ordered_json identity = case_document(c);
  if (!potential) return identity;
  identity["potential_definition"] = definition_of(*potential);
  return identity;
}

Error interrupted_in(const RunFolder& folder) {
  return Error(ExitCode::interrupted,
               fmt::format("interrupted; the finished depths are kept: continue with --resume --out '{}'",
                           folder.path().string()));
}

/// The potential that the run uses: its switch moved in a copy in the folder if asked for.
std::optional<PotentialFile> prepared(const std::optional<PotentialFile>& potential, const Case& c, RunFolder& folder) {
  if (!potential) return std::nullopt;
  if (!c.switch_length_A) return potential;
  PotentialFile moved = with_switch_at(*potential, *c.switch_length_A, folder.drafts(), "switch-length");
  folder.publish();
  moved.potential.file = (folder.path() / std::filesystem::path(moved.potential.file).filename()).string();
  return moved;
}

}  // namespace

int run_indentation(const Case& c, const RunOptions& options, const std::optional<PotentialFile>& potential) {
  atomistic::use_one_math_thread();
  AtomsLaunch launch{.cores = available_cores()};
  if (potential) launch = launch_of(options);
  if (options.dry_run) {
    fmt::print("{}", plan_text(c, potential, launch));
    return 0;
  }
  catch_interrupts();
  RunFolder folder(options, folder_name(c), identity_of(c, potential));
  Progress progress(options.quiet);
  try {
    if (options.json) check_json_target(options.json->string());
    const auto used = prepared(potential, c, folder);
    const StudyOutcome outcome =
        run_study(c, used, {launch, options.ranks, folder.path(), options.all_fields}, progress);
    report(outcome, used ? used->potential : atomistic::Potential(), options, folder);
    if (!outcome.failure.empty()) throw Error(outcome.failure_code, outcome.failure);
    folder.finish(verdict(outcome));
    progress.say(fmt::format("wrote {}", folder.path().string()));
    return static_cast<int>(verdict(outcome));
  } catch (const std::exception& error) {
    const auto* known = dynamic_cast<const Error*>(&error);
    if (known && known->exit_code() == ExitCode::interrupted) throw interrupted_in(folder);
    folder.remove_if_unused();
    throw;
  }
}

}  // namespace validate
