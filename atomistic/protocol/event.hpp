// What validate-atoms tells while it works: one JSON line per event on its standard output.
#pragma once

#include <string>
#include <variant>

#include "atomistic/problem.hpp"

namespace atomistic {

struct StartEvent {
  int lammps_version = 0;  ///< 20210929
  int ranks = 1;
  int atoms = 0;  ///< 0 for a card
};

struct CardEvent {
  Card card;
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

struct EndEvent {
  Report report;
};

struct ErrorEvent {
  std::string message;
};

using Event = std::variant<StartEvent, CardEvent, ProgressEvent, StepEvent, EndEvent, ErrorEvent>;

std::string to_line(const Event& event);  ///< without the newline

/// Throws std::runtime_error if the line is not an event.
Event event_from_line(const std::string& line);

}  // namespace atomistic
