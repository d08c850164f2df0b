// lang/expression/expression: values given by expressions, spec mach3 1; sums with formal parameters, spec s2c42 3.

#include "lang/expression/expression.h"

#include <cmath>
#include <optional>

#include "choices.h"
#include "lang/read_block.h"

namespace kadr::expression_test {
namespace {

using namespace test;

/// The value of the text, or its alarm as "id: characters".
struct Value {
  std::optional<double> number;
  std::string alarm;
};

Value value_of(const std::string& text) {
  Block block;
  Cursor cursor{text, 0};
  const auto named = [&](const Alarm& a) {
    return std::string(name_of(a.id)) + ": " + text.substr(a.where.begin, a.where.end - a.where.begin);
  };
  const auto compiled = compile_value(cursor, grammar_of("mach3"), block);
  if (!compiled) return {{}, named(compiled.error())};
  if (cursor.at != text.size()) return {{}, "rest: " + text.substr(cursor.at)};
  const auto value = evaluate(block, *compiled, SampleVariables{});
  if (!value) return {{}, named(value.error())};
  return {*value, ""};
}

TEST(expressions, have_the_values_of_the_manual) {
  struct Case {
    const char* text;
    double value;
  };
  const Case cases[] = {
      {"12.5", 12.5},         {"[2]", 2},
      {"-[2]", -2},           {"[+2]", 2},
      {"[--2]", 2},           {"#5", 50},
      {"##2", 200},           {"#[1+1]", 20},
      {"-#3", -30},           {"[1+2*3]", 7},
      {"[[1+2]*3]", 9},       {"[7-2-1]", 4},
      {"[8/4/2]", 1},         {"[2*3**2]", 18},
      {"[2**3*2]", 16},       {"[2**3**2]", 64},
      {"[-2**2]", 4},         {"[7 MOD 3]", 1},
      {"[-7 MOD 3]", 2},      {"[7 mod -3]", 1},
      {"[1+7MOD3]", 2},       {"[1 AND 0]", 0},
      {"[2 and 3]", 1},       {"[1 OR 0]", 1},
      {"[1 XOR 1]", 0},       {"[1 OR 0 AND 0]", 0},
      {"[1+1 AND 0]", 0},     {"ABS[-3]", 3},
      {"SQRT[9]", 3},         {"ROUND[2.5]", 3},
      {"ROUND[-2.5]", -3},    {"FIX[2.8]", 2},
      {"FIX[-2.8]", -3},      {"FUP[2.1]", 3},
      {"FUP[-2.8]", -2},      {"EXP[0]", 1},
      {"LN[1]", 0},           {"sin[90]", 1},
      {"COS[90]", 0},         {"COS[180]", -1},
      {"TAN[180]", 0},        {"ATAN[1]/[0]", 90},
      {"ATAN[0]/[-1]", 180},  {"ATAN[-1]/[0]", -90},
      {"[ATAN[0]/[1]/2]", 0}, {"[ 1 + 2 ]", 3},
      {"[1.5.5]", NAN},
  };
  for (const Case& c : cases) {
    const Value value = value_of(c.text);
    if (std::isnan(c.value)) EXPECT_NE(value.alarm, "") << c.text;
    else EXPECT_EQ(value.number, c.value) << c.text << " " << value.alarm;
  }
  EXPECT_NEAR(*value_of("ACOS[0.5]").number, 60, 1e-12);
  EXPECT_NEAR(*value_of("ASIN[0.5]").number, 30, 1e-12);
  EXPECT_NEAR(*value_of("ATAN[1]/[-1]").number, 135, 1e-12);
  EXPECT_NEAR(*value_of("SIN[30]").number, 0.5, 1e-15);
}

TEST(expressions, that_are_wrong_name_the_place) {
  struct Fault {
    const char* text;
    const char* alarm;
  };
  const Fault faults[] = {
      {"[1+]", "expression_syntax: ]"},       {"[]", "expression_syntax: ]"},
      {"[1+2", "bracket_not_closed: ["},      {"[1 2]", "expression_syntax: 2"},
      {"[1 ? 2]", "operator_unknown: ?"},     {"[1 EQ 2]", "operator_unknown: EQ"},
      {"[1 GE 2]", "operator_unknown: GE"},   {"FOO[1]", "function_unknown: FOO"},
      {"SIN 30", "function_unknown: SIN"},    {"ATAN[1]", "expression_syntax: ATAN[1]"},
      {"[.]", "number_damaged: ."},           {"#", "expression_syntax: "},
      {"[1/0]", "division_by_zero: /0"},      {"[5 MOD 0]", "division_by_zero: MOD 0"},
      {"SQRT[-1]", "not_a_number: SQRT[-1]"}, {"LN[0]", "not_a_number: LN[0]"},
      {"ASIN[2]", "not_a_number: ASIN[2]"},   {"TAN[90]", "not_a_number: TAN[90]"},
      {"[10**400]", "not_a_number: **400"},
  };
  for (const Fault& f : faults) EXPECT_EQ(value_of(f.text).alarm, f.alarm) << f.text;
}

TEST(expressions, nest_sixty_four_deep_and_no_deeper) {
  const auto nested = [](std::size_t depth) { return std::string(depth, '[') + "1" + std::string(depth, ']'); };
  EXPECT_EQ(value_of(nested(limits::expression_depth)).number, 1);
  EXPECT_EQ(value_of(nested(limits::expression_depth + 1)).alarm, "nesting_too_deep: [");
  EXPECT_EQ(value_of("[" + std::string(1000, '-') + "1]").alarm, "nesting_too_deep: -");
}

TEST(parameters, are_added_as_raw_digits) {
  const SampleVariables variables{{{1, 500}, {2, -300}, {0, 60}}};
  struct Case {
    const char* text;
    double value;
  };
  const Case cases[] = {{"X+R1", 0.5},       {"X-R1", -0.5},    {"XR1", 0.5},  {"Z-1200+R2", -1.5},
                        {"Z-1200-R2", -0.9}, {"Z1200+R1", 1.7}, {"Z-R2", 0.3}, {"F+R0", 60}};
  for (const Case& c : cases) {
    const Sample sample(c.text, words_of("s2c42"));
    ASSERT_EQ(sample.alarm, "") << c.text;
    const auto value = evaluate(sample.block, sample.block.words[0].expression, variables);
    ASSERT_TRUE(value) << c.text;
    EXPECT_EQ(*value, c.value) << c.text;
  }
}

TEST(parameters, never_set_are_an_alarm_at_the_word) {
  const Sample sample("X+R1 Z-1200+R7", words_of("s2c42"));
  const auto value = evaluate(sample.block, sample.block.words[1].expression, SampleVariables{});
  ASSERT_FALSE(value);
  EXPECT_EQ(value.error().id, AlarmId::variable_not_set);
  EXPECT_EQ(sample.block.text_of(value.error().where), "Z-1200+R7");
}

TEST(assignments, wait_until_the_block_is_carried_out) {
  const Sample sample("#1=5 X#1 #[1+1]=[#1*2]", words_of("mach3"));
  ASSERT_EQ(sample.alarm, "");
  EXPECT_EQ(shown(sample.block), "X?");
  ASSERT_EQ(sample.block.assignments.size(), 2u);
  EXPECT_EQ(sample.block.text_of(sample.block.assignments[1].where), "#[1+1]=[#1*2]");
  EXPECT_EQ(*evaluate(sample.block, sample.block.assignments[1].target, SampleVariables{}), 2);
  EXPECT_EQ(*evaluate(sample.block, sample.block.assignments[1].value, SampleVariables{}), 20);
}

// ---- the slow reference: it works on the text itself and splits it at the last operator that binds least

using Twin = std::optional<double>;  // nullopt: the text has no value
Twin twin(std::string_view text);

std::string_view trimmed(std::string_view text) {
  while (!text.empty() && text.front() == ' ') text.remove_prefix(1);
  while (!text.empty() && text.back() == ' ') text.remove_suffix(1);
  return text;
}

Twin finite(double x) { return std::isfinite(x) ? Twin(x) : Twin(); }

Twin joined(std::string_view op, double a, double b) {
  if (op == "**") return finite(std::pow(a, b));
  if (op == "*") return finite(a * b);
  if (op == "/") return b == 0 ? Twin() : finite(a / b);
  if (op == "MOD") return b == 0 ? Twin() : Twin(std::fmod(a, b) < 0 ? std::fmod(a, b) + std::fabs(b) : std::fmod(a, b));
  if (op == "+") return finite(a + b);
  if (op == "-") return finite(a - b);
  if (op == "AND") return a != 0 && b != 0 ? 1.0 : 0.0;
  if (op == "OR") return a != 0 || b != 0 ? 1.0 : 0.0;
  return (a != 0) != (b != 0) ? 1.0 : 0.0;
}

Twin called(std::string_view name, double x) {
  if (name == "ABS") return std::fabs(x);
  if (name == "FIX") return std::floor(x);
  if (name == "FUP") return std::ceil(x);
  if (name == "ROUND") return std::round(x);
  if (name == "SQRT") return finite(std::sqrt(x));
  if (name == "SIN") return sincos_deg(x).sin;
  return x;
}

/// Returns true if the operator at `at` is between two values: it is neither a sign nor half of `**`.
bool splits_at(std::string_view text, std::size_t at, std::string_view op) {
  if (at == 0 || text.substr(at, op.size()) != op) return false;
  if (op == "*" && (text[at + 1] == '*' || text[at - 1] == '*')) return false;
  const char before = trimmed(text.substr(0, at)).empty() ? '\0' : trimmed(text.substr(0, at)).back();
  return before == ']' || before == '.' || (before >= '0' && before <= '9');
}

struct Split {
  std::size_t at = 0;
  std::string_view op;
};

Split last_split(std::string_view text, std::initializer_list<std::string_view> ops) {
  Split found;
  int depth = 0;
  for (std::size_t i = 0; i < text.size(); ++i) {
    depth += (text[i] == '[') - (text[i] == ']');
    for (const std::string_view op : ops)
      if (depth == 0 && splits_at(text, i, op)) found = {i, op};
  }
  return found;
}

Twin twin_value(std::string_view text) {
  if (text.front() == '-' || text.front() == '+') {
    const Twin x = twin_value(trimmed(text.substr(1)));
    return x ? Twin(text.front() == '-' ? -*x : *x) : x;
  }
  if (text.front() == '#') {
    const Twin x = twin_value(trimmed(text.substr(1)));
    return x ? Twin(*x * 10) : x;
  }
  const std::size_t bracket = text.find('[');
  if (bracket == std::string_view::npos) return std::strtod(std::string(text).c_str(), nullptr);
  const Twin x = twin(text.substr(bracket + 1, text.size() - bracket - 2));
  return x ? called(trimmed(text.substr(0, bracket)), *x) : x;
}

Twin twin(std::string_view text) {
  text = trimmed(text);
  for (const std::initializer_list<std::string_view>& ops :
       {std::initializer_list<std::string_view>{"AND", "OR", "XOR"}, {"+", "-"}, {"*", "/", "MOD"}, {"**"}}) {
    const Split split = last_split(text, ops);
    if (split.op.empty()) continue;
    const Twin a = twin(text.substr(0, split.at));
    const Twin b = twin(text.substr(split.at + split.op.size()));
    return a && b ? joined(split.op, *a, *b) : Twin();
  }
  return twin_value(text);
}

std::string random_expression(Choices& choose, int depth);

std::string random_value(Choices& choose, int depth) {
  static constexpr const char* numbers[] = {"1", "2", "0", "3.", ".5", "12.25", "100", "0.001", "7"};
  static constexpr const char* names[] = {"ABS", "FIX", "FUP", "ROUND", "SQRT", "SIN"};
  const std::size_t kind = depth == 0 ? 0 : choose.below(6);
  if (kind == 1) return "[" + random_expression(choose, depth - 1) + "]";
  if (kind == 2) return std::string(choose.of(names)) + "[" + random_expression(choose, depth - 1) + "]";
  if (kind == 3) return "-" + random_value(choose, depth - 1);
  if (kind == 4) return "#" + random_value(choose, depth - 1);
  return choose.of(numbers);
}

std::string random_expression(Choices& choose, int depth) {
  static constexpr const char* operators[] = {"+", "-", "*", "/", "**", "MOD", "AND", "OR", "XOR"};
  std::string text = random_value(choose, depth);
  for (std::size_t more = choose.below(4); more > 0; --more)
    text += std::string(choose.below(2), ' ') + choose.of(operators) + std::string(choose.below(2), ' ') + random_value(choose, depth);
  return text;
}

RC_GTEST_PROP(expressions, have_the_value_of_the_slow_twin, ()) {
  Choices choose = choices(200);
  const std::string text = "[" + random_expression(choose, 4) + "]";
  const Value value = value_of(text);
  const Twin expected = twin(text.substr(1, text.size() - 2));
  RC_TAG(expected.has_value());
  if (!(value.number == expected))
    RC_FAIL(text + " gave " + (value.number ? number_text(*value.number) : value.alarm) + ", not " +
            (expected ? number_text(*expected) : "an alarm"));
}

}  // namespace
}  // namespace kadr::expression_test
