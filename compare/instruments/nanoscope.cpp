#include "compare/instruments/nanoscope.hpp"

#include <algorithm>
#include <cmath>

#include "compare/base/errors.hpp"
#include "compare/instruments/assemble.hpp"
#include "compare/instruments/bytes.hpp"
#include "compare/instruments/nanoscope_header.hpp"
#include "compare/instruments/text.hpp"

namespace validate {
namespace {

using Sections = std::vector<NanoscopeSection>;

/// A channel of all curves of the file: where it lies and how its integers become volts.
struct Channel {
  std::string name;       ///< "Deflection Error"
  std::string reference;  ///< of its sensitivity: "Sens. DeflSens"
  std::size_t offset = 0, bytes = 2, length = 0;
  std::size_t approach = 0, retract = 0;  ///< points
  double volts = 1;                       ///< of one

  std::size_t points() const { return approach + retract; }
};

std::string text_of(const NanoscopeSection& section, std::string_view key) {
  const auto found = section.keys.find(key);
  return found == section.keys.end() ? std::string() : found->second;
}

std::size_t whole_number(const NanoscopeSection& section, std::string_view key, const FileContent& file) {
  const std::string text = text_of(section, key);
  const auto cells = cells_of(text, ' ');
  const auto value = cells.empty() ? std::nullopt : number_of(cells.front());
  if (!value || !(*value >= 0 && *value <= static_cast<double>(file.bytes.size())) || *value != std::floor(*value))
    throw bad_input("{}: {}: '{}' is not a whole number from 0 to {}, the file's size", file.name, key, printable(text),
                    file.bytes.size());
  return static_cast<std::size_t>(*value);
}

/// Points of both ways. Where there are two numbers the first is the way back.
void set_points(Channel& channel, const NanoscopeSection& section, const FileContent& file) {
  const std::string text = text_of(section, "Samps/line");
  const auto cells = cells_of(text, ' ');
  channel.retract = whole_number(section, "Samps/line", file);
  const auto second = cells.size() > 1 ? number_of(cells[1]) : std::nullopt;
  channel.approach = channel.retract;
  if (second && *second >= 0 && *second <= static_cast<double>(file.bytes.size()))
    channel.approach = static_cast<std::size_t>(*second);
  if (channel.points() == 0) throw bad_input("{}: Samps/line: '{}' leaves no points", file.name, printable(text));
}

/// "S [DeflectionError] "Deflection Error"" → Deflection Error.
std::string image_name(const std::string& text) {
  const auto from = text.find('"');
  if (from == std::string::npos) return std::string(trimmed(text.substr(text.find(']') + 1)));
  return text.substr(from + 1, text.find('"', from + 1) - from - 1);
}

Channel channel_of(const NanoscopeSection& section, const FileContent& file) {
  Channel channel;
  channel.name = image_name(text_of(section, "Image Data"));
  channel.offset = whole_number(section, "Data offset", file);
  channel.length = whole_number(section, "Data length", file);
  channel.bytes = section.keys.contains("Bytes/pixel") ? whole_number(section, "Bytes/pixel", file) : 2;
  set_points(channel, section, file);
  // Since version 9.2 two bytes may be said of what takes four.
  if (channel.length == 4 * channel.points()) channel.bytes = 4;
  if (channel.bytes != 2 && channel.bytes != 4)
    throw bad_input("{}: Bytes/pixel: {}; allowed: 2, 4", file.name, channel.bytes);
  if (channel.length > file.bytes.size() - channel.offset)
    throw bad_input("{}: '{}': {} bytes from byte {} on end behind the file of {} bytes", file.name,
                    printable(channel.name), channel.length, channel.offset, file.bytes.size());
  if (channel.length < channel.points() * channel.bytes)
    throw bad_input("{}: '{}': Data length: {} bytes hold less than {} points of {} bytes", file.name,
                    printable(channel.name), channel.length, channel.points(), channel.bytes);
  const NanoscopeValue scale = nanoscope_value(text_of(section, "Z scale"));
  channel.reference = scale.reference;
  if (scale.soft && *scale.soft != 0)
    channel.volts = *scale.soft / std::exp2(8.0 * static_cast<double>(channel.bytes));
  else if (scale.hard)
    channel.volts = *scale.hard;
  else
    throw bad_input("{}: '{}': no Z scale", file.name, printable(channel.name));
  return channel;
}

/// Values of one way in order of time, V. Both ways are stored from the contact outwards.
std::vector<double> volts(const Channel& channel, const FileContent& file, std::size_t curve, bool approach) {
  const std::size_t count = approach ? channel.approach : channel.retract;
  std::size_t at = channel.offset + (curve * channel.points() + (approach ? 0 : channel.approach)) * channel.bytes;
  std::vector<double> values(count);
  for (double& value : values) {
    value = channel.volts * (channel.bytes == 2 ? number_at<std::int16_t>(file.bytes, at, ByteOrder::little)
                                                : number_at<std::int32_t>(file.bytes, at, ByteOrder::little));
    at += channel.bytes;
  }
  if (approach) std::ranges::reverse(values);
  return values;
}

/// m/V of "V 61.7 nm/V" under the name in brackets.
double sensitivity(const Sections& sections, const std::string& reference) {
  const auto text = nanoscope_find(sections, reference);
  if (!text) return not_known;
  const NanoscopeValue value = nanoscope_value(*text);
  const auto unit = si_unit(value.unit);
  return value.soft && unit && unit->unit == "m/V" ? *value.soft * unit->factor : not_known;
}

/// Length of the ramp in m: volts of the piezo by its sensitivity.
double ramp_m(const Sections& sections) {
  for (const char* key : {"Ramp size", "Ramp Size"})
    if (const auto text = nanoscope_find(sections, key)) {
      const NanoscopeValue value = nanoscope_value(*text);
      if (value.soft) return *value.soft * sensitivity(sections, value.reference);
    }
  return not_known;
}

double number(const Sections& sections, std::string_view key) {
  const std::string text = nanoscope_find(sections, key).value_or("");
  const auto cells = cells_of(text, ' ');
  return cells.empty() || cells.front().empty() ? not_known : number_of(cells.front()).value_or(not_known);
}

RecordingMetadata metadata_of(const Sections& sections) {
  RecordingMetadata m;
  m.format = nanoscope_format.name;
  m.imaging_mode = "force-distance";
  m.software = "NanoScope";
  m.software_version = nanoscope_find(sections, "Version").value_or("");
  m.instrument = nanoscope_find(sections, "Microscope").value_or("");
  m.date = nanoscope_find(sections, "Date").value_or("");
  m.spring_constant_N_per_m = number(sections, "Spring Constant");
  if (!std::isfinite(m.spring_constant_N_per_m)) m.spring_constant_N_per_m = number(sections, "Spring constant");
  const double z = sensitivity(sections, "Sens. Zsens");
  m.speed_approach_m_per_s = number(sections, "Forward vel.") * z;
  m.speed_retract_m_per_s = number(sections, "Reverse vel.") * z;
  return m;
}

/// The sensor's sign is not told: the height has to fall on the way to the sample.
void orient(SegmentData& approach, SegmentData& retract) {
  const auto& way = approach.columns["height (measured)"].values;
  if (way.empty() || way.back() <= way.front()) return;
  for (SegmentData* part : {&approach, &retract})
    for (double& value : part->columns["height (measured)"].values) value = -value;
}

class Nanoscope : public Recordings {
 public:
  Nanoscope(const FileContent& file, const Calibration& calibration)
      : name_(file.name), bytes_(file.bytes), calibration_(calibration), sections_(nanoscope_sections(bytes_, name_)) {
    for (const NanoscopeSection& section : sections_)
      if (section.title.starts_with("ciao force image list")) channels_.push_back(channel_of(section, content()));
    if (channels_.empty()) throw bad_input("{}: no section '\\*Ciao force image list': no force curve", name_);
    for (const Channel& channel : channels_) {
      if (channel.approach != channels_[0].approach || channel.retract != channels_[0].retract)
        throw bad_input("{}: channels of {} and {} points", name_, channels_[0].points(), channel.points());
      curves_ = std::min(curves_, channel.length / channel.bytes / channel.points());
    }
  }

