// How a law is made from a name and named numbers, and at which parameters it is tried.
#pragma once

#include <concepts>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "membrane/laws/response.hpp"

namespace membrane {

/// A parameter as a caller names it.
struct LawParameter {
  std::string_view name, unit, meaning;
  std::optional<double> usual = std::nullopt;  ///< where it is not given; nothing: it must be
};

using LawValues = std::map<std::string, double, std::less<>>;

/// One way to name a law's parameters. A law whose parameters are data has none.
template <class L>
struct LawForm {
  std::string_view name, meaning;
  std::vector<LawParameter> parameters;
  L (*make)(const LawValues& values);  ///< of every parameter
};

/// Parameters that stand for the law where every law is tried.
template <class L>
struct LawExample {
  std::string name;
  L law;
};

/// What the list wants of a law beside its response. A law without an answer does not compile.
template <class L>
concept ListedLaw = MaterialLaw<L> && requires {
  { L::forms() } -> std::same_as<std::vector<LawForm<L>>>;
  { L::examples() } -> std::same_as<std::vector<LawExample<L>>>;
};

/// Sheet modulus of the examples that are no lattice, eV/Å²: the paper's 5.864 eV/Å³ × 1.37 Å.
inline constexpr double example_modulus_eV_per_A2 = 8.03368;

/// "nu = 0.19" after a law's name.
std::string with_nu(std::string_view name, double nu);

/// The parameters that all laws share.
inline const LawParameter Eh_parameter{"Eh", "eV/Å²", "sheet modulus E·h"};
inline const LawParameter nu_parameter{"nu", "", "Poisson ratio"};

}  // namespace membrane
