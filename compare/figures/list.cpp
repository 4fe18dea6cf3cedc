#include "compare/figures/paper_figure.hpp"

namespace validate {

const std::vector<FigureEntry>& paper_figures() {
  static const std::vector<FigureEntry> all = {
      {1, "force against depth of drums of 0.5 and 0.75 µm: membrane, tips, Eq. 16 and the experiment's spread",
       figure1},
      {2, "atoms, membrane, plates and Eq. 16 at R = 110 Å, and atoms over membrane", figure2},
      {3, "larger principal stress on the paper's mesh under a point and a disc, the rim at 0.125 eV/Å³", figure3},
      {4, "pressurised square: principal stresses, wrinkled zones, tension rays", figure4},
  };
  return all;
}

}  // namespace validate
