// Figure 4's square as atoms: do they wrinkle where the tension field says?
#pragma once

#include "compare/figures/paper_figure.hpp"

namespace validate {

/// Adds panels, numbers and remarks for the context's first potential: the membrane with the card's constants and the
/// lowest of the atoms' states of equilibrium under the same pressure (square_search).
/// Throws Error: bad input for the potential; atomistic failed; interrupted.
void add_square_of_atoms(PaperFigure& figure, const FigureContext& context);

}  // namespace validate
