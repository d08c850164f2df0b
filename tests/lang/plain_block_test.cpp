// lang/block/plain_block against lang/block/lexer: the fast reader gives the same words as the slow one.

#include "lang/block/plain_block.h"

#include "choices.h"
#include "lang/read_block.h"

namespace kadr::plain_block_test {
namespace {

using namespace test;

constexpr const char* controls[] = {"nct", "mach3", "s2c42", "gost", "correctors"};

bool same(double a, double b) { return a == b ? std::signbit(a) == std::signbit(b) : a != a && b != b; }

/// Returns where two words differ, "" if they are equal.
std::string difference(const Word& a, const Word& b) {
  if (a.address != b.address || a.written != b.written) return "address";
  if (!same(a.value, b.value) || !same(a.second, b.second)) return "value";
  if (!(a.where == b.where)) return "place";
  if (a.code != b.code) return "code";
  if (a.digits != b.digits || a.has_point != b.has_point) return "digits";
  if (a.incremental != b.incremental || a.bare != b.bare || a.expression || b.expression) return "kind";
  return "";
}

std::string difference(const Block& a, const Block& b) {
  if (a.word_count != b.word_count) return "number of words";
  for (std::uint32_t i = 0; i < a.word_count; ++i)
    if (const std::string d = difference(a.words[i], b.words[i]); !d.empty()) return d + " of word " + std::to_string(i + 1);
  if (a.letters != b.letters) return "letters";
  for (char letter = 'A'; letter <= 'Z'; ++letter)
    if (a.has(letter) && a.find(letter) - a.words.data() != b.find(letter) - b.words.data()) return "first word of a letter";
  if (a.has_number != b.has_number || a.number != b.number || a.number_digits != b.number_digits) return "block number";
  if (a.has_number && !(a.number_where == b.number_where)) return "place of the block number";
  if (!(a.where == b.where)) return "place of the block";
  if (b.skip != 0 || b.marker != Marker::none || b.main_block || !b.comments.empty() || !b.assignments.empty() || !b.code.empty())
    return "what a plain block has not";
  return "";
}

/// Returns a piece of a line, mostly a word.
std::string piece(Choices& choose) {
  constexpr const char* odd[] = {"(a)", "#1", "/", "%",    "[1]", ",C", "LF", "ПС", "=", ";", "I",
                                 "X",   "-",  ".", "\x7f", "é",   "g1", ":5", "IF", "0", "5 "};
  constexpr const char* number[] = {"0",   "1", "00",  "01", "10.5", "-2.5", "+.5", "5.", "54.1", "12345678901234567890",
                                    "1e5", "9", "007", "-0"};
  constexpr const char* blank[] = {" ", "", "  ", "\t", "\r"};
  if (choose.one_in(12)) return choose.of(odd);
  return std::string(1, static_cast<char>('A' + choose.below(26))) + choose.of(number) + choose.of(blank);
}

TEST(plain_blocks, are_most_blocks_of_a_long_program) {
  for (const char* const text : {"G1 X10.5 Y-2", "X1Y2", "G1 X1 F200", "G0 G90 M3", "g1 x5 ", "N10 G1 X5.", "G2 X1 Y2 I-.5 J0"}) {
    for (const char* const control : {"nct", "mach3"}) {
      Block block;
      EXPECT_TRUE(PlainBlocks(grammar_of(control)).read(text, 0, block)) << control << ": " << text;
    }
  }
}

TEST(plain_blocks, nothing_else_is_read) {
  for (const char* const text :
       {"G1 X#1", "X[1]", "(a)", "G1 X1 (a)", "/X1", "IF", "X", "XI5", "S2=500", "X1 1", "O1", "X1;", "GOTO5", "X1 =5"}) {
    Block block;
    EXPECT_FALSE(PlainBlocks(grammar_of("nct")).read(text, 0, block)) << text;
    EXPECT_TRUE(block.word_count == 0 && block.letters == 0 && !block.has_number && !block.shape) << text;
  }
}

TEST(plain_blocks, of_one_shape_have_the_same_addresses_and_codes) {
  const PlainBlocks plain(grammar_of("nct"));
  const auto shape = [&](const char* text) {
    Block block;
    EXPECT_TRUE(plain.read(text, 0, block)) << text;
    return block.shape;
  };
  EXPECT_EQ(shape("G1 X1 Y2"), shape("N5 g01x-3.Y0"));
  EXPECT_NE(shape("G1 X1 Y2"), shape("G1 Y1 X2"));
  EXPECT_NE(shape("G1 X1"), shape("G2 X1"));
  EXPECT_NE(shape("G54.1 P1"), shape("G54 P1"));
  EXPECT_NE(shape("X1"), shape("X1 Y1"));
  EXPECT_FALSE(shape("G1 G40 G49 G90 G94 G97 X1"));  // more codes than a shape can hold: no shape
}

RC_GTEST_PROP(plain_blocks, are_what_the_lexer_reads, ()) {
  Choices choose = choices(60);
  const Grammar& grammar = choose.one_in(2) ? grammar_of(choose.of(controls)) : grammar_of("nct");
  std::string text;
  for (std::size_t n = choose.below(8); n-- > 0;) text += piece(choose);
  Block plain;
  const bool is_plain = PlainBlocks(grammar).read(text, 0, plain);
  RC_TAG(is_plain ? "plain" : "other");
  if (!is_plain) return;
  const Sample slow(text, grammar);
  RC_LOG(text);
  RC_ASSERT(slow.alarm == "");
  RC_ASSERT(difference(plain, slow.block) == "");
  RC_ASSERT(slow.lexed.next == text.size() && !slow.lexed.marked);
}

}  // namespace
}  // namespace kadr::plain_block_test
