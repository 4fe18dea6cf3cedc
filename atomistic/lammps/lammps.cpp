#include "atomistic/lammps/lammps.hpp"

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
#include "atomistic/ranks/mpi_team.hpp"

namespace atomistic {
namespace {

/// LAMMPS's own `nktv2p` of metal units (bar per eV/Å³): undoes exactly what its pressure compute applied.
constexpr double lammps_bar = 1.6021765e6;

/// Goes with every thermo_style, which forgets it.
const std::string thermo_format = "thermo_modify norm no lost error format float %.15g";

enum class Order : int { evaluate, evaluate_fresh, virials, stop };

double seconds() {
  using clock = std::chrono::steady_clock;
  return std::chrono::duration<double>(clock::now().time_since_epoch()).count();
}

void* open_lammps(const std::string& log_file, MPI_Comm communicator) {
  std::vector<std::string> words = {"validate-atoms", "-log", log_file, "-screen", "none", "-nocite"};
  std::vector<char*> arguments;
  for (std::string& word : words) arguments.push_back(word.data());
  return lammps_open(static_cast<int>(arguments.size()), arguments.data(), communicator, nullptr);
}

std::string with_file(std::string line, const std::string& file) {
  if (const auto at = line.find("{file}"); at != std::string::npos) line.replace(at, 6, '"' + file + '"');
  return line;
}

/// Pair styles of this LAMMPS that begin with the same letters, for a message.
std::string styles_like(void* lammps, const std::string& style) {
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
std::string wider_bins(const Box& box, const Eigen::VectorXd& positions) {
  constexpr double bins_per_atom = 16, own_size_A = 5;
  const double atoms = static_cast<double>(positions.size()) / 3;
  const double size = std::cbrt((box.high - box.low).prod() / (bins_per_atom * atoms));
  return !box.periodic && size > own_size_A ? fmt::format(" binsize {:.3g}", size) : "";
}

/// Before LAMMPS is told, so that it does not end the process over it.
void require_style(void* lammps, const std::string& pair_style) {
  const std::string style = pair_style.substr(0, pair_style.find(' '));
  if (!lammps_has_style(lammps, "pair", style.c_str()))
    throw BadPotential(
        fmt::format("pair_style: this LAMMPS has no pair style '{}'{}", style, styles_like(lammps, style)));
}

}  // namespace

MpiSession::MpiSession(int* argc, char*** argv) { MPI_Init(argc, argv); }
MpiSession::~MpiSession() { MPI_Finalize(); }
int MpiSession::rank() const {
  int rank = 0;
  MPI_Comm_rank(MPI_COMM_WORLD, &rank);
  return rank;
}
int MpiSession::ranks() const {
  int ranks = 1;
  MPI_Comm_size(MPI_COMM_WORLD, &ranks);
  return ranks;
}
void MpiSession::abort(int code) {
  MPI_Abort(MPI_COMM_WORLD, code);
  std::abort();
}

int lammps_release() {
  void* lammps = open_lammps("none", MPI_COMM_WORLD);
  const int version = lammps ? lammps_version(lammps) : 0;
  if (lammps) lammps_close(lammps);
  return version;
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
    const double start = seconds();
    atoms_here().put(positions);
    command(fresh ? "run 0 post no" : "run 1 pre no post no");
    forces.resize(positions.size());
    atoms_here().collect(forces);
    const double energy = lammps_get_thermo(lammps, "pe");
    ++timing.calls;
    (fresh ? timing.setup_s : timing.force_s) += seconds() - start;
    return energy;
  }

