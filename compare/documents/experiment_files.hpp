// The documents of an experiment: one list, each writes its files into a folder.
#pragma once

#include <filesystem>

#include "compare/study/study.hpp"

namespace validate {

/// Writes all documents. `work` is the run's folder of that name, with LAMMPS's logs and the finished steps. One
/// document that fails does not keep the others from being written; the first failure is thrown at the end (Error, file
/// failed).
void write_experiment(const StudyOutcome& outcome, const std::filesystem::path& work,
                      const std::filesystem::path& folder);

}  // namespace validate
