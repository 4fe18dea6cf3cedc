#include "compare/instruments/jpk_text.hpp"

#include <algorithm>
#include <map>

#include "compare/base/errors.hpp"
#include "compare/instruments/afmformats_names.hpp"
#include "compare/instruments/assemble.hpp"
#include "compare/instruments/headings.hpp"
#include "compare/instruments/text.hpp"

namespace validate {
namespace {

constexpr std::string_view columns_key = "columns", units_key = "units", segment_key = "segment";

/// Rows below comments of their own.
struct Block {
  std::map<std::string, std::string, std::less<>> keys;
  std::vector<TextLine> rows;
};

std::vector<Block> blocks_of(std::string_view text) {
  std::vector<Block> blocks(1);
  for (const TextLine& line : lines_of(text)) {
    const std::string_view content = trimmed(line.text);
    if (content.empty()) continue;
    if (!content.starts_with('#')) {
      blocks.back().rows.push_back(line);
      continue;
    }
    // What a block does not say again holds on.
    if (!blocks.back().rows.empty()) blocks.push_back({blocks.back().keys, {}});
    const auto colon = content.find(": ");
    if (colon == std::string_view::npos) continue;
    blocks.back().keys.insert_or_assign(std::string(trimmed(content.substr(1, colon - 1))),
                                        std::string(trimmed(content.substr(colon + 2))));
  }
  std::erase_if(blocks, [](const Block& block) { return block.rows.empty(); });
  return blocks;
}

std::string text_of(const Block& block, std::string_view key) {
  const auto found = block.keys.find(key);
  return found == block.keys.end() ? std::string() : found->second;
}

SegmentKind kind_of(const Block& block) {
  const std::string kind = text_of(block, segment_key);
  return kind.starts_with("extend")    ? SegmentKind::approach
         : kind.starts_with("retract") ? SegmentKind::retract
         : kind.starts_with("pause")   ? SegmentKind::pause
                                       : SegmentKind::approach;
}

std::vector<std::vector<double>> values_of(const Block& block, std::size_t columns, const std::string& file) {
  std::vector<std::vector<double>> values(columns);
  for (const TextLine& line : block.rows) {
    const auto cells = cells_of(line.text, ' ');
    if (cells.size() != columns)
      throw bad_input("{}:{}: {} cells where '# columns:' names {}", file, line.number, cells.size(), columns);
    for (std::size_t c = 0; c < columns; ++c) {
      const auto value = number_of(cells[c]);
      if (!value) throw bad_input("{}:{}: '{}' is not a number", file, line.number, printable(cells[c]));
      values[c].push_back(*value);
    }
  }
  return values;
}

SegmentData segment_of(const Block& block, const std::string& file) {
  const std::string names = text_of(block, columns_key), units = text_of(block, units_key);
  const auto columns = cells_of(names, ' '), unit_texts = cells_of(units, ' ');
  std::vector<std::vector<double>> values = values_of(block, columns.size(), file);
  SegmentData part;
  part.segment = {.kind = kind_of(block), .points = static_cast<int>(block.rows.size())};
  for (std::size_t c = 0; c < columns.size(); ++c) {
    const Heading heading = heading_of(columns[c], c < unit_texts.size() ? unit_texts[c] : std::string_view());
    RecordedColumn column{heading.unit ? heading.unit->unit : "", std::move(values[c])};
    for (double& value : column.values) value *= heading.unit ? heading.unit->factor : 1;
    const std::string name = kept_as(heading);
    part.columns.emplace(part.columns.contains(name) ? heading.cell : name, std::move(column));
  }
  return part;
}

bool recognises_jpk_text(const FileContent& file) {
  if (file.archive || !file.bytes.starts_with('#') || !is_text(file.bytes)) return false;
  const std::string_view head = file.bytes.substr(0, 16384);
  return head.find("\n# columns: ") != std::string_view::npos && head.find("\n# units: ") != std::string_view::npos;
}

std::unique_ptr<Recordings> open_jpk_text(const FileContent& file, const Calibration& calibration) {
  const std::string text = to_utf8(file.bytes);
  const std::vector<Block> blocks = blocks_of(text);
  if (blocks.empty()) throw bad_input("{}: no rows below the comments", file.name);
  Recording recording;
  recording.file = file.name;
  for (const auto& [name, value] : blocks.front().keys) set_metadata_from_text(recording.metadata, name, value);
  recording.metadata.format = jpk_text_format.name;
  recording.metadata.software = "JPK";
  std::vector<SegmentData> parts;
  for (const Block& block : blocks) parts.push_back(segment_of(block, file.name));
  assemble(recording, std::move(parts), file.name);
  calibrate(recording, calibration);
  return std::make_unique<ReadyRecordings>(std::vector{std::move(recording)});
}

}  // namespace

const InstrumentFormat jpk_text_format = {"JPK text", ".txt", recognises_jpk_text, open_jpk_text};

}  // namespace validate
