#include "atomistic/protocol/step_file.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <cerrno>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <fstream>
#include <stdexcept>
#include <system_error>

namespace atomistic {
namespace {

namespace fs = std::filesystem;

/// The fixed part of the file; the vectors follow as doubles. `magic` names the layout and its version.
struct Header {
  char magic[8] = {'V', 'S', 'T', 'E', 'P', '0', '0', '5'};
  std::int64_t level, unloading, search, broken, converged, evaluations, factorisations, solves;
  double target, depth, conjugate_depth, force, energy, max_force, balance, force_error, longest_bond;
  std::int64_t positions, forces, factorised_at, virials;  ///< lengths
  std::uint64_t checksum;                                  ///< of all others and of the vectors
};

/// FNV-1a: a change of one byte always changes it.
class Checksum {
 public:
  void add(const void* data, std::size_t size) {
    const auto* bytes = static_cast<const unsigned char*>(data);
    for (std::size_t i = 0; i < size; ++i) value_ = (value_ ^ bytes[i]) * 0x100000001b3u;
  }
  std::uint64_t value() const { return value_; }

 private:
  std::uint64_t value_ = 0xcbf29ce484222325u;
};

std::uint64_t checksum_of(const Header& header, const Step& step) {
  Checksum sum;
  sum.add(&header, offsetof(Header, checksum));
  for (const Eigen::VectorXd* v : {&step.positions, &step.forces, &step.factorised_at, &step.virials})
    sum.add(v->data(), sizeof(double) * static_cast<std::size_t>(v->size()));
  return sum.value();
}

Header header_of(const Step& s) {
  Header h{};
  std::memcpy(h.magic, Header{}.magic, sizeof h.magic);
  h.level = s.level;
  h.unloading = s.unloading;
  h.search = s.search;
  h.broken = s.broken;
  h.target = s.target;
  h.converged = s.converged;
  h.evaluations = s.evaluations;
  h.factorisations = s.factorisations;
  h.solves = s.solves;
  h.depth = s.depth_A;
  h.conjugate_depth = s.conjugate_depth_A;
  h.force = s.force_eV_per_A;
  h.energy = s.energy_eV;
  h.max_force = s.max_force_eV_per_A;
  h.balance = s.balance_relative;
  h.force_error = s.force_error_relative;
  h.longest_bond = s.longest_bond_A;
  h.positions = s.positions.size();
  h.forces = s.forces.size();
  h.factorised_at = s.factorised_at.size();
  h.virials = s.virials.size();
  h.checksum = checksum_of(h, s);
  return h;
}

Step step_of(const Header& h) {
  Step s;
  s.level = static_cast<int>(h.level);
  s.unloading = h.unloading != 0;
  s.search = h.search != 0;
  s.broken = h.broken != 0;
  s.target = h.target;
  s.converged = h.converged != 0;
  s.evaluations = static_cast<int>(h.evaluations);
  s.factorisations = static_cast<int>(h.factorisations);
  s.solves = static_cast<int>(h.solves);
  s.depth_A = h.depth;
  s.conjugate_depth_A = h.conjugate_depth;
  s.force_eV_per_A = h.force;
  s.energy_eV = h.energy;
  s.max_force_eV_per_A = h.max_force;
  s.balance_relative = h.balance;
  s.force_error_relative = h.force_error;
  s.longest_bond_A = h.longest_bond;
  s.positions.resize(h.positions);
  s.forces.resize(h.forces);
  s.factorised_at.resize(h.factorised_at);
  s.virials.resize(h.virials);
  return s;
}

[[noreturn]] void fail(const fs::path& file) {
  throw std::system_error(errno, std::generic_category(), "cannot write " + file.string());
}

void write_all(int descriptor, const void* data, std::size_t size, const fs::path& file) {
  const char* at = static_cast<const char*>(data);
  while (size > 0) {
    const ssize_t written = ::write(descriptor, at, size);
    if (written < 0 && errno == EINTR) continue;
    if (written < 0) fail(file);
    at += written;
    size -= static_cast<std::size_t>(written);
  }
}

}  // namespace

fs::path step_file_name(int level) { return fmt::format("step-{:04d}.bin", level); }

void write_step(const Step& step, const fs::path& folder) {
  const fs::path final_name = folder / step_file_name(step.level);
  const fs::path temporary = final_name.string() + ".part";
  const int descriptor = ::open(temporary.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0666);
  if (descriptor < 0) fail(temporary);
  try {
    const Header header = header_of(step);
    write_all(descriptor, &header, sizeof header, temporary);
    for (const Eigen::VectorXd* v : {&step.positions, &step.forces, &step.factorised_at, &step.virials})
      write_all(descriptor, v->data(), sizeof(double) * static_cast<std::size_t>(v->size()), temporary);
    if (::fsync(descriptor) != 0) fail(temporary);
  } catch (...) {
    ::close(descriptor);
    ::unlink(temporary.c_str());
    throw;
  }
  ::close(descriptor);
  if (::rename(temporary.c_str(), final_name.c_str()) != 0) fail(final_name);
}

Step read_step(const fs::path& file) {
  const auto broken = [&](const char* why) { return std::runtime_error(file.string() + ": " + why); };
  std::ifstream in(file, std::ios::binary);
  Header header{};
  if (!in.read(reinterpret_cast<char*>(&header), sizeof header)) throw broken("not a step file, or cut short");
  if (std::memcmp(header.magic, Header{}.magic, sizeof header.magic) != 0) throw broken("not a step file");
  const std::uintmax_t bytes = fs::file_size(file);
  std::uintmax_t doubles = 0;
  for (const std::int64_t length : {header.positions, header.forces, header.factorised_at, header.virials}) {
    if (length < 0 || static_cast<std::uintmax_t>(length) > bytes) throw broken("a step file of the wrong length");
    doubles += static_cast<std::uintmax_t>(length);
  }
  if (bytes != sizeof header + sizeof(double) * doubles) throw broken("a step file of the wrong length");
  Step step = step_of(header);
  for (Eigen::VectorXd* v : {&step.positions, &step.forces, &step.factorised_at, &step.virials})
    if (!in.read(reinterpret_cast<char*>(v->data()), static_cast<std::streamsize>(sizeof(double)) * v->size()))
      throw broken("cut short");
  if (checksum_of(header, step) != header.checksum) throw broken("a damaged step file");
  return step;
}

namespace {

/// The path goes on from three, of which one may have been reached again on the way back.
constexpr int states_kept = 6;

/// A sheet's vectors at every level are far more than a path needs to go on.
void forget_vectors(std::vector<Step>& steps) {
  int states = 0;
  for (std::size_t k = steps.size(); k-- > 0;) {
    const bool state = steps[k].converged && !steps[k].broken;
    if (k + 1 == steps.size()) {
      states += state;
      continue;
    }
    if (!(state && ++states <= states_kept)) steps[k].positions.resize(0);
    for (Eigen::VectorXd* v : {&steps[k].forces, &steps[k].factorised_at, &steps[k].virials}) v->resize(0);
  }
}

/// Those that are whole, in order; `forget` is called after each with all so far.
template <class Forget>
std::vector<Step> read_whole_steps(const fs::path& folder, Forget&& forget) {
  std::vector<Step> steps;
  for (int level = 0; fs::exists(folder / step_file_name(level)); ++level) {
    try {
      steps.push_back(read_step(folder / step_file_name(level)));
      forget(steps);
    } catch (const std::runtime_error&) {  // damaged: it and what followed it is computed again
      break;
    }
  }
  return steps;
}

}  // namespace

std::vector<Step> read_finished_steps(const fs::path& folder) { return read_whole_steps(folder, forget_vectors); }

std::vector<Step> read_way_there(const fs::path& folder) {
  std::vector<Step> steps = read_whole_steps(folder, [](std::vector<Step>& so_far) {
    for (Eigen::VectorXd* v : {&so_far.back().forces, &so_far.back().factorised_at, &so_far.back().virials})
      v->resize(0);
  });
  while (!steps.empty() && (steps.back().unloading || steps.back().search)) steps.pop_back();
  if (!steps.empty()) steps.back() = read_step(folder / step_file_name(steps.back().level));
  return steps;
}

std::vector<Step> read_equilibria(const fs::path& folder) {
  std::vector<Step> steps = read_way_there(folder);
  std::erase_if(steps, [](const Step& s) { return s.unloading || s.search || s.broken || !s.converged; });
  return steps;
}

}  // namespace atomistic
