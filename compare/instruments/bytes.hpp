// Numbers in binary files, of either byte order.
#pragma once

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <string_view>
#include <type_traits>

namespace validate {

enum class ByteOrder { little, big };

/// The number at an offset, which must leave room for it.
template <class Number>
Number number_at(std::string_view bytes, std::size_t offset, ByteOrder order) {
  static_assert(std::endian::native == std::endian::little);
  std::array<char, sizeof(Number)> raw;
  for (std::size_t i = 0; i < sizeof(Number); ++i)
    raw[order == ByteOrder::little ? i : sizeof(Number) - 1 - i] = bytes[offset + i];
  return std::bit_cast<Number>(raw);
}

}  // namespace validate
