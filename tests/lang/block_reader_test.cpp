// lang/block/block_reader: reads the blocks of a program from any position, in any encoding. Spec s2c42 1–2.

#include "lang/block/block_reader.h"

#include <iconv.h>

#include "choices.h"
#include "lang/read_block.h"

namespace kadr::block_reader_test {
namespace {

using namespace test;

/// The parts of a block that the tests compare.
struct Read {
  Position position;
  std::string words;
  std::string alarm;
  std::uint32_t number = 0;
  friend bool operator==(const Read&, const Read&) = default;
};
std::ostream& operator<<(std::ostream& to, const Read& r) {
  return to << "line " << r.position.line << " nth " << r.position.nth << " N" << r.number << " [" << r.words << "] " << r.alarm << "\n";
}

class Reading {
 public:
  Reading(const std::string& text, const Grammar& grammar, std::optional<Encoding> encoding = {})
      : reader_(text_source(text), grammar, encoding) {}
  std::optional<Read> next() {
    Block block;
    const auto got = reader_.next(block);
    if (got && *got == BlockReader::Got::end) return {};
    Read read{block.position, shown(block), "", block.has_number ? block.number : 0};
    if (!got) {
      Span place = got.error().where;
      const std::string line = reader_.shown(block.text, place);
      read.alarm = std::string(name_of(got.error().id)) + ": " + line.substr(place.begin, place.end - place.begin);
      read.words.clear();
    }
    return read;
  }
  std::vector<Read> all() {
    std::vector<Read> blocks;
    while (auto read = next()) blocks.push_back(*read);
    return blocks;
  }
  void seek(Position position) { reader_.seek(position); }

