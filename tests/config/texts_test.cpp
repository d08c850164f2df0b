// The texts by id: which form belongs to a number, and the languages.

#include "config/texts.h"

#include <gtest/gtest.h>

#include <array>
#include <vector>

namespace kadr::texts_test {

// Numbers of each form, from the tables of Unicode CLDR 42, "Language Plural Rules": en and ru, whole numbers.
TEST(TheFormOfAText, FollowsTheNumber) {
  const std::array<std::vector<std::uint64_t>, 3> slavic = {
      {{1, 21, 31, 41, 51, 61, 71, 81, 101, 1001},
       {2, 3, 4, 22, 23, 24, 32, 33, 34, 102, 1002},
       {0, 5, 6, 10, 11, 12, 13, 14, 15, 19, 20, 100, 111, 112, 1000, 1011, 1000000}}};
  for (std::size_t form = 0; form < slavic.size(); ++form)
    for (const std::uint64_t n : slavic[form]) EXPECT_EQ(plural_form(PluralRule::slavic, n), form) << n;
  EXPECT_EQ(plural_form(PluralRule::one_other, 1), 0u);
  for (const std::uint64_t n : {0u, 2u, 11u, 21u, 101u}) EXPECT_EQ(plural_form(PluralRule::one_other, n), 1u) << n;
  for (const std::uint64_t n : {0u, 1u, 2u, 5u}) EXPECT_EQ(plural_form(PluralRule::none, n), 0u) << n;
}

TEST(TheLanguages, BeginWithEnglishAndRussianAsInLang) {
  ASSERT_GE(text_languages().size(), 2u);
  EXPECT_STREQ(text_languages()[static_cast<std::size_t>(Lang::en)].id, "en");
  EXPECT_STREQ(text_languages()[static_cast<std::size_t>(Lang::ru)].id, "ru");
}

TEST(TheNameOfALanguage, BeginsWithItsId) {
  EXPECT_EQ(language_named("ru"), Lang::ru);
  EXPECT_EQ(language_named("ru_RU.UTF-8"), Lang::ru);
  EXPECT_EQ(language_named("en_GB"), Lang::en);
  for (const char* const name : {"", "C", "POSIX", "r", "RU"}) EXPECT_EQ(language_named(name), std::nullopt) << name;
  EXPECT_STREQ(id_of(Lang::ru), "ru");
}

}  // namespace kadr::texts_test
