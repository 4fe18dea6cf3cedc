#include "compare/instruments/igor_wave.hpp"

#include <algorithm>
#include <array>
#include <cstdint>
#include <optional>

#include "compare/base/errors.hpp"
#include "compare/instruments/bytes.hpp"

namespace validate {
namespace {

constexpr std::size_t header_bytes = 384;
constexpr int version = 5;

/// Offsets of what is read in the header.
namespace at {
constexpr std::size_t formula_size = 8, note_size = 12, extended_size = 16, dimension_unit_sizes = 20, label_sizes = 36,
                      type = 80, extents = 132, step = 148, unit = 212;
}
constexpr std::size_t label_bytes = 32;

std::string text_at(std::string_view bytes, std::size_t offset, std::size_t size) {
  const std::string_view field = bytes.substr(offset, size);
  return std::string(field.substr(0, field.find('\0')));
}

template <class Number>
double value_at(std::string_view bytes, std::size_t offset, ByteOrder order) {
  return static_cast<double>(number_at<Number>(bytes, offset, order));
}

struct ValueType {
  int code;
  std::size_t bytes;
  double (*at)(std::string_view, std::size_t, ByteOrder);
};
constexpr std::array types = {ValueType{2, 4, value_at<float>},
                              ValueType{4, 8, value_at<double>},
                              ValueType{8, 1, value_at<std::int8_t>},
                              ValueType{16, 2, value_at<std::int16_t>},
                              ValueType{32, 4, value_at<std::int32_t>},
                              ValueType{64 + 8, 1, value_at<std::uint8_t>},
                              ValueType{64 + 16, 2, value_at<std::uint16_t>},
                              ValueType{64 + 32, 4, value_at<std::uint32_t>}};

class Header {
 public:
  Header(std::string_view bytes, ByteOrder order, const std::string& label)
      : bytes_(bytes), order_(order), label_(label) {}

  /// A size of something in the file, which cannot be larger than it.
  std::size_t size(std::size_t offset, const char* what) const {
    const auto value = number_at<std::int32_t>(bytes_, offset, order_);
    if (value < 0 || static_cast<std::size_t>(value) > bytes_.size())
      throw bad_input("{}: byte {}: {} of {} in a file of {} bytes", label_, offset, what, value, bytes_.size());
    return static_cast<std::size_t>(value);
  }

  const ValueType& type() const {
    const auto code = number_at<std::int16_t>(bytes_, at::type, order_);
    const auto found = std::ranges::find(types, code, &ValueType::code);
    if (found == types.end())
      throw bad_input(
          "{}: byte {}: values of type {}; allowed: 2 (float32), 4 (float64), 8, 16, 32 (integers), 72, 80, "
          "96 (unsigned)",
          label_, at::type, code);
    return *found;
  }

 private:
  std::string_view bytes_;
  ByteOrder order_;
  const std::string& label_;
};

std::optional<ByteOrder> order_of(std::string_view bytes) {
  if (bytes.size() < header_bytes) return std::nullopt;
  for (const ByteOrder order : {ByteOrder::little, ByteOrder::big}) {
    if (number_at<std::int16_t>(bytes, 0, order) != version) continue;
    std::uint16_t sum = 0;
    for (std::size_t i = 0; i < header_bytes; i += 2)
      sum = static_cast<std::uint16_t>(sum + number_at<std::uint16_t>(bytes, i, order));
    if (sum == 0) return order;
  }
  return std::nullopt;
}

}  // namespace

bool is_igor_wave(std::string_view bytes) { return order_of(bytes).has_value(); }

IgorWave read_igor_wave(std::string_view bytes, const std::string& label) {
  const ByteOrder order = order_of(bytes).value();
  const Header header(bytes, order, label);
  const ValueType& type = header.type();
  IgorWave wave;
  wave.rows = header.size(at::extents, "rows");
  const std::size_t columns = std::max<std::size_t>(header.size(at::extents + 4, "columns"), 1);
  if (header.size(at::extents + 8, "layers") > 1)
    throw bad_input("{}: byte {}: a wave of three dimensions; a force curve has two, points and channels", label,
                    at::extents + 8);
  if (wave.rows == 0 || columns > (bytes.size() - header_bytes) / type.bytes / wave.rows)
    throw bad_input("{}: byte {}: {} rows of {} columns of {} bytes are more than the file of {} bytes has", label,
                    at::extents, wave.rows, columns, type.bytes, bytes.size());
  wave.step = number_at<double>(bytes, at::step, order);
  wave.unit = text_at(bytes, at::unit, 4);
  std::size_t offset = header_bytes;
  for (std::size_t c = 0; c < columns; ++c) {
    std::vector<double>& column = wave.columns.emplace_back(wave.rows);
    for (double& value : column) value = type.at(bytes, offset, order), offset += type.bytes;
  }
  const auto need = [&](std::size_t size, const char* what) {
    if (size > bytes.size() - offset)
      throw bad_input("{}: byte {}: {} of {} bytes ends behind the file of {} bytes", label, offset, what, size,
                      bytes.size());
  };
  const auto skip = [&](std::size_t size, const char* what) { need(size, what), offset += size; };
  skip(header.size(at::formula_size, "formula"), "formula");
  const std::size_t note = header.size(at::note_size, "note");
  need(note, "note");
  wave.note = std::string(bytes.substr(offset, note));
  offset += note;
  skip(header.size(at::extended_size, "unit"), "unit");
  for (std::size_t d = 0; d < 4; ++d)
    skip(header.size(at::dimension_unit_sizes + 4 * d, "dimension unit"), "dimension unit");
  skip(header.size(at::label_sizes, "labels"), "labels");
  const std::size_t labels = header.size(at::label_sizes + 4, "labels");
  need(labels, "labels");
  for (std::size_t i = 1; i < labels / label_bytes; ++i)  // the first is of the whole dimension
    wave.labels.push_back(text_at(bytes, offset + i * label_bytes, label_bytes));
  return wave;
}

}  // namespace validate
