// What validate-atoms tells while it works: one JSON line per event on its standard output.
#pragma once

#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "atomistic/problem.hpp"
#include "atomistic/response.hpp"
#include "atomistic/temperature.hpp"

namespace atomistic {

struct StartEvent {
  int lammps_version = 0;  ///< 20210929
  int ranks = 1;
  int atoms = 0;  ///< 0 for a card
};

struct CardEvent {
  Card card;
};

struct ResponseEvent {
  Response response;
};

/// One for each of the positions asked for, in their order.
struct ForcesEvent {
  std::vector<AtomForces> states;
};

struct ProgressEvent {
  int level = 0, evaluations = 0;
  double max_force_eV_per_A = 0;
};

/// A level's file is complete on the disk.
struct StepEvent {
  int level = 0;
  std::string file;
};

/// What a temperature does to a level is on the disk.
struct HeatEvent {
  int level = 0;
};

struct WarmEvent {
  WarmCard card;
  std::vector<double> free_energy_eV_per_A2;  ///< of each strain asked for, relative to the unstrained sheet
};

/// What has been sampled so far is on the disk.
struct SampleEvent {
  int level = 0;
  double length_ps = 0, mean_depth_A = 0, error_A = 0;
};

struct EndEvent {
  Report report;
};

enum class Fault {
  program,    ///< ours or LAMMPS's
  bad_input,  ///< the potential's description asks for what LAMMPS does not have
  file,       ///< a step could not be written
  memory      ///< there is not enough
};

struct ErrorEvent {
  std::string message;
  Fault fault = Fault::program;
};

using Event = std::variant<StartEvent, CardEvent, ResponseEvent, ProgressEvent, StepEvent, EndEvent, ErrorEvent,
                           ForcesEvent, HeatEvent, WarmEvent, SampleEvent>;

std::string to_line(const Event& event);  ///< without the newline

/// Throws std::runtime_error if the line is not an event.
Event event_from_line(const std::string& line);

/// The event in a line of which a launcher may have made something else: a word before it, or all of it. Nothing where
/// there is none.
std::optional<Event> event_in_line(const std::string& line);

}  // namespace atomistic
