#include "atomistic/protocol/job.hpp"

#include <array>
#include <fstream>
#include <stdexcept>
#include <string_view>

#include "atomistic/protocol/json.hpp"

namespace atomistic {

NLOHMANN_JSON_SERIALIZE_ENUM(Shape, {{Shape::disc, "disc"}, {Shape::square, "square"}})
NLOHMANN_JSON_SERIALIZE_ENUM(Centre, {{Centre::hexagon, "hexagon"}, {Centre::atom, "atom"}})
NLOHMANN_JSON_SERIALIZE_ENUM(Edge, {{Edge::clamped, "clamped"}, {Edge::sliding, "sliding"}})
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(DiscLoad, radius_A)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(SphereLoad, radius_A, stiffness_eV_per_A3)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(PressureLoad, following)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(Guide, level, spacing_A, outward_A, depth_A)
static void to_json(nlohmann::json& j, const PointLoad&) { j = nlohmann::json::object(); }
static void from_json(const nlohmann::json&, PointLoad&) {}

namespace {

using nlohmann::json;

/// In the order of the variant's alternatives.
constexpr std::array<std::string_view, std::variant_size_v<Load>> load_kinds = {"point", "disc", "sphere", "pressure"};

json load_to_json(const Load& load) {
  json j = std::visit([](const auto& l) { return json(l); }, load);
  j["kind"] = load_kinds[load.index()];
  return j;
}

template <std::size_t index = 0>
Load load_from_json(const json& j) {
  if constexpr (index < load_kinds.size()) {
    if (j.at("kind") == load_kinds[index]) return j.get<std::variant_alternative_t<index, Load>>();
    return load_from_json<index + 1>(j);
  } else {
    throw std::runtime_error("unknown load");
  }
}

json places_to_json(const std::vector<Eigen::Vector2d>& places) {
  json list = json::array();
  for (const Eigen::Vector2d& p : places) list.push_back({p.x(), p.y()});
  return list;
}

std::vector<Eigen::Vector2d> places_from_json(const json& j) {
  std::vector<Eigen::Vector2d> places;
  for (const json& p : j) places.emplace_back(p.at(0).get<double>(), p.at(1).get<double>());
  return places;
}

json form_to_json(const SheetForm& f) {
  return {{"shape", f.shape},
          {"edge", f.edge},
          {"centre", f.centre},
          {"rotation_deg", f.rotation_deg},
          {"vacancies_A", places_to_json(f.vacancies)},
          {"stone_wales_A", places_to_json(f.stone_wales)}};
}

SheetForm form_from_json(const json& j) {
  return {.shape = j.at("shape"),
          .edge = j.at("edge"),
          .centre = j.at("centre"),
          .rotation_deg = j.at("rotation_deg"),
          .vacancies = places_from_json(j.at("vacancies_A")),
          .stone_wales = places_from_json(j.at("stone_wales_A"))};
}

json forces_to_json(const ForcesJob& job) {
  json positions = json::array();
  for (const Eigen::VectorXd& x : job.positions) positions.push_back(numbers_of(x));
  return {{"potential", job.potential}, {"positions_A", positions}};
}

ForcesJob forces_from_json(const json& j) {
  ForcesJob job{.potential = j.at("potential"), .positions = {}};
  for (const json& x : j.at("positions_A")) job.positions.push_back(vector_of(x));
  return job;
}

json problem_to_json(const Problem& p) {
  return {{"potential", p.potential},
          {"card", p.card},
          {"radius_A", p.radius_A},
          {"form", form_to_json(p.form)},
          {"biaxial_strain", p.biaxial_strain},
          {"rim_tension_eV_per_A2", p.rim_tension_eV_per_A2},
          {"load", load_to_json(p.load)},
          {"force_control", p.control == Control::force},
          {"levels", p.levels},
          {"guides", p.guides},
          {"unload", p.unload},
          {"force_tolerance_eV_per_A", p.force_tolerance_eV_per_A},
          {"max_evaluations", p.max_evaluations},
          {"past_artefact", p.past_artefact},
          {"ripple_A", p.ripple_A},
          {"ripple_seed", p.ripple_seed},
          {"ripple_waves", p.ripple_waves},
          {"virials", p.virials},
          {"preconditioning", p.preconditioning}};
}

Problem problem_from_json(const json& j) {
  return {.potential = j.at("potential"),
          .card = j.at("card"),
          .radius_A = j.at("radius_A"),
          .form = form_from_json(j.at("form")),
          .biaxial_strain = j.at("biaxial_strain"),
          .rim_tension_eV_per_A2 = j.at("rim_tension_eV_per_A2"),
          .load = load_from_json(j.at("load")),
          .control = j.at("force_control") ? Control::force : Control::conjugate_depth,
          .levels = j.at("levels"),
          .guides = j.at("guides"),
          .unload = j.at("unload"),
          .force_tolerance_eV_per_A = j.at("force_tolerance_eV_per_A"),
          .max_evaluations = j.at("max_evaluations"),
          .past_artefact = j.at("past_artefact"),
          .ripple_A = j.at("ripple_A"),
          .ripple_seed = j.at("ripple_seed"),
          .ripple_waves = j.at("ripple_waves"),
          .virials = j.at("virials"),
          .preconditioning = j.at("preconditioning")};
}

/// Paths and names are bytes, JSON's texts are not: each byte becomes the character of its number.
std::string text_of_bytes(const std::string& bytes) {
  std::string text;
  for (const char c : bytes) {
    const auto byte = static_cast<unsigned char>(c);
    if (byte < 0x80)
      text += c;
    else
      text += {static_cast<char>(0xC0 | byte >> 6), static_cast<char>(0x80 | (byte & 0x3F))};
  }
  return text;
}

std::string bytes_of_text(const std::string& text) {
  std::string bytes;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const auto first = static_cast<unsigned char>(text[i]);
    if (first < 0x80) {
      bytes += text[i];
    } else {
      if ((first & 0xFC) != 0xC0 || i + 1 == text.size()) throw std::runtime_error("not a text of bytes");
      bytes += static_cast<char>((first & 0x03) << 6 | (static_cast<unsigned char>(text[++i]) & 0x3F));
    }
  }
  return bytes;
}

void change_texts(json& j, std::string (*change)(const std::string&)) {
  if (j.is_string()) j = change(j.get<std::string>());
  if (j.is_structured())
    for (json& part : j) change_texts(part, change);
}

}  // namespace

