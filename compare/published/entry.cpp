#include "compare/published/entry.hpp"

#include <fmt/format.h>

#include <cmath>

#include "compare/base/errors.hpp"
#include "compare/base/toml_file.hpp"
#include "compare/base/units.hpp"

namespace validate::published {
namespace {

constexpr std::string_view pure = "1";

/// A key that the row must have, or must not.
struct Demand {
  std::string_view key;
  bool wanted, there;
  std::string because;
};

void meet(const Entry& e, const std::vector<Demand>& demands) {
  for (const Demand& d : demands) {
    if (d.wanted && !d.there) throw bad_input("{}: [[row]] lacks the key '{}': {}", e.place, d.key, d.because);
    if (!d.wanted && d.there) throw bad_input("{}: [[row]] has the key '{}', which {}", e.place, d.key, d.because);
  }
}

void check(const Entry& e, const Origins& given) {
  const auto has = [&](std::string_view key) { return given.contains(key); };
  const auto always = [&](std::string_view key) { return Demand{key, true, has(key), "every row has it"}; };
  meet(e, {always("name"), always("quantity"), always("published"), always("unit"), always("conditions"),
           always("comparable"), always("source")});
  const Owner owner = owner_of(e.quantity);
  const std::string not_of = fmt::format("the quantity '{}' does not take", e.quantity);
  const std::string of = fmt::format("the quantity '{}' needs it", e.quantity);
  const auto only = [&](std::string_view key, bool wanted) {
    return Demand{key, wanted, has(key), wanted ? of : not_of};
  };
  std::vector<Demand> demands = {only("nu", owner == Owner::membrane), only("figure", owner == Owner::figure),
                                 only("number", owner == Owner::figure),
                                 only("tip-ratio", e.quantity == Subject::taut_disc)};
  if (owner != Owner::potential) demands.push_back(only("potentials", false));
  if (!e.comparable) demands.push_back({"reason", true, has("reason"), "comparable = false needs one"});
  if (e.comparable) demands.push_back({"reason", false, has("reason"), "comparable = true does not take"});
  if (e.relation != Relation::equal)
    demands.push_back({"uncertainty", false, has("uncertainty"), "a bound does not take"});
  meet(e, demands);
  if (e.figure && *e.figure != std::floor(*e.figure))
    throw bad_input("{}: '{}' is no figure; allowed: 1, 2, 3, 4", given.at("figure"), *e.figure);
  if (owner != Owner::figure) unit_in_base(e);
}

}  // namespace

double unit_in_base(const Entry& e) {
  const std::string_view base = base_unit_of(e.quantity);
  const std::string label = e.place + ": unit";
  if (base == unit::none || base == unit::energy) {
    const std::string_view wanted = base == unit::none ? pure : base;
    if (e.unit != wanted) throw bad_input("{}: '{}' is none for '{}'; allowed: {}", label, e.unit, e.quantity, wanted);
    return 1;
  }
  return parse_quantity("1 " + e.unit, base, label);
}

std::vector<Entry> read_entries(const std::filesystem::path& file, std::string_view label) {
  std::vector<Entry> entries;
  for (TomlFile& row : TomlFile(file, label).tables("row")) {
    Entry entry;
    entry.place = row.where();
    const Origins given = row.read(entry);
    check(entry, given);
    entries.push_back(std::move(entry));
  }
  return entries;
}

}  // namespace validate::published