  std::size_t size() const override { return curves_; }

  Recording read(std::size_t i) const override {
    Recording recording;
    recording.file = name_;
    recording.index = static_cast<int>(i);
    recording.metadata = metadata_of(sections_);
    SegmentData approach, retract;
    approach.segment.points = static_cast<int>(channels_[0].approach);
    retract.segment = {.kind = SegmentKind::retract, .points = static_cast<int>(channels_[0].retract)};
    add_ramp(approach, retract);
    for (const Channel& channel : channels_) add_channel(recording, channel, i, approach, retract);
    if (approach.columns.contains("height (measured)")) orient(approach, retract);
    std::vector<SegmentData> parts;
    for (SegmentData* part : {&approach, &retract})
      if (part->segment.points > 0) parts.push_back(std::move(*part));
    assemble(recording, std::move(parts), name_);
    calibrate(recording, calibration_);
    return recording;
  }

 private:
  FileContent content() const { return {.name = name_, .bytes = bytes_}; }

  /// The ramp is even, its zero where it begins.
  void add_ramp(SegmentData& approach, SegmentData& retract) const {
    const double ramp = ramp_m(sections_);
    if (!std::isfinite(ramp)) return;
    const auto column = [&](std::size_t points, bool down) {
      RecordedColumn height{"m", std::vector<double>(points)};
      for (std::size_t i = 0; i < points; ++i)
        height.values[i] = -ramp * static_cast<double>(down ? i : points - 1 - i) / static_cast<double>(points);
      return height;
    };
    approach.columns["height (piezo)"] = column(channels_[0].approach, true);
    retract.columns["height (piezo)"] = column(channels_[0].retract, false);
  }

