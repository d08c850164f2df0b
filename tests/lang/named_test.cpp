// lang/named: lines and blocks of a control with names (spec/sinumerik 2, 3, 7 to 9).

#include "lang/named/named_parser.h"
#include "lang/named/named_reader.h"
#include "lang/read_block.h"

namespace kadr::named_test {
namespace {

using namespace test;

const Grammar& grammar() {
  static const Grammar names = [] {
    Grammar made;
    made.named_blocks = true;
    return made;
  }();
  return names;
}

/// Returns the parts of a line: "/skip N number label: statement ;comment".
std::string parts(const std::string& line) {
  const Sample sample(line, grammar());
  if (!sample.alarm.empty()) return sample.alarm;
  const Block& b = sample.block;
  std::string text;
  if (b.skip != 0) text += "/" + std::to_string(b.skip % 10) + " ";
  if (b.has_number) text += std::string(b.main_block ? ":" : "N") + std::to_string(b.number) + " ";
  if (b.statement.label_where.end > 0) text += std::string(b.text_of(b.statement.label_where)) + ": ";
  text += "[" + std::string(b.text_of(b.statement.text)) + "]";
  for (const Span comment : b.comments) text += ";" + std::string(b.text_of(comment));
  return text;
}

TEST(named_lines, have_parts) {
  EXPECT_EQ(parts("N10 G0 X10 ; rapid"), "N10 [G0 X10]; rapid");
  EXPECT_EQ(parts("/3 N10 LAB1: X=R1"), "/3 N10 LAB1: [X=R1]");
  EXPECT_EQ(parts("/X1"), "/0 [X1]");
  EXPECT_EQ(parts(":20 T1"), ":20 [T1]");
  EXPECT_EQ(parts("MSG(\"a;b\")"), "[MSG(\"a;b\")]");
  EXPECT_EQ(parts("N10G0X10Y20Z-5"), "N10 [G0X10Y20Z-5]");
  EXPECT_EQ(parts("%_N_PART1_MPF"), "[%_N_PART1_MPF]");
  EXPECT_EQ(parts("  ENDE:"), "ENDE: []");
  EXPECT_EQ(parts("/12 X1"), "skip_level_wrong: /12");
}

/// Returns the steps of an expression in the order of execution: "R1 2 * 3 +".
std::string steps(const NamedBlock& block, NamedExpression expression) {
  std::string text;
  for (std::uint32_t i = expression.begin; i < expression.end; ++i) {
    const NamedStep& step = block.code[i];
    text += text.empty() ? "" : " ";
    switch (step.kind) {
      case NamedStep::Kind::apply: text += (step.operands == 1 ? "~" : "") + std::string(written(step.op)); break;
      case NamedStep::Kind::parameter: text += step.operands == 0 ? "R" + number_text(step.number) : "R[]"; break;
      case NamedStep::Kind::text: text += "\"" + step.name + "\""; break;
      case NamedStep::Kind::name: text += step.name + (step.operands == 0 ? "" : "[" + std::to_string(step.operands) + "]"); break;
      case NamedStep::Kind::call: text += step.name + "(" + std::to_string(step.operands) + ")"; break;
      case NamedStep::Kind::omitted: text += "_"; break;
      default: text += number_text(step.number); break;
    }
  }
  return text;
}

/// Returns the items of a block: "X=R1 2 *|G1|TRANS".
std::string items(const std::string& text) {
  const auto read = read_named_block(text, {0, static_cast<std::uint32_t>(text.size())});
  if (!read) {
    const Span at = read.error().where;
    return std::string(name_of(read.error().id)) + ": " + text.substr(at.begin, at.end - at.begin);
  }
  std::string all;
  for (const NamedItem& item : read->items) {
    all += all.empty() ? "" : "|";
    all += item.name;
    if (item.extension >= 0) all += std::to_string(item.extension);
    if (item.kind == NamedItem::Kind::word && !item.has_equals) all += number_text(item.number);
    for (const NamedExpression& each : item.arguments) all += "{" + steps(*read, each) + "}";
    if (item.form == WordForm::absolute) all += "=AC";
    if (item.form == WordForm::incremental) all += "=IC";
    if (item.value) all += "=" + steps(*read, item.value);
    if (!item.text.empty() && item.kind == NamedItem::Kind::jump) all += " " + item.text;
  }
  return all;
}

TEST(named_blocks, are_words_and_names) {
  EXPECT_EQ(items("N10"), "N10");
  EXPECT_EQ(items("G0X10Y20Z-.5"), "G0|X10|Y20|Z-0.5");
  EXPECT_EQ(items("X 10 Y=R1*2"), "X10|Y=R1 2 *");
  EXPECT_EQ(items("X1=10 S2=500 CR=5 M3"), "X1=10|S2=500|CR=5|M3");
  EXPECT_EQ(items("X=IC(5) Z=AC(-R2)"), "X=IC=5|Z=AC=R2 ~-");
  EXPECT_EQ(items("R1=1.5EX2 R[R1+2]='HFF'"), "R1=150|R{R1 2 +}=255");
  EXPECT_EQ(items("TRANS X10 Y5"), "TRANS|X10|Y5");
  EXPECT_EQ(items("CYCLE81(20,0,2,-10)"), "CYCLE81{20}{0}{2}{10 ~-}");
  EXPECT_EQ(items("CYCLE81(20,,2,)"), "CYCLE81{20}{_}{2}{_}");
  EXPECT_EQ(items("$P_UIFR[1,X,TR]=30"), "$P_UIFR{1}{X}{TR}=30");
  EXPECT_EQ(items("T=\"MILL_20\" D1"), "T=\"MILL_20\"|D1");
}

TEST(named_blocks, jump) {
  EXPECT_EQ(items("GOTOF lab1"), "GOTOF LAB1");
  EXPECT_EQ(items("GOTOB N100"), "GOTOB N100");
  EXPECT_EQ(items("GOTOF \"LAB\"<<R1"), "GOTOF=\"LAB\" R1 <<");
  EXPECT_EQ(items("IF R1==1 GOTOF A1A IF (R1==2) GOTOF BB"), "IF=R1 1 ==|GOTOF A1A|IF=R1 2 ==|GOTOF BB");
  EXPECT_EQ(items("CASE(R1) OF 1 GOTOF LA1 DEFAULT GOTOF LA9"), "CASE=R1|GOTOF{1} LA1|GOTOF LA9");
}

TEST(named_expressions, bind_as_the_manual_says) {
  EXPECT_EQ(items("R1=2+3*4-6/2"), "R1=2 3 4 * + 6 2 / -");
  EXPECT_EQ(items("R1=1 B_OR 2 B_AND 6"), "R1=1 2 6 B_AND B_OR");
  EXPECT_EQ(items("R1=AA OR BB AND CC"), "R1=AA BB CC AND OR");
  EXPECT_EQ(items("R1=NOT AA OR BB"), "R1=AA ~NOT BB OR");
  EXPECT_EQ(items("R1=R2==R3 AND R4"), "R1=R2 R3 R4 AND ==");
  EXPECT_EQ(items("R1=-R2*3"), "R1=R2 ~- 3 *");
  EXPECT_EQ(items("MSG(\"X\"<<R1+2)"), "MSG{\"X\" R1 2 + <<}");
  EXPECT_EQ(items("F1=CTRANS(X,1):CROT(Z,90)"), "F1=X 1 CTRANS(2) Z 90 CROT(2) :");
}

TEST(named_blocks, refuse_faults_at_their_place) {
  EXPECT_EQ(items("X-R1"), "number_missing: X-R");
  EXPECT_EQ(items("R1=(2+3"), "bracket_not_closed: (");
  EXPECT_EQ(items("R1=1==2==3"), "comparison_chained: ==");
  EXPECT_EQ(items("R1=2+"), "expression_syntax: ");
  EXPECT_EQ(items("MSG(\"open)"), "bracket_not_closed: \"");
  EXPECT_EQ(items("X=CAC(2)"), "not_available: CAC");
  EXPECT_EQ(items("G0 X1 !"), "unexpected_character: !");
}

TEST(named_definitions, name_types_and_parameters) {
  const std::string define = "DEF REAL AA=2.5, BB[3,4]", procedure = "PROC ONE(REAL X, VAR INT NN, INT DD=5) SAVE";
  const auto made = read_named_block(define, {0, static_cast<std::uint32_t>(define.size())});
  ASSERT_TRUE(made);
  EXPECT_EQ(made->kind, NamedKind::definition);
  ASSERT_EQ(made->definitions.size(), 2u);
  EXPECT_EQ(made->definitions[0].initial.size(), 1u);
  EXPECT_EQ(made->definitions[1].sizes.size(), 2u);
  const auto program = read_named_block(procedure, {0, static_cast<std::uint32_t>(procedure.size())});
  ASSERT_TRUE(program);
  EXPECT_EQ(program->name, "ONE");
  ASSERT_EQ(program->definitions.size(), 3u);
  EXPECT_TRUE(program->definitions[1].by_reference);
  EXPECT_EQ(program->definitions[2].initial.size(), 1u);
  EXPECT_EQ(program->attributes, std::vector<std::string>{"SAVE"});
}

}  // namespace
}  // namespace kadr::named_test
