#include "compare/documents/bytes/trajectory_h5.hpp"

#include <array>
#include <numeric>

#include "compare/base/errors.hpp"
#include "compare/documents/bytes/h5_read.hpp"

namespace validate {
namespace {

void write_head(h5::Group& root, const std::string& version) {
  h5::Group head = root.group("h5md");
  head.attribute("version", std::array{1, 1});
  h5::Group creator = head.group("creator");
  creator.attribute("name", "validate");
  creator.attribute("version", version);
  head.group("author").attribute("name", "validate");
}

void write_steps(h5::Group& element, std::size_t frames) {
  std::vector<int> steps(frames);
  std::iota(steps.begin(), steps.end(), 0);
  element.data_set("step", steps);
}

void write_positions(h5::Group& particles, const AtomsTrajectory& t) {
  h5::Group group = particles.group(t.load);
  group.attribute("free_atoms", static_cast<int>(t.free_atoms));
  h5::Group box = group.group("box");
  const std::array<std::string, 3> boundary = {"none", "none", "none"};
  box.attribute("dimension", 3);
  box.attribute("boundary", boundary);
  h5::Group position = group.group("position");
  write_steps(position, t.depth_A.size());
  h5::Object value = position.data_set("value", t.positions_A, std::array{t.depth_A.size(), t.atoms, std::size_t{3}});
  value.attribute("unit", "Å");
  value.attribute("meaning", "places of the atoms; the first frame is the flat sheet as built");
}

void write_observable(h5::Group& of_load, const char* name, const char* unit, const std::vector<double>& values) {
  h5::Group element = of_load.group(name);
  write_steps(element, values.size());
  element.data_set("value", values).attribute("unit", unit);
}

std::vector<double> observable(const std::optional<h5::ReadGroup>& of_load, const char* name) {
  const auto element = of_load ? of_load->group(name) : std::nullopt;
  return element ? element->column("value") : std::vector<double>{};
}

AtomsTrajectory read_one(const std::string& load, const h5::ReadGroup& particles,
                         const std::optional<h5::ReadGroup>& observables) {
  AtomsTrajectory t{.load = load};
  const auto position = particles.group("position");
  h5::NumberBlock block = position ? position->block("value") : h5::NumberBlock{};
  const auto of_load = observables ? observables->group(load) : std::nullopt;
  t.depth_A = observable(of_load, "depth"), t.force_eV_per_A = observable(of_load, "force");
  const double free = particles.has_attribute("free_atoms") ? particles.number("free_atoms") : 0;
  if (block.shape.size() != 3 || block.shape[2] != 3 || block.shape[0] == 0 || t.depth_A.size() != block.shape[0] ||
      t.force_eV_per_A.size() != block.shape[0] || !(free >= 0 && free <= static_cast<double>(block.shape[1])))
    throw Error(ExitCode::file_failed, "run.h5, atoms' trajectories: lengths do not fit each other");
  t.atoms = block.shape[1], t.free_atoms = static_cast<std::size_t>(free);
  t.positions_A = std::move(block.values);
  return t;
}

}  // namespace

void write_trajectories(h5::Group& root, const std::vector<AtomsTrajectory>& trajectories, const std::string& version) {
  if (trajectories.empty()) return;
  write_head(root, version);
  h5::Group particles = root.group("particles"), observables = root.group("observables");
  for (const AtomsTrajectory& t : trajectories) {
    write_positions(particles, t);
    h5::Group of_load = observables.group(t.load);
    write_observable(of_load, "depth", "Å", t.depth_A);
    write_observable(of_load, "force", "eV/Å", t.force_eV_per_A);
  }
}

std::vector<AtomsTrajectory> read_trajectories(const std::filesystem::path& file) {
  std::vector<AtomsTrajectory> all;
  if (!std::filesystem::is_regular_file(file)) return all;
  const h5::ReadGroup root = h5::open_file(file, {});
  const auto particles = root.group("particles"), observables = root.group("observables");
  if (!particles) return all;
  for (const std::string& load : particles->group_names())
    all.push_back(read_one(load, *particles->group(load), observables));
  return all;
}

}  // namespace validate
