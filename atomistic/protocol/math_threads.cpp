#include "atomistic/protocol/math_threads.hpp"

#include <omp.h>

#include <filesystem>
#include <fstream>

extern "C" void openblas_set_num_threads(int) __attribute__((weak));

namespace atomistic {

void use_one_math_thread() {
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
