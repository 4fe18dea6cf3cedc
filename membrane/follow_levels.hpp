// The way along the levels of a problem, the same for every discretisation.
#pragma once

#include <sstream>
#include <string>
#include <vector>

#include "membrane/problem.hpp"

namespace membrane {

/// Goes to a value of what the levels prescribe; where an attempt fails, a value between is reached first, and the
/// steps grow again from there. Returns the last attempt at the value itself.
///   attempt(value)          something with a member `equilibrium` (converged, reason)
///   between(value)          a value between the present one and one that could not be reached
///   goes_on(cuts)           whether to try once more after so many failures
///   note(value, next, why)  hears of each value that was not reached, and of the one that is tried instead
template <class Try, class Between, class GoesOn, class Note>
auto reach(double value, Try attempt, Between between, GoesOn goes_on, Note note) {
  auto at = attempt(value);
  std::vector<double> stations;  // unreported, the next one last
  for (int cuts = 0; !at.equilibrium.converged && goes_on(cuts); ++cuts) {
    const double missed = stations.empty() ? value : stations.back();
    stations.push_back(between(missed));
    note(missed, stations.back(), at.equilibrium);
    while (!stations.empty()) {
      const auto station = attempt(stations.back());
      if (!station.equilibrium.converged) {
        at.equilibrium.reason = station.equilibrium.reason;
        break;
      }
      stations.pop_back();
    }
    if (stations.empty()) at = attempt(value);
  }
  return at;
}

/// "on the way to 3 (why); trying 2 first": an entry of Report::cuts.
template <class Equilibrium>
std::string cut_note(double missed, double next, const Equilibrium& why) {
  std::ostringstream text;
  text << "on the way to " << missed << ": " << why.reason << "; trying " << next << " first";
  return text.str();
}

/// Goes through the levels until one is not reached or the caller has enough; says in the report how it ended.
///   go_to(level)         an attempt as above
///   step_of(i, attempt)  the Step that is reported of it
///   unit                 of the levels, for the report
template <class GoTo, class StepOf>
void follow_levels(const std::vector<double>& levels, const char* unit, const OnStep& on_step, Report& report,
                   GoTo go_to, StepOf step_of) {
  report.reason = "every level was reached";
  report.converged = true;
  for (std::size_t i = 0; i < levels.size(); ++i) {
    const auto end = go_to(levels[i]);
    const bool reached = end.equilibrium.converged;
    const bool go_on = on_step(step_of(static_cast<int>(i), end));
    if (reached && go_on) continue;
    report.converged = reached && i + 1 == levels.size();
    std::ostringstream why;
    why << "level " << i << " (" << levels[i] << " " << unit << "): " << end.equilibrium.reason
        << "; relative residual " << end.equilibrium.relative_residual;
    report.reason = reached ? "ended by the caller" : why.str();
    return;
  }
}

}  // namespace membrane
