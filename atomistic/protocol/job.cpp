#include "atomistic/protocol/job.hpp"

#include <fstream>
#include <stdexcept>

#include "atomistic/protocol/json.hpp"

namespace atomistic {
namespace {

using nlohmann::json;

json load_to_json(const Load& load) {
  if (const auto* disc = std::get_if<DiscLoad>(&load))
    return {{"kind", "disc"}, {"radius_A", disc->radius_A}};
  return {{"kind", "point"}};
}

Load load_from_json(const json& j) {
  if (j.at("kind") == "disc") return DiscLoad{j.at("radius_A")};
  return PointLoad{};
}

json problem_to_json(const Problem& p) {
  return {{"potential", p.potential},
          {"card", p.card},
          {"radius_A", p.radius_A},
          {"biaxial_strain", p.biaxial_strain},
          {"load", load_to_json(p.load)},
          {"force_control", p.control == Control::force},
          {"levels", p.levels},
          {"force_tolerance_eV_per_A", p.force_tolerance_eV_per_A},
          {"max_evaluations", p.max_evaluations},
          {"past_artefact", p.past_artefact}};
}

Problem problem_from_json(const json& j) {
  return {.potential = j.at("potential"),
          .card = j.at("card"),
          .radius_A = j.at("radius_A"),
          .biaxial_strain = j.at("biaxial_strain"),
          .load = load_from_json(j.at("load")),
          .control = j.at("force_control") ? Control::force : Control::conjugate_depth,
          .levels = j.at("levels"),
          .force_tolerance_eV_per_A = j.at("force_tolerance_eV_per_A"),
          .max_evaluations = j.at("max_evaluations"),
          .past_artefact = j.at("past_artefact")};
}

}  // namespace

void write_job(const Job& job, const std::filesystem::path& file) {
  json j = {{"log_file", job.log_file}};
  if (const auto* curve = std::get_if<CurveJob>(&job.work))
    j["curve"] = {{"problem", problem_to_json(curve->problem)}, {"steps_folder", curve->steps_folder}};
  else
    j["card"] = {{"potential", std::get<CardJob>(job.work).potential}};
  std::ofstream out(file);
  out << j.dump(1) << '\n';
  if (!out.flush()) throw std::runtime_error("cannot write " + file.string());
}

Job read_job(const std::filesystem::path& file) {
  std::ifstream in(file);
  if (!in) throw std::runtime_error("cannot read the job file " + file.string());
  try {
    const json j = json::parse(in);
    Job job;
    job.log_file = j.at("log_file");
    if (j.contains("card"))
      job.work = CardJob{j.at("card").at("potential")};
    else
      job.work = CurveJob{problem_from_json(j.at("curve").at("problem")), j.at("curve").at("steps_folder")};
    return job;
  } catch (const json::exception& e) {
    throw std::runtime_error(file.string() + " is not a job file: " + e.what());
  }
}

}  // namespace atomistic
