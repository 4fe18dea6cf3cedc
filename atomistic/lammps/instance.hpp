// LAMMPS itself behind a ForceField: its library interface, for the sources of this room alone.
#pragma once

#include <mpi.h>
#define LAMMPS_LIB_MPI
#include <fmt/format.h>
#include <library.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdlib>
#include <numeric>
#include <stdexcept>
#include <utility>
#include <vector>

#include "atomistic/lammps/atoms_here.hpp"
#include "atomistic/lammps/lammps.hpp"

namespace atomistic {

/// LAMMPS's own `nktv2p` of metal units (bar per eV/Å³): undoes exactly what its pressure compute applied.
inline constexpr double lammps_bar = 1.6021765e6;

/// Goes with every thermo_style, which forgets it.
inline const std::string thermo_format = "thermo_modify norm no lost error format float %.15g";

enum class Order : int { evaluate, evaluate_fresh, virials, stop };

inline double lammps_clock_s() {
  using clock = std::chrono::steady_clock;
  return std::chrono::duration<double>(clock::now().time_since_epoch()).count();
}

inline void* open_lammps(const std::string& log_file, MPI_Comm communicator) {
  std::vector<std::string> words = {"validate-atoms", "-log", log_file, "-screen", "none", "-nocite"};
  std::vector<char*> arguments;
  for (std::string& word : words) arguments.push_back(word.data());
  return lammps_open(static_cast<int>(arguments.size()), arguments.data(), communicator, nullptr);
}

inline std::string with_file(std::string line, const std::string& file) {
  if (const auto at = line.find("{file}"); at != std::string::npos) line.replace(at, 6, '"' + file + '"');
  return line;
}

/// Pair styles of this LAMMPS that begin with the same letters, for a message.
inline std::string styles_like(void* lammps, const std::string& style) {
  std::string alike;
  const int count = lammps_style_count(lammps, "pair");
  for (int i = 0; i < count; ++i) {
    char name[128] = {};
    if (lammps_style_name(lammps, "pair", i, name, sizeof name) && std::string(name).substr(0, 3) == style.substr(0, 3))
      alike += (alike.empty() ? "" : ", ") + std::string(name);
  }
  return alike.empty() ? "" : "; those that begin alike: " + alike;
}

/// A flat sheet in a box as high as it is wide leaves most neighbour bins empty, and LAMMPS refuses to make
/// more than 2³¹ of its own size: for large sheets no more than some 16 an atom.
inline std::string wider_bins(const Box& box, const Eigen::VectorXd& positions) {
  constexpr double bins_per_atom = 16, own_size_A = 5;
  const double atoms = static_cast<double>(positions.size()) / 3;
  const double size = std::cbrt((box.high - box.low).prod() / (bins_per_atom * atoms));
  return !box.periodic && size > own_size_A ? fmt::format(" binsize {:.3g}", size) : "";
}

/// Before LAMMPS is told, so that it does not end the process over it.
inline void require_style(void* lammps, const std::string& pair_style) {
  const std::string style = pair_style.substr(0, pair_style.find(' '));
  if (!lammps_has_style(lammps, "pair", style.c_str()))
    throw BadPotential(
        fmt::format("pair_style: this LAMMPS has no pair style '{}'{}", style, styles_like(lammps, style)));
}

struct ForceField::Instance {
  void* lammps = nullptr;
  MPI_Comm communicator = MPI_COMM_WORLD;
  int rank = 0, ranks = 1;
  int atoms = 0;
  Box box;
  bool cell_changed = true;  ///< also true before the first run
  bool shared = false;       ///< every rank evaluates, none serves
  ForceTiming timing;
  Eigen::VectorXd local;  ///< this rank's share of the forces, in creation order

  void command(const std::string& line) {
    lammps_command(lammps, line.c_str());
    check();
  }

  /// Libraries built with exceptions (not Debian's) report errors here.
  void check() const {
    if (!lammps_config_has_exceptions() || !lammps_has_error(lammps)) return;
    char text[512] = {};
    lammps_get_last_error_message(lammps, text, sizeof text);
    throw std::runtime_error(text);
  }

  void open(const std::string& log_file) {
    communicator = box.periodic ? MPI_COMM_SELF : MPI_COMM_WORLD;
    lammps = open_lammps(log_file, communicator);
    if (!lammps) throw std::runtime_error("LAMMPS did not start; see " + log_file);
    MPI_Comm_rank(communicator, &rank);
    MPI_Comm_size(communicator, &ranks);
  }

  void create(const Eigen::VectorXd& positions) {
    atoms = static_cast<int>(positions.size()) / 3;
    std::vector<int> ids(atoms), types(atoms, 1);
    std::iota(ids.begin(), ids.end(), 1);
    if (lammps_create_atoms(lammps, atoms, ids.data(), types.data(), positions.data(), nullptr, nullptr, 0) != atoms)
      throw std::runtime_error("LAMMPS did not take all atoms: some lie outside the box");
    check();
    local.resize(positions.size());
  }

