// SVG as gnuplot writes it, made small: maps of many triangles.
#pragma once

#include <string>

namespace validate {

/// gnuplot draws every triangle of a map and every stroke of an outline as a plot of its own, 300 to 500 bytes each.
/// Here neighbouring groups with the same attributes become one, groups that are empty or only name a plot go, and the
/// filled polygons of a group become one path per colour, with coordinates to a tenth of a pixel: those of a map or a
/// colour box do not overlap, so that their order does not show. Everything else stays as it is.
std::string compact_svg(const std::string& svg);

}  // namespace validate
