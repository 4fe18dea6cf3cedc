// The list of laws: by name, with their parameters, and at their examples.
#include <gtest/gtest.h>

#include <set>
#include <stdexcept>
#include <string>

#include "membrane/laws/list.hpp"

namespace membrane {
namespace {

/// What make_law() says of a name and values that it refuses.
std::string refusal(const std::string& name, const LawValues& values) {
  try {
    make_law(name, values);
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return "";
}

bool says(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

/// A law that answers everything but how it is called, since that is said of another law.
struct Unnamed : StVenantKirchhoff {};
static_assert(MaterialLaw<Unnamed> && !ListedLaw<Unnamed>);

TEST(LawList, EveryLawHasExamplesWithNamesOfTheirOwn) {
  std::set<std::size_t> laws;
  std::set<std::string> names;
  for (const auto& [name, law] : example_laws()) {
    laws.insert(law.index());
    EXPECT_TRUE(names.insert(name).second) << name;
    EXPECT_NO_THROW(std::visit([]<MaterialLaw L>(const L& any) { any.check(); }, law)) << name;
  }
  EXPECT_EQ(laws.size(), std::variant_size_v<Law>);
}

TEST(LawList, EveryNameMakesALawOfItsParameters) {
  std::set<std::string_view> names;
  for (const LawEntry& entry : laws_by_name()) {
    SCOPED_TRACE(entry.name);
    EXPECT_TRUE(names.insert(entry.name).second);
    EXPECT_FALSE(entry.meaning.empty());
    LawValues values;
    for (const LawParameter& p : entry.parameters) {
      EXPECT_FALSE(p.meaning.empty()) << p.name;
      EXPECT_FALSE(says(refusal(std::string(entry.name), {}), "has no parameter")) << p.name;
      values.emplace(p.name, p.name == "Eh" ? 17 : 0.25);
    }
    const Law law = make_law(entry.name, values);
    EXPECT_EQ(sheet_modulus(law), 17);
    EXPECT_EQ(poisson_ratio(law), 0.25);
    values.erase("nu");
    EXPECT_TRUE(says(refusal(std::string(entry.name), values), "needs its parameter 'nu'"));
  }
  EXPECT_EQ(names, (std::set<std::string_view>{"svk", "neo-hookean", "mooney-rivlin", "lee"}));
}

TEST(LawList, NamedNumbersReachTheirParameters) {
  const auto lee = std::get<LeeGraphene>(make_law("lee", {{"Eh", 21.35}, {"nu", 0.165}, {"third_order", -30}}));
  EXPECT_EQ(lee.third_order_modulus_eV_per_A2, -30);
  const auto usual = std::get<LeeGraphene>(make_law("lee", {{"Eh", 21.35}, {"nu", 0.165}}));
  EXPECT_EQ(usual.third_order_modulus_eV_per_A2, LeeGraphene{}.third_order_modulus_eV_per_A2);
  const auto rubber =
      std::get<MooneyRivlin>(make_law("mooney-rivlin", {{"Eh", 8}, {"nu", 0.5}, {"second_share", 0.2}}));
  EXPECT_EQ(rubber.second_share, 0.2);
  EXPECT_EQ(std::get<MooneyRivlin>(make_law("neo-hookean", {{"Eh", 8}, {"nu", 0.5}})).second_share, 0);
}

TEST(LawList, WhatIsNotThereIsRefusedByName) {
  EXPECT_TRUE(says(refusal("hooke", {}), "svk, neo-hookean, mooney-rivlin, lee"));
  EXPECT_TRUE(says(refusal("svk", {{"Eh", 8}, {"nu", 0.2}, {"mu", 1}}), "'mu': it has Eh, nu"));
  EXPECT_TRUE(says(refusal("svk", {{"Eh", 8}, {"nu", 1}}), "law.nu"));
  EXPECT_TRUE(says(refusal("svk", {{"Eh", 0}, {"nu", 0.2}}), "law.sheet_modulus_eV_per_A2"));
}

}  // namespace
}  // namespace membrane
