#include "compare/process/document_folder.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <string>
#include <system_error>
#include <vector>

#include "compare/base/errors.hpp"
#include "compare/base/file.hpp"
#include "compare/base/system_failure.hpp"
#include "compare/process/run_folder.hpp"

namespace validate {

namespace fs = std::filesystem;

fs::path DocumentFolder::drafts() const {
  const fs::path folder = work() / "drafts";
  std::error_code error;
  lock_->require_in_place();
  fs::create_directories(folder, error);
  if (error) throw system_failure(fmt::format("cannot create '{}'", folder.string()), error.value());
  return folder;
}

void DocumentFolder::publish() {
  std::vector<std::string> names;
  for (const auto& entry : fs::directory_iterator(drafts())) names.push_back(entry.path().filename().string());
  if (names.empty()) return;
  std::sort(names.begin(), names.end());
  for (const std::string& name : names) record_.add_file(name);
  write_record(path_, record_);  // first: a kill then leaves names without files, never files without names
  std::string failure;
  for (const std::string& name : names) {
    std::error_code error;
    fs::rename(drafts() / name, path_ / name, error);
    if (error && failure.empty())
      failure = fmt::format("cannot write '{}': {}", (path_ / name).string(), error.message());
  }
  sync_folder(path_);
  if (!failure.empty()) throw Error(ExitCode::file_failed, failure);
}

// Not `work`: in a folder that is no run's it may be the user's.
OutputFolder::OutputFolder(const fs::path& out, bool overwrite) : DocumentFolder(".validate-work") {
  path_ = fs::absolute(out);
  std::error_code error;
  fs::create_directories(path_, error);
  if (error) throw system_failure(fmt::format("--out: cannot create '{}'", path_.string()), error.value());
  lock_.emplace(path_);
  if (is_resumable(path_))
    throw bad_input("--out: '{}' holds an unfinished run; choose another folder", path_.string());
  if (overwrite) clear_documents(path_);
  record_ = read_record(path_).value_or(RunRecord());
  of_a_run_ = record_.exit_code.has_value();
  if (!of_a_run_) record_.exit_code = static_cast<int>(ExitCode::interrupted);  // until finish()
  fs::remove_all(overwrite ? work() : work() / "drafts", error);                // half written ones
  drafts();
}

void OutputFolder::finish(int exit_code) {
  if (!of_a_run_) record_.exit_code = exit_code;
  publish();
  std::error_code ignored;
  fs::remove_all(work(), ignored);
}

}  // namespace validate
