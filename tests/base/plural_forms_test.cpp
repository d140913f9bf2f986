// Plural forms: the rules of languages choose the forms that these have, and no other rule is taken.

#include "core/base/text/plural_forms.hpp"

#include <gtest/gtest.h>

#include <cstdint>
#include <string>
#include <utility>

#include "tests/support/mutated.hpp"
#include "tests/support/random.hpp"

namespace hariko {
namespace {

constexpr const char* japanese_rule = "nplurals=1; plural=0;";
constexpr const char* english_rule = "nplurals=2; plural=(n != 1);";
constexpr const char* polish_rule =
    "nplurals=3; plural=(n==1 ? 0 : n%10>=2 && n%10<=4 && (n%100<10 || n%100>=20) ? 1 : 2);";
constexpr const char* arabic_rule =
    "nplurals=6; plural=(n==0 ? 0 : n==1 ? 1 : n==2 ? 2 : n%100>=3 && n%100<=10 ? 3 : n%100>=11 ? 4 : 5);";

PluralForms forms_of(const std::string& rule) {
  const auto forms = PluralForms::parse(rule);
  EXPECT_TRUE(forms.ok()) << rule << ": " << (forms.ok() ? std::string() : forms.error().text);
  return forms.ok() ? *forms : PluralForms();
}

TEST(PluralForms, JapaneseHasOneForm) {
  const PluralForms forms = forms_of(japanese_rule);
  EXPECT_EQ(forms.count(), 1U);
  EXPECT_EQ(PluralForms().count(), 1U);
  for (const std::uint64_t n : {0, 1, 2, 1000}) {
    EXPECT_EQ(forms.form(n), 0U);
    EXPECT_EQ(PluralForms().form(n), 0U);
  }
}

TEST(PluralForms, EnglishTellsOneFromSeveral) {
  const PluralForms forms = forms_of(english_rule);
  EXPECT_EQ(forms.count(), 2U);
  EXPECT_EQ(forms.form(1), 0U);
  for (const std::uint64_t n : {0, 2, 11, 21, 101}) EXPECT_EQ(forms.form(n), 1U) << n;
  EXPECT_EQ(forms_of("nplurals=2; plural=n>1;").form(0), 0U) << "French";
}

/// "1 wierzchołek, 2 wierzchołki, 5 wierzchołków": by the last digit, but for the teens.
TEST(PluralForms, PolishLooksAtTheLastDigits) {
  const PluralForms forms = forms_of(polish_rule);
  EXPECT_EQ(forms.count(), 3U);
  EXPECT_EQ(forms.form(1), 0U);
  for (const std::uint64_t n : {2, 3, 4, 22, 34, 102, 1'000'003}) EXPECT_EQ(forms.form(n), 1U) << n;
  for (const std::uint64_t n : {0, 5, 11, 12, 14, 21, 31, 112, 1000}) EXPECT_EQ(forms.form(n), 2U) << n;
}

TEST(PluralForms, ArabicHasSix) {
  const PluralForms forms = forms_of(arabic_rule);
  EXPECT_EQ(forms.count(), 6U);
  for (const std::uint64_t n : {0, 1, 2}) EXPECT_EQ(forms.form(n), n);
  for (const std::uint64_t n : {3, 10, 103, 110}) EXPECT_EQ(forms.form(n), 3U) << n;
  for (const std::uint64_t n : {11, 99, 111, 199}) EXPECT_EQ(forms.form(n), 4U) << n;
  for (const std::uint64_t n : {100, 101, 102, 200}) EXPECT_EQ(forms.form(n), 5U) << n;
}

TEST(PluralForms, OperatorsBindAsInC) {
  const auto form = [](const std::string& expression, std::uint64_t n) {
    return forms_of("nplurals=8; plural=" + expression + ";").form(n);
  };
  EXPECT_EQ(form("1 + 2 * 3 - 4", 0), 3U);
  EXPECT_EQ(form("(1 + 2) * 2", 0), 6U);
  EXPECT_EQ(form("7 - 2 - 1", 0), 4U) << "from left to right";
  EXPECT_EQ(form("n % 8 / 2", 5), 2U);
  EXPECT_EQ(form("n == 1 || n == 2 && n == 3", 1), 1U) << "&& before ||";
  EXPECT_EQ(form("!n + 1", 0), 2U);
  EXPECT_EQ(form("!(n < 2)", 2), 1U);
  EXPECT_EQ(form("1 < 2 == 1", 0), 1U);
  EXPECT_EQ(form("n <= 3", 3) + form("n >= 4", 3), 1U);
  EXPECT_EQ(form("n==0 ? 1 : n==1 ? 2 : 3", 1), 2U);
  EXPECT_EQ(form("n != 0 && 6 / n == 3", 2), 1U) << "what is not needed may divide by zero";
}

TEST(PluralForms, WhatIsNoRuleIsRefusedAndSaysWhy) {
  const std::pair<std::string, const char*> wrong[] = {
      {"", "does not give"},
      {"plural=0;", "does not give"},
      {"nplurals=2;", "does not give"},
      {"nplurals=0; plural=0;", "none from 1 to 8"},
      {"nplurals=9; plural=0;", "none from 1 to 8"},
      {"nplurals=2; plural=;", "no expression"},
      {"nplurals=2; plural=n=1;", "no expression"},
      {"nplurals=2; plural=(n!=1;", "no expression"},
      {"nplurals=2; plural=n!=1);", "no expression"},
      {"nplurals=2; plural=n ? 1;", "no expression"},
      {"nplurals=2; plural=m;", "no expression"},
      {"nplurals=2; plural=n n;", "no expression"},
      {"nplurals=2; plural=99999999999999999999;", "no expression"},
      {"nplurals=2; plural=system(1);", "no expression"},
      {"nplurals=2; plural=" + std::string(60, '(') + "n" + std::string(60, ')') + ";", "no expression"},
      {"nplurals=2; plural=" + std::string(60, '!') + "n;", "no expression"},
      {"nplurals=2; plural=1/n;", "divides by zero for the count 0"},
      {"nplurals=2; plural=n%(n-7)*0;", "divides by zero for the count 7"},
      {"nplurals=2; plural=n;", "gives the count 2 a form"},
      {"nplurals=2; plural=n==1000 ? 2 : 0;", "gives the count 1000 a form"},
      {"nplurals=1; plural=0" + std::string(1000, ' ') + ";", "too long"}};
  for (const auto& [rule, why] : wrong) {
    const auto forms = PluralForms::parse(rule);
    ASSERT_FALSE(forms.ok()) << rule;
    EXPECT_EQ(forms.error().code, e_plural_forms);
    EXPECT_NE(forms.error().text.find(why), std::string::npos) << rule << ": " << forms.error().text;
    EXPECT_FALSE(forms.error().remedy.empty());
  }
}

/// Counts that were not tried when the rule was read.
TEST(PluralForms, ALargeCountWithoutAFormTakesTheLast) {
  EXPECT_EQ(forms_of("nplurals=2; plural=n > 5000 ? 7 : 0;").form(6000), 1U);
  EXPECT_EQ(forms_of("nplurals=2; plural=1 / (n - 5000) * 0;").form(5000), 1U);
}

TEST(PluralForms, DamagedRulesHaveSoundFormsOrNone) {
  int taken = 0;
  test::for_random(4001, 300, [&](std::mt19937_64& rng) {
    const std::string rule =
        test::mutated(rng, test::chance(rng, 0.5) ? std::string(polish_rule) : std::string(arabic_rule));
    const auto forms = PluralForms::parse(rule);
    if (!forms.ok()) return;
    ++taken;
    for (int k = 0; k < 20; ++k) EXPECT_LT(forms->form(rng()), forms->count()) << rule;
  });
  EXPECT_GT(taken, 0);
}

}  // namespace
}  // namespace hariko
