#include "compare/published/compare.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "compare/base/errors.hpp"
#include "compare/base/nearest.hpp"
#include "compare/figures/paper_figure.hpp"
#include "compare/input/potential_file.hpp"
#include "compare/published/numbers.hpp"

namespace validate::published {
namespace {

std::string with_identifiers(const Entry& e) {
  std::string text = e.source;
  if (!e.doi.empty()) text += ", doi:" + e.doi;
  if (!e.arxiv.empty()) text += ", arXiv:" + e.arxiv;
  return text;
}

PublishedRow row_of(const Entry& e, std::string of, double ours) {
  return {.name = e.name,
          .quantity = std::string(to_string(e.quantity)),
          .of = std::move(of),
          .ours = ours,
          .relation = e.relation,
          .published = *e.published,
          .uncertainty = e.uncertainty,
          .unit = e.unit,
          .conditions = e.conditions,
          .comparable = e.comparable,
          .reason = e.reason,
          .source = with_identifiers(e)};
}

class Comparison {
 public:
  explicit Comparison(const Means& means) : means_(means) {}

  void add(const Entry& e) {
    means_.progress.status(e.name);
    switch (owner_of(e.quantity)) {
      case Owner::potential:
        for (const std::string& name : potentials_of(e))
          rows_.push_back(row_of(e, name, number_of(card(name, e), e.quantity) / unit_in_base(e)));
        break;
      case Owner::membrane:
        rows_.push_back(row_of(e, "membrane", number_of_membrane(e)));
        break;
      case Owner::figure:
        rows_.push_back(row_of(e, fmt::format("figure {:g}", *e.figure), figure_number(e)));
        break;
    }
  }

  std::vector<PublishedRow> rows() && { return std::move(rows_); }

 private:
  std::vector<std::string> potentials_of(const Entry& e) const {
    if (e.potentials.empty()) return means_.chosen;
    std::vector<std::string> wanted;
    for (const std::string& name : e.potentials)
      if (!means_.chosen_alone || std::ranges::count(means_.chosen, name) > 0) wanted.push_back(name);
    return wanted;
  }

  const PotentialCard& card(const std::string& name, const Entry& e) {
    if (const auto found = cards_.find(name); found != cards_.end()) return found->second;
    means_.progress.say(fmt::format("card of {}", name));
    const std::string label = e.potentials.empty() ? "--potential" : e.place + ": potentials";
    const PotentialFile file = read_potential(name, means_.potentials, label);
    return cards_.emplace(name, potential_card(file, means_.launch, means_.cards, false)).first->second;
  }

  const PaperFigure& figure(int number) {
    if (const auto found = figures_.find(number); found != figures_.end()) return found->second;
    for (const FigureEntry& entry : paper_figures()) {
      if (entry.number != number) continue;
      const FigureContext of_the_membrane{.work = {}, .potentials = {}, .progress = means_.progress};
      return figures_.emplace(number, entry.make(of_the_membrane)).first->second;
    }
    throw bad_input("figure {} is none that can be made", number);
  }

  double figure_number(const Entry& e) {
    std::vector<std::string_view> names;
    for (const FigureNumber& number : figure(static_cast<int>(*e.figure)).numbers) {
      names.push_back(number.what);
      if (number.what != e.number) continue;
      if (number.unit != e.unit)
        throw bad_input("{}: unit: '{}' is not that of '{}'; allowed: {}", e.place, e.unit, e.number, number.unit);
      return number.ours;
    }
    throw bad_input("{}: number: '{}' is none of figure {:g}; allowed: {}{}", e.place, e.number, *e.figure,
                    fmt::join(names, "; "), did_you_mean(e.number, names));
  }

  const Means& means_;
  std::map<std::string, PotentialCard> cards_;
  std::map<int, PaperFigure> figures_;
  std::vector<PublishedRow> rows_;
};

}  // namespace

std::vector<PublishedRow> compared(const std::vector<Entry>& entries, const Means& means) {
  Comparison comparison(means);
  for (const Entry& entry : entries) comparison.add(entry);
  return std::move(comparison).rows();
}

}  // namespace validate::published
