// lang/block/statement_reader, lang/expression/expression_compiler, lang/expression/macro_arithmetic: the language of custom macros,
// spec/nct/23 23.1, 23.2.

#include <bit>
#include <map>
#include <random>

#include "config/machine/machine_axes.h"
#include "lang/expression/macro_arithmetic.h"
#include "lang/read_block.h"
#include "macro_trees.h"

namespace kadr::macro_test {
namespace {

using namespace test;

/// Returns the grammar with the axes X, Y and Z, as of a machine without a set-up.
const Grammar& nct() {
  static const ControlDef def = [] {
    ControlDef d = load_control("nct").value();
    EXPECT_EQ(fit_to_machine(d, {}), "");
    return d;
  }();
  return def.grammar;
}

/// The variables #1 … #33 of a test, some of them vacant; any other number is an alarm.
struct MacroVariables {
  std::map<int, double> values;

  double value(int n) const {
    const auto found = values.find(n);
    return found == values.end() ? vacant : found->second;
  }
  static bool exists(double number) { return number >= 0 && number <= 33 && number == std::floor(number); }
  bool known(double number, double& to) const {
    if (!exists(number)) return false;
    to = value(static_cast<int>(number));
    return true;
  }
  Result<double> variable(double number, Span where) const {
    if (is_vacant(number)) number = 0;
    if (!exists(number)) return fail(alarm(AlarmId::variable_unknown, where, number));
    return value(static_cast<int>(number));
  }
  Result<double> parameter(int, Span where) const { return fail(alarm(AlarmId::variable_not_set, where)); }
  Result<double> element(double symbol, double index, Span) const {
    return nct().symbols[static_cast<std::size_t>(symbol)].number + index - nct().symbols[static_cast<std::size_t>(symbol)].first_index;
  }
  Result<double> control_value(double number, double bit, double index, Span) const {
    return (is_vacant(number) ? 0 : number) + (is_vacant(bit) ? 0 : bit / 10) + (is_vacant(index) ? 0 : index / 100);
  }
};

const MacroVariables some_variables{{{1, 5}, {2, -2.5}, {3, 0}, {5, 3}, {7, 1e6}, {33, 0.25}}};

/// Returns the value of the expression after `#100=`, or the alarm as "id: characters".
std::string assigned(const std::string& expression) {
  const Sample sample("#100=" + expression, nct());
  if (!sample.alarm.empty()) return sample.alarm;
  const auto value = evaluate(sample.block, sample.block.statement.value, some_variables);
  if (!value) return std::string(name_of(value.error().id)) + ": " + std::string(sample.block.text_of(value.error().where));
  return is_vacant(*value) ? "vacant" : number_text(*value);
}

TEST(macro_expressions, have_the_values_of_the_manual) {
  struct Case {
    const char* text;
    const char* value;
  };
  const Case cases[] = {
      {"27MOD4", "3"},
      {"ASIN[-0.5]", "-30"},
      {"ACOS[-0.5]", "120"},
      {"ATAN[-0.5]", "-26.56505118"},
      {"EXP1", "2.718281828"},
      {"ABS[-3.1]", "3.1"},
      {"ABS[5.25]", "5.25"},
      {"FIX4.8", "4"},
      {"FIX[-6.7]", "-6"},
      {"FUP12.1", "13"},
      {"FUP[-7.3]", "-8"},
      {"NOT0", "-1"},
      {"SIN30-#1", "-4.5"},
      {"TAN135", "-1"},
      {"#1+#2*COS60", "3.75"},
      {"LN[EXP[2]]", "2"},
      {"SQRT[#5+1]", "2"},
      {"-#1", "-5"},
      {"--#1", "5"},
      {"2*-3", "-6"},
      {"10-4-3", "3"},
      {"16/4/2", "2"},
      {"7OR8AND12", "15"},
      {"[7OR8]AND12", "12"},
      {"1XOR3OR4", "6"},
      {"[16777215AND-1]XOR[-1694498816]", "-1677721601"},
      {"#[#5-2]", "5"},
      {"#[1]", "5"},
      {"#0", "vacant"},
      {"#4", "vacant"},
      {"[#4]", "vacant"},
      {"+#4", "vacant"},
      {"-#4", "0"},
      {"#4*3", "0"},
      {"#4+#4", "0"},
      {"SIN#4", "0"},
      {"#[#4]", "vacant"},
      {"0000.50", "0.5"},
      {".25", "0.25"},
      {"3.", "3"},
      {"COS[[[#1-#5]*2+1]*#3]", "1"},
  };
  for (const Case& c : cases) EXPECT_EQ(assigned(c.text), c.value) << c.text;
}

TEST(macro_expressions, give_their_alarms_at_their_place) {
  struct Case {
    const char* text;
    const char* alarm;
  };
  const Case cases[] = {
      {"1/0", "division_by_zero: /0"},
      {"1MOD#3", "division_by_zero: MOD#3"},
      {"SQRT[-1]", "root_of_negative: SQRT[-1]"},
      {"TAN90", "tangent_of_right_angle: TAN90"},
      {"TAN[-270]", "tangent_of_right_angle: TAN[-270]"},
      {"ASIN1.001", "argument_above_one: ASIN1.001"},
      {"LN0", "argument_not_positive: LN0"},
      {"4294967296AND1", "bits_out_of_range: AND1"},
      {"EXP1000", "not_a_number: EXP1000"},
      {"1+2]", "expression_syntax: ]"},
      {"[1+2", "bracket_not_closed: ["},
      {"##5", "expression_syntax: #"},
      {"1+", "expression_syntax: "},
      {"SINX", "expression_syntax: X"},
      {"POW[2]", "function_unknown: POW"},
      {"1=2", "expression_syntax: ="},
      {"1 2", "expression_syntax: 2"},
      {"#1.5", "number_damaged: 1.5"},
      {"AXNUM[U]", "illegal_address: U"},
  };
  for (const Case& c : cases) EXPECT_EQ(assigned(c.text), c.alarm) << c.text;
}

TEST(macro_expressions, of_a_word_keep_what_is_vacant) {
  const Sample sample("X-#4 Y[#4] Z-[#1+1] G#33", nct());
  ASSERT_EQ(sample.alarm, "");
  const auto value = [&](std::size_t i) { return *evaluate(sample.block, sample.block.words[i].expression, some_variables); };
  EXPECT_TRUE(is_vacant(value(0)));
  EXPECT_TRUE(is_vacant(value(1)));
  EXPECT_EQ(value(2), -6);
  EXPECT_EQ(value(3), 0.25);
}

TEST(remainder_of, is_fmod_bit_by_bit) {
  std::mt19937_64 choose(3);
  const auto any = [&] {
    const auto whole = static_cast<double>(static_cast<std::int64_t>(choose()) >> choose() % 64);
    return choose() % 3 == 0 ? std::ldexp(whole, -static_cast<int>(choose() % 70)) : whole;
  };
  for (int i = 0; i < 200'000; ++i) {
    const double a = any(), b = any();
    if (b == 0) continue;
    EXPECT_EQ(std::bit_cast<std::uint64_t>(remainder_of(a, b)), std::bit_cast<std::uint64_t>(std::fmod(a, b))) << a << ' ' << b;
  }
}

TEST(macro_statements, are_read_with_their_parts) {
  struct Case {
    const char* text;
    StatementKind kind;
    int loop;
    int conditions;
  };
  const Case cases[] = {
      {"#1=2", StatementKind::assign, 0, 0},
      {"#[1+1]=2(NOTE)", StatementKind::assign, 0, 0},
      {"if[#1eq2]then#3=4", StatementKind::assign, 0, 1},
      {"if[#1eq2]then g0x5", StatementKind::words, 0, 1},
      {"IF[#1EQ2]IF[#1LT9],C5", StatementKind::words, 0, 2},
      {"IF[#1EQ2]#3=4", StatementKind::assign, 0, 1},
      {"IF[#1EQ2]IF[#2EQ3]GOTO[#1+10]", StatementKind::go_to, 0, 2},
      {"WHILE[#1LT-5.39]DO3", StatementKind::loop, 3, 1},
      {"DO 1", StatementKind::loop, 1, 0},
      {"END2", StatementKind::loop_end, 2, 0},
      {"N5 GOTO 10", StatementKind::go_to, 0, 0},
      {"#3000=12(TOO HOT)", StatementKind::message, 0, 0},
      {"#_MSG=(HERE)", StatementKind::message, 0, 0},
      {"POPEN31", StatementKind::open_port, 0, 0},
      {"FOPEN1P12", StatementKind::open_file, 0, 0},
      {"FOPEN2<data.txt>", StatementKind::open_file, 0, 0},
      {"DPRNT[X#130[53]]", StatementKind::print_decimal, 0, 0},
      {"G1X1", StatementKind::none, 0, 0},
  };
  for (const Case& c : cases) {
    const Sample sample(c.text, nct());
    EXPECT_EQ(sample.alarm, "") << c.text;
    EXPECT_EQ(sample.block.statement.kind, c.kind) << c.text;
    EXPECT_EQ(sample.block.statement.loop, c.loop) << c.text;
    EXPECT_EQ(sample.block.statement.condition_count, c.conditions) << c.text;
  }
}

TEST(macro_statements, that_are_wrong_say_where) {
  struct Case {
    const char* text;
    const char* alarm;
  };
  const Case cases[] = {
      {"DO4", "do_number: DO4"},
      {"WHILE[#1EQ1]", "while_without_do: WHILE[#1EQ1]"},
      {"WHILE[#1=1]DO1", "terminator_wrong: ="},
      {"IF[#1=1]GOTO5", "terminator_wrong: ="},
      {"IF#1EQ1GOTO5", "expression_syntax: #"},
      {"IF[#1EQ1]", "expression_syntax: "},
      {"IF[#1EQ1]THEN", "expression_syntax: "},
      {"IF[#1]GOTO5", "expression_syntax: ]"},
      {"IF[#1EQ1]DO1", "expression_syntax: D"},
      {"G1X1#1=2", "statement_not_alone: #"},
      {"#1=2#2=3", "expression_syntax: #"},
      {"#1=2X5", "expression_syntax: X"},
      {"X5GOTO1", "statement_not_alone: GO"},
      {"IF[#1EQ1]THENX5#1=2", "statement_not_alone: #"},
      {"IF[#1EQ1]5", "expression_syntax: 5"},
      {"GOTO", "expression_syntax: "},
      {"N#1X5", "number_by_variable: N#"},
      {"PRM[1]=2", "illegal_address: PRM"},
      {"FOPEN1", "program_name_missing: FOPEN1"},
      {"DPRNT[X", "bracket_not_closed: ["},
  };
  for (const Case& c : cases) EXPECT_EQ(Sample(c.text, nct()).alarm, c.alarm) << c.text;
}

TEST(macro_statements, leave_nothing_to_the_block_behind_them) {
  for (const char* faulty : {"IF[#1EQ1]", "WHILE[#1EQ1]", "IF[#1EQ1]GOTO", "IF", "#1=", "FOPEN1"}) {
    Block block;
    EXPECT_FALSE(lex_block(faulty, 0, true, nct(), block)) << faulty;
    block.clear();
    ASSERT_TRUE(lex_block("END1", 0, true, nct(), block)) << faulty;
    EXPECT_EQ(block.statement.condition_count, 0) << faulty;
    EXPECT_FALSE(block.statement.with_if) << faulty;
  }
}

TEST(macro_statements, nest_as_deep_as_the_limit_and_no_deeper) {
  const auto nested = [](std::size_t depth) { return std::string(depth, '[') + "1" + std::string(depth, ']'); };
  EXPECT_EQ(assigned(nested(limits::expression_depth)), "1");
  EXPECT_EQ(assigned(nested(limits::expression_depth + 1)).substr(0, 16), "nesting_too_deep");
}

RC_GTEST_PROP(macro_expressions, have_the_value_of_the_tree, ()) {
  Choices choose = choices(200);
  const Tree tree = random_tree(choose, 5, 9);
  TreePrinter print(choose, choose.one_in(3));
  const std::string text = "#100=" + print(tree);
  const TreeValue expected = value_of(tree, [](double n) -> TreeValue {
    if (is_vacant(n)) n = 0;
    if (!MacroVariables::exists(n)) return AlarmId::variable_unknown;
    return some_variables.value(static_cast<int>(n));
  });
  const Sample sample(text, nct());
  if (!sample.alarm.empty()) RC_FAIL(text + " gave " + sample.alarm);
  const auto value = evaluate(sample.block, sample.block.statement.value, some_variables);
  const TreeValue got = value ? TreeValue(*value) : TreeValue(value.error().id);
  RC_TAG(expected.index() == 0);
  if (!same_value(got, expected)) RC_FAIL(text + " gave " + value_text(got) + ", not " + value_text(expected));
}

RC_GTEST_PROP(macro_conditions, are_those_of_the_tree, ()) {
  Choices choose = choices(100);
  const Tree left = random_tree(choose, 2, 9), right = random_tree(choose, 2, 9);
  const std::string relation = choose.of(tree_relations);
  TreePrinter print(choose, choose.one_in(3));
  const std::string text =
      "IF" + print.blank() + "[" + print(left) + " " + print.spelled(relation) + print.blank() + print(right) + "]GOTO1";
  const auto read = [](double n) -> TreeValue {
    if (is_vacant(n)) n = 0;
    if (!MacroVariables::exists(n)) return AlarmId::variable_unknown;
    return some_variables.value(static_cast<int>(n));
  };
  const TreeValue a = value_of(left, read), b = value_of(right, read);
  const Sample sample(text, nct());
  if (!sample.alarm.empty()) RC_FAIL(text + " gave " + sample.alarm);
  const auto value = evaluate(sample.block, sample.block.statement.conditions[0], some_variables);
  const TreeValue got = value ? TreeValue(*value) : TreeValue(value.error().id);
  TreeValue expected = a.index() == 1 ? a : b;
  if (a.index() == 0 && b.index() == 0) expected = holds(relation, std::get<0>(a), std::get<0>(b)) ? 1.0 : 0.0;
  if (!same_value(got, expected)) RC_FAIL(text + " gave " + value_text(got) + ", not " + value_text(expected));
}

}  // namespace
}  // namespace kadr::macro_test
