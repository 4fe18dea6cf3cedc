// The colours of every drawing: Okabe and Ito's, which colour-blind readers tell apart, and greys.
#pragma once

#include <cstddef>
#include <vector>

namespace validate {

enum class Colour { blue, vermilion, green, purple, orange, sky, black, dark_grey, grey, pale_grey, white };

/// #rrggbb.
const char* hex(Colour colour);

/// The colour of the n-th of several things of one kind; they begin again after six.
Colour nth_colour(std::size_t n);

inline constexpr Colour colour_of_atoms = Colour::vermilion, colour_of_membrane = Colour::blue;

/// From small to large values of a field, evenly spaced (viridis).
const std::vector<const char*>& scale_of_fields();

}  // namespace validate
