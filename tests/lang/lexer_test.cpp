// lang/block/lexer: splits one block into words, each with its exact characters. Spec mach3 1, s2c42 1–3, gost 2–3, correctors 1.

#include "lang/block/lexer.h"

#include "choices.h"
#include "lang/read_block.h"

namespace kadr::lexer_test {
namespace {

using namespace test;

struct Case {
  const char* text;
  const char* words;   // addresses and values
  const char* places;  // the exact characters of each word
};

void expect_words(const Grammar& grammar, std::initializer_list<Case> cases) {
  for (const Case& c : cases) {
    const Sample sample(c.text, grammar);
    EXPECT_EQ(sample.alarm, "") << c.text;
    EXPECT_EQ(shown(sample.block), c.words) << c.text;
    EXPECT_EQ(places(sample.block), c.places) << c.text;
  }
}

struct Fault {
  const char* text;
  const char* alarm;  // "id: the characters that it points at"
};

void expect_alarms(const Grammar& grammar, std::initializer_list<Fault> faults) {
  for (const Fault& f : faults) EXPECT_EQ(Sample(f.text, grammar).alarm, f.alarm) << f.text;
}

TEST(words, of_mach3_are_free) {
  expect_words(words_of("mach3"), {
                                      // text                      words                   characters
                                      {"G1 X10 Y-2.5", "G1 X10 Y-2.5", "G1|X10|Y-2.5|"},
                                      {"g1x10y-2.5", "G1 X10 Y-2.5", "g1|x10|y-2.5|"},
                                      {"G01X+.5Y5.", "G1 X0.5 Y5", "G01|X+.5|Y5.|"},
                                      {"X - 3 Y\t+4", "X-3 Y4", "X - 3|Y\t+4|"},
                                      {"X1 0 Y1 .5", "X10 Y1.5", "X1 0|Y1 .5|"},  // blanks have no meaning
                                      {"G38.2 Z-10", "G38.2 Z-10", "G38.2|Z-10|"},
                                      {"G0 G90 G17 X1", "G0 G90 G17 X1", "G0|G90|G17|X1|"},
                                      {"X#1 Y[2+3] Z-#2", "X? Y? Z?", "X#1|Y[2+3]|Z-#2|"},
                                      {"G1 (X5) X1 ; Y7", "G1 X1", "G1|X1|"},
                                      {"G1 X1 // back", "G1 X1", "G1|X1|"},
                                      {"% 12 G1", "", ""},
                                  });
}

TEST(words, of_2c42_count_increments_of_a_micrometre) {
  expect_words(words_of("s2c42"), {
                                      {"G01 X8000 Y-12 Z+1", "G1 X8 Y-0.012 Z0.001", "G01|X8000|Y-12|Z+1|"},
                                      {"X0012 I9999999", "X0.012 I9999.999", "X0012|I9999999|"},
                                      {"F300 S1000 T5 D02 E250", "F300 S1000 T5 D2 E250", "F300|S1000|T5|D02|E250|"},
                                      {"L0801 H5", "L801 H5", "L0801|H5|"},
                                      {"X+R1 Z-1200+R2 Y-R3", "X? Z? Y?", "X+R1|Z-1200+R2|Y-R3|"},
                                      {"X5 M6 M8 M3 ПС", "X0.005 M6 M8 M3", "X5|M6|M8|M3|"},
                                      {"G92 /2/ X10", "G92 A2 X0.01", "G92|/2/|X10|"},
                                  });
}

TEST(words, of_gost_follow_the_format) {
  expect_words(words_of("gost"), {
                                     {"X8000 Y8. Z100", "X8 Y8 Z1", "X8000|Y8.|Z100|"},  // X+053, Z+042
                                     {"F125", "F12.5", "F125|"},                         // F031
                                     {"F12.5", "F12.5", "F12.5|"},
                                     {"T0404 M03", "T404 M3", "T0404|M03|"},
                                     {"X-12.345 LF", "X-12.345", "X-12.345|"},
                                 });
}

TEST(words, of_correctors_take_a_second_number) {
  expect_words(words_of("correctors"), {
                                           {"G01 Z+100. L17", "G1 Z100 L17", "G01|Z+100.|L17|"},
                                           {"X -100 L2 15 M08", "X-100 L2/15 M8", "X -100|L2 15|M08|"},
                                       });
}

TEST(words, after_an_alarm_are_those_before_it) {
  const Sample sample("G1 X1 X2", words_of("mach3"));
  EXPECT_EQ(sample.alarm, "address_twice: X");
  EXPECT_EQ(shown(sample.block), "G1 X1");
}

TEST(alarms_of_words, on_mach3) {
  expect_alarms(words_of("mach3"), {
                                       {"G1 X", "number_missing: X"},
                                       {"G1 X Y2", "function_unknown: Y"},  // X accepts a function, but Y is not a function
                                       {"G1 X1..5", "number_damaged: ."},
                                       {"G1 X.", "number_damaged: X."},
                                       {"G1 E5", "address_unknown: E"},
                                       {"G1 X1 ? Y2", "unexpected_character: ?"},
                                       {"G1 X1 Ж Y2", "unexpected_character: Ж"},
                                       {"M3 M7 M8 M48 M6", "too_many_codes: M"},
                                       {"X1 N5", "block_number_position: N5"},
                                       {"N5 N6", "address_twice: N6"},
                                       {"G1 X1 /2", "skip_position: /"},
                                       {"G1 (X1", "comment_not_closed: ("},
                                       {"F-5", ""},  // the lexer accepts a sign; the control checks the range
                                       {"#1 5", "expression_syntax: #1 5"},
                                       {"X[1+2", "bracket_not_closed: ["},
                                       {"G1.05", "code_unknown: G1.05"},
                                       {"X1\x01", "control_character: \x01"},
                                   });
}

TEST(alarms_of_words, on_2c42_by_digits_and_signs) {
  expect_alarms(words_of("s2c42"), {
                                       {"X12345678", "too_many_digits: X12345678"},
                                       {"X1.5", "point_not_allowed: X1.5"},
                                       {"F123456", "too_many_digits: F123456"},
                                       {"F-3", "sign_not_allowed: -"},
                                       {"N123456 X1", "too_many_digits: N123456"},
                                       {"G100", "too_many_digits: G100"},
                                       {"X5 X6", "address_twice: X"},
                                       {"M1 M2 M3 M4 M5 M6", "too_many_codes: M"},
                                       {"X5+6", "parameter_not_allowed: +6"},
                                       {"L+R1", "parameter_not_allowed: L+R"},
                                       {"TR1", "parameter_not_allowed: TR"},
                                       {"R2+50 R2+51", "address_twice: R2+51"},
                                       {"R123456789", "too_many_digits: R123456789"},  // R1, then eight digits
                                       {"W5", "address_unknown: W"},
                                       {"С5", "address_unknown: С"},  // a Cyrillic С instead of the Latin C
                                       {"X1 (5%)", "comment_character: %"},
                                       {"X1 (5:)", "comment_character: :"},
                                   });
}

TEST(alarms_of_words, on_gost_by_the_format) {
  expect_alarms(words_of("gost"), {
                                      {"X1234567890", "too_many_digits: X1234567890"},
                                      {"X1.2345", "too_many_decimals: X1.2345"},
                                      {"G0 G1 G2 G3", "too_many_codes: G"},
                                  });
}

TEST(look_alikes, are_understood_with_a_warning_at_the_letter) {
  const Sample sample("N1 Х5000 М3", words_of("s2c42"));  // Х and М are Cyrillic
  EXPECT_EQ(sample.alarm, "");
  EXPECT_EQ(shown(sample.block), "X5 M3");
  ASSERT_EQ(sample.block.warnings.size(), 2u);
  EXPECT_EQ(sample.block.text_of(sample.block.warnings[0].where), "Х");
  EXPECT_EQ(sample.block.text_of(sample.block.warnings[1].where), "М");
  EXPECT_EQ(sample.block.warnings[0].id, AlarmId::look_alike_letter);
  EXPECT_EQ(places(sample.block), "Х5000|М3|");
}

TEST(look_alikes, in_comments_are_left_alone) { EXPECT_TRUE(Sample("X5 (ХОД)", words_of("s2c42")).block.warnings.empty()); }

TEST(end_of_block, may_stand_in_the_middle_of_a_line) {
  const std::string line = "N1 G0 X1000 ПС N2 Y2000 LF N3 M2";
  const Grammar& grammar = grammar_of("s2c42");
  const Sample first(line, grammar);
  EXPECT_EQ(shown(first.block), "G0 X1");
  EXPECT_TRUE(first.lexed.marked);
  const Sample second(line, grammar, first.lexed.next);
  EXPECT_EQ(shown(second.block), "Y2");
  EXPECT_EQ(second.block.number, 2u);
  const Sample third(line, grammar, second.lexed.next);
  EXPECT_EQ(shown(third.block), "M2");
  EXPECT_FALSE(third.lexed.marked);
  EXPECT_EQ(third.lexed.next, line.size());
}

TEST(end_of_block, is_no_word_of_mach3) { EXPECT_EQ(Sample("X1 ПС", words_of("mach3")).alarm, "unexpected_character: П"); }

TEST(beginning, numbers_skips_and_markers) {
  const Sample block("/N010 X1", grammar_of("s2c42"));
  EXPECT_EQ(block.block.skip, 1);
  EXPECT_EQ(block.block.number, 10u);
  EXPECT_EQ(block.block.number_digits, 3);
  EXPECT_EQ(block.block.text_of(block.block.number_where), "N010");
  EXPECT_TRUE(Sample(":5 X1", grammar_of("s2c42")).block.main_block);
  EXPECT_EQ(Sample("%012", grammar_of("s2c42")).block.label, 12u);
  EXPECT_EQ(Sample("%123456", grammar_of("s2c42")).alarm, "program_number_damaged: %123456");
  EXPECT_EQ(Sample("L ПС", grammar_of("s2c42")).block.marker, Marker::section);
  EXPECT_EQ(Sample("O100", grammar_of("mach3")).block.marker, Marker::label);
  EXPECT_EQ(Sample("O100", grammar_of("mach3")).block.label, 100u);
  EXPECT_EQ(Sample("X1", grammar_of("s2c42")).alarm, "block_number_missing: X");
}

TEST(comments, are_kept) {
  const Sample sample("G1 (one) X1 (two); three", words_of("mach3"));
  ASSERT_EQ(sample.block.comments.size(), 3u);
  EXPECT_EQ(sample.block.text_of(sample.block.comments[0]), "one");
  EXPECT_EQ(sample.block.text_of(sample.block.comments[1]), "two");
  EXPECT_EQ(sample.block.text_of(sample.block.comments[2]), " three");
}

TEST(block_length, counts_characters_not_bytes) {
  const std::string comment = "(" + std::string(70, 'a') + ")";
  EXPECT_EQ(Sample("N1 X5000" + comment, grammar_of("s2c42")).alarm, "");  // 80 characters
  EXPECT_TRUE(Sample("N1 X50000" + comment, grammar_of("s2c42")).alarm.starts_with("block_too_long: N1 X50000"));
  std::string russian = "N1 X5000(";
  for (int i = 0; i < 70; ++i) russian += "Ж";
  EXPECT_EQ(Sample(russian + ")", grammar_of("s2c42")).alarm, "");
}

// ---- read_number and its reference versions

RC_GTEST_PROP(read_number, gives_the_same_double_as_strtod, ()) {
  Choices choose = choices(80);
  std::string digits;
  const std::size_t whole = choose.below(25);
  for (std::size_t i = 0; i < whole; ++i) digits += static_cast<char>('0' + choose.below(10));
  if (whole == 0 || choose.below(2) == 1) {
    digits += '.';
    for (std::size_t i = choose.below(25) + (whole == 0); i > 0; --i) digits += static_cast<char>('0' + choose.below(10));
  }
  Cursor cursor{digits, 0};
  Number number;
  RC_ASSERT(read_number(cursor, number));
  RC_ASSERT(cursor.at == digits.size());
  RC_ASSERT(number.value == std::strtod(digits.c_str(), nullptr));
  RC_ASSERT(number.whole_digits == whole);
  RC_ASSERT(number.has_point == (digits.find('.') != std::string::npos));
  RC_ASSERT(number.whole_digits + number.fraction_digits + (number.has_point ? 1u : 0u) == digits.size());
}

// ---- round trip: words → text → the same words

struct Printed {
  std::string text, words, places;
};

void print_word(Printed& to, Choices& choose, char letter, int thousandths, bool increments) {
  const int size = std::abs(thousandths);
  std::string digits = std::to_string(size / 1000);
  std::string fraction = std::to_string(1000 + size % 1000).substr(1);
  if (increments) digits = std::to_string(size);
  else if (size % 1000 != 0 || choose.one_in(4)) digits += "." + fraction;
  digits.insert(0, choose.below(7 - std::min<std::size_t>(digits.size(), 6)), '0');
  const std::string sign = thousandths < 0 ? "-" : choose.one_in(3) ? "+" : "";
  const std::string word = letter + sign + digits;
  to.text += word + std::string(choose.below(3), ' ');
  to.words += (to.words.empty() ? "" : " ") + std::string(1, letter) + number_text(thousandths / 1000.0);
  to.places += word + "|";
}

RC_GTEST_PROP(round_trip, words_of_mach3_come_back, ()) {
  Choices choose = choices(60);
  Printed program;
  for (const char letter : std::string_view("XYZABCIJKR"))
    if (choose.below(2) == 1) print_word(program, choose, letter, choose.between(-99'999, 99'999), false);
  const Sample sample(program.text, words_of("mach3"));
  RC_ASSERT(sample.alarm == "");
  RC_ASSERT(shown(sample.block) == program.words);
  RC_ASSERT(places(sample.block) == program.places);
}

RC_GTEST_PROP(round_trip, words_of_2c42_come_back, ()) {
  Choices choose = choices(60);
  Printed program;
  program.text = "N" + std::to_string(choose.below(99'999)) + " ";
  for (const char letter : std::string_view("ZYXKJI"))
    if (choose.below(2) == 1) print_word(program, choose, letter, choose.between(-99'999, 99'999), true);
  program.text += choose.below(2) == 1 ? "ПС" : "";
  const Sample sample(program.text, grammar_of("s2c42"));
  RC_ASSERT(sample.alarm == "");
  RC_ASSERT(shown(sample.block) == program.words);
  RC_ASSERT(places(sample.block) == program.places);
}

}  // namespace
}  // namespace kadr::lexer_test
