#include "compare/results/result.hpp"

#include <cmath>

namespace validate {

std::string_view to_string(Model model) {
  switch (model) {
    case Model::membrane:
      return "membrane";
    case Model::atomistic:
      return "atomistic";
    case Model::sheet:
      return "sheet";
  }
  return "";
}

std::string_view to_string(Constants constants) {
  switch (constants) {
    case Constants::card:
      return "card";
    case Constants::paper:
      return "paper";
    case Constants::given:
      return "given";
    case Constants::calibrated:
      return "calibrated";
    case Constants::none:
      return "none";
  }
  return "";
}

std::string_view to_string(Ended ended) {
  switch (ended) {
    case Ended::depth_max:
      return "depth_max";
    case Ended::artefact:
      return "artefact";
    case Ended::rupture:
      return "rupture";
    case Ended::not_converged:
      return "not_converged";
  }
  return "";
}

std::string_view to_string(Regime regime) {
  switch (regime) {
    case Regime::bending:
      return "bending";
    case Regime::membrane:
      return "membrane";
    case Regime::softening:
      return "softening";
    case Regime::artefact:
      return "artefact";
  }
  return "";
}

std::string_view to_string(const std::optional<Ended>& ended) { return ended ? to_string(*ended) : "failed"; }

namespace {

// A membrane run leaves artefact[] empty: nothing in it is an artefact.
bool is_artefact(const Run& run, std::size_t i) { return i < run.artefact.size() && run.artefact[i]; }

}  // namespace

std::vector<std::size_t> usable_points(const Run& run) {
  std::vector<std::size_t> usable;
  for (std::size_t i = 0; i < run.depth_A.size(); ++i) {
    const bool finite = std::isfinite(run.depth_A[i]) && std::isfinite(run.force_eV_per_A[i]);
    if (finite && run.depth_A[i] > 0 && run.converged[i] && !is_artefact(run, i)) usable.push_back(i);
  }
  return usable;
}

double artefact_bond_of(const Result& result) {
  constexpr double usual_A = 1.70;
  return result.card && std::isfinite(result.card->artefact_bond_A) ? result.card->artefact_bond_A : usual_A;
}

std::optional<std::size_t> first_artefact(const Run& run) {
  for (std::size_t i = 0; i < run.artefact.size(); ++i) {
    if (run.artefact[i]) return i;
  }
  return std::nullopt;
}

}  // namespace validate
