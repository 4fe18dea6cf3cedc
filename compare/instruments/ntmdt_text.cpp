#include "compare/instruments/ntmdt_text.hpp"

#include <algorithm>
#include <array>

#include "compare/base/errors.hpp"
#include "compare/instruments/assemble.hpp"
#include "compare/instruments/text.hpp"

namespace validate {
namespace {

using Row = std::array<double, 3>;  ///< height in nm, signal on approach and on retract in nA

std::optional<Row> row_of(std::string_view line) {
  const auto cells = cells_of(line, ' ');
  Row row;
  if (cells.size() != row.size()) return std::nullopt;
  for (std::size_t i = 0; i < row.size(); ++i) {
    const auto value = number_of(cells[i], ',');
    if (!value) return std::nullopt;
    row[i] = *value;
  }
  return row;
}

/// Three columns of numbers and nothing else; a decimal comma tells them from any other table.
bool recognises_ntmdt(const FileContent& file) {
  if (file.archive || !is_text(file.bytes)) return false;
  const std::string head = to_utf8(file.bytes.substr(0, 4096));
  auto lines = lines_of(head);
  if (file.bytes.size() > 4096 && lines.size() > 1) lines.pop_back();  // it may be cut
  int rows = 0;
  bool comma = false;
  for (const TextLine& line : lines) {
    if (trimmed(line.text).empty()) continue;
    if (!row_of(line.text)) return false;
    comma = comma || line.text.find(',') != std::string_view::npos;
    ++rows;
  }
  return rows > 1 && comma;
}

/// One signal against the height they share: where the beginning is padded with a repeated value, its last row counts.
SegmentData segment(const std::vector<Row>& rows, std::size_t column, SegmentKind kind) {
  std::size_t from = 0;
  while (from + 1 < rows.size() && rows[from + 1][column] == rows[0][column]) ++from;
  SegmentData part;
  part.segment = {.kind = kind, .points = static_cast<int>(rows.size() - from)};
  RecordedColumn &height = part.columns["height (piezo)"], &signal = part.columns["deflection"];
  height.unit = "m";
  signal.unit = "A";
  for (std::size_t i = from; i < rows.size(); ++i) {
    height.values.push_back(1e-9 * rows[i][0]);
    signal.values.push_back(1e-9 * rows[i][column]);
  }
  return part;
}

std::unique_ptr<Recordings> open_ntmdt(const FileContent& file, const Calibration& calibration) {
  const std::string text = to_utf8(file.bytes);
  std::vector<Row> rows;
  for (const TextLine& line : lines_of(text)) {
    if (trimmed(line.text).empty()) continue;
    const auto row = row_of(line.text);
    if (!row)
      throw bad_input("{}:{}: '{}' is not three numbers (height in nm, signals in nA) with a decimal comma", file.name,
                      line.number, printable(line.text));
    rows.push_back(*row);
  }
  std::vector<SegmentData> parts = {segment(rows, 1, SegmentKind::approach), segment(rows, 2, SegmentKind::retract)};
  for (auto& [name, column] : parts[0].columns)
    std::ranges::reverse(column.values);  // the axis is that of the way back
  Recording recording;
  recording.file = file.name;
  recording.metadata.format = ntmdt_text_format.name;
  recording.metadata.imaging_mode = "force-distance";
  assemble(recording, std::move(parts), file.name);
  calibrate(recording, calibration);
  return std::make_unique<ReadyRecordings>(std::vector{std::move(recording)});
}

}  // namespace

const InstrumentFormat ntmdt_text_format = {"NT-MDT text", ".txt", recognises_ntmdt, open_ntmdt};

}  // namespace validate
