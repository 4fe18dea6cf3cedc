#include "membrane/laws/list.hpp"

#include <algorithm>
#include <iterator>
#include <sstream>
#include <stdexcept>
#include <utility>

namespace membrane {
namespace {

/// Calls visit(std::type_identity<L>) for every law.
template <class Visit, std::size_t... I>
void over_types(Visit visit, std::index_sequence<I...>) {
  (visit(std::type_identity<std::variant_alternative_t<I, Law>>{}), ...);
}
template <class Visit>
void over_types(Visit visit) {
  over_types(visit, std::make_index_sequence<std::variant_size_v<Law>>{});
}

/// "a, b, c": the names of entries or parameters.
template <class Named>
std::string listed(const std::vector<Named>& all) {
  std::string text;
  for (const Named& one : all) text += (text.empty() ? "" : ", ") + std::string(one.name);
  return text;
}

/// The values with the usual ones added; throws where that is not one for each parameter.
template <class L>
LawValues complete(const LawForm<L>& form, LawValues values) {
  const std::string law = "law '" + std::string(form.name) + "'";
  for (const auto& [name, value] : values)
    if (std::ranges::none_of(form.parameters, [&](const LawParameter& p) { return p.name == name; }))
      throw std::invalid_argument(law + " has no parameter '" + name + "': it has " + listed(form.parameters));
  for (const LawParameter& p : form.parameters) {
    if (values.contains(p.name)) continue;
    if (!p.usual)
      throw std::invalid_argument(law + " needs its parameter '" + std::string(p.name) +
                                  "': " + std::string(p.meaning));
    values.emplace(p.name, *p.usual);
  }
  return values;
}

}  // namespace

bool is_isotropic(const Law& law) {
  return std::visit([]<MaterialLaw L>(const L&) { return IsotropicLaw<L>; }, law);
}

double sheet_modulus(const Law& law) {
  return std::visit([]<MaterialLaw L>(const L& any) -> double { return any.sheet_modulus_eV_per_A2; }, law);
}

double poisson_ratio(const Law& law) {
  return std::visit([]<MaterialLaw L>(const L& any) -> double { return any.nu; }, law);
}

std::string with_nu(std::string_view name, double nu) {
  std::ostringstream text;
  text << name << ", nu = " << nu;
  return text.str();
}

std::vector<LawEntry> laws_by_name() {
  std::vector<LawEntry> all;
  over_types([&]<ListedLaw L>(std::type_identity<L>) {
    for (const LawForm<L>& form : L::forms()) all.push_back({form.name, form.meaning, form.parameters});
  });
  return all;
}

Law make_law(std::string_view name, const LawValues& values) {
  std::optional<Law> made;
  over_types([&]<ListedLaw L>(std::type_identity<L>) {
    for (const LawForm<L>& form : L::forms()) {
      if (form.name != name) continue;
      const L law = form.make(complete(form, values));
      law.check();
      made = law;
    }
  });
  if (!made)
    throw std::invalid_argument("there is no law '" + std::string(name) + "': there are " + listed(laws_by_name()));
  return *made;
}

std::vector<NamedLaw> example_laws() {
  std::vector<NamedLaw> all;
  over_types([&]<ListedLaw L>(std::type_identity<L>) {
    for (LawExample<L>& example : L::examples()) all.push_back({std::move(example.name), std::move(example.law)});
  });
  return all;
}

}  // namespace membrane
