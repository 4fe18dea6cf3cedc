// A figure of the paper as data: curves in panels, and the numbers to compare with.
#pragma once

#include <Eigen/Core>
#include <array>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "compare/base/progress.hpp"

namespace validate {

struct FigureCurve {
  std::string name;  ///< in the legend and in the data files
  std::vector<double> x, y;
  std::vector<double> y_high;  ///< with it a band from y to y_high
  std::string style;           ///< gnuplot's, behind "with"
  bool broken = false;         ///< strokes: every two points are a line of their own
};

/// A value per triangle, drawn as a map over the reference.
struct FigureField {
  std::string name, key;  ///< key: name with unit for the data files
  std::vector<std::array<Eigen::Vector2d, 3>> corners_A;
  std::vector<double> value;
};

struct FigurePanel {
  std::string title, x_label, y_label;
  std::string x_key, y_key;  ///< names with units for the data files: depth_nm, force_nN
  std::string settings;      ///< more gnuplot settings: ranges, objects
  std::vector<FigureCurve> curves;
  std::vector<FigureField> fields = {};  ///< at most one is drawn, the curves over it
};

/// A published number, or one computed with codes written separately, beside ours.
struct FigureNumber {
  std::string what, unit, source;
  double reference = 0, ours = 0;
  double tolerance = 0;  ///< relative; 0: a difference that is the point of the figure
  std::string comment;   ///< where they differ, why
};

/// Whether ours is within the tolerance; true where none is asked.
bool passes(const FigureNumber& number);

struct PaperFigure {
  int number = 0;
  std::string title;
  std::vector<FigurePanel> panels;
  std::vector<FigureNumber> numbers;
  std::vector<std::string> remarks = {};  ///< what the numbers alone do not say
};

/// What making a figure may use.
struct FigureContext {
  std::filesystem::path work;           ///< an existing folder for intermediate files, removed afterwards
  std::vector<std::string> potentials;  ///< for the atoms
  bool atoms = false;                   ///< figure 4: the square as atoms too
  int starts = 3;                       ///< from which its equilibrium is searched
  Progress& progress;
};

PaperFigure figure1(const FigureContext&);
PaperFigure figure2(const FigureContext&);
PaperFigure figure3(const FigureContext&);
PaperFigure figure4(const FigureContext&);

/// Every figure that can be made. A further one is a file here, a function and a line in the list.
struct FigureEntry {
  int number;
  const char* what;
  PaperFigure (*make)(const FigureContext&);
};
const std::vector<FigureEntry>& paper_figures();

/// The numbers as a table.
std::string numbers_text(const PaperFigure& figure);

/// Writes figureN.svg, .png, .csv and .h5 into an existing folder. Throws Error (file failed).
void write_paper_figure(const PaperFigure& figure, const std::filesystem::path& folder);

}  // namespace validate
