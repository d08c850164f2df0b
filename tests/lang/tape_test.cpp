// lang/text/tape: converts between rows of a punched tape and text. Spec s2c42 1: plain ISO-646 with even parity in the eighth track.

#include "lang/text/tape.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <bit>

namespace kadr::tape_test {
namespace {

std::string encoded(std::string_view text) { return encode_tape(text, 0).value(); }
std::string read_back(std::string_view text) { return decode_tape(encoded(text)).text; }

TEST(tape_parity, number_of_holes_is_even) {
  for (int code = 0; code < 128; ++code) {
    const std::uint8_t row = with_even_parity(static_cast<std::uint8_t>(code));
    EXPECT_EQ(std::popcount(row) % 2, 0);
    EXPECT_EQ(row & 0x7F, code);
    EXPECT_TRUE(has_even_parity(row));
    EXPECT_FALSE(has_even_parity(row ^ 0x80));
  }
}

TEST(tape_parity, codes_of_the_table) {
  EXPECT_EQ(with_even_parity(045), 0245);   // %: three holes and the parity hole in track 8
  EXPECT_EQ(with_even_parity(012), 012);    // ПС: two holes
  EXPECT_EQ(with_even_parity(0130), 0330);  // X: three holes
}

TEST(encode_tape, block_by_hand) {
  EXPECT_EQ(encoded("%\nN1\n"), "\xA5\x0A\x4E\xB1\x0A");  // N is 0x4E, four holes; 1 is 0x31, three holes
}

TEST(encode_tape, leader_and_trailer_are_blank) { EXPECT_EQ(encode_tape("N3\n", 2).value(), std::string("\0\0\x4E\x33\x0A\0\0", 7)); }

TEST(encode_tape, literal_end_of_block_becomes_the_line_feed) {
  for (const char* text : {"N1 M2 ПС\n", "N1 M2 LF\n", "N1 M2ПС\n", "N1 M2  ПС  \n", "N1 M2 LF\r\n", "N1 M2 ПС"})
    EXPECT_EQ(read_back(text), "N1 M2\n") << text;
}

TEST(encode_tape, mark_of_an_empty_block) { EXPECT_EQ(read_back("ПС\n LF\n"), "\n\n"); }

TEST(encode_tape, mark_within_a_word_or_a_line_is_text) {
  EXPECT_EQ(read_back("(SELF\n"), "(SELF\n");
  EXPECT_EQ(read_back("(КПС\n"), "(КПС\n");
  EXPECT_EQ(read_back("(ПС)\n"), "(ПС)\n");
}

TEST(encode_tape, every_end_of_line_is_one_line_feed) {
  for (const char* text : {"N1\nN2\n", "N1\r\nN2\r\n", "N1\rN2\r", "N1\r\r\nN2"}) EXPECT_EQ(read_back(text), "N1\nN2\n");
}

TEST(encode_tape, russian_letters_stand_between_so_and_si) {
  // С is 0xF3 and ф is 0xC6 in KOI8-R; without bit 8 they are 0x73 and 0x46
  EXPECT_EQ(encoded("(Сф)"), "\x28\x8E\xF3\xC6\x0F\xA9\x0A");
}

TEST(encode_tape, characters_without_code_are_named) {
  for (const std::string bad : {"Ъ", "Ё", "ё", "№", "\x7F", "\x0E", "\r", "\xD0"}) {
    const auto rows = encode_tape("N1\n(" + bad + ")\n", 0);
    ASSERT_FALSE(rows) << bad;
    EXPECT_EQ(rows.error().id, AlarmId::bad_encoding);
    EXPECT_EQ(rows.error().where, (Span{4, static_cast<std::uint32_t>(4 + bad.size())}));
    EXPECT_EQ(rows.error().args[0].text(), bad);
  }
}

TEST(encode_tape, small_hard_sign_has_a_code) { EXPECT_EQ(read_back("(объезд)\n"), "(объезд)\n"); }

TEST(decode_tape, blank_and_deleted_rows_and_cr_give_nothing) {
  EXPECT_EQ(decode_tape(std::string("\0\xFF\x4E\0\x33\xFF\x8D\x0A\0", 9)).text, "N3\n");
}

TEST(decode_tape, odd_row_is_a_question_mark_and_a_fault) {
  const TapeText tape = decode_tape("N1\n");  // '1' has three holes without parity
  EXPECT_EQ(tape.text, "N?\n");
  ASSERT_EQ(tape.faults.size(), 1u);
  EXPECT_EQ(tape.faults[0].row, 2u);
  EXPECT_EQ(tape.faults[0].byte, '1');
}

TEST(decode_tape, deleted_row_without_its_parity_is_a_fault) { EXPECT_EQ(decode_tape("\x7F").faults.size(), 1u); }

TEST(decode_tape, no_more_than_a_thousand_faults_are_listed) {
  const TapeText tape = decode_tape(std::string(5000, '1'));
  EXPECT_EQ(tape.faults.size(), 1000u);
  EXPECT_EQ(tape.text, std::string(5000, '?'));
}

TEST(decode_tape, each_line_begins_with_latin_letters) {
  const std::string open_comment = {static_cast<char>(0x8E), static_cast<char>(0xF3), 0x0A, 0x4E};  // SO С LF N
  EXPECT_EQ(decode_tape(open_comment).text, "С\nN");
}

TEST(decode_tape, digits_are_the_same_among_russian_letters) {
  const std::string rows = {static_cast<char>(0x8E), static_cast<char>(0xF3), 0x33};  // SO С 3
  EXPECT_EQ(decode_tape(rows).text, "С3");
}

RC_GTEST_PROP(tape_round_trip, text_of_the_code_comes_back, ()) {
  const std::vector<std::string> characters = {"N",  "1",  "0", " ", "(", ")", "%", "X", "+", "z", "~", "_", "@",
                                               "\t", "\n", "А", "я", "Я", "ю", "ъ", "Ч", "П", "С", "L", "F", "Г"};
  std::string text;
  for (const auto& c : *rc::gen::container<std::vector<std::string>>(rc::gen::elementOf(characters))) text += c;
  text += "\n";
  // A mark at the end of a line is an end of block, not text; other tests check such lines.
  for (const std::string mark : {"ПС", "LF"})
    for (std::size_t at = text.find(mark); at != std::string::npos; at = text.find(mark)) text.replace(at, mark.size(), "Г");
  const auto leader = *rc::gen::inRange<std::size_t>(0, 50);
  const auto rows = encode_tape(text, leader);
  RC_ASSERT(rows.has_value());
  const TapeText tape = decode_tape(*rows);
  RC_ASSERT(tape.faults.empty());
  RC_ASSERT(tape.text == text);
}

RC_GTEST_PROP(tape_round_trip, one_wrong_hole_is_always_found, ()) {
  std::string rows = encoded("N10 G01 X8000 (СВЕРЛО)\nN20 M2\n");
  const auto row = *rc::gen::inRange<std::size_t>(0, rows.size());
  const auto track = *rc::gen::inRange(0, 8);
  rows[row] = static_cast<char>(static_cast<unsigned char>(rows[row]) ^ (1u << track));
  const TapeText tape = decode_tape(rows);
  RC_ASSERT(tape.faults.size() == 1u);
  RC_ASSERT(tape.faults[0].row == row + 1);
}

}  // namespace
}  // namespace kadr::tape_test