  void add_channel(Recording& recording, const Channel& channel, std::size_t curve, SegmentData& approach,
                   SegmentData& retract) const {
    const double per_volt = sensitivity(sections_, channel.reference);
    const bool height = channel.name.find("Height Sensor") != std::string::npos && std::isfinite(per_volt);
    const bool deflection = channel.name.find("Deflection") != std::string::npos;
    std::string name = height ? "height (measured)" : deflection ? "deflection" : printable(channel.name);
    if (approach.columns.contains(name)) name += " again";
    if (deflection && std::isfinite(per_volt)) recording.metadata.sensitivity_m_per_V = per_volt;
    for (const bool way : {true, false}) {
      RecordedColumn column{height ? "m" : "V", volts(channel, content(), curve, way)};
      for (double& value : column.values) value *= height ? per_volt : 1;
      (way ? approach : retract).columns[name] = std::move(column);
    }
  }

  std::string name_, bytes_;
  Calibration calibration_;
  Sections sections_;
  std::vector<Channel> channels_;
  std::size_t curves_ = static_cast<std::size_t>(-1);
};

bool recognises_nanoscope(const FileContent& file) {
  return !file.archive && (file.bytes.starts_with("\\*Force file list") || file.bytes.starts_with("\\*File list") ||
                           file.bytes.starts_with("\\*EC File list"));
}

std::unique_ptr<Recordings> open_nanoscope(const FileContent& file, const Calibration& calibration) {
  return std::make_unique<Nanoscope>(file, calibration);
}

}  // namespace

const InstrumentFormat nanoscope_format = {"NanoScope", ".spm, .000, .001, …", recognises_nanoscope, open_nanoscope};

}  // namespace validate