  /// The part that all ranks do together.
  double compute(Eigen::VectorXd& positions, Eigen::VectorXd& forces, bool fresh) {
    const double start = seconds();
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
    (fresh ? timing.setup_s : timing.force_s) += seconds() - start;
    return energy;
  }
};

ForceField::ForceField(const Potential& potential, const Box& box, const Eigen::VectorXd& positions,
                       const std::string& log_file)
    : instance_(std::make_unique<Instance>()) {
  const double start = seconds();
  Instance& in = *instance_;
  in.box = box;
  in.open(log_file);
  if (potential.kim_model.empty())
    in.command("units metal");
  else
    in.command(fmt::format("kim init {} metal", potential.kim_model));
  in.command("atom_style atomic");
  in.command("atom_modify map array sort 0 0");  // creation order is kept, and a resumed run sums alike
  in.command(box.periodic ? "boundary p p f" : "boundary f f f");
  if (!box.periodic) in.command("processors * * 1");  // the sheet is flat: no cuts across z
  in.command("box tilt large");
  in.command(fmt::format("region cell prism {:.17g} {:.17g} {:.17g} {:.17g} {:.17g} {:.17g} {:.17g} 0 0", box.low.x(),
                         box.high.x(), box.low.y(), box.high.y(), box.low.z(), box.high.z(), box.tilt_xy));
  in.command("create_box 1 cell");
  in.command(fmt::format("mass 1 {:.17g}", potential.mass));
  in.set_potential(potential);
  in.command("neighbor 0.5 bin");
  in.command("neigh_modify every 1 delay 0 check yes" + wider_bins(box, positions));
  in.command("thermo_style custom step pe pxx pyy pxy");
  in.command(thermo_format);
  in.create(positions);
  in.timing.setup_s += seconds() - start;
}

ForceField::~ForceField() {
  if (!instance_->lammps) return;
  if (instance_->rank == 0 && !instance_->shared) {
    Order order = Order::stop;
    MPI_Bcast(&order, 1, MPI_INT, 0, instance_->communicator);
  }
  lammps_close(instance_->lammps);
}

double ForceField::evaluate(const Eigen::VectorXd& positions, Eigen::VectorXd& forces, bool fresh) {
  if (!positions.allFinite()) throw std::runtime_error("positions are not finite; LAMMPS was not asked");
  fresh = std::exchange(instance_->cell_changed, false) || fresh;
  Order order = fresh ? Order::evaluate_fresh : Order::evaluate;
  MPI_Bcast(&order, 1, MPI_INT, 0, instance_->communicator);
  Eigen::VectorXd sent = positions;
  const double energy = instance_->compute(sent, forces, fresh);
  if (!std::isfinite(energy) || !forces.allFinite())
    throw std::runtime_error("LAMMPS returned an energy or a force that is not finite");
  return energy;
}

std::vector<int> ForceField::atoms_here() const {
  std::vector<int> atoms = instance_->atoms_here().numbers();
  std::ranges::sort(atoms);
  return atoms;
}

void ForceField::share_out(const std::vector<int>& own) {
  instance_->atoms_here().belong_to(own);
  instance_->shared = true;
}

double ForceField::evaluate_own(const Eigen::VectorXd& positions, Eigen::VectorXd& forces, bool fresh) {
  if (!positions.allFinite()) throw std::runtime_error("positions are not finite; LAMMPS was not asked");
  fresh = std::exchange(instance_->cell_changed, false) || fresh;
  const double energy = instance_->compute_own(positions, forces, fresh);
  if (!std::isfinite(energy) || !forces.allFinite())
    throw std::runtime_error("LAMMPS returned an energy or a force that is not finite");
  return energy;
}

Eigen::VectorXd ForceField::gather_forces() const {
  const AtomsHere here = instance_->atoms_here();
  Eigen::VectorXd whole(instance_->rank == 0 ? 3 * static_cast<Eigen::Index>(instance_->atoms) : 0);
  MpiTeam().gather(here.forces(), here.numbers(), whole);
  return whole;
}

Eigen::VectorXd ForceField::virials(const Eigen::VectorXd& positions) {
  Order order = Order::virials;
  MPI_Bcast(&order, 1, MPI_INT, 0, instance_->communicator);
  Eigen::VectorXd sent = positions, virials;
  instance_->compute_virials(sent, virials);
  return virials;
}

void ForceField::serve() {
  Eigen::VectorXd positions, forces;
  for (;;) {
    Order order = Order::stop;
    MPI_Bcast(&order, 1, MPI_INT, 0, instance_->communicator);
    if (order == Order::stop) return;
    if (order == Order::virials)
      instance_->compute_virials(positions, forces);
    else
      instance_->compute(positions, forces, order == Order::evaluate_fresh);
  }
}

void ForceField::set_box(const Box& box) {
  instance_->box = box;
  instance_->command(
      fmt::format("change_box all x final {:.17g} {:.17g} y final {:.17g} {:.17g} xy final {:.17g} units box",
                  box.low.x(), box.high.x(), box.low.y(), box.high.y(), box.tilt_xy));
  instance_->cell_changed = true;
}

Eigen::Matrix2d ForceField::membrane_force() const {
  const auto pressure = [&](const char* name) { return lammps_get_thermo(instance_->lammps, name); };
  const double height = instance_->box.high.z() - instance_->box.low.z();
  Eigen::Matrix2d p;
  p << pressure("pxx"), pressure("pxy"), pressure("pxy"), pressure("pyy");
  return -p * height / lammps_bar;
}

const ForceTiming& ForceField::timing() const { return instance_->timing; }

}  // namespace atomistic
