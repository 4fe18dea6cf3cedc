// Figure 4's square as atoms: do they wrinkle where the tension field says?
#pragma once

#include "compare/figures/paper_figure.hpp"

namespace compare {

/// Adds panels, numbers and remarks for the context's first potential: the membrane with the card's constants and the
/// lowest of `starts` equilibria of the atoms under the same pressure. The problem is not convex; the starts are
///   0: up through smaller pressures, along the branch that begins flat;
///   1: the full pressure at once;
///   2, …: the full pressure at once on a sheet with random ripples of 0.5 Å.
/// Throws Error: bad input for the potential; atomistic failed; interrupted.
void add_square_of_atoms(PaperFigure& figure, const FigureContext& context);

}  // namespace compare
