#include "tests/atomistic/support/paths.hpp"

#include <map>
#include <utility>

using namespace atomistic;

const Card& card_of(const std::string& name) {
  static std::map<std::string, Card> cards;
  if (!cards.contains(name)) cards[name] = compute_card(potential(name), "none");
  return cards[name];
}

Problem problem_of(const std::string& name, double radius, Load load, std::vector<double> levels) {
  Problem p;
  p.potential = potential(name);
  p.card = card_of(name);
  p.radius_A = radius;
  p.load = load;
  p.levels = std::move(levels);
  return p;
}

Path follow(const Problem& p, const std::vector<Step>& finished) {
  Path path;
  path.report =
      follow_path(p, "none", finished, {.on_step = [&](const Step& s) { path.steps.push_back(s); }, .on_progress = {}},
                  lammps_session());
  return path;
}
