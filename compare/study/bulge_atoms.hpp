// The same sheet as atoms, beside a bulge's membrane.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "compare/base/describe.hpp"
#include "compare/pairing/bulge_pairing.hpp"
#include "compare/process/atoms_curves.hpp"
#include "compare/results/result.hpp"
#include "compare/results/sheet_columns.hpp"

namespace validate {

/// One pressure on the atoms, beside the membrane's depth at it.
struct BulgeAtomsPoint {
  double pressure_eV_per_A3 = not_known, depth_A = not_known, membrane_depth_A = not_known, depth_ratio = not_known;
  double sheet_depth_A = not_known, sheet_ratio = not_known;
  double volume_A3 = not_known, energy_eV = not_known;
  bool converged = false, artefact = false;
  double longest_bond_A = not_known, max_force_eV_per_A = not_known, balance_relative = not_known;
  int force_evaluations = 0, factorisations = 0;
};

template <class Self, class Visitor>
requires SameStruct<Self, BulgeAtomsPoint>
void describe(Self& p, Visitor&& visit) {
  visit(Field{"pressure", unit::stress, "follower pressure"}, p.pressure_eV_per_A3);
  visit(Field{"depth", unit::length, "of the atoms at one bond from the axis"}, p.depth_A);
  visit(Field{"membrane_depth", unit::length, "of the membrane with the potential's constants there"},
        p.membrane_depth_A);
  visit(Field{"depth_ratio", unit::none, "atoms / membrane"}, p.depth_ratio);
  visit(Field{"sheet_depth", unit::length, "of the sheet of the potential's own law that bends; clamped discs only"},
        p.sheet_depth_A);
  visit(Field{"sheet_ratio", unit::none, "atoms / sheet"}, p.sheet_ratio);
  visit(Field{"volume", unit::volume, "under the bulge"}, p.volume_A3);
  visit(Field{"energy", unit::energy, "relative to the flat sheet"}, p.energy_eV);
  visit(Field{"converged", unit::none, "equilibrium reached"}, p.converged);
  visit(Field{"artefact", unit::none, "longest bond in the potential's switching range"}, p.artefact);
  visit(Field{"longest_bond", unit::length, "longest bond of the sheet"}, p.longest_bond_A);
  visit(Field{"max_force", unit::force, "largest force left on a free atom"}, p.max_force_eV_per_A);
  visit(Field{"balance_relative", unit::none, "pressure's resultant plus rim reaction, over it"}, p.balance_relative);
  visit(Field{"force_evaluations", unit::none, "LAMMPS force computations for this pressure"}, p.force_evaluations);
  visit(Field{"factorisations", unit::none, "preconditioner factorisations"}, p.factorisations);
}

/// Places and heights along a line through the sheet, in order of the place.
struct Profile {
  std::vector<double> x_A, z_A;
};

struct BulgeAtoms {
  CardSummary card;
  int atoms = 0, free_atoms = 0;
  double membrane_size_x_A = 0, membrane_size_y_A = 0;  ///< of the paired membrane
  std::vector<BulgeAtomsPoint> points;
  std::optional<Ended> ended;
  std::string ended_reason;
  Profile atoms_profile, membrane_profile;  ///< along x through the centre, at the last pressure that both have
};

/// Of a sheet of atoms: those within 0.6 bonds of the line y = 0 in the flat sheet.
Profile profile_of(const atomistic::Sheet& sheet, const Eigen::VectorXd& positions);

/// Of a membrane: the nodes on y = 0, mirrored where the mesh is a quarter.
Profile profile_of(const SheetPicture& picture);

/// The atoms' curve beside the membrane's pictures and depths, pressure by pressure.
BulgeAtoms bulge_atoms(const BulgePair& pair, const AtomsCurve& curve, const std::vector<double>& membrane_depth_A,
                       const std::vector<SheetPicture>& pictures);

}  // namespace validate
