// LAMMPS alone, as its own input script would run it: the judge of our route.
#pragma once

#include <Eigen/Core>
#include <filesystem>
#include <string>

#include "atomistic/problem.hpp"

class PlainLammps {
 public:
  /// Reads a data file of carbon; energies and forces of `potential`.
  PlainLammps(const atomistic::Potential& potential, const std::filesystem::path& data_file);
  ~PlainLammps();
  PlainLammps(const PlainLammps&) = delete;
  PlainLammps& operator=(const PlainLammps&) = delete;

  void command(const std::string& line);
  double thermo(const char* keyword) const;
  Eigen::VectorXd gather(const char* name, int atoms) const;        ///< "x" or "f", by id
  double variable(const std::string& name) const;                   ///< of equal style
  long evaluations() const;                                         ///< of the last minimisation
  void minimise(const std::string& style, double force_tolerance);  ///< on the 2-norm of all forces

 private:
  std::filesystem::path log_;
  void* lammps_;
};
