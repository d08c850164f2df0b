// lang/block/o_word_reader: O words, named variables, and the evidence of a file (spec/linuxcnc 2, 4.2, 6.1).

#include "choices.h"
#include "lang/block/o_word_reader.h"
#include "lang/read_block.h"

namespace kadr::o_word_test {
namespace {

using namespace test;

TEST(o_words, say_what_the_line_does) {
  const Grammar& grammar = words_of("linuxcnc");
  struct Row {
    const char* text;
    OWord word;
    std::size_t arguments, conditions;
  };
  for (const Row& row :
       {Row{"O100 sub", OWord::sub, 0, 0}, Row{"o100 endsub [#1+2]", OWord::endsub, 0, 1}, Row{"N5 O1 call [1] [2][3]", OWord::call, 3, 0},
        Row{"O<Depth Of> while [#1 LT 3] (comment)", OWord::while_, 0, 1}, Row{"O[#1+2] endif", OWord::endif, 0, 0},
        Row{"O7", OWord::label, 0, 0}, Row{"O 12 re peat [3]", OWord::repeat, 0, 1}, Row{"O1 return", OWord::return_, 0, 0}}) {
    const Sample sample(row.text, grammar);
    EXPECT_EQ(sample.alarm, "") << row.text;
    EXPECT_EQ(sample.block.statement.kind, StatementKind::o_word) << row.text;
    EXPECT_EQ(sample.block.statement.o_word, row.word) << row.text;
    EXPECT_EQ(sample.block.arguments.size(), row.arguments) << row.text;
    EXPECT_EQ(sample.block.statement.condition_count, row.conditions) << row.text;
  }
}

TEST(o_words, stand_alone) {
  const Grammar& grammar = words_of("linuxcnc");
  struct Row {
    const char* text;
    const char* alarm;
  };
  for (const Row& row :
       {Row{"O1 goto", "o_word_unknown"}, Row{"O1 call G0", "o_word_rest"}, Row{"O1 if 1", "o_word_bracket"},
        Row{"O<a call", "variable_name_open"}, Row{"O1 else G0 X1", "o_word_rest"}, Row{"X1 O1 call", "unexpected_character"}}) {
    const Sample sample(row.text, grammar);
    EXPECT_TRUE(std::string_view(sample.alarm).starts_with(row.alarm)) << row.text << ": " << sample.alarm;
  }
}

TEST(variable_names, are_compared_without_case_and_blanks) {
  VariableNames names;
  const auto depth = names.number_of("Hole Depth");
  ASSERT_TRUE(depth.has_value());
  EXPECT_EQ(names.number_of("holedepth"), depth);
  EXPECT_NE(names.number_of("hole_depth"), depth);
  EXPECT_EQ(names.name_of(*depth), "holedepth");
  EXPECT_EQ(names.name_of(5), "");
  EXPECT_TRUE(VariableNames::is_named(*depth));
  EXPECT_FALSE(VariableNames::is_named(5601));
}

TEST(sign_of_file, has_nothing_else) {
  const Grammar& grammar = words_of("linuxcnc");
  EXPECT_EQ(Sample(" % ", grammar).block.marker, Marker::program_start);
  EXPECT_NE(Sample("% 5", grammar).alarm, "");
  EXPECT_EQ(Sample("G0 X1", grammar).block.marker, Marker::none);
}

}  // namespace
}  // namespace kadr::o_word_test
