#include "compare/instruments/jpk_segment.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "compare/base/errors.hpp"
#include "compare/instruments/jpk_channel.hpp"
#include "compare/instruments/text.hpp"

namespace validate {
namespace {

constexpr std::string_view settings = "force-segment-header.settings.";

SegmentKind kind_of(const Properties& header, const std::string& label) {
  std::string style = header.text(std::string(settings) + "style");
  if (style.empty()) style = header.text(std::string(settings) + "segment-settings.style");
  if (style == "extend") return SegmentKind::approach;
  if (style == "retract") return SegmentKind::retract;
  if (style == "pause") return SegmentKind::pause;
  throw bad_input("{}: force-segment-header.settings.style: '{}'; allowed: extend, retract, pause", label,
                  printable(style));
}

/// Name and slot of the first channel of a list that the segment has with that slot.
struct Choice {
  std::string_view channel, slot;
};
constexpr std::array measured = {Choice{"capacitiveSensorHeight", "nominal"}, Choice{"measuredHeight", "nominal"},
                                 Choice{"strainGaugeHeight", "nominal"}};
constexpr std::array piezo = {Choice{"head-height", "calibrated"}, Choice{"height", "calibrated"}};

class Reader {
 public:
  Reader(const Archive& archive, const std::string& folder, const Properties& header, int points,
         const std::string& label)
      : archive_(archive), folder_(folder), header_(header), points_(points), label_(label) {
    const std::string list = header.text("channels.list");
    for (const std::string_view name : cells_of(list, ' ')) names_.emplace_back(name);
  }

  bool has(std::string_view name) const {
    return std::find(names_.begin(), names_.end(), name) != names_.end() &&
           header_.find(fmt::format("channel.{}.data.file.name", name));
  }
  JpkChannel channel(std::string_view name) const {
    return JpkChannel(archive_, folder_, header_, std::string(name), points_, label_);
  }

  template <std::size_t N>
  void height(const std::array<Choice, N>& choices, const char* column, SegmentData& into) const {
    for (const auto& [name, slot] : choices) {
      if (!has(name)) continue;
      const JpkChannel one = channel(name);
      const JpkSlot* found = one.slot(slot);
      if (!found || found->unit != "m") continue;
      into.columns[column] = {found->unit, one.in(slot)};
      return;
    }
  }

 private:
  const Archive& archive_;
  const std::string& folder_;
  const Properties& header_;
  int points_;
  const std::string& label_;
  std::vector<std::string> names_;
};

/// Deflection in m where the file calibrates it, else in V, and force where it calibrates that.
void read_deflection(const Reader& reader, JpkSegment& segment) {
  if (!reader.has("vDeflection")) return;
  const JpkChannel channel = reader.channel("vDeflection");
  const JpkSlot *distance = channel.slot("distance"), *force = channel.slot("force");
  const std::string& base = channel.slots().front().name;
  const bool metres = distance && distance->unit == "m", newtons = force && force->unit == "N";
  segment.data.columns["deflection"] = {metres ? "m" : channel.slots().front().unit,
                                        channel.in(metres ? "distance" : base)};
  if (metres && distance->base == base) segment.sensitivity_m_per_V = distance->multiplier;
  if (!newtons) return;
  segment.data.columns["force"] = {"N", channel.in("force")};
  if (metres && force->base == "distance") segment.spring_constant_N_per_m = force->multiplier;
}

void read_settings(JpkSegment& segment, const std::string& label) {
  const Properties& header = segment.header;
  RecordedSegment& s = segment.data.segment;
  const auto number = [&header](const std::string& key) { return header.number(key).value_or(not_known); };
  const std::string planned = std::string(settings) + "segment-settings.";
  s.kind = kind_of(header, label);
  const auto points = header.count("force-segment-header.num-points");
  if (!points) throw bad_input("{}: force-segment-header.num-points: is missing", label);
  s.points = *points;
  s.duration_s = number("force-segment-header.duration");
  s.time_stamp = header.text("force-segment-header.time-stamp");
  s.baseline_V = number("force-segment-header.baseline.baseline");
  s.setpoint_V = number(planned + "setpoint");
  segment.approach_id = header.text("force-segment-header.approach-id");
  segment.settings_type = header.text(planned + "type");
  segment.planned_duration_s = number(planned + "duration");
  segment.stroke_m = std::abs(number(planned + "z-start") - number(planned + "z-end"));
}

}  // namespace

JpkSegment read_jpk_segment(const Archive& archive, const std::string& folder, const Properties& shared,
                            const std::string& label) {
  const std::string file = folder + "segment-header.properties", where = label + ": " + file;
  JpkSegment segment;
  segment.header = Properties(archive.read(file), where);
  segment.header.resolve(shared);
  read_settings(segment, where);
  const Reader reader(archive, folder, segment.header, segment.data.segment.points, where);
  read_deflection(reader, segment);
  reader.height(measured, "height (measured)", segment.data);
  reader.height(piezo, "height (piezo)", segment.data);
  if (segment.data.columns.empty())
    throw bad_input("{}: channels.list has neither vDeflection nor a height with data: {}", where,
                    printable(segment.header.text("channels.list")));
  return segment;
}

}  // namespace validate
