#include "compare/instruments/nanosurf.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

#include "compare/base/errors.hpp"
#include "compare/instruments/assemble.hpp"
#include "compare/instruments/bytes.hpp"
#include "compare/instruments/text.hpp"

namespace validate {
namespace {

using Section = std::map<std::string, std::string, std::less<>>;
using Sections = std::map<std::string, Section, std::less<>>;

constexpr std::string_view data_mark = "#!";
constexpr std::size_t most_channels = 64;  ///< of a group

Sections sections_of(std::string_view header) {
  Sections sections;
  Section* current = nullptr;
  const std::string text = to_utf8(header);
  for (const TextLine& line : lines_of(text)) {
    const std::string_view content = trimmed(line.text);
    if (content.starts_with('[') && content.ends_with(']')) {
      current = &sections[std::string(content.substr(1, content.size() - 2))];
      continue;
    }
    const auto equal = content.find('=');
    if (current && equal != std::string_view::npos)
      current->emplace(trimmed(content.substr(0, equal)), trimmed(content.substr(equal + 1)));
  }
  return sections;
}

std::string text_of(const Section& section, std::string_view key) {
  const auto found = section.find(key);
  return found == section.end() ? std::string() : found->second;
}

double number(const Section& section, std::string_view key) {
  return number_of(text_of(section, key)).value_or(not_known);
}

/// A data set: one channel of one frame, lines of points each; a line is a curve.
struct DataSet {
  std::string frame, channel, unit, ramp_unit;
  std::size_t points = 0, lines = 0, bytes = 0, offset = 0;
  bool is_signed = true;
  double low = 0, range = 0;            ///< of the values
  double ramp_low = 0, ramp_range = 0;  ///< of dimension 0
};

class Reader {
 public:
  explicit Reader(const FileContent& file) : file_(file) {
    const auto mark = file.bytes.find(data_mark);
    if (mark == std::string_view::npos) throw bad_input("{}: no '{}' between header and data", file.name, data_mark);
    sections_ = sections_of(file.bytes.substr(0, mark));
    offset_ = mark + data_mark.size();
    read_sets();
  }

  const std::vector<DataSet>& sets() const { return sets_; }
  const Section& section(const std::string& name) const {
    static const Section none;
    const auto found = sections_.find(name);
    return found == sections_.end() ? none : found->second;
  }

  std::vector<double> values(const DataSet& set, std::size_t line) const {
    std::vector<double> values(set.points);
    const double span = std::exp2(8.0 * static_cast<double>(set.bytes));
    for (std::size_t i = 0; i < set.points; ++i) {
      const std::size_t at = set.offset + (line * set.points + i) * set.bytes;
      const double raw = set.bytes == 2 ? number_at<std::int16_t>(file_.bytes, at, ByteOrder::little)
                                        : number_at<std::int32_t>(file_.bytes, at, ByteOrder::little);
      const double shifted = set.is_signed ? raw + span / 2 : raw < 0 ? raw + span : raw;
      values[i] = set.low + set.range * shifted / span;
    }
    return values;
  }

 private:
  std::size_t count(const Section& section, const std::string& name, std::string_view key) const {
    const double value = number(section, key);
    if (!(value >= 1 && value <= static_cast<double>(file_.bytes.size())) || value != std::floor(value))
      throw bad_input("{}: [{}]: {}: '{}' is not a whole number from 1 to {}", file_.name, printable(name), key,
                      printable(text_of(section, key)), file_.bytes.size());
    return static_cast<std::size_t>(value);
  }

  /// Data sets in the order of groups and channels, which is that of their data.
  void read_sets() {
    const Section& list = section("DataSet");
    const std::size_t groups = std::min(count(list, "DataSet", "GroupCount"), list.size());  // each has a name
    for (std::size_t g = 0; g < groups; ++g)
      for (std::size_t c = 0; c < most_channels; ++c) {
        const std::string name = text_of(list, fmt::format("Gr{}-Ch{}", g, c));
        if (!name.empty()) add_set(name);
      }
  }

  void add_set(const std::string& name) {
    const Section& s = section(name);
    DataSet set;
    set.frame = text_of(s, "Frame");
    set.channel = text_of(s, "Dim2Name");
    set.unit = text_of(s, "Dim2Unit");
    set.ramp_unit = text_of(s, "Dim0Unit");
    set.points = count(s, name, "Points");
    set.lines = count(s, name, "Lines");
    const std::size_t bits = count(s, name, "SaveBits");
    if (bits != 16 && bits != 32)
      throw bad_input("{}: [{}]: SaveBits: {}; allowed: 16, 32", file_.name, printable(name), bits);
    set.bytes = bits / 8;
    set.is_signed = text_of(s, "SaveSign") != "Unsigned";
    set.low = number(s, "Dim2Min");
    set.range = number(s, "Dim2Range");
    set.ramp_low = number(s, "Dim0Min");
    set.ramp_range = number(s, "Dim0Range");
    set.offset = offset_;
    if (set.lines > (file_.bytes.size() - offset_) / set.bytes / set.points)
      throw bad_input("{}: [{}]: {} lines of {} points of {} bytes from byte {} on end behind the file of {} bytes",
                      file_.name, printable(name), set.lines, set.points, set.bytes, offset_, file_.bytes.size());
    offset_ += set.lines * set.points * set.bytes;
    sets_.push_back(std::move(set));
  }

