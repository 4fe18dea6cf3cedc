#include "compare/verify_atoms/outside_numbers.hpp"

#include <algorithm>
#include <array>

namespace validate::verify {

const OutsideCard* outside_card(std::string_view potential) {
  static constexpr std::array cards = {
      OutsideCard{"airebo", 2.41924328, 277.7, 0.3645, 0.966}, OutsideCard{"rebo", 2.46018783, 244.0, 0.3945, 1.401},
      OutsideCard{"tersoff", 2.49204894, 354.9, 0.065, 1.865}, OutsideCard{"lcbop", 2.45931935, 315.0, 0.2215, 0.730}};
  const auto* found = std::ranges::find(cards, potential, &OutsideCard::potential);
  return found == cards.end() ? nullptr : found;
}

}  // namespace validate::verify
