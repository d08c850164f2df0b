// out/text/explain/line_words: explains the words of a line.

#include "out/text/explain/line_words.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <map>

#include "config/control/control_file.h"

namespace kadr::line_words_test {
namespace {

using testing::HasSubstr;
using testing::IsEmpty;

struct Known {
  ControlDef def;
  AlarmTexts texts;
};
const Known& known(const std::string& control) {
  static std::map<std::string, Known> all;
  if (!all.contains(control)) {
    ControlDef def = load_control(control).value();
    AlarmTexts texts = AlarmTexts::load(&def).value();
    all.emplace(control, Known{std::move(def), std::move(texts)});
  }
  return all.at(control);
}

std::vector<LineWord> words(const std::string& control, std::string_view line, Lang lang = Lang::en) {
  const Known& k = known(control);
  return words_of_line(k.def, k.texts, line, lang);
}

TEST(LineWords, codes_addresses_and_where_they_stand) {
  const auto all = words("nct", "N10 G01 X-5.5 F200");
  ASSERT_EQ(all.size(), 4u);
  EXPECT_EQ(all[0].code, "N");
  EXPECT_EQ(all[1].code, "G1");
  EXPECT_EQ(all[1].from, 5u);
  EXPECT_EQ(all[1].to, 8u);
  EXPECT_THAT(all[1].text, HasSubstr("lasts: until replaced"));
  EXPECT_EQ(all[2].code, "X");
  EXPECT_EQ(all[2].from, 9u);
  EXPECT_EQ(all[2].to, 14u);
  EXPECT_THAT(all[3].text, HasSubstr("nct F: "));
}

TEST(LineWords, a_letter_means_what_the_code_beside_it_makes_of_it) {
  const auto all = words("nct", "G83 Z-20 R2 Q5");
  ASSERT_EQ(all.size(), 4u);
  EXPECT_THAT(all[2].title, HasSubstr("G83: point R"));
  EXPECT_THAT(all[3].title, HasSubstr("G83: depth of one peck"));
}

TEST(LineWords, columns_count_characters_and_comments_say_nothing) {
  const auto all = words("mach3", "(фреза G2 #5021) G1 X1", Lang::ru);
  ASSERT_EQ(all.size(), 2u);
  EXPECT_EQ(all[0].from, 18u);
  EXPECT_EQ(all[0].code, "G1");
}

TEST(LineWords, variables_of_the_system) {
  const auto all = words("nct", "#1=#5021+#[2]");
  ASSERT_FALSE(all.empty());
  EXPECT_EQ(all.back().code, "#5021");
  EXPECT_EQ(all.back().from, 4u);
  EXPECT_THAT(all.back().text, HasSubstr("#_ABSMT[1]"));
}

TEST(LineWords, a_cycle_called_by_its_letter) {
  const auto all = words("s2c42", "L81 R2 10");
  ASSERT_FALSE(all.empty());
  EXPECT_EQ(all[0].code, "L81");
}

TEST(LineWords, what_stands_before_a_fault) {
  const auto all = words("nct", "G1 X1 Y-- Z2");
  ASSERT_GE(all.size(), 2u);
  EXPECT_EQ(all[0].code, "G1");
  EXPECT_THAT(words("nct", ""), IsEmpty());
}

RC_GTEST_PROP(LineWordsProperty, of_any_line_they_stand_in_it_one_after_another, ()) {
  const auto line = *rc::gen::container<std::string>(rc::gen::elementOf(std::string("GMXYZRLNFT#[]=+-.0123456789 ()%:;/IF")));
  const std::string control = *rc::gen::element<std::string>("nct", "s2c42", "mach3", "linuxcnc", "fanuc", "haas", "gost");
  std::uint32_t before = 1;
  for (const LineWord& w : words(control, line)) {
    RC_ASSERT(w.from >= before);
    RC_ASSERT(w.to > w.from);
    RC_ASSERT(w.to <= line.size() + 1);
    before = w.from;
  }
}

}  // namespace
}  // namespace kadr::line_words_test
