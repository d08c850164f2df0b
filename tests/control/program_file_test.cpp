// Jumps by block number (nct 14.1, 14.4.4, 23.2.8): the index is compared
// with reading on block by block, which defines what a jump means.
#include "control/flow/program_file.h"

#include <gtest/gtest.h>

#include <random>
#include <string>

#include "config/control/control_file.h"
#include "control/flow/block_numbers.h"

namespace kadr::program_file_test {
namespace {

const Grammar& nct_grammar() {
  static const ControlDef def = load_control("nct").value();
  return def.grammar;
}

BlockReader reader_of(const std::string& text, const Grammar& grammar = nct_grammar()) {
  return {text_source(text), grammar, Encoding::utf8};
}

/// Searches as the manual describes it: block by block from `from` to the end, then from the beginning to `from`.
std::optional<Position> by_reading(BlockReader& reader, std::uint32_t number, Position from) {
  Block block;
  for (const bool again : {false, true}) {
    reader.seek(again ? Position{} : from);
    bool in_data = false;
    for (;;) {
      const Position at = reader.position();
      if (again && (at.offset > from.offset || (at.offset == from.offset && at.nth >= from.nth))) break;
      const auto got = reader.next(block);
      if (got && *got == BlockReader::Got::end) break;
      if (!in_data && block.has_number && block.number == number) return block.position;
      for (std::uint32_t i = 0; i < block.word_count; ++i) {
        const Word& w = block.words[i];
        const Word* const l = block.find('L');
        if (w.address == 'G' && w.code == 100 && l != nullptr && (l->value == 52 || (l->value >= 75 && l->value <= 77))) in_data = true;
        if (w.address == 'G' && w.code == 110) in_data = false;
      }
    }
  }
  return std::nullopt;
}

/// Writes lines that are hard to search: duplicate numbers, leading zeros, numbers in comments, skipped and damaged blocks, data lines.
std::string random_program(std::mt19937& random, std::size_t lines, int numbers) {
  const auto any = [&](int below) { return static_cast<int>(random() % static_cast<unsigned>(below)); };
  const auto n = [&] { return std::string(static_cast<std::size_t>(any(3)), '0') + std::to_string(any(numbers)); };
  std::string text;
  for (std::size_t i = 0; i < lines; ++i) {
    switch (any(14)) {
      case 0: text += "(N" + n() + " G1)\n"; break;
      case 1: text += "/N" + n() + " X1\n"; break;
      case 2: text += "/2N" + n() + "\n"; break;
      case 3: text += "\n"; break;
      case 4: text += "X" + n() + " (N" + n() + ")\n"; break;
      case 5: text += "N" + n() + " ] [ *\n"; break;  // damaged after its number
      case 6: text += "(over\nN" + n() + " lines)\n"; break;
      case 7: text += any(4) == 0 ? "G10 L52\n" : "G10 L75 P1\n"; break;
      case 8: text += any(2) == 0 ? "N" + n() + " G11\n" : "G11\n"; break;
      case 9: text += "N" + n() + " G10 L52\n"; break;
      case 10: text += "#1=" + n() + "\r\n"; break;
      case 11: text += "N" + n() + " IF[#1EQ1]GOTO" + n() + "\n"; break;
      default: text += "N" + n() + " G1 X" + std::to_string(i) + "\n"; break;
    }
  }
  return text;
}

/// Returns every position from which a jump may start.
std::vector<Position> places_of(BlockReader& reader) {
  std::vector<Position> places{{}};
  Block block;
  reader.seek({});
  for (;;) {
    const auto got = reader.next(block);
    if (got && *got == BlockReader::Got::end) return places;
    places.push_back(block.position);
    places.push_back(reader.position());
  }
}

TEST(BlockNumbers, FindsWhatReadingOnFinds) {
  std::mt19937 random(15);
  int found = 0, missing = 0;
  for (int run = 0; run < 60; ++run) {
    const std::string text = random_program(random, 1 + random() % 40, 8);
    BlockReader reader = reader_of(text), slow = reader_of(text);
    BlockNumbers index;
    ASSERT_TRUE(index.make(reader, {}));
    for (const Position from : places_of(slow))
      for (std::uint32_t number = 0; number < 9; ++number) {
        const auto expected = by_reading(slow, number, from);
        ASSERT_EQ(index.find(number, from), expected) << text << "GOTO" << number << " from line " << from.line;
        ++(expected ? found : missing);
      }
  }
  EXPECT_GT(found, 3000);
  EXPECT_GT(missing, 100);
}

// Several blocks on a line: the NCT does not allow them, but a control that extends it may.
TEST(BlockNumbers, TellsBlocksOfOneLineApart) {
  Grammar grammar = nct_grammar();
  grammar.end_of_block = EndOfBlock::line;
  const std::string text = "N1 X1 LF N2 X2 LF N1 X3 LF\nN2 X4 LF N3 X5 LF\n";
  BlockReader reader = reader_of(text, grammar), slow = reader_of(text, grammar);
  BlockNumbers index;
  ASSERT_TRUE(index.make(reader, {}));
  EXPECT_EQ(index.size(), 5U);
  EXPECT_EQ(index.find(1, {0, 1, 1}), (Position{0, 1, 2}));
  EXPECT_EQ(index.find(1, {27, 2, 0}), (Position{0, 1, 0}));
  for (const Position from : places_of(slow))
    for (std::uint32_t number = 1; number < 5; ++number) EXPECT_EQ(index.find(number, from), by_reading(slow, number, from));
}

// In a file too long to be searched by reading, the answers are the same before the index exists and after.
TEST(ProgramFile, FindsTheSameWithAndWithoutItsIndex) {
  std::mt19937 random(16);
  const std::string text = random_program(random, 6000, 3000);
  BlockReader slow = reader_of(text);
  const std::vector<Position> places = places_of(slow);
  ProgramFile file("long.nct", text_source(text), nct_grammar(), Encoding::utf8);
  for (int i = 0; i < 150; ++i) {
    const Position from = places[random() % places.size()];
    const auto number = static_cast<std::uint32_t>(random() % 3010);
    ASSERT_EQ(file.find_number(number, from), by_reading(slow, number, from)) << number << " from line " << from.line;
  }
}

TEST(ProgramFile, ASearchEndsWhenAsked) {
  std::atomic<bool> stop = true;
  ProgramFile file("any.nct", text_source("N1 X1\nN2 X2\n"), nct_grammar(), Encoding::utf8, StopToken(stop));
  EXPECT_FALSE(file.find_number(2, {}).has_value());
  stop = false;
  EXPECT_TRUE(file.find_number(2, {}).has_value());
}

}  // namespace
}  // namespace kadr::program_file_test
