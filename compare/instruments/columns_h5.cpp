#include "compare/instruments/columns_h5.hpp"

#include <algorithm>
#include <cmath>

#include "compare/base/errors.hpp"
#include "compare/documents/bytes/h5_read.hpp"
#include "compare/instruments/afmformats_names.hpp"
#include "compare/instruments/assemble.hpp"
#include "compare/instruments/headings.hpp"
#include "compare/instruments/text.hpp"

namespace validate {
namespace {

/// Groups below groups that are looked into.
constexpr int deepest = 4;
constexpr std::size_t most_groups = 100000;

/// Numbers as numbers: 2 before 10.
bool comes_before(const std::string& a, const std::string& b) {
  const auto left = number_of(a), right = number_of(b);
  return left && right ? *left < *right : a < b;
}

/// A group whose data sets are the columns of a curve.
struct CurveGroup {
  h5::ReadGroup group;
  std::string name;
};

/// Curves below a group come before its own.
void find_curves(h5::ReadGroup group, const std::string& name, int depth, std::vector<CurveGroup>& into) {
  if (into.size() > most_groups) throw bad_input("more than {} groups", most_groups);
  std::vector<std::string> names = depth == deepest ? std::vector<std::string>() : group.group_names();
  std::ranges::stable_sort(names, comes_before);
  for (const std::string& below : names)
    if (auto next = group.group(below))
      find_curves(std::move(*next), name.empty() ? below : name + "/" + below, depth + 1, into);
  if (group.column_names().size() > 1) into.push_back({std::move(group), name});
}

/// afmformats' "spring constant" and this program's "spring_constant_N_per_m".
void read_metadata(RecordingMetadata& m, const h5::ReadGroup& group) {
  for (const std::string& attribute : group.attribute_names()) {
    std::string name = attribute;
    std::ranges::replace(name, '_', ' ');
    for (const std::string_view unit : {" N per m", " m per V", " m per A", " m per s", " Hz", " s", " m"})
      if (name.ends_with(unit)) {
        name = name.substr(0, name.size() - unit.size());
        break;
      }
    if (group.is_number(attribute)) set_metadata(m, name, group.number(attribute));
    if (group.is_text(attribute)) set_metadata(m, name, group.text(attribute));
  }
}

class ColumnsH5 : public Recordings {
 public:
  ColumnsH5(std::string name, std::vector<CurveGroup> groups, const Calibration& calibration)
      : name_(std::move(name)), groups_(std::move(groups)), calibration_(calibration) {}

  std::size_t size() const override { return groups_.size(); }

  Recording read(std::size_t i) const override {
    const CurveGroup& curve = groups_.at(i);
    const std::string label = fmt::format("{}: group '{}'", name_, printable(curve.name));
    try {
      return recording(curve, label, static_cast<int>(i));
    } catch (const Error& error) {
      throw bad_input("{}: {}", label, printable_line(error.what()));
    }
  }

 private:
  static std::string printable_line(std::string_view text) {
    std::string line;
    for (std::size_t at = 0; at < text.size(); at += 50) line += printable(text.substr(at, 50));
    return line;
  }

  Recording recording(const CurveGroup& curve, const std::string& label, int place) const {
    std::vector<HeadedColumn> columns;
    for (const std::string& name : curve.group.column_names()) {
      h5::NumberSet set = curve.group.number_set(name);
      if (!columns.empty() && set.values.size() != columns.front().values.size()) continue;
      columns.push_back({heading_of(name, set.unit), std::move(set.values)});
    }
    Recording recording;
    recording.file = name_;
    read_metadata(recording.metadata, curve.group);
    recording.metadata.format = columns_h5_format.name;
    recording.index = std::max(recording.metadata.number.value_or(place), 0);
    if (curve.group.has_attribute("index") && curve.group.is_number("index"))
      recording.index = static_cast<int>(std::clamp(curve.group.number("index"), 0.0, 2e9));
    place_headed(recording, std::move(columns), label);
    calibrate(recording, calibration_);
    return recording;
  }

  std::string name_;
  std::vector<CurveGroup> groups_;
  Calibration calibration_;
};

bool recognises_h5(const FileContent& file) { return !file.archive && file.bytes.starts_with("\x89HDF\r\n\x1a\n"); }

std::unique_ptr<Recordings> open_h5(const FileContent& file, const Calibration& calibration) {
  if (file.path.empty()) throw bad_input("{}: HDF5 inside an archive is not read; take it out first", file.name);
  std::vector<CurveGroup> groups;
  try {
    find_curves(h5::open_file(file.path, ""), "", 0, groups);
  } catch (const Error& error) {
    throw bad_input("{}: {}", file.name, error.what());
  }
  if (groups.empty())
    throw bad_input(
        "{}: no group with at least two data sets of one dimension, such as 'force' and 'height (piezo)', each "
        "with an attribute 'unit'",
        file.name);
  return std::make_unique<ColumnsH5>(file.name, std::move(groups), calibration);
}

}  // namespace

const InstrumentFormat columns_h5_format = {"HDF5 of columns", ".h5, of afmformats, of this program, of one's own",
                                            recognises_h5, open_h5};

}  // namespace validate
