#include "compare/documents/page/packed.hpp"

#include <algorithm>
#include <cstddef>
#include <span>

#include "compare/documents/bytes/base64.hpp"

namespace validate {
namespace {

constexpr std::size_t block = 32;   // numbers that share a width
constexpr std::uint32_t most = 20;  // ones before a number that is written out

/// Bits into bytes, the highest of a byte first.
class BitWriter {
 public:
  void bits(std::uint64_t value, std::uint32_t count) {
    while (count > 0) {
      const std::uint32_t taken = std::min(count, 32U);
      count -= taken;
      pending_ = pending_ << taken | (value >> count & ((1ULL << taken) - 1));
      for (held_ += taken; held_ >= 8; held_ -= 8) bytes_ += static_cast<char>(pending_ >> (held_ - 8) & 0xff);
      pending_ &= (1ULL << held_) - 1;
    }
  }
  std::string finish() {
    if (held_ > 0) bits(0, 8 - held_);
    return std::move(bytes_);
  }

 private:
  std::string bytes_;
  std::uint64_t pending_ = 0;
  std::uint32_t held_ = 0;
};

/// 0, −1, 1, −2, 2 … as 0, 1, 2, 3, 4 …
std::uint32_t without_sign(std::int32_t value) {
  return static_cast<std::uint32_t>(value) << 1 ^ static_cast<std::uint32_t>(value >> 31);
}

/// Bits of a number that are written as they are: nearly the best for numbers that fall off geometrically.
std::uint32_t width_for(std::span<const std::uint32_t> numbers) {
  std::uint64_t sum = 0;
  for (const std::uint32_t number : numbers) sum += number;
  std::uint32_t width = 0;
  while (sum >> width > numbers.size()) ++width;
  return std::min(width, 31U);
}

void write_block(BitWriter& writer, std::span<const std::uint32_t> numbers) {
  const std::uint32_t width = width_for(numbers);
  writer.bits(width, 5);
  for (const std::uint32_t number : numbers) {
    const std::uint32_t high = number >> width;
    if (high >= most) {
      writer.bits((1ULL << most) - 1, most);
      writer.bits(number, 32);
    } else {
      writer.bits((1ULL << (high + 1)) - 2, high + 1);
      writer.bits(number & ((1ULL << width) - 1), width);
    }
  }
}

}  // namespace

std::string packed(const std::vector<std::vector<std::int32_t>>& frames) {
  BitWriter writer;
  std::vector<std::uint32_t> rest;
  for (std::size_t f = 0; f < frames.size(); ++f) {
    rest.clear();
    for (std::size_t i = 0; i < frames[f].size(); ++i) {
      const std::int32_t guess = f == 0 ? 0 : f == 1 ? 2 * frames[0][i] : 2 * frames[f - 1][i] - frames[f - 2][i];
      rest.push_back(without_sign(frames[f][i] - guess));
    }
    for (std::size_t i = 0; i < rest.size(); i += block)
      write_block(writer, std::span(rest).subspan(i, std::min(block, rest.size() - i)));
  }
  return base64(writer.finish());
}

}  // namespace validate
