// Published numbers as data: one [[row]] each in a TOML file.
#pragma once

#include <array>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "compare/base/describe.hpp"
#include "compare/base/words.hpp"
#include "compare/results/checks.hpp"

namespace validate::published {

/// What of ours can stand beside a published number.
enum class Subject {
  lattice_constant,
  sheet_modulus,
  poisson,
  C11,
  C12,
  biaxial_stiffness,
  young,
  third_zigzag,
  third_armchair,
  nominal_third_zigzag,
  nominal_third_armchair,
  strength_zigzag,
  strength_armchair,
  strength_equibiaxial,
  bending,
  point_alpha,
  point_beta,
  taut_disc,
  hencky,
  figure
};
constexpr auto words(Subject) {
  return std::array{Word{Subject::lattice_constant, "a0"},
                    Word{Subject::sheet_modulus, "Eh"},
                    Word{Subject::poisson, "nu"},
                    Word{Subject::C11, "C11"},
                    Word{Subject::C12, "C12"},
                    Word{Subject::biaxial_stiffness, "C11+C12"},
                    Word{Subject::young, "young"},
                    Word{Subject::third_zigzag, "third-order-zigzag"},
                    Word{Subject::third_armchair, "third-order-armchair"},
                    Word{Subject::nominal_third_zigzag, "third-order-nominal-zigzag"},
                    Word{Subject::nominal_third_armchair, "third-order-nominal-armchair"},
                    Word{Subject::strength_zigzag, "strength-zigzag"},
                    Word{Subject::strength_armchair, "strength-armchair"},
                    Word{Subject::strength_equibiaxial, "strength-equibiaxial"},
                    Word{Subject::bending, "bending-modulus"},
                    Word{Subject::point_alpha, "point-alpha"},
                    Word{Subject::point_beta, "point-beta"},
                    Word{Subject::taut_disc, "taut-disc"},
                    Word{Subject::hencky, "hencky"},
                    Word{Subject::figure, "figure"}};
}

/// Whose number it is.
enum class Owner { potential, membrane, figure };
Owner owner_of(Subject);

/// In words, for --help.
std::string meaning_of(Subject);

/// Base unit of ours, as in describe.hpp's `unit`.
std::string_view base_unit_of(Subject);

/// A row as it stands in the file.
struct Entry {
  std::string name;
  Subject quantity = Subject::sheet_modulus;
  std::vector<std::string> potentials;  ///< empty: those asked for
  std::optional<double> nu, tip_ratio;  ///< of the membrane's quantities
  std::optional<double> figure;         ///< of the paper
  std::string number;                   ///< which of the figure's numbers
  Relation relation = Relation::equal;
  std::optional<double> published, uncertainty;
  std::string unit, conditions, reason, source, doi, arxiv;
  bool comparable = false;
  std::string place;  ///< "file:line"
};

void describe(SameStruct<Entry> auto& e, auto&& visit) {
  visit(Field{"name", unit::none, "of the published number"}, e.name);
  visit(Field{"quantity", unit::none, "which of ours stands beside it"}, e.quantity);
  visit(Field{"potentials", unit::none, "whose; left out: those of --potential"}, e.potentials);
  visit(Field{"nu", unit::none, "Poisson's ratio of the membrane", from_to(-0.5, 0.5)}, e.nu);
  visit(Field{"tip-ratio", unit::none, "radius of the loaded disc over the sheet's", between(0, 1)}, e.tip_ratio);
  visit(Field{"figure", unit::none, "of the paper", from_to(1, 4)}, e.figure);
  visit(Field{"number", unit::none, "which of the figure's numbers"}, e.number);
  visit(Field{"relation", unit::none, "=, or <= and >= for a bound; default ="}, e.relation);
  visit(Field{"published", unit::none, "the number, in `unit`"}, e.published);
  visit(Field{"uncertainty", unit::none, "as published, in `unit`; left out: none was", positive()}, e.uncertainty);
  visit(Field{"unit", unit::none, "of both; 1: a pure number"}, e.unit);
  visit(Field{"conditions", unit::none, "under which it was found"}, e.conditions);
  visit(Field{"comparable", unit::none, "whether both mean the same"}, e.comparable);
  visit(Field{"reason", unit::none, "why they do not"}, e.reason);
  visit(Field{"source", unit::none, "publication"}, e.source);
  visit(Field{"doi", unit::none, "of the source"}, e.doi);
  visit(Field{"arxiv", unit::none, "of the source"}, e.arxiv);
}

/// The rows of a file. Throws Error (bad input) with file, line, key, what is allowed and the nearest name.
std::vector<Entry> read_entries(const std::filesystem::path& file, std::string_view label);

/// One of the entry's unit in ours' base unit. Throws as above.
double unit_in_base(const Entry& entry);

}  // namespace validate::published
