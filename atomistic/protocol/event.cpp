#include "atomistic/protocol/event.hpp"

#include <array>
#include <stdexcept>
#include <string_view>

#include "atomistic/protocol/json.hpp"

namespace atomistic {

NLOHMANN_JSON_SERIALIZE_ENUM(Fault, {{Fault::program, "program"},
                                     {Fault::bad_input, "bad_input"},
                                     {Fault::file, "file"},
                                     {Fault::memory, "memory"}})
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(StartEvent, lammps_version, ranks)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(CardEvent, card)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(ProgressEvent, level, evaluations, max_force_eV_per_A)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(StepEvent, level, file)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(HeatEvent, level)
static void to_json(nlohmann::json& j, const WarmEvent& e) {
  j = {{"card", e.card}, {"free_energy_eV_per_A2", e.free_energy_eV_per_A2}};
}
static void from_json(const nlohmann::json& j, WarmEvent& e) {
  e.card = j.at("card");
  for (const nlohmann::json& value : j.at("free_energy_eV_per_A2"))
    e.free_energy_eV_per_A2.push_back(number_or_nan(value));
}
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(SampleEvent, level, length_ps, mean_depth_A, error_A)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(EndEvent, report)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(ResponseEvent, response)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(ErrorEvent, message, fault)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(ForcesEvent, states)

namespace {

/// In the order of the variant's alternatives.
constexpr std::array<std::string_view, std::variant_size_v<Event>> names = {
    "start", "card", "response", "progress", "step", "end", "error", "forces", "heat", "warm", "sample"};

template <std::size_t index = 0>
Event read_alternative(std::string_view name, const nlohmann::json& j) {
  if constexpr (index < names.size()) {
    if (name == names[index]) return j.get<std::variant_alternative_t<index, Event>>();
    return read_alternative<index + 1>(name, j);
  } else {
    throw std::runtime_error("unknown event");
  }
}

}  // namespace

std::string to_line(const Event& event) {
  nlohmann::json j = std::visit([](const auto& e) { return nlohmann::json(e); }, event);
  j["event"] = names[event.index()];
  return j.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
}

Event event_from_line(const std::string& line) {
  try {
    const auto j = nlohmann::json::parse(line);
    return read_alternative(j.at("event").get<std::string>(), j);
  } catch (const nlohmann::json::exception& e) {
    throw std::runtime_error(std::string("not an event: ") + e.what());
  }
}

std::optional<Event> event_in_line(const std::string& line) {
  const std::size_t start = line.find('{'), end = line.rfind('}');
  if (start == std::string::npos || end == std::string::npos || end < start) return std::nullopt;
  try {
    return event_from_line(line.substr(start, end - start + 1));
  } catch (const std::runtime_error&) {
    return std::nullopt;
  }
}

}  // namespace atomistic
