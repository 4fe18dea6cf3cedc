// The law that a case names: every name of the list, its parameters as keys, and what is refused.
#include "compare/input/membrane_law.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <string>

#include "compare/input/case.hpp"
#include "tests/compare/support.hpp"

namespace {

using namespace validate;
using compare_tests::expect_refusal;

MembraneLaw named(std::string name, std::string_view key = {}, double value = 0) {
  MembraneLaw law;
  law.name = std::move(name);
  for (std::size_t i = 0; i < law_keys().size(); ++i)
    if (law_keys()[i].name == key) law.parameters[i] = value;
  return law;
}

TEST(MembraneLaw, NamesAreThoseOfTheListOfLaws) {
  std::vector<std::string_view> names;
  for (const membrane::LawEntry& entry : membrane::laws_by_name()) names.push_back(entry.name);
  EXPECT_TRUE(std::ranges::equal(names, law_names()));
  EXPECT_EQ(std::ranges::count(law_names(), MembraneLaw{}.name), 1);
}

/// A key is one number in one unit, whichever laws have it, and takes no name that the case has already.
TEST(MembraneLaw, EachParameterIsOneKeyOfTheCase) {
  for (const membrane::LawEntry& entry : membrane::laws_by_name())
    for (const membrane::LawParameter& p : entry.parameters) {
      if (p.name == "Eh" || p.name == "nu") continue;
      std::string name(p.name);
      std::ranges::replace(name, '_', '-');
      const auto key = std::ranges::find(law_keys(), std::string_view(name), &Field::name);
      ASSERT_NE(key, law_keys().end()) << name;
      EXPECT_EQ(key->unit, p.unit) << name;
    }
  std::set<std::string_view> names;
  const Case c;
  describe(c, [&](const Field& field, const auto&) { EXPECT_TRUE(names.insert(field.name).second) << field.name; });
}

TEST(MembraneLaw, TakesTheConstantsOfTheSheetAndItsOwnParameters) {
  const auto svk = std::get<membrane::StVenantKirchhoff>(law_of({}, 8, 0.19));
  EXPECT_EQ(svk.sheet_modulus_eV_per_A2, 8);
  EXPECT_EQ(svk.nu, 0.19);
  const auto lee = std::get<membrane::LeeGraphene>(law_of(named("lee", "third-order", -30), 21, 0.165));
  EXPECT_EQ(lee.sheet_modulus_eV_per_A2, 21);
  EXPECT_EQ(lee.third_order_modulus_eV_per_A2, -30);
  EXPECT_EQ(std::get<membrane::LeeGraphene>(law_of(named("lee"), 21, 0.165)).third_order_modulus_eV_per_A2,
            membrane::LeeGraphene{}.third_order_modulus_eV_per_A2);
  EXPECT_EQ(std::get<membrane::MooneyRivlin>(law_of(named("mooney-rivlin", "second-share", 0.2), 8, 0.5)).second_share,
            0.2);
  EXPECT_EQ(std::get<membrane::MooneyRivlin>(law_of(named("neo-hookean"), 8, 0.5)).second_share, 0);
}

TEST(MembraneLaw, SaysWhatIsWrongAndWhatIsAllowed) {
  const Origins origins = {{"law", "--law"}, {"third-order", "case.toml:7: third-order"}};
  expect_refusal([&] { law_of(named("mooney-rivlin"), 8, 0.2, origins); }, {"--law", "mooney-rivlin", "second-share"});
  expect_refusal([&] { law_of(named("svk", "third-order", -30), 8, 0.2, origins); },
                 {"case.toml:7: third-order", "'svk'", "none beside E, thickness and nu"});
  expect_refusal([&] { law_of(named("lee", "second-share", 0.2), 8, 0.2, origins); },
                 {"second-share", "'lee'", "third-order in eV/Å²"});
  expect_refusal([&] { law_of(named("mooney-rivlin", "second-share", 3), 8, 0.2, origins); },
                 {"--law", "second_share", "3", "between 0"});
  expect_refusal([&] { law_of(named("neo-hookean"), 8, 0.7, origins); }, {"--law", "nu", "0.7"});
  expect_refusal([&] { law_of(named("hooke"), 8, 0.2, origins); }, {"'hooke'", "svk, neo-hookean"});
}

TEST(MembraneLaw, IsCheckedWithTheCase) {
  Case c;
  c.law = named("mooney-rivlin");
  expect_refusal([&] { check(c, {{"law", "--law"}}); }, {"--law", "second-share"});
  c.law = named("lee");
  EXPECT_NO_THROW(check(c));
  c.models = Models::atomistic;
  expect_refusal([&] { check(c, {{"law", "--law"}}); }, {"--law", "'lee'", "models", "atomistic"});
}

TEST(MembraneLaw, IsToldInWords) {
  EXPECT_EQ(in_words({}), "svk");
  EXPECT_EQ(in_words(named("lee", "third-order", -30)), "lee, third-order = -30 eV/Å²");
  EXPECT_EQ(in_words(named("mooney-rivlin", "second-share", 0.2)), "mooney-rivlin, second-share = 0.2");
}

}  // namespace