  /// Which rank has an atom, and where in its arrays, would tell of the way here, and so would the last bits of sums: a
  /// resumed run has come another way.
  void create_anew(const Eigen::VectorXd& positions) {
    command("delete_atoms group all compress no");
    create(positions);
  }

  void set_potential(const Potential& potential) {
    if (!potential.kim_model.empty()) return command("kim interactions C");
    require_style(lammps, potential.pair_style);
    command("pair_style " + potential.pair_style);
    for (const std::string& line : potential.pair_coeff) command("pair_coeff " + with_file(line, potential.file));
  }

  /// Writes this rank's atoms; the order of LAMMPS's arrays changes when atoms change ranks, so go by id.
  void put(const Eigen::VectorXd& positions) {
    const int own = *static_cast<int*>(lammps_extract_global(lammps, "nlocal"));
    const auto* id = static_cast<int*>(lammps_extract_atom(lammps, "id"));
    auto** x = static_cast<double**>(lammps_extract_atom(lammps, "x"));
    for (int i = 0; i < own; ++i) Eigen::Map<Eigen::Vector3d>{x[i]} = positions.segment<3>(3 * (id[i] - 1));
  }

  void collect_forces(Eigen::VectorXd& forces) {
    const int own = *static_cast<int*>(lammps_extract_global(lammps, "nlocal"));
    const auto* id = static_cast<int*>(lammps_extract_atom(lammps, "id"));
    auto** f = static_cast<double**>(lammps_extract_atom(lammps, "f"));
    local.setZero();
    for (int i = 0; i < own; ++i) local.segment<3>(3 * (id[i] - 1)) = Eigen::Map<Eigen::Vector3d>{f[i]};
    forces.resize(rank == 0 ? local.size() : 0);
    MPI_Reduce(local.data(), forces.data(), static_cast<int>(local.size()), MPI_DOUBLE, MPI_SUM, 0, communicator);
  }

  /// Per-atom virials are tallied only in a run whose output asks for them: here the sum of one component.
  void compute_virials(Eigen::VectorXd& positions, Eigen::VectorXd& virials) {
    positions.resize(3 * atoms);
    MPI_Bcast(positions.data(), static_cast<int>(positions.size()), MPI_DOUBLE, 0, communicator);
    put(positions);
    command("compute virial all stress/atom NULL virial");
    command("compute virial_sum all reduce sum c_virial[1]");
    command("thermo_style custom step pe c_virial_sum");
    command("run 0 post no");
    const int own = *static_cast<int*>(lammps_extract_global(lammps, "nlocal"));
    const auto* id = static_cast<int*>(lammps_extract_atom(lammps, "id"));
    auto** v = static_cast<double**>(lammps_extract_compute(lammps, "virial", LMP_STYLE_ATOM, LMP_TYPE_ARRAY));
    check();
    Eigen::VectorXd share = Eigen::VectorXd::Zero(6 * static_cast<Eigen::Index>(atoms));
    for (int i = 0; i < own; ++i)
      share.segment<6>(6 * (id[i] - 1)) = Eigen::Map<Eigen::Matrix<double, 6, 1>>{v[i]} / lammps_bar;
    virials.resize(rank == 0 ? share.size() : 0);
    MPI_Reduce(share.data(), virials.data(), static_cast<int>(share.size()), MPI_DOUBLE, MPI_SUM, 0, communicator);
    command("thermo_style custom step pe pxx pyy pxy");
    command(thermo_format);
    command("uncompute virial_sum");
    command("uncompute virial");
  }

  AtomsHere atoms_here() const { return {lammps, rank}; }

  double compute_own(const Eigen::VectorXd& positions, Eigen::VectorXd& forces, bool fresh) {
    const double start = lammps_clock_s();
    atoms_here().put(positions);
    command(fresh ? "run 0 post no" : "run 1 pre no post no");
    forces.resize(positions.size());
    atoms_here().collect(forces);
    const double energy = lammps_get_thermo(lammps, "pe");
    ++timing.calls;
    (fresh ? timing.setup_s : timing.force_s) += lammps_clock_s() - start;
    return energy;
  }

  /// The part that all ranks do together.
  double compute(Eigen::VectorXd& positions, Eigen::VectorXd& forces, bool fresh) {
    const double start = lammps_clock_s();
    positions.resize(3 * atoms);
    MPI_Bcast(positions.data(), static_cast<int>(positions.size()), MPI_DOUBLE, 0, communicator);
    if (fresh && ranks > 1)
      create_anew(positions);
    else
      put(positions);
    command(fresh ? "run 0 post no" : "run 1 pre no post no");
    collect_forces(forces);
    const double energy = lammps_get_thermo(lammps, "pe");
    ++timing.calls;
    (fresh ? timing.setup_s : timing.force_s) += lammps_clock_s() - start;
    return energy;
  }
};

}  // namespace atomistic
