// Runs the gnuplot program.
#pragma once

#include <filesystem>
#include <optional>
#include <string>

namespace validate {

struct GnuplotReport {
  bool succeeded = false;
  std::string messages;  ///< what it wrote; with exit status 0 these are warnings (a missing font)
};

/// Runs `gnuplot -d script` (found on PATH, no shell) in the script's folder and waits for it. Nothing where there is
/// no such program. Throws Error (interrupted).
std::optional<GnuplotReport> run_gnuplot(const std::filesystem::path& script);

/// A gnuplot string in single quotes, the quotes inside it doubled.
std::string gnuplot_quoted(std::string text);

}  // namespace validate