 private:
  BlockReader reader_;
};

std::vector<std::string> words_in(const std::string& text, const Grammar& grammar) {
  std::vector<std::string> words;
  for (const Read& read : Reading(text, grammar).all()) words.push_back(read.alarm.empty() ? read.words : read.alarm);
  return words;
}
using Words = std::vector<std::string>;

TEST(blocks, a_line_each) { EXPECT_EQ(words_in("G0 X1\n\n  \nY2\r\n(note)\nZ3", grammar_of("mach3")), (Words{"G0 X1", "Y2", "", "Z3"})); }

TEST(blocks, several_on_a_line_between_marks) {
  const std::string text = "% ПС\nN1 G0 X1000 ПС N2 Y2000 ПС\nN3 M2 ПС\n";
  EXPECT_EQ(words_in(text, grammar_of("s2c42")), (Words{"", "G0 X1", "Y2", "M2"}));
  const std::vector<Read> blocks = Reading(text, grammar_of("s2c42")).all();
  EXPECT_EQ(blocks[1].position.nth, 0u);
  EXPECT_EQ(blocks[2].position.nth, 1u);
  EXPECT_EQ(blocks[2].position.line, 2u);
  EXPECT_EQ(blocks[3].position.line, 3u);
}

TEST(blocks, behind_a_faulty_one_go_on) {
  EXPECT_EQ(words_in("% ПС\nN1 X1000 ПС N2 X1 X2 ПС N3 Y2000 ПС\nN4 M2 ПС", grammar_of("s2c42")),
            (Words{"", "X1", "address_twice: X", "Y2", "M2"}));
}

/// A caller that continues after the fault may look the word up: its value must not be left over from an earlier block.
TEST(blocks, of_a_word_that_cannot_be_read_hold_no_value_of_a_block_before) {
  BlockReader reader(text_source("G1 X25 F725\nG1 X4 F-20\n"), grammar_of("gost"), {});
  Block block;
  ASSERT_TRUE(reader.next(block));
  ASSERT_FALSE(reader.next(block));
  ASSERT_NE(block.find('F'), nullptr);
  EXPECT_EQ(block.find('F')->value, 0);
}

TEST(blocks, without_the_mark_the_others_have_are_an_alarm) {
  EXPECT_EQ(words_in("% ПС\nN1 X1000 ПС\nN2 X5\nN3 M2 ПС", grammar_of("s2c42")), (Words{"", "X1", "end_of_block_missing: 5", "M2"}));
}

TEST(blocks, of_a_line_too_long_are_an_alarm) {
  const std::string text = "X1\n" + std::string(limits::line_bytes + 5, ' ') + "\nX2\n";
  EXPECT_EQ(words_in(text, grammar_of("mach3")), (Words{"X1", "line_too_long:  ", "X2"}));
}

// ---- from any position

/// Returns a random program of the 2С42 with comments, empty lines, look-alike letters, several blocks on a line, and faults.
std::string random_program(Choices& choose) {
  static constexpr const char* pieces[] = {"X1000", "Y-20", "Z+R1", "G1", "М3", "(ХОД %)", "(Ход)", "X5 X6", "G0 F100", "I10 J10"};
  std::string text = "% ПС\n";
  const std::size_t lines = 1 + choose.below(8);
  std::uint32_t number = 0;
  for (std::size_t i = 0; i < lines; ++i) {
    for (std::size_t blocks = choose.below(4); blocks > 0; --blocks) {
      text += "N" + std::to_string(++number) + " ";
      for (std::size_t words = 1 + choose.below(3); words > 0; --words) text += std::string(choose.of(pieces)) + " ";
      text += choose.one_in(3) ? "LF " : "ПС ";
    }
    if (choose.one_in(5)) text += "(Конец)";
    text += choose.one_in(2) ? "\r\n" : "\n";
  }
  return text;
}

RC_GTEST_PROP(seek, to_the_place_of_a_block_gives_that_block_and_the_rest, ()) {
  Choices choose = choices(120);
  const std::string text = random_program(choose);
  const Grammar& grammar = grammar_of("s2c42");
  const std::vector<Read> blocks = Reading(text, grammar).all();
  Reading again(text, grammar);
  for (int i = 0; i < 5; ++i) {
    const std::size_t wanted = choose.below(blocks.size());
    again.seek(blocks[wanted].position);
    for (std::size_t k = wanted; k < std::min(wanted + 3, blocks.size()); ++k) {
      const auto read = again.next();
      RC_ASSERT(read.has_value());
      RC_ASSERT(*read == blocks[k]);
    }
  }
}

// ---- in any encoding

std::string written(std::string text, const char* iconv_name) {
  std::string bytes(text.size(), '\0');
  const iconv_t converter = iconv_open(iconv_name, "UTF-8");
  char* from = text.data();
  char* to = bytes.data();
  std::size_t from_left = text.size();
  std::size_t to_left = bytes.size();
  EXPECT_EQ(iconv(converter, &from, &from_left, &to, &to_left), 0u) << text;
  iconv_close(converter);
  bytes.resize(bytes.size() - to_left);
  return bytes;
}

std::vector<Read> without_offsets(std::vector<Read> blocks) {
  for (Read& read : blocks) read.position.offset = 0;
  return blocks;
}

RC_GTEST_PROP(encodings, give_the_same_blocks_and_alarms, ()) {
  Choices choose = choices(120);
  const std::string text = random_program(choose);
  const Grammar& grammar = grammar_of("s2c42");
  const std::vector<Read> expected = without_offsets(Reading(text, grammar, Encoding::utf8).all());
  RC_ASSERT(without_offsets(Reading(written(text, "CP1251"), grammar, Encoding::cp1251).all()) == expected);
  RC_ASSERT(without_offsets(Reading(written(text, "KOI8-R"), grammar, Encoding::koi8r).all()) == expected);
  RC_ASSERT(without_offsets(Reading(written(text, "CP866"), grammar, Encoding::cp866).all()) == expected);
}

TEST(encodings, second_block_of_a_line_that_is_decoded_late) {
  // The first block of the line has its non-ASCII bytes in a comment only; the second block has a look-alike letter.
  const std::string text = "% LF\nN1 (ПРИВЕТ) X1000 LF N2 М3 LF\n";
  EXPECT_EQ(without_offsets(Reading(written(text, "CP1251"), grammar_of("s2c42"), Encoding::cp1251).all()),
            without_offsets(Reading(text, grammar_of("s2c42")).all()));
}

}  // namespace
}  // namespace kadr::block_reader_test
