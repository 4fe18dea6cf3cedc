#include "compare/instruments/igor.hpp"

#include <algorithm>
#include <cmath>
#include <map>

#include "compare/base/errors.hpp"
#include "compare/instruments/assemble.hpp"
#include "compare/instruments/igor_wave.hpp"
#include "compare/instruments/text.hpp"

namespace validate {
namespace {

using Note = std::map<std::string, std::string, std::less<>>;

Note note_of(const std::string& text) {
  Note note;
  const std::string utf8 = to_utf8(text);
  for (const TextLine& line : lines_of(utf8)) {
    const auto colon = line.text.find(':');
    if (colon != std::string_view::npos)
      note.emplace(trimmed(line.text.substr(0, colon)), trimmed(line.text.substr(colon + 1)));
  }
  return note;
}

double number(const Note& note, std::string_view key) {
  const auto found = note.find(key);
  return found == note.end() ? not_known : number_of(found->second).value_or(not_known);
}

std::string text(const Note& note, std::string_view key) {
  const auto found = note.find(key);
  return found == note.end() ? std::string() : found->second;
}

std::vector<double> list(const Note& note, std::string_view key) {
  std::vector<double> values;
  const auto found = note.find(key);
  if (found == note.end()) return values;
  for (const std::string_view cell : cells_of(found->second, ','))
    if (!cell.empty()) values.push_back(number_of(cell).value_or(not_known));
  return values;
}

/// Sections of the wave: `Indexes` are their first points and the last point of all, `Direction` 1, -1 or 0 behind a
/// NaN.
std::vector<RecordedSegment> segments_of(const Note& note, std::size_t rows, const std::string& label) {
  const std::vector<double> first = list(note, "Indexes"), direction = list(note, "Direction");
  std::vector<RecordedSegment> segments;
  std::size_t from = 0;
  for (std::size_t i = 1; i < first.size() && i < direction.size(); ++i) {
    const bool last = i + 1 == std::min(first.size(), direction.size());
    if (!(first[i] >= static_cast<double>(from) && first[i] <= static_cast<double>(rows)))
      throw bad_input("{}: note: Indexes: {:g} is not from {} to {}, the wave's points", label, first[i], from, rows);
    const std::size_t to = last ? rows : static_cast<std::size_t>(first[i]);
    if (to > from)
      segments.push_back({.kind = direction[i] > 0   ? SegmentKind::approach
                                  : direction[i] < 0 ? SegmentKind::retract
                                                     : SegmentKind::pause,
                          .points = static_cast<int>(to - from)});
    from = to;
  }
  return segments;
}

/// The column of the first label that is there, times a factor.
std::optional<RecordedColumn> channel(const IgorWave& wave, std::initializer_list<std::string_view> names,
                                      double factor) {
  for (const std::string_view name : names)
    for (std::size_t c = 0; c < wave.labels.size() && c < wave.columns.size(); ++c) {
      if (wave.labels[c] != name) continue;
      RecordedColumn column{"m", wave.columns[c]};
      for (double& value : column.values) value *= factor;
      return column;
    }
  return std::nullopt;
}

void add_other_channels(Recording& recording, const IgorWave& wave) {
  static constexpr std::array<std::string_view, 6> known = {"Raw", "Height", "Defl", "Deflection", "ZSnsr", "ZSensor"};
  for (std::size_t c = 0; c < wave.labels.size() && c < wave.columns.size(); ++c)
    if (std::ranges::find(known, wave.labels[c]) == known.end())
      recording.other_columns.push_back({printable(wave.labels[c]), "", wave.columns[c]});
}

RecordingMetadata metadata_of(const Note& note) {
  RecordingMetadata m;
  m.format = igor_format.name;
  m.imaging_mode = "force-distance";
  m.feedback_mode = lower_case(text(note, "ImagingMode"));
  m.instrument = text(note, "MicroscopeModel");
  m.software = "Asylum Research";
  m.software_version = text(note, "Version");
  m.date = text(note, "Date");
  m.time = text(note, "Time");
  m.session_id = m.date + "_" + m.time;
  m.duration_s = number(note, "InputTime");
  m.spring_constant_N_per_m = number(note, "SpringConstant");
  m.sensitivity_m_per_V = number(note, "InvOLS");
  m.position_x_m = number(note, "XLVDT");
  m.position_y_m = number(note, "YLVDT");
  m.rate_approach_Hz = m.rate_retract_Hz = number(note, "NumPtsPerSec");
  m.speed_approach_m_per_s = number(note, "ApproachVelocity");
  m.speed_retract_m_per_s = number(note, "RetractVelocity");
  const std::string trigger = text(note, "TriggerChannel");
  if (trigger == "Force") m.setpoint_unit = "N";
  if (trigger.starts_with("Defl")) m.setpoint_unit = trigger == "DeflVolts" ? "V" : "m";
  if (!m.setpoint_unit.empty()) m.setpoint = number(note, "TriggerPoint");
  return m;
}

bool recognises_igor(const FileContent& file) { return !file.archive && is_igor_wave(file.bytes); }

std::unique_ptr<Recordings> open_igor(const FileContent& file, const Calibration& calibration) {
  const IgorWave wave = read_igor_wave(file.bytes, file.name);
  const Note note = note_of(wave.note);
  Recording recording;
  recording.file = file.name;
  recording.metadata = metadata_of(note);
  recording.metadata.points = static_cast<int>(wave.rows);
  recording.columns.height_piezo = channel(wave, {"Raw", "Height"}, -1);
  recording.columns.height_measured = channel(wave, {"ZSnsr", "ZSensor"}, -1);
  recording.columns.deflection = channel(wave, {"Defl", "Deflection"}, 1);
  add_other_channels(recording, wave);
  if (!recording.columns.deflection && !recording.columns.height_piezo && !recording.columns.height_measured)
    throw bad_input(
        "{}: no channel of a force curve among the labels: {}; expected Raw or Height, Defl or Deflection, "
        "ZSnsr or ZSensor",
        file.name, printable(fmt::format("{}", fmt::join(wave.labels, ", "))));
  recording.segments = segments_of(note, wave.rows, file.name);
  if (recording.segments.empty()) {
    const auto& z = recording.columns.height_piezo ? recording.columns.height_piezo : recording.columns.height_measured;
    const auto turn =
        z ? std::ranges::min_element(z->values) - z->values.begin() : static_cast<std::ptrdiff_t>(wave.rows);
    recording.segments = approach_and_retract(static_cast<std::size_t>(turn), wave.rows);
    recording.notes.push_back("the wave's note has no Indexes: segments are told apart at the lowest height");
  }
  calibrate(recording, calibration);
  return std::make_unique<ReadyRecordings>(std::vector{std::move(recording)});
}

}  // namespace

const InstrumentFormat igor_format = {"Igor binary wave", ".ibw", recognises_igor, open_igor};

}  // namespace validate
