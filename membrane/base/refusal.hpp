// How a problem that makes no sense is refused: always the member, its value and what is allowed.
#pragma once

#include <sstream>
#include <stdexcept>
#include <string_view>

namespace membrane {

/// Throws std::invalid_argument "Problem::<member> = <value>: <allowed>".
template <class Value>
[[noreturn]] void refuse(std::string_view member, const Value& value, std::string_view allowed) {
  std::ostringstream message;
  message << "Problem::" << member << " = " << value << ": " << allowed;
  throw std::invalid_argument(message.str());
}

}  // namespace membrane
