#include "tests/atomistic/support/plain_lammps.hpp"

#include <mpi.h>
#define LAMMPS_LIB_MPI
#include <fmt/format.h>
#include <library.h>

#include <fstream>
#include <sstream>
#include <string>

PlainLammps::PlainLammps(const atomistic::Potential& potential, const std::filesystem::path& data_file)
    : log_(data_file.string() + ".log") {
  std::string words[] = {"plain", "-log", log_.string(), "-screen", "none", "-nocite"};
  char* arguments[std::size(words)];
  for (std::size_t i = 0; i < std::size(words); ++i) arguments[i] = words[i].data();
  lammps_ = lammps_open(static_cast<int>(std::size(words)), arguments, MPI_COMM_WORLD, nullptr);
  for (const char* line : {"units metal", "atom_style atomic", "atom_modify map array", "boundary f f f"})
    command(line);
  command("read_data " + data_file.string());
  command("pair_style " + potential.pair_style);
  for (std::string line : potential.pair_coeff) {
    if (const auto at = line.find("{file}"); at != std::string::npos) line.replace(at, 6, '"' + potential.file + '"');
    command("pair_coeff " + line);
  }
  command("thermo_style custom step pe fnorm fmax");
  command("thermo_modify norm no");
}

PlainLammps::~PlainLammps() {
  lammps_close(lammps_);
  std::filesystem::remove(log_);
}

/// From the log's "Iterations, force evaluations = 12 34".
long PlainLammps::evaluations() const {
  std::ifstream in(log_);
  long iterations = 0, count = 0;
  for (std::string line; std::getline(in, line);)
    if (const auto at = line.find("force evaluations ="); at != std::string::npos)
      std::istringstream(line.substr(at + 19)) >> iterations >> count;
  return count;
}

void PlainLammps::command(const std::string& line) { lammps_command(lammps_, line.c_str()); }

double PlainLammps::thermo(const char* keyword) const { return lammps_get_thermo(lammps_, keyword); }

double PlainLammps::variable(const std::string& name) const {
  auto* value = static_cast<double*>(lammps_extract_variable(lammps_, name.c_str(), nullptr));
  const double copy = *value;
  lammps_free(value);
  return copy;
}

Eigen::VectorXd PlainLammps::gather(const char* name, int atoms) const {
  Eigen::VectorXd values(3 * atoms);
  lammps_gather_atoms(lammps_, const_cast<char*>(name), 1, 3, values.data());
  return values;
}

void PlainLammps::minimise(const std::string& style, double force_tolerance) {
  command("min_style " + style);
  command(fmt::format("minimize 0 {} 100000 1000000", force_tolerance));
}
