// lang/block/format: format descriptors of words. Spec gost 3, s2c42 2.

#include "lang/block/format.h"

#include <gtest/gtest.h>

namespace kadr::format_test {
namespace {

WordFormat parsed(std::string_view digits, bool point = false) { return parse_word_format(digits, point).value(); }

Grammar described(std::string_view descriptor) {
  Grammar grammar;
  const auto applied = apply_descriptor(descriptor, grammar);
  EXPECT_TRUE(applied) << applied.error();
  return grammar;
}

std::string refusal(std::string_view descriptor) {
  Grammar grammar;
  const auto applied = apply_descriptor(descriptor, grammar);
  EXPECT_FALSE(applied) << descriptor;
  return applied ? "" : applied.error();
}

constexpr std::string_view gost = "%: / DS N04 3G2 X+053 Y+053 Z+042 F031 S04 T05 M2*";
constexpr std::string_view older = "N3 G02 X±33 Y±33 Z±42 F2 S2 T2 M2 LF";
constexpr std::string_view s2c42 = "N05 G02 X+043 Y+043 Z+043 I+043 J+043 K+043 D+043 F05 S04 R1 L4 H04 E043 T*2 M02 ПС";

TEST(word_format, one_digit_counts_whole_digits) {
  const WordFormat f = parsed("2");
  EXPECT_TRUE(f.known);
  EXPECT_FALSE(f.drop_zeros);
  EXPECT_EQ(f.whole_digits, 2);
  EXPECT_EQ(f.fraction_digits, 0);
  EXPECT_FALSE(f.implied);
}

TEST(word_format, leading_zero_means_zeros_may_be_dropped) {
  EXPECT_TRUE(parsed("04").drop_zeros);
  EXPECT_EQ(parsed("04").whole_digits, 4);
}

TEST(word_format, two_digits_stand_before_and_after_the_point) {
  const WordFormat f = parsed("031");
  EXPECT_EQ(f.whole_digits, 3);
  EXPECT_EQ(f.fraction_digits, 1);
  EXPECT_TRUE(f.implied);
  EXPECT_FALSE(f.sign);
}

TEST(word_format, both_signs_mean_signed) {
  EXPECT_TRUE(parsed("+053").sign);
  EXPECT_TRUE(parsed("±33").sign);
  EXPECT_FALSE(parsed("±33").drop_zeros);
}

// T*2 of the 2С42: two digits, and before them one that marks the tool in the spindle.
TEST(word_format, star_is_a_digit_of_its_own) { EXPECT_EQ(parsed("*2").whole_digits, 3); }

TEST(word_format, point_is_as_told) {
  EXPECT_TRUE(parsed("+053", true).point);
  EXPECT_FALSE(parsed("+053", false).point);
}

TEST(word_format, what_is_no_format) {
  for (const char* bad : {"", "-053", "+", "0", "00", "003", "0531", "5x", "+-5", "**2"})
    EXPECT_FALSE(parse_word_format(bad, false)) << bad;
}

TEST(descriptor, of_gost) {
  const Grammar g = described(gost);
  EXPECT_TRUE(g.main_blocks);
  EXPECT_EQ(g.end_of_block, EndOfBlock::line);
  EXPECT_TRUE(g.mark_everywhere);
  EXPECT_EQ(g.word('G').at_most, 3);
  EXPECT_EQ(g.word('G').whole_digits, 2);
  EXPECT_EQ(g.word('X').whole_digits, 5);
  EXPECT_EQ(g.word('X').fraction_digits, 3);
  EXPECT_TRUE(g.word('X').sign);
  EXPECT_TRUE(g.word('X').point);
  EXPECT_EQ(g.word('Z').fraction_digits, 2);
  EXPECT_EQ(g.word('F').fraction_digits, 1);
  EXPECT_EQ(g.word('T').whole_digits, 5);
  EXPECT_FALSE(g.word('W').known);
}

TEST(descriptor, codes_and_numbers_have_no_point_with_ds_either) {
  const Grammar g = described(gost);
  for (const char letter : {'N', 'G', 'M'}) EXPECT_FALSE(g.word(letter).point) << letter;
}

TEST(descriptor, older_form_asks_for_every_digit) {
  const Grammar g = described(older);
  EXPECT_FALSE(g.word('X').drop_zeros);  // X+154125 = 154.125
  EXPECT_FALSE(g.word('F').drop_zeros);
  EXPECT_FALSE(g.word('N').drop_zeros);
  EXPECT_FALSE(g.word('X').point);
  EXPECT_FALSE(g.main_blocks);
}

TEST(descriptor, zeros_of_a_code_mean_nothing_in_any_form) {
  for (const std::string_view text : {gost, older, s2c42}) {
    const Grammar g = described(text);
    for (const char letter : {'G', 'M'}) {
      EXPECT_TRUE(g.word(letter).code);
      EXPECT_TRUE(g.word(letter).drop_zeros);
    }
    EXPECT_FALSE(g.word('X').code);
  }
}

TEST(descriptor, of_2c42) {
  const Grammar g = described(s2c42);
  EXPECT_EQ(g.word('N').whole_digits, 5);
  EXPECT_EQ(g.word('K').whole_digits + g.word('K').fraction_digits, 7);
  EXPECT_EQ(g.word('R').whole_digits, 1);
  EXPECT_FALSE(g.word('L').drop_zeros);  // L0801: zeros must not be dropped
  EXPECT_TRUE(g.word('H').drop_zeros);
  EXPECT_FALSE(g.word('E').sign);
  EXPECT_EQ(g.word('T').whole_digits, 3);  // T*2: the third digit marks the tool in the spindle
}

TEST(descriptor, blanks_are_free) {
  const Grammar g = described("  %:/DSN04 3G2X+053  M2 * ");
  EXPECT_TRUE(g.word('X').sign);
  EXPECT_EQ(g.word('M').whole_digits, 2);
}

TEST(descriptor, what_it_does_not_name_stays) {
  Grammar g;
  g.word('L').second_number = true;
  g.word('M').at_most = 5;
  g.word('A').known = true;
  ASSERT_TRUE(apply_descriptor("L2 M2", g));
  EXPECT_TRUE(g.word('L').second_number);
  EXPECT_EQ(g.word('M').at_most, 5);
  EXPECT_TRUE(g.word('A').known);
}

TEST(descriptor, refusal_names_the_piece) {
  EXPECT_EQ(refusal("N04 X-053 Y+053"), "format \"X-053\" is not understood: a sign is written + or ±");
  EXPECT_NE(refusal("N04 X053 X+053").find("\"X+053\""), std::string::npos);
  EXPECT_NE(refusal("N04 ?").find("\"?\""), std::string::npos);
  EXPECT_NE(refusal("N04 0G2").find("\"0G2\""), std::string::npos);
  EXPECT_NE(refusal("M2* N04").find("\"N04\""), std::string::npos);
  EXPECT_NE(refusal("X").find("\"X\""), std::string::npos);
}

TEST(descriptor, count_glued_to_the_number_before_is_refused) { EXPECT_NE(refusal("N043G2"), ""); }

TEST(descriptor, refused_changes_nothing) {
  Grammar g;
  EXPECT_FALSE(apply_descriptor("X+053 Y-053", g));
  EXPECT_FALSE(g.word('X').known);
}

}  // namespace
}  // namespace kadr::format_test
