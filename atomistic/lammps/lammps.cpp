#include "atomistic/lammps/lammps.hpp"

#include <algorithm>

#include "atomistic/lammps/instance.hpp"
#include "atomistic/ranks/mpi_team.hpp"

namespace atomistic {

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

ForceField::ForceField(const Potential& potential, const Box& box, const Eigen::VectorXd& positions,
                       const std::string& log_file)
    : instance_(std::make_unique<Instance>()) {
  const double start = lammps_clock_s();
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
  in.timing.setup_s += lammps_clock_s() - start;
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
