// The law that a case names for its membranes, with its parameters as keys.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "compare/base/describe.hpp"
#include "compare/base/field_value.hpp"
#include "membrane/laws/list.hpp"

namespace validate {

/// The names that a case can give its law: those of membrane::laws_by_name().
std::span<const std::string_view> law_names();

/// A key of [membrane], which is a flag too, for each parameter of these laws. E·h and ν are not among them: they are
/// the case's constants, or the card's.
const std::vector<Field>& law_keys();

/// Which law a membrane has: a new one in the list brings its name and its keys with it.
struct MembraneLaw {
  std::string name = "svk";  ///< the paper's
  std::vector<std::optional<double>> parameters = std::vector<std::optional<double>>(law_keys().size());

  /// Whether it is not the paper's.
  bool is_chosen() const { return name != MembraneLaw{}.name; }
};

/// Visits the name and each parameter as members of the case's table.
template <class Law, class Visitor>
requires SameStruct<Law, MembraneLaw>
void describe_law(Law& law, Visitor&& visit) {
  Field name = Field{"law", {}, "law of the membranes; atoms' own law and the paper's membrane stay", {}, "membrane"};
  name.choices = law_names();
  visit(name.at_top_too(), law.name);
  for (std::size_t i = 0; i < law_keys().size(); ++i) visit(law_keys()[i], law.parameters[i]);
}

/// "lee, third-order = -43.07 eV/Å²": its name and what is given of it.
std::string in_words(const MembraneLaw& law);

/// The law with the sheet modulus E·h (eV/Å²) and Poisson's ratio. Throws Error (bad input), with the origin of the
/// key, for a parameter that the law has not, for one that it needs, and for values that it refuses.
membrane::Law law_of(const MembraneLaw& law, double Eh_eV_per_A2, double nu, const Origins& origins = {});

}  // namespace validate
