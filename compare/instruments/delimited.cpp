#include "compare/instruments/delimited.hpp"

#include <algorithm>
#include <cmath>

#include "compare/base/errors.hpp"
#include "compare/instruments/afmformats_names.hpp"
#include "compare/instruments/assemble.hpp"
#include "compare/instruments/headings.hpp"
#include "compare/instruments/table.hpp"
#include "compare/instruments/text.hpp"

namespace validate {
namespace {

bool recognises_delimited(const FileContent& file) {
  return !file.archive && is_text(file.bytes) && has_table(to_utf8(file.bytes));
}

/// Columns with their headings. One without heading and values is what a separator at the end of a line makes.
std::vector<HeadedColumn> headed(TextTable& table) {
  std::vector<HeadedColumn> columns;
  for (std::size_t c = 0; c < table.columns.size(); ++c) {
    const bool named = !table.headings.empty() && !table.headings[c].empty();
    if (!named && std::ranges::all_of(table.columns[c], [](double value) { return std::isnan(value); })) continue;
    const std::string name = named ? table.headings[c] : fmt::format("column {}", c + 1);
    columns.push_back(
        {heading_of(name, table.units.empty() ? std::string_view() : table.units[c]), std::move(table.columns[c])});
    if (!named) columns.back().heading.column.clear();
  }
  return columns;
}

/// "segment 1: pause", as this program writes them.
void name_segments(Recording& recording) {
  for (std::size_t i = 0; i < recording.segments.size(); ++i) {
    const auto found = recording.remarks.find(fmt::format("segment {}", i));
    const auto kind = found == recording.remarks.end() ? std::nullopt : from_word<SegmentKind>(found->second);
    if (kind) recording.segments[i].kind = *kind;
  }
}

std::unique_ptr<Recordings> open_delimited(const FileContent& file, const Calibration& calibration) {
  Recording recording = read_delimited(file, delimited_format.name);
  calibrate(recording, calibration);
  return std::make_unique<ReadyRecordings>(std::vector{std::move(recording)});
}

}  // namespace

const InstrumentFormat delimited_format = {"table of numbers", ".csv, .txt, .dat, .tsv", recognises_delimited,
                                           open_delimited};

Recording read_delimited(const FileContent& file, std::string_view format) {
  TextTable table = read_text_table(to_utf8(file.bytes), file.name);
  Recording recording;
  recording.file = file.name;
  recording.remarks = std::move(table.remarks);
  for (const auto& [name, text] : recording.remarks) set_metadata_from_text(recording.metadata, name, text);
  recording.metadata.format = format;
  if (const auto index = recording.remarks.find("index"); index != recording.remarks.end())
    if (const auto number = number_of(index->second); number && *number >= 0 && *number < 2e9)
      recording.index = static_cast<int>(*number);
  if (table.headings.empty())
    recording.notes.push_back("the table has no header: its columns have no names and no units");
  recording.headings = table.headings;
  recording.header_line = table.header_line;
  place_headed(recording, headed(table), file.name);
  name_segments(recording);
  return recording;
}

}  // namespace validate
