#include "compare/cli/run_experiment.hpp"

#include <fmt/format.h>

#include <exception>
#include <nlohmann/json.hpp>

#include "atomistic/protocol/math_threads.hpp"
#include "atomistic/protocol/preconditioning.hpp"
#include "compare/base/errors.hpp"
#include "compare/base/interrupt.hpp"
#include "compare/base/terminal.hpp"
#include "compare/cli/atoms_options.hpp"
#include "compare/cli/plan.hpp"
#include "compare/documents/experiment_files.hpp"
#include "compare/documents/texts/json.hpp"
#include "compare/documents/texts/table.hpp"
#include "compare/potential/switch_length.hpp"
#include "compare/process/atoms_budget.hpp"
#include "compare/process/run_folder.hpp"
#include "compare/study/study.hpp"

namespace validate {
namespace {

std::string folder_name(Command command, const Case& c) {
  const std::string potential = std::filesystem::path(c.potential).stem().string();
  if (command == Command::bulge)
    return fmt::format("bulge{}-{}-{:g}", potential.empty() ? "" : "-" + potential, c.shape, 2 * c.radius_A);
  return fmt::format("indentation-{}-R{:g}", has_given_constants(c) ? "membrane" : potential, c.radius_A);
}

/// What decides the numbers of a run: the case but for how it is shown, and what the potential's name stands for.
nlohmann::ordered_json identity_of(const Case& c, const std::optional<PotentialFile>& potential) {
  nlohmann::ordered_json identity = document(c);
  identity.erase("units");
  if (potential) identity["potential_definition"] = definition_of(*potential);
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
  return with_switch_at(*potential, *c.switch_length_A, folder, "switch-length");
}

/// What one document fails at does not take the others away.
void write_documents(const StudyOutcome& outcome, const RunOptions& options, RunFolder& folder) {
  std::exception_ptr failure;
  try {
    write_experiment(outcome, folder.work(), folder.drafts());
    if (options.json && *options.json != "-") write_json(outcome.result, options.json->string());
  } catch (const std::exception&) {
    failure = std::current_exception();
  }
  folder.publish();
  if (failure) std::rethrow_exception(failure);
}

/// After everything that is to stay has been written.
void print(const StudyOutcome& outcome, const RunOptions& options) {
  if (options.json && *options.json == "-")
    write_json(outcome.result, "-");
  else if (!outcome.result.runs.empty())
    print_table(outcome.result);
}

/// Curves run side by side as far as there is memory for them.
StudyOptions study_options(const Case& c, const std::optional<PotentialFile>& potential, const AtomsLaunch& launch,
                           const RunOptions& options, const RunFolder& folder) {
  const int curves = static_cast<int>(c.loads.size());
  const int at_once = potential ? curves_at_once(atoms_budget(c, potential->potential, 1), launch, curves) : curves;
  return {launch, options.ranks, folder.path(), options.all_fields, at_once};
}

}  // namespace

int run_experiment(Command command, const Case& c, const RunOptions& options,
                   const std::optional<PotentialFile>& potential) {
  atomistic::use_one_math_thread();
  AtomsLaunch launch{.cores = available_cores()};
  if (potential) launch = launch_of(options);
  if (c.preconditioner == Preconditioner::multigrid && !atomistic::has_multigrid())
    throw bad_input(
        "preconditioner: 'multigrid' needs hypre, which this program was built without; allowed: auto, factor");
  if (options.dry_run) {
    print_text(plan_text(c, potential, launch));
    return 0;
  }
  if (potential && c.models != Models::membrane) require_memory(c, potential->potential, launch);
  catch_interrupts();
  RunFolder folder(options, folder_name(command, c), identity_of(c, potential));
  Progress progress(options.quiet);
  try {
    if (options.json) check_json_target(options.json->string());
    const auto used = prepared(potential, c, folder);
    const StudyOutcome outcome =
        run_study(command, c, used, study_options(c, potential, launch, options, folder), progress);
    write_documents(outcome, options, folder);
    if (outcome.failure.empty()) folder.finish(static_cast<ExitCode>(outcome.result.exit_code));
    print(outcome, options);
    if (!outcome.failure.empty()) throw Error(outcome.failure_code, outcome.failure);
    progress.say(fmt::format("wrote {}", folder.path().string()));
    return outcome.result.exit_code;
  } catch (const std::exception& error) {
    const auto* known = dynamic_cast<const Error*>(&error);
    if (known && known->exit_code() == ExitCode::interrupted) throw interrupted_in(folder);
    folder.remove_if_unused();
    throw;
  }
}

}  // namespace validate
