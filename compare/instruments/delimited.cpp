#include "compare/instruments/delimited.hpp"

#include "compare/base/errors.hpp"
#include "compare/instruments/assemble.hpp"
#include "compare/instruments/headings.hpp"
#include "compare/instruments/table.hpp"
#include "compare/instruments/text.hpp"

namespace validate {
namespace {

bool recognises_delimited(const FileContent& file) {
  return !file.archive && is_text(file.bytes) && has_table(to_utf8(file.bytes));
}

std::vector<HeadedColumn> headed(TextTable& table) {
  std::vector<HeadedColumn> columns;
  for (std::size_t c = 0; c < table.columns.size(); ++c) {
    const std::string name = table.headings.empty() ? fmt::format("column {}", c + 1) : table.headings[c];
    columns.push_back(
        {heading_of(name, table.units.empty() ? std::string_view() : table.units[c]), std::move(table.columns[c])});
    if (table.headings.empty()) columns.back().heading.column.clear();
  }
  return columns;
}

std::unique_ptr<Recordings> open_delimited(const FileContent& file, const Calibration& calibration) {
  TextTable table = read_text_table(to_utf8(file.bytes), file.name);
  Recording recording;
  recording.file = file.name;
  recording.metadata.format = delimited_format.name;
  if (table.headings.empty())
    recording.notes.push_back("the table has no header: its columns have no names and no units");
  place_headed(recording, headed(table), file.name);
  calibrate(recording, calibration);
  return std::make_unique<ReadyRecordings>(std::vector{std::move(recording)});
}

}  // namespace

const InstrumentFormat delimited_format = {"table of numbers", ".csv, .txt, .dat, .tsv", recognises_delimited,
                                           open_delimited};

}  // namespace validate
