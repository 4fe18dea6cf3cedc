// The fields of a solved sheet as named columns, for every format that holds them.
#pragma once

#include <string>
#include <vector>

#include "membrane/fields.hpp"

namespace compare {

/// Values over triangles or nodes, `components` of them each, one after the other.
struct SheetColumn {
  std::string key;  ///< with its unit: force_1_eV_per_A2
  std::string unit, meaning;
  int components = 1;
  std::vector<double> values;
};

/// A solved sheet ready to be written: the meshed part only (one quarter where the sheet is symmetric).
struct SheetPicture {
  membrane::Mesh mesh;
  std::vector<SheetColumn> triangles, nodes;
  std::vector<double> displacement;  ///< Å, three a node
  double level = 0;                  ///< what the step was asked for
};

/// Columns of a step. Stresses need the thickness that they are over (Å).
SheetPicture picture_of(const membrane::Problem& problem, const membrane::Step& step, double thickness_A);

/// Values of the column with this key. Throws std::out_of_range.
const std::vector<double>& column(const std::vector<SheetColumn>& columns, const std::string& key);

}  // namespace compare