void write_job(const Job& job, const std::filesystem::path& file) {
  json j = {{"log_file", job.log_file}};
  if (const auto* curve = std::get_if<CurveJob>(&job.work))
    j["curve"] = {{"problem", problem_to_json(curve->problem)}, {"steps_folder", curve->steps_folder}};
  else if (const auto* response = std::get_if<ResponseJob>(&job.work))
    j["response"] = {{"potential", response->potential}, {"card", response->card}, {"strains", response->strains}};
  else if (const auto* forces = std::get_if<ForcesJob>(&job.work))
    j["forces"] = forces_to_json(*forces);
  else if (const auto* warm = std::get_if<WarmJob>(&job.work))
    j["warm"] = {
        {"potential", warm->potential}, {"card", warm->card}, {"heat", warm->heat}, {"strains", warm->strains}};
  else if (const auto* sample = std::get_if<SampleJob>(&job.work))
    j["sample"] = {{"problem", problem_to_json(sample->problem)},
                   {"sampling", sample->sampling},
                   {"level", sample->level},
                   {"steps_folder", sample->steps_folder}};
  else if (const auto* heated = std::get_if<HeatJob>(&job.work))
    j["heat"] = {
        {"problem", problem_to_json(heated->problem)}, {"heat", heated->heat}, {"steps_folder", heated->steps_folder}};
  else
    j["card"] = {{"potential", std::get<CardJob>(job.work).potential}};
  change_texts(j, text_of_bytes);
  std::ofstream out(file);
  out << j.dump(1) << '\n';
  if (!out.flush()) throw std::runtime_error("cannot write " + file.string());
}

Job read_job(const std::filesystem::path& file) {
  std::ifstream in(file);
  if (!in) throw std::runtime_error("cannot read the job file " + file.string());
  try {
    json j = json::parse(in);
    change_texts(j, bytes_of_text);
    Job job;
    job.log_file = j.at("log_file");
    if (j.contains("card"))
      job.work = CardJob{j.at("card").at("potential")};
    else if (j.contains("response"))
      job.work = ResponseJob{j["response"].at("potential"), j["response"].at("card"), j["response"].at("strains")};
    else if (j.contains("forces"))
      job.work = forces_from_json(j["forces"]);
    else if (j.contains("warm"))
      job.work =
          WarmJob{j["warm"].at("potential"), j["warm"].at("card"), j["warm"].at("heat"), j["warm"].at("strains")};
    else if (j.contains("sample"))
      job.work = SampleJob{problem_from_json(j["sample"].at("problem")), j["sample"].at("sampling"),
                           j["sample"].at("level"), j["sample"].at("steps_folder")};
    else if (j.contains("heat"))
      job.work =
          HeatJob{problem_from_json(j["heat"].at("problem")), j["heat"].at("heat"), j["heat"].at("steps_folder")};
    else
      job.work = CurveJob{problem_from_json(j.at("curve").at("problem")), j.at("curve").at("steps_folder")};
    return job;
  } catch (const json::exception& e) {
    throw std::runtime_error(file.string() + " is not a job file: " + e.what());
  }
}

}  // namespace atomistic
