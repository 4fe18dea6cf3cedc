#include "compare/instruments/jpk.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <map>
#include <set>

#include "compare/base/errors.hpp"
#include "compare/instruments/assemble.hpp"
#include "compare/instruments/jpk_segment.hpp"
#include "compare/instruments/text.hpp"

namespace validate {
namespace {

/// The number between a prefix and the next slash of a member's name, and what follows.
std::optional<int> number_after(std::string_view name, std::string_view prefix, std::string_view& rest) {
  if (!name.starts_with(prefix)) return std::nullopt;
  name.remove_prefix(prefix.size());
  int number = 0;
  const auto [end, error] = std::from_chars(name.data(), name.data() + name.size(), number);
  rest = name.substr(static_cast<std::size_t>(end - name.data()));
  if (error != std::errc{} || number < 0 || !rest.starts_with('/')) return std::nullopt;
  rest.remove_prefix(1);
  return number;
}

/// What the beginning of a segment's keys is called in a header: force-scan-series, quantitative-imaging-map, …
std::string key_prefix(const Properties& header) { return header.text("type") + "."; }

std::string imaging_mode(const std::vector<JpkSegment>& segments) {
  std::string pattern;
  for (const JpkSegment& s : segments)
    pattern += s.data.segment.kind == SegmentKind::approach  ? 'a'
               : s.data.segment.kind == SegmentKind::retract ? 'r'
               : s.settings_type == "constant-force-pause"   ? 'f'
                                                             : 'h';
  if (pattern == "ar") return "force-distance";
  if (pattern == "afr" || pattern == "hafr") return "creep-compliance";
  if (pattern == "ahr" || pattern == "hahr") return "stress-relaxation";
  return "";
}

/// Runs over all segments: what is idle between them is in the time stamps alone.
void add_times(std::vector<JpkSegment>& segments) {
  double before = 0;
  for (JpkSegment& s : segments) {
    const RecordedSegment& segment = s.data.segment;
    RecordedColumn time{"s", {}};
    for (int i = 0; i < segment.points; ++i) time.values.push_back(before + i * segment.duration_s / segment.points);
    before += segment.duration_s;
    if (std::isfinite(segment.duration_s)) s.data.columns["time"] = std::move(time);
  }
}

/// "2016-03-31 17:51:14.543 +0200" → date and time of the day, without zeros at the end.
void set_date(RecordingMetadata& m, const std::string& time_stamp) {
  const auto parts = cells_of(time_stamp, ' ');
  if (parts.size() < 2) return;
  m.date = parts[0];
  m.time = parts[1];
  if (m.time.find('.') == std::string::npos) return;
  while (m.time.ends_with('0')) m.time.pop_back();
  if (m.time.ends_with('.')) m.time.pop_back();
}

void set_motion(RecordingMetadata& m, const JpkSegment& s) {
  const RecordedSegment& segment = s.data.segment;
  const double rate = segment.points / segment.duration_s, speed = s.stroke_m / s.planned_duration_s;
  const auto first = [](double& place, double value) {
    if (!std::isfinite(place) && std::isfinite(value)) place = value;
  };
  if (segment.kind == SegmentKind::approach) first(m.rate_approach_Hz, rate), first(m.speed_approach_m_per_s, speed);
  if (segment.kind == SegmentKind::retract) first(m.rate_retract_Hz, rate), first(m.speed_retract_m_per_s, speed);
  first(m.sensitivity_m_per_V, s.sensitivity_m_per_V);
  first(m.spring_constant_N_per_m, s.spring_constant_N_per_m);
}

const JpkSegment& approach_of(const std::vector<JpkSegment>& segments) {
  const auto found =
      std::ranges::find(segments, SegmentKind::approach, [](const JpkSegment& s) { return s.data.segment.kind; });
  return found == segments.end() ? segments.front() : *found;
}

class JpkRecordings : public Recordings {
 public:
  JpkRecordings(const FileContent& file, const Calibration& calibration)
      : name_(file.name),
        archive_(file.archive),
        calibration_(calibration),
        header_(archive_->read("header.properties"), name_ + ": header.properties") {
    if (archive_->has("shared-data/header.properties"))
      shared_ = Properties(archive_->read("shared-data/header.properties"), name_ + ": shared-data/header.properties");
    find_curves();
    if (curves_.empty()) throw bad_input("{}: a JPK archive without segments/0/segment-header.properties", name_);
  }

  std::size_t size() const override { return curves_.size(); }

