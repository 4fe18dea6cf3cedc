#include "compare/instruments/jpk_channel.hpp"

#include <algorithm>
#include <functional>

#include "compare/base/errors.hpp"
#include "compare/instruments/bytes.hpp"
#include "compare/instruments/text.hpp"

namespace validate {
namespace {

constexpr std::string_view encoders =
    "signedshort, unsignedshort, signedinteger, unsignedinteger, signedlong, float-data, double-data, raster-data";

template <class Number>
std::vector<double> numbers(std::string_view bytes) {
  std::vector<double> values(bytes.size() / sizeof(Number));
  for (std::size_t i = 0; i < values.size(); ++i)
    values[i] = static_cast<double>(number_at<Number>(bytes, i * sizeof(Number), ByteOrder::big));
  return values;
}

struct Encoding {
  std::string_view name;
  std::size_t bytes;
  std::vector<double> (*decode)(std::string_view);
};
constexpr Encoding encodings[] = {
    {"signedshort", 2, numbers<std::int16_t>},   {"unsignedshort", 2, numbers<std::uint16_t>},
    {"signedinteger", 4, numbers<std::int32_t>}, {"unsignedinteger", 4, numbers<std::uint32_t>},
    {"signedlong", 8, numbers<std::int64_t>},    {"float-data", 4, numbers<float>},
    {"double-data", 8, numbers<double>}};

}  // namespace

JpkChannel::JpkChannel(const Archive& archive, const std::string& folder, const Properties& header,
                       const std::string& name, int points, const std::string& label)
    : points_(points), label_(fmt::format("{}: channel {}", label, printable(name))) {
  const std::string prefix = "channel." + name + ".";
  read_slots(header, prefix);
  read_values(archive, folder, header, prefix);
}

const JpkSlot* JpkChannel::slot(std::string_view name) const {
  const auto found = std::ranges::find(slots_, name, &JpkSlot::name);
  return found == slots_.end() ? nullptr : &*found;
}

void JpkChannel::read_slots(const Properties& header, const std::string& prefix) {
  const std::string set = prefix + "conversion-set.";
  std::string base = header.text(set + "conversions.base");
  if (base.empty()) base = "volts";
  std::string unit;
  for (const char* key : {"data.encoder.scaling.unit.unit", "encoder.scaling.unit.unit", "unit.unit", "data.unit.unit"})
    if (unit.empty()) unit = header.text(prefix + key);
  slots_.push_back({base, "", 1, 0, unit});
  const std::string list = header.text(set + "conversions.list");
  for (const std::string_view name : cells_of(list, ' ')) {
    const std::string slot = fmt::format("{}conversion.{}.", set, name);
    const auto multiplier = header.number(slot + "scaling.multiplier");
    if (name == base || header.text(slot + "defined") != "true" || !multiplier) continue;
    slots_.push_back({std::string(name), header.text(slot + "base-calibration-slot"), *multiplier,
                      header.number(slot + "scaling.offset").value_or(0), header.text(slot + "scaling.unit.unit")});
  }
}

void JpkChannel::read_values(const Archive& archive, const std::string& folder, const Properties& header,
                             const std::string& prefix) {
  std::string encoder, encoding;
  for (const char* place : {"data.encoder.", "encoder."})
    if (encoder.empty() && header.find(prefix + place + "type")) encoder = prefix + place;
  if (!encoder.empty()) encoding = header.text(encoder + "type");
  if (encoding.empty()) encoding = header.text(prefix + "type");
  if (encoding.empty()) encoding = header.text(prefix + "data.type");
  if (const auto step = header.number(prefix + "data.step"); step && encoding == "raster-data") {
    const double start = header.number(prefix + "data.start").value_or(0);
    for (int i = 0; i < points_; ++i) base_.push_back(start + i * *step);
    return;
  }
  const std::string* file = header.find(prefix + "data.file.name");
  if (!file) throw bad_input("{}: data.file.name: is missing", label_);
  base_ = decoded(archive.read(folder + *file), encoding);
  if (encoder.empty()) return;
  const double multiplier = header.number(encoder + "scaling.multiplier").value_or(1),
               offset = header.number(encoder + "scaling.offset").value_or(0);
  for (double& value : base_) value = value * multiplier + offset;
}

std::vector<double> JpkChannel::decoded(std::string_view bytes, const std::string& encoder) const {
  const auto found = std::ranges::find(encodings, encoder, &Encoding::name);
  if (found == std::end(encodings))
    throw bad_input("{}: the encoder '{}' is not known; known: {}", label_, printable(encoder), encoders);
  if (bytes.size() != found->bytes * static_cast<std::size_t>(points_))
    throw bad_input("{}: {} bytes where {} points of {} take {}", label_, bytes.size(), points_, encoder,
                    found->bytes * static_cast<std::size_t>(points_));
  return found->decode(bytes);
}

std::vector<double> JpkChannel::in(std::string_view name) const {
  std::vector<const JpkSlot*> chain;
  for (const JpkSlot* at = slot(name); at && at != &slots_.front(); at = slot(at->base)) {
    if (std::ranges::find(chain, at) != chain.end())
      throw bad_input("{}: the conversion {} is made from itself", label_, printable(name));
    chain.push_back(at);
  }
  if (name != slots_.front().name && (chain.empty() || !slot(chain.back()->base)))
    throw bad_input("{}: the conversion {} is made from none that the file defines", label_, printable(name));
  std::vector<double> values = base_;
  for (auto at = chain.rbegin(); at != chain.rend(); ++at)
    for (double& value : values) value = value * (*at)->multiplier + (*at)->offset;
  return values;
}

}  // namespace validate
