#include "compare/documents/plots/colours.hpp"

#include <array>

namespace validate {

const char* hex(Colour colour) {
  switch (colour) {
    case Colour::blue:
      return "#0072B2";
    case Colour::vermilion:
      return "#D55E00";
    case Colour::green:
      return "#009E73";
    case Colour::purple:
      return "#CC79A7";
    case Colour::orange:
      return "#E69F00";
    case Colour::sky:
      return "#56B4E9";
    case Colour::dark_grey:
      return "#555555";
    case Colour::grey:
      return "#999999";
    case Colour::pale_grey:
      return "#dddddd";
    case Colour::white:
      return "#ffffff";
    case Colour::black:
      break;
  }
  return "#000000";
}

Colour nth_colour(std::size_t n) {
  constexpr std::array order = {Colour::blue,   Colour::vermilion, Colour::green,
                                Colour::purple, Colour::orange,    Colour::sky};
  return order[n % order.size()];
}

const std::vector<const char*>& scale_of_fields() {
  static const std::vector<const char*> colours = {"#440154", "#3b528b", "#21918c", "#5ec962", "#fde725"};
  return colours;
}

}  // namespace validate
