// The fields of a solved sheet as named columns, for every format that holds them.
#pragma once

#include <string>
#include <vector>

#include "membrane/triangles/fields.hpp"

namespace validate {

/// Values over triangles or nodes, `components` of them each, one after the other.
struct SheetColumn {
  std::string key;  ///< with its unit: force_1_eV_per_A2
  std::string unit, meaning;
  int components = 1;
  std::vector<double> values;
};

/// One number of the full sheet.
struct SheetTotal {
  std::string key;  ///< with its unit: energy_eV
  std::string unit, meaning;
  double value = 0;
};

/// What is seen of a sheet at one depth: of the same mesh as the picture that it belongs to.
struct SheetShape {
  double depth_A = 0, force_eV_per_A = 0;
  std::vector<float> displacement_A;      ///< three a node
  std::vector<float> cauchy_1_eV_per_A3;  ///< one a triangle: larger principal stress
  std::vector<float> state;               ///< 0 taut, 1 wrinkled, 2 slack
};

/// A solved sheet ready to be written: the meshed part only (one quarter where the sheet is symmetric),
/// totals of the full sheet.
struct SheetPicture {
  membrane::Mesh mesh;
  std::vector<SheetColumn> triangles, nodes;
  std::vector<SheetTotal> totals;
  std::vector<double> displacement;  ///< Å, three a node
  double level = 0;                  ///< what the step was asked for
  double thickness_A = 0;            ///< that stresses are over
  std::vector<SheetShape> earlier;   ///< of the path, where its other depths are no pictures of their own
};

/// Columns and totals of a step. Stresses need the thickness that they are over (Å).
SheetPicture picture_of(const membrane::Problem& problem, const membrane::Step& step, double thickness_A);

/// The picture's own shape.
SheetShape shape_of(const SheetPicture& picture);

/// Pictures of the converged steps of one path: of all, or of the last one, with the shapes before it.
class SheetAlbum {
 public:
  SheetAlbum(const membrane::Problem& problem, double thickness_A, bool every_level)
      : problem_(problem), thickness_A_(thickness_A), every_level_(every_level) {}

  void keep(const membrane::Step& step);
  std::vector<SheetPicture> pictures() const;

 private:
  const membrane::Problem& problem_;
  double thickness_A_;
  bool every_level_;
  std::vector<membrane::Step> steps_;
};

/// The total with this key. Throws std::out_of_range.
double total(const std::vector<SheetTotal>& totals, const std::string& key);

/// Values of the column with this key. Throws std::out_of_range.
const std::vector<double>& column(const std::vector<SheetColumn>& columns, const std::string& key);

}  // namespace validate