  const FileContent& file_;
  Sections sections_;
  std::size_t offset_ = 0;
  std::vector<DataSet> sets_;
};

struct Frame {
  std::string_view name;
  SegmentKind kind;
};
constexpr std::array frames = {
    Frame{"Spec forward", SegmentKind::approach}, Frame{"Spec fwd pause", SegmentKind::pause},
    Frame{"Spec backward", SegmentKind::retract}, Frame{"Spec bwd pause", SegmentKind::pause}};

/// Columns of one line of a data set: a deflection, a height, or what else it is.
void add_column(SegmentData& part, const DataSet& set, std::vector<double> values) {
  const auto unit = si_unit(set.unit);
  const std::string lower = lower_case(set.channel);
  const std::string si = unit ? unit->unit : set.unit;
  std::string name = printable(set.channel);
  if (lower.starts_with("deflection") && (si == "V" || si == "m")) name = "deflection";
  if (lower.starts_with("deflection") && si == "N") name = "force";
  if (lower.starts_with("z-position sensor") && si == "m")
    name = "height (measured)";
  else if (lower.starts_with("z-") && si == "m")
    name = "height (piezo)";
  if (unit)
    for (double& value : values) value *= unit->factor;
  part.columns.emplace(name, RecordedColumn{si, std::move(values)});
}

/// The ramp of dimension 0 where no channel has the height; the value grows towards the sample.
void add_ramp(SegmentData& part, const DataSet& set) {
  const auto unit = si_unit(set.ramp_unit);
  if (part.columns.contains("height (piezo)") || !unit || unit->unit != "m" || set.points < 2) return;
  if (!std::isfinite(set.ramp_low) || !std::isfinite(set.ramp_range)) return;
  RecordedColumn height{"m", {}};
  for (std::size_t i = 0; i < set.points; ++i) {
    const double along = static_cast<double>(i) / static_cast<double>(set.points - 1);
    const double share = part.segment.kind == SegmentKind::retract ? 1 - along : along;
    height.values.push_back(-unit->factor * (set.ramp_low + share * set.ramp_range));
  }
  part.columns.emplace("height (piezo)", std::move(height));
}

std::vector<SegmentData> curve_of(const Reader& reader, std::size_t line) {
  std::vector<SegmentData> parts;
  for (const Frame& frame : frames) {
    SegmentData part;
    part.segment.kind = frame.kind;
    const DataSet* first = nullptr;
    for (const DataSet& set : reader.sets()) {
      if (set.frame != frame.name || line >= set.lines) continue;
      if (!first) first = &set;
      if (set.points == first->points) add_column(part, set, reader.values(set, line));
    }
    if (!first) continue;
    part.segment.points = static_cast<int>(first->points);
    add_ramp(part, *first);
    parts.push_back(std::move(part));
  }
  return parts;
}

/// "D[0.2]*[N/m]" → 0.2 N/m.
std::optional<SiUnit> property(const std::string& text) {
  const auto open = text.find('['), close = text.find(']'), unit = text.find("*[");
  if (open == std::string::npos || close == std::string::npos || unit == std::string::npos || close < open) return {};
  const auto value = number_of(std::string_view(text).substr(open + 1, close - open - 1));
  auto si = si_unit(std::string_view(text).substr(unit + 2, text.find(']', unit) - unit - 2));
  if (!value || !si) return std::nullopt;
  si->factor *= *value;
  return si;
}

RecordingMetadata metadata_of(const Reader& reader) {
  RecordingMetadata m;
  m.format = nanosurf_format.name;
  m.imaging_mode = "force-distance";
  m.software = "Nanosurf";
  const Section& info = reader.section("DataSet-Info");
  m.date = text_of(info, "Date");
  m.time = text_of(info, "Time");
  m.instrument = text_of(info, "Scan head");
  for (const auto& [key, value] : reader.section("DataSet\\Calibration\\Cantilever")) {
    const auto found = property(value);
    if (!found) continue;
    if (found->unit == "N/m" && !std::isfinite(m.spring_constant_N_per_m)) m.spring_constant_N_per_m = found->factor;
    if (found->unit == "m/V" && !std::isfinite(m.sensitivity_m_per_V)) m.sensitivity_m_per_V = found->factor;
  }
  return m;
}

bool recognises_nanosurf(const FileContent& file) {
  return !file.archive && file.bytes.substr(0, 4096).find("[DataSet]") != std::string_view::npos &&
         file.bytes.find(data_mark) != std::string_view::npos;
}

class Nanosurf : public Recordings {
 public:
  Nanosurf(const FileContent& file, const Calibration& calibration)
      : bytes_(file.bytes), file_{.name = file.name, .bytes = bytes_}, calibration_(calibration), reader_(file_) {
    for (const DataSet& set : reader_.sets())
      if (std::ranges::find(frames, set.frame, &Frame::name) != frames.end()) lines_ = std::max(lines_, set.lines);
    if (lines_ == 0)
      throw bad_input("{}: no frame of a force curve: Spec forward, Spec backward, Spec fwd pause", file.name);
  }

  std::size_t size() const override { return lines_; }

  Recording read(std::size_t line) const override {
    Recording recording;
    recording.file = file_.name;
    recording.index = static_cast<int>(line);
    recording.metadata = metadata_of(reader_);
    assemble(recording, curve_of(reader_, line), file_.name);
    calibrate(recording, calibration_);
    return recording;
  }

 private:
  std::string bytes_;
  FileContent file_;
  Calibration calibration_;
  Reader reader_;
  std::size_t lines_ = 0;
};

std::unique_ptr<Recordings> open_nanosurf(const FileContent& file, const Calibration& calibration) {
  return std::make_unique<Nanosurf>(file, calibration);
}

}  // namespace

const InstrumentFormat nanosurf_format = {"Nanosurf", ".nid", recognises_nanosurf, open_nanosurf};

}  // namespace validate
