// The section [expressions] of a control file: rows that a file adds, and what is refused.

#include <gtest/gtest.h>

#include "config/control/control_file.h"
#include "config/machine/machine_axes.h"
#include "control/control.h"
#include "lang/expression/expression.h"

namespace kadr::expression_rows_test {
namespace {

std::string fault_of(const std::string& rows, const std::string& base = "mach3") {
  const auto def = parse_control("id = \"own\"\nextends = \"" + base + "\"\nname = {en = \"x\", ru = \"x\"}\n" + rows, "own.toml");
  return def ? "" : def.error();
}

/// Returns the values of #1 … after a program has run.
std::map<std::string, double> variables_of(const std::string& rows, const std::string& program) {
  const auto def = parse_control("id = \"own\"\nextends = \"mach3\"\nname = {en = \"x\", ru = \"x\"}\n" + rows, "own.toml");
  if (!def) throw std::runtime_error(def.error());
  Control control(*def, {}, Program{"p", text_source(program), {}}, RunLimits{});
  ActionBatch batch;
  Control::State state = Control::State::running;
  while (state == Control::State::running) state = control.run(batch);
  EXPECT_EQ(state, Control::State::ended) << name_of(control.report().alarm.id);
  std::map<std::string, double> values;
  for (const auto& [name, value] : control.ending().variables) values[name] = value;
  return values;
}

TEST(expression_rows, of_one_s_own_are_added_to_those_of_the_base) {
  const auto values = variables_of(
      "[expressions.operators]\n\"<=\" = {does = \"less_equal\", binding = 1}\n\"^\" = {does = \"power\", binding = 4}\nEQ = {does = "
      "\"equal\", binding = 1}\n"
      "[expressions.functions]\nKOREN = {does = \"sqrt\"}\nARC = {does = \"atan\", operand = \"pair\"}\nNEG = {does = \"fix\", operand = "
      "\"value\"}\n",
      "#1=[2^3+koren[16]]\n#2=[1 <= 2]\n#3=[3 <= 2]\n#4=[#1 EQ 12]\n#5=ARC[1]/[1]\n#6=[2*3**2]\n#7=[NEG 2.7+1]\nM30\n");
  EXPECT_EQ(values.at("#1"), 12);
  EXPECT_EQ(values.at("#2"), 1);
  EXPECT_EQ(values.at("#3"), 0);
  EXPECT_EQ(values.at("#4"), 1);
  EXPECT_EQ(values.at("#5"), 45);
  EXPECT_EQ(values.at("#6"), 18);
  EXPECT_EQ(values.at("#7"), 3);
}

TEST(expression_rows, change_how_tightly_an_operator_binds) {
  EXPECT_EQ(variables_of("[expressions.operators]\n\"+\" = {does = \"add\", binding = 4}\n", "#1=[2*3+4]\nM30\n").at("#1"), 14);
}

/// The base has no expressions, and the file only switches them on.
TEST(expression_rows, that_nobody_writes_are_those_of_RS274) {
  const auto def = parse_control(
      "id = \"own\"\nextends = \"gost\"\nname = {en = \"x\", ru = \"x\"}\n[grammar]\nexpressions = true\nvariables = 99\n", "own.toml");
  ASSERT_TRUE(def) << def.error();
  EXPECT_TRUE(def->grammar.expression.operators.has("**"));
  EXPECT_TRUE(def->grammar.expression.functions.has("SQRT"));
  EXPECT_TRUE(load_control("gost")->grammar.expression.operators.all().empty());
}

/// Fanuc's custom macros have comparisons as operators: a condition is
/// any expression. A control without them still requires a relation.
TEST(expression_rows, may_make_a_condition_of_any_expression) {
  const auto compiles = [](const std::string& rows, std::string_view text) {
    const auto def = parse_control("id = \"own\"\nextends = \"nct\"\nname = {en = \"x\", ru = \"x\"}\n" + rows, "own.toml");
    Block block;
    Cursor cursor{text, 0};
    return compile_condition(cursor, def.value().grammar, block) && cursor.at == text.size();
  };
  const std::string rows =
      "[expressions.operators]\nEQ = {does = \"equal\", binding = 1}\nLT = {does = \"less\", binding = 1}\n"
      "AND = {does = \"logic_and\"}\n";
  for (const char* const text : {"[#1 EQ 2]", "[[#1 EQ 2] AND [#3 LT 4]]", "[#1 GT 2]"}) EXPECT_TRUE(compiles(rows, text)) << text;
  EXPECT_TRUE(compiles("", "[#1 EQ 2]"));
  for (const char* const text : {"[#1]", "[#1 AND 2]", "[[#1 EQ 2] AND [#3 LT 4]]"}) EXPECT_FALSE(compiles("", text)) << text;
}

/// AXNUM[…] keeps its meaning although a function's name is the beginning of AXNUM and is also written with a bracket.
TEST(expression_rows, do_not_hide_axnum) {
  auto def = parse_control(
      "id = \"own\"\nextends = \"nct\"\nname = {en = \"x\", ru = \"x\"}\n[expressions.functions]\nAXN = {does = \"abs\"}\n", "own.toml");
  ASSERT_TRUE(def) << def.error();
  ASSERT_EQ(fit_to_machine(*def, {}), "");
  for (const std::string_view text : {"AXNUM[X]", "AXNUM[Z]+AXN[1]"}) {
    Block block;
    Cursor cursor{text, 0};
    const auto compiled = compile_macro_value(cursor, def->grammar, block, MacroValue::sum);
    ASSERT_TRUE(compiled) << text << " " << name_of(compiled.error().id);
    EXPECT_EQ(cursor.at, text.size());
    EXPECT_EQ(block.code[0].number, text[6] == 'X' ? 1 : 3);
  }
}

TEST(expression_rows, that_cannot_be_are_refused_by_name) {
  const std::pair<const char*, const char*> refused[] = {
      {"[expressions]\noperator = {}\n", "own.toml:5: unknown key 'operator', nearest: 'operators'"},
      {"[expressions]\noperators = 5\n", "own.toml:5: operators must be a table"},
      {"[expressions.operators]\n\"<\" = 5\n", "own.toml:5: < must be a table"},
      {"[expressions.operators]\n\"<\" = {does = \"les\"}\n", "own.toml:5: unknown operation 'les', nearest: 'less'"},
      {"[expressions.operators]\n\"<\" = {}\n", "own.toml:5: unknown operation ''"},
      {"[expressions.operators]\n\"<\" = {does = \"sin\"}\n", "own.toml:5: unknown operation 'sin'"},
      {"[expressions.functions]\nF = {does = \"add\"}\n", "own.toml:5: unknown operation 'add'"},
      {"[expressions.functions]\nF = {does = \"sin\", operand = \"pair\"}\n", "own.toml:5: unknown operation 'sin'"},
      {"[expressions.functions]\nF = {does = \"sin\", operand = \"both\"}\n", "own.toml:5: operand: bracket, value or pair"},
      {"[expressions.functions]\n\"F2 \" = {does = \"sin\"}\n", "own.toml:5: 'F2 ': letters A to Z"},
      {"[expressions.functions]\n\"<\" = {does = \"sin\"}\n", "own.toml:5: '<': letters A to Z"},
      {"[expressions.operators]\n\"\" = {does = \"add\"}\n", "own.toml:5: '': letters A to Z"},
      {"[expressions.operators]\n\"A<\" = {does = \"add\"}\n", "own.toml:5: 'A<': letters A to Z"},
      {"[expressions.operators]\n\"[\" = {does = \"add\"}\n", "own.toml:5: '[': letters A to Z"},
      {"[expressions.operators]\nABCDEFGHIJKLMNOPQ = {does = \"add\"}\n", "own.toml:5: 'ABCDEFGHIJKLMNOPQ': letters A to Z"},
      {"[expressions.operators]\n\"<\" = {does = \"less\", binding = 10}\n", "own.toml:5: binding must be a whole number from 0 to 9"},
      {"[expressions.operators]\n\"<\" = {does = \"less\", operand = \"value\"}\n", "own.toml:5: unknown key 'operand'"},
      {"[expressions.relations]\nPLUS = {does = \"add\"}\n", "own.toml:5: unknown operation 'add'"},
      {"[expressions.functions]\nsin = {does = \"cos\"}\n", "stands twice"},
  };
  for (const auto& [rows, fault] : refused) EXPECT_NE(fault_of(rows).find(fault), std::string::npos) << rows << fault_of(rows);
  EXPECT_NE(fault_of("[expressions.functions]\nF = {does = \"sin\"}\n", "gost").find("without [grammar] expressions = true"),
            std::string::npos);
  std::string many = "[expressions.functions]\n";
  for (char a = 'A'; a <= 'Z'; ++a)
    for (const char b : {'A', 'B', 'C'}) many += std::string("Q") + a + b + " = {does = \"sin\"}\n";
  EXPECT_NE(fault_of(many).find("functions: more than 64 rows"), std::string::npos) << fault_of(many);
}

}  // namespace
}  // namespace kadr::expression_rows_test
