// What validate-atoms is asked to do: one job file (JSON), one thing to compute.
#pragma once

#include <filesystem>
#include <string>
#include <variant>

#include "atomistic/problem.hpp"
#include "atomistic/response.hpp"
#include "atomistic/temperature.hpp"

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

/// Energy and forces of an isolated set of atoms, nothing moved and nothing held.
struct ForcesJob {
  Potential potential;
  std::vector<Eigen::VectorXd> positions;  ///< 3N each
};

struct CurveJob {
  Problem problem;
  std::string steps_folder;  ///< finished levels are written here, and those already here are taken over
};

/// What a temperature does to a curve's finished levels.
struct HeatJob {
  Problem problem;
  Heat heat;
  std::string steps_folder;  ///< of the curve; heated levels are written there, and those already there are taken over
};

/// The flat sheet at a temperature, and what its vibrations add to the free energy under homogeneous strain.
struct WarmJob {
  Potential potential;
  Card card;
  Heat heat;
  std::vector<StrainState> strains;
};

/// A finished level by dynamics.
struct SampleJob {
  Problem problem;
  Sampling sampling;
  int level = 0;
  std::string steps_folder;  ///< what has been sampled is kept there
};

struct Job {
  std::variant<CardJob, ResponseJob, CurveJob, ForcesJob, HeatJob, WarmJob, SampleJob> work;
  std::string log_file;  ///< LAMMPS's log
};

void write_job(const Job& job, const std::filesystem::path& file);

/// Throws std::runtime_error naming the file if it cannot be read or is not a job.
Job read_job(const std::filesystem::path& file);

}  // namespace atomistic
