// LAMMPS's own Langevin dynamics on a force field's atoms.
#include "atomistic/lammps/instance.hpp"
#include "atomistic/lammps/lammps.hpp"

namespace atomistic {
namespace {

/// The same of LAMMPS's own arrays, one rank.
double depth_now(void* lammps, const std::vector<bool>& is_loaded, std::size_t loaded) {
  const int own = *static_cast<int*>(lammps_extract_global(lammps, "nlocal"));
  const auto* id = static_cast<int*>(lammps_extract_atom(lammps, "id"));
  auto** x = static_cast<double**>(lammps_extract_atom(lammps, "x"));
  double sum = 0;
  for (int i = 0; i < own; ++i)
    if (is_loaded[static_cast<std::size_t>(id[i] - 1)]) sum -= x[i][2];
  return sum / static_cast<double>(loaded);
}

void copy(void* lammps, const char* array, Eigen::VectorXd& values, bool into_lammps) {
  const int own = *static_cast<int*>(lammps_extract_global(lammps, "nlocal"));
  const auto* id = static_cast<int*>(lammps_extract_atom(lammps, "id"));
  auto** at = static_cast<double**>(lammps_extract_atom(lammps, array));
  for (int i = 0; i < own; ++i) {
    Eigen::Map<Eigen::Vector3d> here(at[i]);
    auto mine = values.segment<3>(3 * (id[i] - 1));
    if (into_lammps)
      here = mine;
    else
      mine = here;
  }
}

}  // namespace

std::vector<double> ForceField::langevin(const LangevinBath& bath, PhasePoint& at, int steps, int every,
                                         unsigned seed) {
  Instance& in = *instance_;
  if (in.ranks > 1) throw std::logic_error("dynamics runs on one rank");
  std::vector<bool> is_loaded(static_cast<std::size_t>(in.atoms));
  for (const int atom : bath.loaded) is_loaded[static_cast<std::size_t>(atom)] = true;
  in.put(at.positions);
  in.command(fmt::format("group mobile id 1:{}", bath.free_atoms));
  std::string loaded = "group loaded id";  // once more the same in later stretches
  for (const int atom : bath.loaded) loaded += fmt::format(" {}", atom + 1);
  in.command(loaded);
  in.command(fmt::format("timestep {:.17g}", bath.step_ps));
  if (at.velocities.size() == 0)
    in.command(fmt::format("velocity mobile create {:.17g} {} dist gaussian loop all", bath.temperature_K, seed));
  else
    copy(in.lammps, "v", at.velocities, true);
  in.command("fix move mobile nve");
  in.command(fmt::format("fix bath mobile langevin {0:.17g} {0:.17g} {1:.17g} {2}", bath.temperature_K, bath.damping_ps,
                         seed));
  in.command(fmt::format("fix push loaded addforce 0 0 {:.17g}",
                         -bath.force_eV_per_A / static_cast<double>(bath.loaded.size())));
  std::vector<double> depths;
  for (int done = 0; done < steps; done += every) {
    in.command(fmt::format("run {} {} post no", every, done == 0 ? "pre yes" : "pre no"));
    depths.push_back(depth_now(in.lammps, is_loaded, bath.loaded.size()));
  }
  at.velocities.resize(at.positions.size());
  copy(in.lammps, "x", at.positions, false);
  copy(in.lammps, "v", at.velocities, false);
  for (const char* fix : {"push", "bath", "move"}) in.command(fmt::format("unfix {}", fix));
  in.cell_changed = true;  // the next evaluation finds its own neighbours
  in.timing.calls += steps;
  return depths;
}

}  // namespace atomistic
