// A figure of the paper as data: curves in panels, and the numbers to compare with.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "compare/base/progress.hpp"
#include "compare/documents/plots/plot.hpp"
#include "compare/results/checks.hpp"

namespace validate {

/// What is drawn, and the numbers beside their references.
struct PaperFigure : FigureResult {
  std::vector<Panel> panels;            ///< two to a row
  std::vector<double> row_shares = {};  ///< see Plot: rows that share their x axis
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

/// What is drawn of it.
Plot plot_of(const PaperFigure& figure);

/// The numbers as a table.
std::string numbers_text(const PaperFigure& figure);

/// Writes figureN.svg, .png, .csv and .h5 into an existing folder. Throws Error (file failed).
void write_paper_figure(const PaperFigure& figure, const std::filesystem::path& folder);

}  // namespace validate
