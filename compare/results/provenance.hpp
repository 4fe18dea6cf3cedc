// Where a result comes from and what it took.
#pragma once

#include <optional>
#include <string>

#include "compare/base/describe.hpp"
#include "compare/results/known.hpp"

namespace validate {

/// Sums over the curves, which run side by side: they may exceed the wall time.
struct Timing {
  double wall_s = not_known, membrane_s = not_known;
  std::optional<double> atomistic_s;
  std::optional<double> force_s;   ///< inside LAMMPS: pair, neighbour, communication
  std::optional<double> setup_s;   ///< inside LAMMPS: start, and the first force of each depth with its set-up
  std::optional<double> factor_s;  ///< factorising the preconditioner
  std::optional<double> solve_s;   ///< solving with it
  std::optional<long> force_calls;
};

void describe(SameStruct<Timing> auto& timing, auto&& visit) {
  visit(Field{"wall", unit::second, "whole command"}, timing.wall_s);
  visit(Field{"membrane", unit::second, "membrane runs"}, timing.membrane_s);
  visit(Field{"atomistic", unit::second, "atomistic curves, without the card"}, timing.atomistic_s);
  visit(Field{"setup", unit::second, "LAMMPS's start and the first force of each depth with its set-up"},
        timing.setup_s);
  visit(Field{"factor", unit::second, "factorising the preconditioner, or setting up its multigrid"}, timing.factor_s);
  visit(Field{"solve", unit::second, "solving with the preconditioner"}, timing.solve_s);
  visit(Field{"force_calls", unit::none, "LAMMPS force computations of all curves"}, timing.force_calls);
  visit(Field{"force", unit::second, "inside LAMMPS's force computation, summed over curves"}, timing.force_s);
}

struct Provenance {
  std::string version, git, lammps, gsl, hdf5, suitesparse, blas;
  std::string potential_file, potential_sha256, potential_edit, command_line;
};

void describe(SameStruct<Provenance> auto& provenance, auto&& visit) {
  visit(Field{"version", unit::none, "version of validate"}, provenance.version);
  visit(Field{"git", unit::none, "git revision of the sources"}, provenance.git);
  visit(Field{"lammps", unit::none, "LAMMPS version"}, provenance.lammps);
  visit(Field{"gsl", unit::none, "GSL version"}, provenance.gsl);
  visit(Field{"hdf5", unit::none, "HDF5 version"}, provenance.hdf5);
  visit(Field{"suitesparse", unit::none, "SuiteSparse version"}, provenance.suitesparse);
  visit(Field{"blas", unit::none, "BLAS library loaded"}, provenance.blas);
  visit(Field{"potential_file", unit::none, "the potential's parameter file"}, provenance.potential_file);
  visit(Field{"potential_sha256", unit::none, "its SHA-256"}, provenance.potential_sha256);
  visit(Field{"potential_edit", unit::none, "what was changed in a copy of it"}, provenance.potential_edit);
  visit(Field{"command_line", unit::none, "the command that made this"}, provenance.command_line);
}

}  // namespace validate
