// What the heading of a column says: name, unit, direction, and which column of a recording it is.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "compare/instruments/assemble.hpp"
#include "compare/instruments/text.hpp"

namespace validate {

struct Heading {
  std::string cell;                      ///< as it stands in the file
  std::string name;                      ///< without unit and direction
  std::optional<SegmentKind> direction;  ///< of a column that is of one way alone: "Defl_V_Ex", "Force (N) retract"
  std::string column;                    ///< of a recording: "force", "height (measured)", …; empty: none of them
  std::optional<SiUnit> unit;            ///< nothing: none, or none that this column can have
};

/// Units stand in parentheses or brackets or behind _, a blank, a comma or /: depth_nm, "Force [nN]", force_eV_per_A. A
/// unit given apart (of a row of units, or an attribute) goes before. In a column of lengths A is ångström.
Heading heading_of(std::string_view cell, std::string_view unit_apart = {});

/// Where a recording keeps a column: under its column's name, or under its own, which is marked where it would be taken
/// for one of them.
std::string kept_as(const Heading& heading);
/// The file's name of what is kept so.
std::string_view without_mark(std::string_view name);

/// Values with their heading.
struct HeadedColumn {
  Heading heading;
  std::vector<double> values;
};

/// Puts columns where their headings say, others among the other columns, with what `segment` numbers; columns of one
/// direction become segments of their own (a row without any value of a direction is no point of it). Throws Error (bad
/// input), which `label` starts.
void place_headed(Recording& recording, std::vector<HeadedColumn> columns, const std::string& label);

}  // namespace validate