  Recording read(std::size_t i) const override {
    const auto& [index, segment_numbers] = *std::next(curves_.begin(), static_cast<std::ptrdiff_t>(i));
    const std::string folder = index < 0 ? "" : fmt::format("index/{}/", index);
    const std::string label = index < 0 ? name_ : fmt::format("{}: curve {}", name_, index);
    std::vector<JpkSegment> segments;
    for (const int n : segment_numbers)
      segments.push_back(read_jpk_segment(*archive_, fmt::format("{}segments/{}/", folder, n), shared_, name_));
    add_times(segments);
    Recording recording;
    recording.file = name_;
    recording.index = std::max(index, 0);
    describe_curve(recording.metadata, folder, segments);
    if (index >= 0) describe_grid(recording.metadata, index);
    std::vector<SegmentData> parts;
    for (JpkSegment& s : segments) parts.push_back(std::move(s.data));
    assemble(recording, std::move(parts), label);
    finish(recording);
    return recording;
  }

 private:
  /// Curves by their number in the scan, -1 for the only one of a file, with the numbers of their segments.
  void find_curves() {
    for (const std::string& member : archive_->names()) {
      std::string_view rest = member;
      int curve = -1;
      if (const auto index = number_after(member, "index/", rest)) curve = *index;
      const auto segment = number_after(rest, "segments/", rest);
      if (segment && rest == "segment-header.properties") curves_[curve].insert(*segment);
    }
  }

  void describe_curve(RecordingMetadata& m, const std::string& folder, const std::vector<JpkSegment>& segments) const {
    const std::string own = folder + "header.properties";
    const Properties header = folder.empty()       ? header_
                              : archive_->has(own) ? Properties(archive_->read(own), name_ + ": " + own)
                                                   : Properties();
    const std::string prefix = key_prefix(header);
    const std::string top = key_prefix(header_);
    const JpkSegment& approach = approach_of(segments);
    m.format = jpk_format.name;
    m.imaging_mode = imaging_mode(segments);
    m.feedback_mode = approach.header.text("force-segment-header.settings.feedback-mode.name");
    m.software = "JPK";
    m.instrument = header.text(prefix + "description.instrument");
    m.software_version = header.text(prefix + "description.source-software");
    if (m.instrument.empty()) m.instrument = header_.text(top + "description.instrument");
    if (m.software_version.empty()) m.software_version = header_.text(top + "description.source-software");
    m.session_id = approach.approach_id;
    const auto place = header.count(prefix + "header.position-index");
    if (!m.session_id.empty()) m.curve_id = fmt::format("{}:{}", m.session_id, place.value_or(0));
    m.position_x_m = header.number(prefix + "header.position.x").value_or(not_known);
    m.position_y_m = header.number(prefix + "header.position.y").value_or(not_known);
    set_date(m, approach.data.segment.time_stamp);
    m.number = 0;
    m.duration_s = 0;
    for (const JpkSegment& s : segments) {
      set_motion(m, s);
      m.duration_s += s.data.segment.duration_s;
    }
    m.setpoint = approach.data.segment.setpoint_V;
  }

  void describe_grid(RecordingMetadata& m, int index) const {
    m.number = index;
    const std::string grid = key_prefix(header_) + "position-pattern.grid.";
    const auto number = [&](const char* key) { return header_.number(grid + key).value_or(not_known); };
    m.grid_center_x_m = number("xcenter");
    m.grid_center_y_m = number("ycenter");
    m.grid_size_x_m = number("ulength");
    m.grid_size_y_m = number("vlength");
    m.grid_shape_x = header_.count(grid + "ilength");
    m.grid_shape_y = header_.count(grid + "jlength");
    if (m.grid_shape_x.value_or(0) < 1) return;
    const int columns = *m.grid_shape_x, row = index / columns, column = index % columns;
    const bool turns = header_.text(key_prefix(header_) + "position-pattern.back-and-forth") == "true";
    m.grid_index_x = turns && row % 2 == 1 ? columns - 1 - column : column;
    m.grid_index_y = row;
  }

  void finish(Recording& recording) const {
    RecordingMetadata& m = recording.metadata;
    calibrate(recording, calibration_);
    if (!std::isfinite(m.setpoint)) return;
    const double newtons_per_volt = m.sensitivity_m_per_V * m.spring_constant_N_per_m;
    m.setpoint_unit = std::isfinite(newtons_per_volt) ? "N" : "V";
    if (std::isfinite(newtons_per_volt)) m.setpoint *= newtons_per_volt;
  }

  std::string name_;
  std::shared_ptr<const Archive> archive_;
  Calibration calibration_;
  Properties header_, shared_;
  std::map<int, std::set<int>> curves_;
};

bool recognises_jpk(const FileContent& file) {
  if (!file.archive || !file.archive->has("header.properties")) return false;
  return file.archive->read("header.properties").find("jpk-data-file") != std::string::npos;
}

std::unique_ptr<Recordings> open_jpk(const FileContent& file, const Calibration& calibration) {
  return std::make_unique<JpkRecordings>(file, calibration);
}

}  // namespace

const InstrumentFormat jpk_format = {"JPK", ".jpk-force, .jpk-force-map, .jpk-qi-data, .jpk-qi-series", recognises_jpk,
                                     open_jpk};

}  // namespace validate
