#include "compare/cli/batch.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <set>

#include "compare/base/errors.hpp"
#include "compare/base/file.hpp"
#include "compare/base/interrupt.hpp"
#include "compare/base/paths.hpp"
#include "compare/base/progress.hpp"
#include "compare/base/standard_streams.hpp"
#include "compare/base/system_failure.hpp"
#include "compare/base/terminal.hpp"
#include "compare/documents/bytes/run_h5.hpp"
#include "compare/documents/bytes/run_h5_read.hpp"
#include "compare/documents/texts/batch_table.hpp"
#include "compare/documents/texts/json.hpp"
#include "compare/process/folder_lock.hpp"
#include "compare/process/many_cases.hpp"
#include "compare/process/provenance.hpp"
#include "compare/process/run_folder.hpp"
#include "compare/process/run_record.hpp"

namespace validate {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

constexpr const char* batch_file = "batch.json";

fs::path batch_folder(Command command, const RunOptions& options) {
  if (options.out) return fs::absolute(*options.out);
  const auto numbered = [command](int n) {
    return fs::path("runs") / fmt::format("{}-batch{}", command, n == 1 ? "" : fmt::format("-{}", n));
  };
  if (!options.resume) return make_numbered_folder(numbered).path;
  int n = 1;
  while (fs::exists(numbered(n))) ++n;
  return fs::absolute(numbered(n > 1 ? n - 1 : n));
}

std::string case_name(const BatchCase& c) {
  return fmt::format("{}-R{:g}", fs::path(c.potential).stem().string(), c.radius_A);
}

std::string log_name(const BatchCase& c) { return case_name(c) + ".log"; }

/// A batch, or what a kill has left of one that --overwrite was clearing.
bool is_batch(const fs::path& folder) {
  const auto record = read_record(folder);
  return fs::exists(folder / batch_file) || (record && record->files.empty() && record->folders.empty());
}

/// Killed before it was marked as a batch.
bool is_begun(const fs::path& folder) {
  return fs::is_directory(folder) &&
         std::all_of(fs::directory_iterator(folder), fs::directory_iterator(),
                     [](const auto& entry) { return is_temporary_of(entry.path().filename().string(), batch_file); });
}

void refuse_contents(const fs::path& folder, const RunOptions& options) {
  if (is_begun(folder)) return;
  const bool exists = fs::exists(folder);
  if (exists && !is_batch(folder))
    throw bad_input("--out: '{}' exists and does not hold a batch of this program; choose another folder",
                    folder.string());
  if (exists && !options.resume && !options.overwrite)
    throw bad_input("--out: '{}' holds a batch; --resume goes on with it, --overwrite starts again", folder.string());
  if (!exists && options.resume) throw bad_input("--resume: '{}' holds no batch", folder.string());
}

void make_folder(const fs::path& folder) {
  std::error_code error;
  fs::create_directories(folder, error);
  if (error) throw system_failure(fmt::format("cannot create '{}'", folder.string()), error.value());
}

/// Marks the folder as a batch, and notes what will be in it before it is there.
void prepare(const fs::path& folder, const std::vector<BatchCase>& cases, const RunOptions& options) {
  if (options.overwrite) clear_run(folder);
  RunRecord record = read_record(folder).value_or(RunRecord());
  Json list = Json::array();
  for (const char* name : {batch_file, "summary.json", "run.h5"}) record.add_file(name);
  for (const BatchCase& c : cases) {
    record.add_folder(case_name(c));
    record.add_file(log_name(c));
    list.push_back(case_name(c));
  }
  record.exit_code.reset();
  write_file(folder / batch_file, Json{{"schema", document_schema}, {"cases", list}}.dump(1) + "\n");
  write_record(folder, record);
}

std::vector<CaseEnd> run_all(Command command, const std::vector<BatchCase>& cases,
                             const std::vector<std::string>& common, const RunOptions& options,
                             const fs::path& folder) {
  std::vector<ManyCase> list;
  for (const BatchCase& c : cases) {
    std::vector<std::string> words = {(program_folder() / "validate").string(), std::string(to_string(command))};
    words.insert(words.end(), common.begin(), common.end());
    words.insert(words.end(), c.words.begin(), c.words.end());
    if (options.overwrite && fs::exists(folder / case_name(c))) words.push_back("--overwrite");
    list.push_back({case_name(c), words, folder / case_name(c), folder / log_name(c), 1});
  }
  Progress progress(options.quiet);
  try {
    return run_cases(list, options.resume, progress);
  } catch (const Error& error) {
    if (error.exit_code() != ExitCode::interrupted) throw;
    throw Error(ExitCode::interrupted, fmt::format("interrupted; continue with --resume --out '{}'", folder.string()));
  }
}

/// A case's own result, as far as it got.
std::shared_ptr<const Result> read_summary(const fs::path& folder) {
  try {
    return std::make_shared<const Result>(read_run_h5(folder / "run.h5"));
  } catch (const Error&) {  // it failed before there was one
    return nullptr;
  }
}

void finish(const Result& result, const RunOptions& options, const fs::path& folder) {
  write_file(folder / "summary.json", json_text(result));
  write_run_h5(result, folder / "run.h5");
  RunRecord record = read_record(folder).value_or(RunRecord());
  record.exit_code = result.exit_code;
  write_record(folder, record);
  if (options.json) write_json(result, options.json->string());
  if (!options.json || *options.json != "-") print_text(batch_table(result, line_width()));
}

}  // namespace

int run_batch(Command command, const std::vector<BatchCase>& cases, const std::vector<std::string>& common,
              const RunOptions& options) {
  std::set<std::string> names;
  for (const BatchCase& c : cases)
    if (!names.insert(case_name(c)).second) throw bad_input("--potential, --radius: {} is named twice", case_name(c));
  if (options.dry_run) {
    for (const BatchCase& c : cases) print_result(case_name(c) + "\n");
    return 0;
  }
  catch_interrupts();
  const fs::path folder = batch_folder(command, options);
  refuse_contents(folder, options);
  make_folder(folder);
  const FolderLock lock(folder);
  prepare(folder, cases, options);
  const std::vector<CaseEnd> ends = run_all(command, cases, common, options, folder);
  Result result;
  result.command = Command::batch;
  result.provenance = provenance(command_line());
  for (std::size_t i = 0; i < cases.size(); ++i) {
    result.cases.push_back({cases[i].potential, cases[i].radius_A, case_name(cases[i]), ends[i].exit_code,
                            read_summary(folder / case_name(cases[i]))});
    result.exit_code = std::max(result.exit_code, ends[i].exit_code);
  }
  finish(result, options, folder);
  return result.exit_code;
}

}  // namespace validate
