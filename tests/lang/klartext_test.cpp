// lang/klartext: lines and blocks of a conversational control (spec/heidenhain 1, 10).

#include "lang/klartext/klartext_line.h"
#include "lang/klartext/klartext_parser.h"
#include "lang/read_block.h"

namespace kadr::klartext_test {
namespace {

using namespace test;

const Grammar& grammar() {
  static const Grammar klartext = [] {
    Grammar made;
    made.klartext_blocks = true;
    return made;
  }();
  return klartext;
}

/// Returns the parts of a line: "/ number words [statement] ;comment".
std::string parts(const std::string& line) {
  const Sample sample(line, grammar());
  if (!sample.alarm.empty()) return sample.alarm;
  const Block& b = sample.block;
  std::string text;
  if (b.skip != 0) text += "/ ";
  if (b.has_number) text += std::to_string(b.number) + " ";
  for (std::uint32_t i = 0; i < b.word_count; ++i) {
    const Word& w = b.words[i];
    text += w.address;
    text += w.code >= 0 ? std::to_string(w.code / 10) : std::to_string(w.value);
    text += ' ';
  }
  if (b.statement.kind == StatementKind::klartext) text += "[" + std::string(b.text_of(b.statement.text)) + "]";
  for (const Span comment : b.comments) text += ";" + std::string(b.text_of(comment));
  return text;
}

TEST(klartext_lines, have_parts) {
  EXPECT_EQ(parts("5 L X+10 Y-0,5 R0 FMAX ; go"), "5 G0 X10.000000 Y-0.500000 G40 ; go");
  EXPECT_EQ(parts("L X-.5 F100 M3"), "G1 X-0.500000 F100.000000 M3 ");
  EXPECT_EQ(parts("/13 L X+1"), "/ 13 G1 X1.000000 ");
  EXPECT_EQ(parts("13 / STOP"), "/ 13 [STOP]");
  EXPECT_EQ(parts("L IX+10"), "[L IX+10]");
  EXPECT_EQ(parts("L X+Q1"), "[L X+Q1]");
  EXPECT_EQ(parts("L X+1 M99"), "[L X+1 M99]");
  EXPECT_EQ(parts("L X+1 X+2"), "[L X+1 X+2]");
  EXPECT_EQ(parts("LBL 1"), "[LBL 1]");
  EXPECT_EQ(parts("* - STRUCTURE"), "; - STRUCTURE");
  EXPECT_EQ(parts(";only a comment"), ";only a comment");
}

/// Returns the steps of an expression in the order of execution: "Q1 2 * 3 +", or the alarm.
std::string formula(const std::string& text) {
  const std::string line = "Q0 = " + text;
  const auto block = read_klartext_block(line, {0, static_cast<std::uint32_t>(line.size())});
  if (!block) return std::string(name_of(block.error().id));
  std::string all;
  for (std::uint16_t i = block->value.begin; i < block->value.end; ++i) {
    const KlartextStep& step = block->code[i];
    if (!all.empty()) all += ' ';
    switch (step.op) {
      case KlartextOp::number: all += std::to_string(static_cast<int>(step.number)); break;
      case KlartextOp::parameter: all += "Q" + std::to_string(step.index); break;
      case KlartextOp::negate: all += "neg"; break;
      case KlartextOp::add: all += "+"; break;
      case KlartextOp::subtract: all += "-"; break;
      case KlartextOp::multiply: all += "*"; break;
      case KlartextOp::divide: all += "/"; break;
      case KlartextOp::power: all += "^"; break;
      case KlartextOp::sin: all += "sin"; break;
      case KlartextOp::square: all += "sq"; break;
      default: all += "?"; break;
    }
  }
  return all;
}

TEST(klartext_formulas, bind_as_the_manual_says) {
  EXPECT_EQ(formula("5 * 3 + 2 * 10"), "5 3 * 2 10 * +");
  EXPECT_EQ(formula("- 2 ^ 2"), "2 neg 2 ^");
  EXPECT_EQ(formula("SQ 2 ^ 3"), "2 sq 3 ^");
  EXPECT_EQ(formula("- SIN 30"), "30 sin neg");
  EXPECT_EQ(formula("3 * - Q2"), "3 Q2 neg *");
  EXPECT_EQ(formula("(Q6 - Q5) / Q7"), "Q6 Q5 - Q7 /");
  EXPECT_EQ(formula("(1 + 2"), "bracket_not_closed");
  EXPECT_EQ(formula("1 +"), "expression_syntax");
  EXPECT_EQ(formula("Q2000"), "index_range");
}

TEST(klartext_formulas, end_for_any_depth) { EXPECT_EQ(formula(std::string(10'000, '(')), "nesting_too_deep"); }

TEST(klartext_blocks, are_read_over_several_lines) {
  const std::string text = "CYCL DEF 200 DRILLING ~\n Q200=+2 ;SET-UP ~\n Q201=-Q5 ;DEPTH~\n Q206=MAX";
  const auto block = read_klartext_block(text, {0, static_cast<std::uint32_t>(text.size())});
  ASSERT_TRUE(block);
  EXPECT_EQ(block->kind, KlartextKind::cycle_definition);
  EXPECT_EQ(block->number, 200);
  ASSERT_EQ(block->words.size(), 3u);
  EXPECT_EQ(block->words[0].number, 2);
  EXPECT_TRUE(block->words[1].value);
  EXPECT_EQ(block->words[2].text, "MAX");
}

}  // namespace
}  // namespace kadr::klartext_test
