// config/alarm_texts: every alarm has a text in both languages.

#include "config/alarm_texts.h"

#include <gtest/gtest.h>

namespace kadr::alarm_texts_test {
namespace {

AlarmTexts common() { return AlarmTexts::load(nullptr).value(); }

TEST(alarm_texts, every_id_has_a_text_in_both_languages) {
  const AlarmTexts texts = common();
  for (std::size_t i = 0; i < static_cast<std::size_t>(AlarmId::count); ++i) {
    const auto id = static_cast<AlarmId>(i);
    EXPECT_FALSE(texts.pattern(id, Lang::en).empty()) << name_of(id);
    EXPECT_FALSE(texts.pattern(id, Lang::ru).empty()) << name_of(id);
    if (id == AlarmId::program_alarm) continue;  // its text comes from the program
    EXPECT_NE(texts.pattern(id, Lang::ru), texts.pattern(id, Lang::en)) << name_of(id);
  }
}

TEST(alarm_texts, the_controls_own_words_go_first) {
  ControlDef def;
  def.alarms[AlarmId::radius_mismatch] = {"2012", {"Radius {0} and {1} of {2}", ""}, {}};
  const AlarmTexts texts = AlarmTexts::load(&def).value();
  EXPECT_EQ(texts.sentence(alarm(AlarmId::radius_mismatch, {}, 3.05, 6.8200000001, "N2"), Lang::en), "Radius 3.05 and 6.82 of N2");
  EXPECT_EQ(texts.sentence(alarm(AlarmId::radius_mismatch, {}, 1.0), Lang::en), "Radius 1 and ? of ?");
  EXPECT_EQ(texts.number(AlarmId::radius_mismatch), "2012");
  EXPECT_EQ(texts.number(AlarmId::code_unknown), "");
  EXPECT_EQ(texts.pattern(AlarmId::radius_mismatch, Lang::ru), common().pattern(AlarmId::radius_mismatch, Lang::ru));
}

TEST(alarm_texts, an_argument_that_is_a_unit_is_in_the_language) {
  const AlarmTexts texts = common();
  const auto in = [&](Lang lang, std::string_view unit) { return texts.sentence(alarm(AlarmId::feed_too_large, {}, 6.5, unit), lang); };
  EXPECT_NE(in(Lang::en, "mm/rev").find("6.5 mm/rev"), std::string::npos) << in(Lang::en, "mm/rev");
  EXPECT_NE(in(Lang::ru, "mm/rev").find("6.5 мм/об"), std::string::npos) << in(Lang::ru, "mm/rev");
  EXPECT_NE(texts.sentence(alarm(AlarmId::point_forgotten, {}, "X12", "0.012 mm"), Lang::ru).find("0.012 мм"), std::string::npos);
  EXPECT_NE(texts.sentence(alarm(AlarmId::point_forgotten, {}, "X12 mm", "1 °"), Lang::ru).find("X12 mm"), std::string::npos)
      << "no figure";
}

TEST(alarm_texts, numbers_for_people) {
  EXPECT_EQ(number_text(-1e-9), "0");
  EXPECT_EQ(number_text(0.1 + 0.2), "0.3");
  EXPECT_EQ(number_text(-12.3456789), "-12.345679");
  EXPECT_EQ(number_text(12.3456789, 3), "12.346");
  EXPECT_EQ(number_text(100), "100");
  EXPECT_EQ(number_text(1e20), "1e+20");
  EXPECT_EQ(number_text(99.99999, 0), "100");
}

}  // namespace
}  // namespace kadr::alarm_texts_test
