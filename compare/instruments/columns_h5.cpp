#include "compare/instruments/columns_h5.hpp"

#include <algorithm>
#include <cmath>

#include "compare/base/errors.hpp"
#include "compare/documents/bytes/h5_read.hpp"
#include "compare/instruments/afmformats_names.hpp"
#include "compare/instruments/apart.hpp"
#include "compare/instruments/assemble.hpp"
#include "compare/instruments/headings.hpp"
#include "compare/instruments/raw_columns.hpp"
#include "compare/instruments/text.hpp"

namespace validate {
namespace {

/// Groups below groups that are looked into.
constexpr int deepest = 4;
constexpr std::size_t most_groups = 100000;
/// What a byte of a file may become: compressed numbers, and names.
constexpr std::size_t bytes_of_one = 64, bytes_of_any = 1 << 20;

/// Numbers as numbers: 2 before 10.
bool comes_before(const std::string& a, const std::string& b) {
  const auto left = number_of(a), right = number_of(b);
  return left && right ? *left < *right : a < b;
}

RawGroup raw_group(const h5::ReadGroup& group, const std::string& name, const std::vector<std::string>& columns) {
  RawGroup raw{name, {}, {}};
  for (const std::string& attribute : group.attribute_names()) {
    if (group.is_number(attribute)) raw.attributes.emplace_back(attribute, group.number(attribute));
    if (group.is_text(attribute)) raw.attributes.emplace_back(attribute, group.text(attribute));
  }
  for (const std::string& column : columns) {
    h5::NumberSet set = group.number_set(column);
    raw.columns.push_back({column, set.unit, std::move(set.values)});
  }
  return raw;
}

/// Curves below a group come before its own.
void find_curves(const h5::ReadGroup& group, const std::string& name, int depth, std::vector<RawGroup>& into) {
  if (into.size() > most_groups) throw bad_input("more than {} groups", most_groups);
  std::vector<std::string> names = depth == deepest ? std::vector<std::string>() : group.group_names();
  std::ranges::stable_sort(names, comes_before);
  for (const std::string& below : names)
    if (const auto next = group.group(below))
      find_curves(*next, name.empty() ? below : name + "/" + below, depth + 1, into);
  const std::vector<std::string> columns = group.column_names();
  if (columns.size() > 1) into.push_back(raw_group(group, name, columns));
}

/// The file's curves: the library is used in a process of its own, for there are files that it does not survive.
std::vector<RawGroup> raw_groups(const FileContent& file) {
  const auto read = [&file] {
    std::vector<RawGroup> groups;
    find_curves(h5::open_file(file.path, ""), "", 0, groups);
    return packed(groups);
  };
  return unpacked(done_apart(read, bytes_of_any + bytes_of_one * std::filesystem::file_size(file.path), file.name));
}

class ColumnsH5 : public Recordings {
 public:
  ColumnsH5(std::string name, std::vector<RawGroup> groups, const Calibration& calibration)
      : name_(std::move(name)), groups_(std::move(groups)), calibration_(calibration) {}

  std::size_t size() const override { return groups_.size(); }

  Recording read(std::size_t i) const override {
    const RawGroup& group = groups_.at(i);
    Recording recording;
    recording.file = name_;
    recording.index = static_cast<int>(i);
    for (const auto& [name, value] : group.attributes) {
      if (const auto* number = std::get_if<double>(&value)) set_number(recording, name, *number);
      if (const auto* text = std::get_if<std::string>(&value)) set_metadata_from_text(recording.metadata, name, *text);
    }
    recording.metadata.format = columns_h5_format.name;
    std::vector<HeadedColumn> columns;
    for (const RawColumn& column : group.columns)
      if (columns.empty() || column.values.size() == columns.front().values.size())
        columns.push_back({heading_of(column.name, column.unit), column.values});
      else
        recording.notes.push_back(fmt::format("'{}' has another length than '{}' and is left out",
                                              printable(column.name), printable(group.columns.front().name)));
    place_headed(recording, std::move(columns), fmt::format("{}: group '{}'", name_, printable(group.name)));
    calibrate(recording, calibration_);
    return recording;
  }

 private:
  static void set_number(Recording& recording, const std::string& name, double value) {
    set_metadata_from_text(recording.metadata, name, fmt::format("{}", value));
    if ((name == "index" || name == "enum") && value >= 0 && value < 2e9) recording.index = static_cast<int>(value);
  }

  std::string name_;
  std::vector<RawGroup> groups_;
  Calibration calibration_;
};

bool recognises_h5(const FileContent& file) { return !file.archive && file.bytes.starts_with("\x89HDF\r\n\x1a\n"); }

std::unique_ptr<Recordings> open_h5(const FileContent& file, const Calibration& calibration) {
  if (file.path.empty()) throw bad_input("{}: HDF5 inside an archive is not read; take it out first", file.name);
  std::vector<RawGroup> groups = raw_groups(file);
  if (groups.empty())
    throw bad_input(
        "{}: no group with at least two data sets of one dimension, such as 'force' and 'height (piezo)', each with an "
        "attribute 'unit'",
        file.name);
  return std::make_unique<ColumnsH5>(file.name, std::move(groups), calibration);
}

}  // namespace

const InstrumentFormat columns_h5_format = {"HDF5 of columns", ".h5, of afmformats, of this program, of one's own",
                                            recognises_h5, open_h5};

}  // namespace validate
