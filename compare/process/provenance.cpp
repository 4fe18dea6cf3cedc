#include "compare/process/provenance.hpp"

#include <cholmod.h>
#include <fmt/core.h>
#include <gsl/gsl_version.h>
#include <hdf5.h>

#include <Eigen/Core>
#include <array>
#include <fstream>
#include <iterator>

#include "atomistic/protocol/math_threads.hpp"
#include "compare/base/child_process.hpp"
#include "compare/base/paths.hpp"
#include "compare/base/temporary_folder.hpp"
#include "compare/process/atoms.hpp"
#include "git_revision.hpp"

namespace validate {
namespace {

std::string hdf5_version() {
  unsigned major = 0, minor = 0, release = 0;
  H5get_libversion(&major, &minor, &release);
  return fmt::format("{}.{}.{}", major, minor, release);
}

std::string cholmod_library_version() {
  int version[3] = {0, 0, 0};
  cholmod_version(version);
  return fmt::format("CHOLMOD {}.{}.{}", version[0], version[1], version[2]);
}

/// What `validate-atoms --version` says; the program may be missing.
std::string lammps_in_use() {
  try {
    const TemporaryFolder session("validate-mpi");
    ChildProcess child({.words = {atoms_program().string(), "--version"},
                        .folder = "/",
                        .standard_error = "/dev/null",
                        .environment = mpi_environment(session.path())});
    const std::string text = child.read_to_end();
    if (child.wait().good()) return lammps_release(std::stoi(text));
  } catch (const std::exception& e) {
    return fmt::format("not known: {}", e.what());
  }
  return "not known: validate-atoms failed";
}

}  // namespace

Provenance provenance(const std::string& line) {
  Provenance p;
  p.version = VALIDATE_VERSION;
  p.git = git_revision;
  p.gsl = gsl_version;
  p.hdf5 = hdf5_version();
  p.suitesparse = cholmod_library_version();
  p.blas = atomistic::loaded_blas();
  p.command_line = line;
  return p;
}

std::string lammps_release(int version) {
  constexpr std::array months = {"Jan", "Feb", "Mar", "Apr", "May", "Jun", "Jul", "Aug", "Sep", "Oct", "Nov", "Dec"};
  const int day = version % 100, month = version / 100 % 100, year = version / 10000;
  if (month < 1 || month > 12) return fmt::format("{}", version);
  return fmt::format("{} {} {}", day, months[month - 1], year);
}

std::string command_line() {
  std::ifstream in("/proc/self/cmdline", std::ios::binary);
  const std::string all{std::istreambuf_iterator<char>(in), {}};
  std::string line;
  for (std::size_t start = 0; start < all.size();) {
    const std::size_t end = std::min(all.find('\0', start), all.size());
    const std::string word = all.substr(start, end - start);
    const bool plain = !word.empty() && word.find_first_of(" \t\"'") == std::string::npos;
    line += (line.empty() ? "" : " ") + (plain ? word : "\"" + word + "\"");
    start = end + 1;
  }
  return line;
}

std::string version_text() {
  const Provenance p = provenance({});
  const bool slow_blas = p.blas.find("openblas") == std::string::npos;
  return fmt::format("validate {} ({})\nLAMMPS {}\nGSL {}\nHDF5 {}\nSuiteSparse {}\nEigen {}.{}.{}\nBLAS {}{}",
                     p.version, p.git, lammps_in_use(), p.gsl, p.hdf5, p.suitesparse, EIGEN_WORLD_VERSION,
                     EIGEN_MAJOR_VERSION, EIGEN_MINOR_VERSION, p.blas,
                     slow_blas ? "  (not OpenBLAS: factorisations take two to three times longer)" : "");
}

}  // namespace validate
