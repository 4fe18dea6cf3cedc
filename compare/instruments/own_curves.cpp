#include "compare/instruments/own_curves.hpp"

#include <algorithm>
#include <limits>
#include <map>

#include "compare/base/errors.hpp"
#include "compare/instruments/assemble.hpp"
#include "compare/instruments/headings.hpp"
#include "compare/instruments/text.hpp"

namespace validate {
namespace {

constexpr std::string_view title = "# title: force-depth curves of validate";

/// Rows of one run.
struct Run {
  std::string model, load;
  std::vector<std::vector<double>> values;  ///< one list a column; NaN where the model has no such column
};

double value_of(std::string_view cell) {
  constexpr double none = std::numeric_limits<double>::quiet_NaN();
  return cell.empty() ? none : number_of(cell).value_or(none);
}

std::map<int, Run> runs_of(const std::vector<TextLine>& rows, std::size_t columns, const std::string& file) {
  std::map<int, Run> runs;
  for (const TextLine& line : rows) {
    const auto cells = cells_of(line.text, ',');
    const auto run = cells.size() == columns ? number_of(cells[0]) : std::nullopt;
    if (!run || !(*run >= 0 && *run < 1e6))
      throw bad_input("{}:{}: not a row of {} cells whose first is the run's number, from 0 to 999999", file,
                      line.number, columns);
    Run& one = runs[static_cast<int>(*run)];
    one.model = cells[1];
    one.load = cells[2];
    one.values.resize(columns);
    for (std::size_t c = 3; c < columns; ++c) one.values[c].push_back(value_of(cells[c]));
  }
  return runs;
}

bool recognises_own(const FileContent& file) { return !file.archive && file.bytes.starts_with(title); }

std::unique_ptr<Recordings> open_own(const FileContent& file, const Calibration& calibration) {
  std::vector<TextLine> lines = lines_of(file.bytes);
  std::erase_if(lines, [](const TextLine& line) { return line.text.starts_with('#') || line.text.empty(); });
  if (lines.empty() || !lines.front().text.starts_with("run,model,load,"))
    throw bad_input("{}: no header 'run,model,load,…' below the comments", file.name);
  const auto headings = cells_of(lines.front().text, ',');
  lines.erase(lines.begin());
  std::vector<Recording> recordings;
  for (auto& [number, run] : runs_of(lines, headings.size(), file.name)) {
    Recording recording;
    recording.file = file.name;
    recording.index = number;
    recording.metadata.format = own_curves_format.name;
    recording.notes.push_back(fmt::format("run {}: {}, load {}", number, printable(run.model), printable(run.load)));
    std::vector<HeadedColumn> columns;
    for (std::size_t c = 3; c < headings.size(); ++c) {
      const bool empty = std::ranges::all_of(run.values[c], [](double value) { return value != value; });
      if (!empty) columns.push_back({heading_of(headings[c]), std::move(run.values[c])});
    }
    if (columns.empty()) continue;
    place_headed(recording, std::move(columns), file.name);
    calibrate(recording, calibration);
    recordings.push_back(std::move(recording));
  }
  if (recordings.empty()) throw bad_input("{}: no rows below the header", file.name);
  return std::make_unique<ReadyRecordings>(std::move(recordings));
}

}  // namespace

const InstrumentFormat own_curves_format = {"validate's curves", "curves.csv", recognises_own, open_own};

}  // namespace validate
