#include "compare/potential/potential_card.hpp"

#include <fmt/format.h>

#include <cstdlib>
#include <numbers>
#include <optional>
#include <stdexcept>

#include "atomistic/protocol/json.hpp"
#include "compare/base/errors.hpp"
#include "compare/base/file.hpp"
#include "compare/base/read_file.hpp"
#include "compare/base/sha256.hpp"
#include "compare/base/temporary_folder.hpp"
#include "compare/potential/law/states.hpp"
#include "compare/potential/law/variants.hpp"
#include "compare/process/provenance.hpp"

namespace validate {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

/// Counts up when a number of the card is computed in another way.
constexpr int card_layout = 5;

std::string digest_of(const json& kept) {
  return sha256(json{kept.at("card"), kept.at("response"), kept.at("lammps")}.dump());
}

std::optional<PotentialCard> cached(const PotentialFile& potential, const fs::path& file) {
  const json j = json::parse(read_if_there(file).value_or(""), nullptr, false);
  if (!j.is_object()) return std::nullopt;
  try {
    if (j.at("sha256") != digest_of(j)) return std::nullopt;  // changed by hand, or by a disk
    return PotentialCard{.potential = potential,
                         .card = j.at("card"),
                         .response = j.at("response"),
                         .lammps = j.at("lammps"),
                         .from_cache = true,
                         .law = {},
                         .no_law = {}};
  } catch (const json::exception&) {
    return std::nullopt;
  }
}

void keep(const PotentialCard& card, const fs::path& file) {
  try {
    fs::create_directories(file.parent_path());
    json kept = {{"card", card.card}, {"response", card.response}, {"lammps", card.lammps}};
    kept["sha256"] = digest_of(kept);
    write_file(file, kept.dump(1) + "\n");
  } catch (const std::exception&) {
    // the next run computes it again
  }
}

void add_law(PotentialCard& card) {
  try {
    const CalibrationRange range = calibration_range(card.potential.potential.artefact_bond_A);
    card.law = calibrate(card.card, card.response.states, range);
    card.law->sixfold = calibrate_sixfold(card.card, card.response.states, range);
  } catch (const std::invalid_argument& reason) {
    card.no_law = reason.what();
  }
}

/// Runs one job and hands its events to `take`.
template <class Take>
void run_job(const AtomsLaunch& launch, TemporaryFolder& folder, const std::string& name,
             const decltype(atomistic::Job::work)& work, Take&& take) {
  const AtomsJob job{name, {work, (folder.path() / name / "log.lammps").string()}, 1};
  const auto outcomes = run_jobs(launch, {job}, folder.path(),
                                 [&](std::size_t, const atomistic::Event& event) { std::visit(take, event); });
  if (outcomes[0].finished) return;
  if (outcomes[0].fault == atomistic::Fault::bad_input) throw bad_input("{}", outcomes[0].failure);
  folder.keep();
  throw Error(ExitCode::atomistic_failed, fmt::format("the potential's {}: {}", name, outcomes[0].failure));
}

struct TakeEvents {
  PotentialCard& card;
  void operator()(const atomistic::StartEvent& e) const { card.lammps = lammps_release(e.lammps_version); }
  void operator()(const atomistic::CardEvent& e) const { card.card = e.card; }
  void operator()(const atomistic::ResponseEvent& e) const { card.response = e.response; }
  template <class Other>
  void operator()(const Other&) const {}
};

}  // namespace

std::string card_key(const PotentialFile& file) {
  const atomistic::Potential& p = file.potential;
  const json key = {card_layout, version_text(),        p.pair_style,      p.pair_coeff, p.kim_model,
                    p.mass,      p.interaction_range_A, p.artefact_bond_A, file.sha256,  file.edit};
  return sha256(key.dump(-1, ' ', false, json::error_handler_t::replace));
}

fs::path card_cache() {
  const auto variable = [](const char* name) {
    const char* value = std::getenv(name);
    return std::string(value ? value : "");
  };
  if (const std::string cache = variable("XDG_CACHE_HOME"); !cache.empty())
    return fs::path(cache) / "validate" / "cards";
  if (const std::string home = variable("HOME"); !home.empty()) return fs::path(home) / ".cache" / "validate" / "cards";
  return {};
}

PotentialCard potential_card(const PotentialFile& potential, const AtomsLaunch& launch, const fs::path& cache,
                             bool refresh) {
  const fs::path file = cache.empty() ? fs::path() : cache / (card_key(potential) + ".json");
  if (!refresh && !file.empty())
    if (auto found = cached(potential, file)) {
      add_law(*found);
      return *found;
    }
  PotentialCard card{.potential = potential, .card = {}, .response = {}, .lammps = {}, .law = {}, .no_law = {}};
  TemporaryFolder folder("validate-card");
  run_job(launch, folder, "card", atomistic::CardJob{potential.potential}, TakeEvents{card});
  run_job(launch, folder, "response",
          atomistic::ResponseJob{potential.potential, card.card,
                                 calibration_strains(card.card.a0_A / std::numbers::sqrt3,
                                                     calibration_range(potential.potential.artefact_bond_A))},
          TakeEvents{card});
  if (!file.empty()) keep(card, file);
  add_law(card);
  return card;
}

}  // namespace validate
