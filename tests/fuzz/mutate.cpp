#include "tests/fuzz/mutate.hpp"

#include <algorithm>
#include <array>
#include <cstdint>
#include <string_view>

namespace fuzz {
namespace {

constexpr std::size_t longest_piece = 64;
constexpr std::size_t header = 512;  ///< where sizes stand: half of the changes are made there

bool of_number(char c) { return (c >= '0' && c <= '9') || c == '.' || c == '-' || c == '+' || c == 'e' || c == 'E'; }

}  // namespace

std::string Mutator::operator()(std::string bytes, const std::string& other) {
  const std::size_t changes = 1 + below(6);
  for (std::size_t i = 0; i < changes; ++i) change(bytes, other);
  return bytes;
}

void Mutator::change(std::string& bytes, const std::string& other) {
  const std::size_t reach = below(2) == 0 ? std::min(bytes.size(), header) : bytes.size();
  const std::size_t at = below(reach),
                    length = std::min(1 + below(longest_piece), bytes.size() - std::min(at, bytes.size()));
  switch (below(9)) {
    case 0:
      if (!bytes.empty()) bytes[at] = static_cast<char>(bytes[at] ^ (1 << below(8)));
      return;
    case 1:
      if (!bytes.empty()) bytes[at] = static_cast<char>(below(256));
      return;
    case 2:
      return put_integer(bytes);
    case 3:
      bytes.erase(at, length);
      return;
    case 4:
      bytes.insert(at, bytes.substr(at, length));
      return;
    case 5: {
      const std::size_t from = below(other.size());
      bytes.insert(at, other.substr(from, 1 + below(longest_piece)));
      return;
    }
    case 6:
    case 7:
      return replace_number(bytes);
    default:
      if (below(4) == 0) bytes.resize(below(bytes.size() + 1));
  }
}

void Mutator::replace_number(std::string& bytes) {
  static constexpr std::array<std::string_view, 14> numbers = {
      "0",          "-1",    "1",       "2",   "65535", "2147483647",
      "4294967296", "1e300", "-1e-300", "nan", "inf",   "99999999999999999999",
      "1,5",        ""};
  const std::size_t start = below(std::min<std::size_t>(bytes.size(), below(2) == 0 ? 4096 : bytes.size()));
  for (std::size_t from = start; from < bytes.size(); ++from) {
    if (!of_number(bytes[from])) continue;
    std::size_t to = from;
    while (to < bytes.size() && of_number(bytes[to])) ++to;
    bytes.replace(from, to - from, numbers[below(numbers.size())]);
    return;
  }
}

void Mutator::put_integer(std::string& bytes) {
  static constexpr std::array<std::uint32_t, 9> values = {0, 1, 2, 0x7F, 0xFF, 0x7FFF, 0xFFFF, 0x7FFFFFFF, 0xFFFFFFFF};
  const std::size_t size = below(2) == 0 ? 2 : 4;
  if (bytes.size() < size) return;
  const std::size_t at = below(std::min(bytes.size() - size + 1, below(2) == 0 ? header : bytes.size()));
  const std::uint32_t value = values[below(values.size())];
  const bool little = below(2) == 0;
  for (std::size_t i = 0; i < size; ++i)
    bytes[at + (little ? i : size - 1 - i)] = static_cast<char>(value >> (8 * i) & 0xFF);
}

}  // namespace fuzz
