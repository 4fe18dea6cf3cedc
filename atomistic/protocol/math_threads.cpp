#include "atomistic/protocol/math_threads.hpp"

#include <omp.h>
#include <sys/mman.h>

#include <filesystem>
#include <fstream>
#include <new>

extern "C" void openblas_set_num_threads(int) __attribute__((weak));

namespace atomistic {
namespace {

/// OpenBLAS asks for its buffer again and again, for ever, where the system does not give it.
void require_buffer() {
  constexpr std::size_t bytes = std::size_t{160} << 20;  // 128 MiB and what else is needed until then
  void* const buffer = ::mmap(nullptr, bytes, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
  if (buffer == MAP_FAILED) throw std::bad_alloc();
  ::munmap(buffer, bytes);
}

}  // namespace

void use_one_math_thread() {
  require_buffer();
  if (openblas_set_num_threads) openblas_set_num_threads(1);
  omp_set_max_active_levels(0);
}

std::string loaded_blas() {
  std::ifstream maps("/proc/self/maps");
  for (std::string line; std::getline(maps, line);) {
    const auto path = line.find('/');
    if (path == std::string::npos) continue;
    const std::string name = std::filesystem::path(line.substr(path)).filename();
    if (name.starts_with("libblas.so") || name.starts_with("libopenblas")) return line.substr(path);
  }
  return {};
}

}  // namespace atomistic
