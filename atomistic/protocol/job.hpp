// What validate-atoms is asked to do: one job file (JSON), one thing to compute.
#pragma once

#include <filesystem>
#include <string>
#include <variant>

#include "atomistic/problem.hpp"
#include "atomistic/response.hpp"

namespace atomistic {

struct CardJob {
  Potential potential;
};

/// Stress–strain curves, and single states of homogeneous strain.
struct ResponseJob {
  Potential potential;
  Card card;
  std::vector<StrainState> strains;
};

struct CurveJob {
  Problem problem;
  std::string steps_folder;  ///< finished levels are written here, and those already here are taken over
};

struct Job {
  std::variant<CardJob, ResponseJob, CurveJob> work;
  std::string log_file;  ///< LAMMPS's log
};

void write_job(const Job& job, const std::filesystem::path& file);

/// Throws std::runtime_error naming the file if it cannot be read or is not a job.
Job read_job(const std::filesystem::path& file);

}  // namespace atomistic
