#include "compare/process/run_record.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <sstream>
#include <system_error>

#include "compare/base/errors.hpp"
#include "compare/base/file.hpp"
#include "compare/base/read_file.hpp"
#include "compare/base/system_failure.hpp"

namespace validate {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view record_name = ".validate-run";
constexpr std::string_view first_line = "validate run folder 1";

bool is_entry_name(std::string_view name) {
  return !name.empty() && name != "." && name != ".." && name.find('/') == std::string_view::npos;
}

void add(std::vector<std::string>& names, const std::string& name) {
  if (is_entry_name(name) && std::find(names.begin(), names.end(), name) == names.end()) names.push_back(name);
}

/// A name on one line.
std::string written(const std::string& name) {
  std::string line;
  for (const char c : name) line += c == '\n' ? "\\n" : c == '\\' ? "\\\\" : std::string(1, c);
  return line;
}

std::string name_of(const std::string& line) {
  std::string name;
  for (std::size_t i = 0; i < line.size(); ++i) {
    const bool escaped = line[i] == '\\' && i + 1 < line.size();
    if (escaped) ++i;
    name += escaped && line[i] == 'n' ? '\n' : line[i];
  }
  return name;
}

std::string text_of(const RunRecord& record) {
  std::string text = fmt::format("{}\n", first_line);
  if (record.exit_code) text += fmt::format("exit_code {}\n", *record.exit_code);
  for (const std::string& name : record.folders) text += fmt::format("folder {}\n", written(name));
  for (const std::string& name : record.files) text += fmt::format("file {}\n", written(name));
  return text;
}

void read_line(const std::string& line, RunRecord& record) {
  const std::size_t space = line.find(' ');
  if (space == std::string::npos) return;
  const std::string key = line.substr(0, space), value = line.substr(space + 1);
  if (key == "file") record.add_file(name_of(value));
  if (key == "folder") record.add_folder(name_of(value));
  int code = 0;
  if (key == "exit_code" && std::from_chars(value.data(), value.data() + value.size(), code).ec == std::errc())
    record.exit_code = code;
}

/// A name may have become a folder of the user's, which is not ours to remove.
void remove_file(const fs::path& file, std::error_code& error) {
  std::error_code kind;
  if (!fs::is_directory(fs::symlink_status(file, kind)) && !error) fs::remove(file, error);
}

/// Than its record, and what a kill has left of records that were being written, which goes.
bool holds_nothing_else(const fs::path& folder) {
  bool nothing = true;
  for (const auto& entry : fs::directory_iterator(folder)) {
    const std::string name = entry.path().filename().string();
    std::error_code error;
    if (is_temporary_of(name, record_name))
      remove_file(entry.path(), error);
    else if (name != record_name)
      nothing = false;
  }
  return nothing;
}

void remove_run_below(const fs::path& folder) {
  std::error_code ignored;
  if (!fs::is_directory(fs::symlink_status(folder, ignored))) return;
  if (!read_record(folder) && !fs::exists(folder / "work" / "case.json", ignored)) return;  // no run of ours
  clear_run(folder);
  fs::remove(folder, ignored);  // if nothing is left in it
}

void clear(const fs::path& folder, const std::vector<fs::path>& leftovers) {
  RunRecord record = read_record(folder).value_or(RunRecord());
  if (record.exit_code) {  // from here on it is no finished run
    record.exit_code.reset();
    write_record(folder, record);
  }
  for (const std::string& name : record.folders) remove_run_below(folder / name);
  std::error_code error;
  for (const std::string& name : record.files) remove_file(folder / name, error);
  for (const fs::path& leftover : leftovers)
    if (!error) fs::remove_all(folder / leftover, error);
  if (error) throw system_failure(fmt::format("cannot write in '{}'", folder.string()), error.value());
  if (holds_nothing_else(folder))
    fs::remove(folder / record_name, error);
  else
    write_record(folder, {});
}

}  // namespace

void RunRecord::add_file(const std::string& name) { add(files, name); }
void RunRecord::add_folder(const std::string& name) { add(folders, name); }

std::optional<RunRecord> read_record(const fs::path& folder) {
  std::istringstream in(read_if_there(folder / record_name).value_or(""));
  std::string line;
  if (!std::getline(in, line) || line != first_line) return std::nullopt;
  RunRecord record;
  while (std::getline(in, line)) read_line(line, record);
  return record;
}

void write_record(const fs::path& folder, const RunRecord& record) {
  write_file(folder / record_name, text_of(record));
}

void add_to_record(const fs::path& file) {
  auto record = read_record(file.parent_path());
  if (!record) return;
  record->add_file(file.filename().string());
  write_record(file.parent_path(), *record);
}

// Without its case none resumes it.
void clear_run(const fs::path& folder) { clear(folder, {fs::path("work") / "case.json", fs::path("work")}); }

void clear_documents(const fs::path& folder) { clear(folder, {}); }

}  // namespace validate
