#include "lang/expression/expression.h"

#include <algorithm>
#include <cmath>

#include "base/ascii.h"
#include "base/vec.h"
#include "lang/expression/macro_arithmetic.h"
#include "lang/text/encoding.h"

namespace kadr {
namespace {

constexpr double powers_of_ten[] = {1e0,  1e1,  1e2,  1e3,  1e4,  1e5,  1e6,  1e7,  1e8,  1e9,  1e10, 1e11,
                                    1e12, 1e13, 1e14, 1e15, 1e16, 1e17, 1e18, 1e19, 1e20, 1e21, 1e22};
constexpr std::size_t exact_digits = 15;    // so many digits are a whole number exactly in a double
constexpr std::size_t number_digits = 300;  // more than any double needs: the number is refused

struct FunctionName {
  std::string_view name;
  Op op;
};
constexpr FunctionName functions[] = {
    {"ABS", Op::abs}, {"ACOS", Op::acos}, {"ASIN", Op::asin},   {"ATAN", Op::atan}, {"COS", Op::cos},   {"EXP", Op::exp}, {"FIX", Op::fix},
    {"FUP", Op::fup}, {"LN", Op::ln},     {"ROUND", Op::round}, {"SIN", Op::sin},   {"SQRT", Op::sqrt}, {"TAN", Op::tan},
};

/// Binary operators and how tightly they bind (spec/mach3 1); the comparisons are not Mach3's: an alarm names them.
struct OperatorName {
  std::string_view name;
  Op op;
  int binding;  // 0: known, but not on this control
};
constexpr OperatorName operators[] = {
    {"**", Op::power, 4},     {"*", Op::multiply, 3},    {"/", Op::divide, 3},         {"MOD", Op::modulo, 3},    {"+", Op::add, 2},
    {"-", Op::subtract, 2},   {"AND", Op::logic_and, 1}, {"OR", Op::logic_or, 1},      {"XOR", Op::logic_xor, 1}, {"EQ", Op::equal, 0},
    {"NE", Op::not_equal, 0}, {"GT", Op::greater, 0},    {"GE", Op::greater_equal, 0}, {"LT", Op::less, 0},       {"LE", Op::less_equal, 0},
};

bool starts_with(std::string_view text, std::size_t at, std::string_view word) {
  if (text.size() - at < word.size()) return false;
  for (std::size_t i = 0; i < word.size(); ++i)
    if (to_upper(text[at + i]) != word[i]) return false;
  return true;
}

/// Precedence climbing over the text of one value; writes instructions in the order of a stack machine.
class Compiler {
 public:
  Compiler(Cursor& cursor, Block& block) : cursor_(cursor), block_(block) {}

  /// number | #value | [expression] | function[expression] | -value
  Status value() {
    cursor_.skip_blanks();
    const std::size_t begin = cursor_.at;
    const char c = cursor_.peek();
    if (c == '+' || c == '-') return signed_value(c);
    if (is_digit(c) || c == '.') return number();
    if (c == '#') return variable();
    if (c == '[') return bracket();
    if (is_letter(c)) return function();
    return fail(alarm(AlarmId::expression_syntax, span(begin, begin + 1), text_at(begin)));
  }

 private:
  Status signed_value(char sign) {
    const std::size_t begin = cursor_.at++;
    KADR_TRY(enter(begin));
    KADR_TRY(value());
    --depth_;
    return sign == '-' ? step(Op::negate, 0, begin, 0) : Status();
  }

  Status number() {
    const std::size_t begin = cursor_.at;
    Number read;
    if (!read_number(cursor_, read)) return fail(alarm(AlarmId::number_damaged, span(begin, cursor_.at)));
    return step(Op::number, read.value, begin, 1);
  }

  Status variable() {
    const std::size_t begin = cursor_.at++;
    KADR_TRY(enter(begin));
    KADR_TRY(value());
    --depth_;
    return step(Op::variable, 0, begin, 0);
  }

  Status bracket() {
    const std::size_t begin = cursor_.at++;
    KADR_TRY(enter(begin));
    KADR_TRY(expression(1));
    --depth_;
    cursor_.skip_blanks();
    if (cursor_.peek() != ']') return fail(alarm(AlarmId::bracket_not_closed, span(begin, begin + 1)));
    ++cursor_.at;
    return {};
  }

  Status function() {
    const std::size_t begin = cursor_.at;
    for (const FunctionName& row : functions) {
      if (!starts_with(cursor_.text, begin, row.name)) continue;
      cursor_.at += row.name.size();
      cursor_.skip_blanks();
      if (cursor_.peek() != '[') break;
      KADR_TRY(bracket());
      return row.op == Op::atan ? second_argument(begin) : step(row.op, 0, begin, 0);
    }
    std::size_t end = begin;
    while (end < cursor_.text.size() && is_letter(cursor_.text[end])) ++end;
    return fail(alarm(AlarmId::function_unknown, span(begin, end), cursor_.text.substr(begin, end - begin)));
  }

  /// ATAN[y]/[x]
  Status second_argument(std::size_t begin) {
    cursor_.skip_blanks();
    if (cursor_.peek() != '/') return fail(alarm(AlarmId::expression_syntax, span(begin, cursor_.at), "ATAN[ ]/[ ]"));
    ++cursor_.at;
    cursor_.skip_blanks();
    if (cursor_.peek() != '[') return fail(alarm(AlarmId::expression_syntax, span(begin, cursor_.at), "ATAN[ ]/[ ]"));
    KADR_TRY(bracket());
    return step(Op::atan, 0, begin, -1);
  }

  Status expression(int least_binding) {
    KADR_TRY(value());
    for (;;) {
      cursor_.skip_blanks();
      const std::size_t begin = cursor_.at;
      const OperatorName* found = nullptr;
      for (const OperatorName& row : operators)
        if (starts_with(cursor_.text, begin, row.name)) {
          found = &row;
          break;
        }
      if (found == nullptr) return end_of_expression(begin);
      if (found->binding == 0) return fail(alarm(AlarmId::operator_unknown, span(begin, begin + found->name.size()), found->name));
      if (found->binding < least_binding) return {};
      cursor_.at += found->name.size();
      KADR_TRY(enter(begin));
      KADR_TRY(expression(found->binding + 1));
      --depth_;
      KADR_TRY(step(found->op, 0, begin, -1));
    }
  }

  Status end_of_expression(std::size_t at) {
    const char c = cursor_.peek();
    if (c == ']' || c == '\0') return {};
    const bool is_value = c == '#' || c == '[' || c == '.' || is_digit(c);  // an operator is missing in front of it
    return fail(alarm(is_value ? AlarmId::expression_syntax : AlarmId::operator_unknown, span(at, at + 1), text_at(at)));
  }

  Status enter(std::size_t at) {
    if (++depth_ > static_cast<int>(limits::expression_depth))
      return fail(alarm(AlarmId::nesting_too_deep, span(at, at + 1), double{limits::expression_depth}));
    return {};
  }

  Status step(Op op, double number, std::size_t begin, int pushed) {
    pushed_ += pushed;
    if (block_.code.size() >= limits::expression_steps || pushed_ > static_cast<int>(limits::expression_depth))
      return fail(alarm(AlarmId::nesting_too_deep, span(begin, begin + 1), double{limits::expression_depth}));
    block_.code.push_back({op, number, span(begin, cursor_.at)});
    return {};
  }

  Span span(std::size_t begin, std::size_t end) const {
    return {static_cast<std::uint32_t>(begin), static_cast<std::uint32_t>(std::min(end, cursor_.text.size()))};
  }
  /// The character there, whole.
  std::string_view text_at(std::size_t at) const {
    if (at >= cursor_.text.size()) return "…";
    return cursor_.text.substr(at, std::max<std::size_t>(first_character(cursor_.text.substr(at)).size, 1));
  }

  Cursor& cursor_;
  Block& block_;
  int depth_ = 0;
  int pushed_ = 0;
};

Result<double> finite(double value, Span where) {
  if (!std::isfinite(value)) return fail(alarm(AlarmId::not_a_number, where));
  return value;
}

Result<double> apply_pair(Op op, double a, double b, Span where) {
  switch (op) {
    case Op::add: return finite(a + b, where);
    case Op::subtract: return finite(a - b, where);
    case Op::multiply: return finite(a * b, where);
    case Op::divide:
      if (b == 0) return fail(alarm(AlarmId::division_by_zero, where));
      return finite(a / b, where);
    case Op::modulo: {
      if (b == 0) return fail(alarm(AlarmId::division_by_zero, where));
      const double rest = std::fmod(a, b);
      return rest < 0 ? rest + std::fabs(b) : rest;  // RS274/NGC: never negative
    }
    case Op::power: return finite(std::pow(a, b), where);
    case Op::logic_and: return a != 0 && b != 0 ? 1.0 : 0.0;
    case Op::logic_or: return a != 0 || b != 0 ? 1.0 : 0.0;
    case Op::logic_xor: return (a != 0) != (b != 0) ? 1.0 : 0.0;
    case Op::atan: return angle_deg({b, a});  // ATAN[a]/[b]
    default: return apply_macro(op, a, b, where);
  }
}

}  // namespace

void Cursor::skip_blanks() {
  while (at < text.size()) {
    const char c = text[at];
    if (c != ' ' && c != '\t' && c != '\r' && c != '\0' && c != '\x7f') return;
    ++at;
  }
}

bool read_number(Cursor& cursor, Number& number) {
  const char* const first = cursor.text.data() + cursor.at;
  const char* const last = cursor.text.data() + cursor.text.size();
  const char* p = first;
  std::uint64_t mantissa = 0;
  while (p < last && is_digit(*p)) mantissa = mantissa * 10 + static_cast<std::uint64_t>(*p++ - '0');
  const auto whole = static_cast<std::size_t>(p - first);
  std::size_t fraction = 0;
  number.has_point = p < last && *p == '.';
  if (number.has_point) {
    const char* const point = p++;
    while (p < last && is_digit(*p)) mantissa = mantissa * 10 + static_cast<std::uint64_t>(*p++ - '0');
    fraction = static_cast<std::size_t>(p - point - 1);
  }
  cursor.at += static_cast<std::size_t>(p - first);
  if (whole + fraction == 0 || whole + fraction > number_digits) return false;
  number.whole_digits = static_cast<std::uint8_t>(std::min<std::size_t>(whole, 255));
  number.fraction_digits = static_cast<std::uint8_t>(std::min<std::size_t>(fraction, 255));
  if (whole + fraction <= exact_digits) [[likely]] {
    number.mantissa = static_cast<double>(mantissa);
    number.value = number.mantissa / powers_of_ten[fraction];  // both exact: correctly rounded
    return true;
  }
  return read_long_number({first, p}, number);
}

Result<double> apply(Op op, double a, double b, Span where) {
  switch (op) {
    case Op::negate: return a == 0 ? 0.0 : -a;
    case Op::abs: return std::fabs(a);
    case Op::acos: return finite(std::acos(a) / rad_per_deg, where);
    case Op::asin: return finite(std::asin(a) / rad_per_deg, where);
    case Op::cos: return sincos_deg(a).cos;
    case Op::sin: return sincos_deg(a).sin;
    case Op::tan: {
      const SinCos turn = sincos_deg(a);
      if (turn.cos == 0) return fail(alarm(AlarmId::not_a_number, where));
      return turn.sin / turn.cos;
    }
    case Op::exp: return finite(std::exp(a), where);
    case Op::fix: return std::floor(a);
    case Op::fup: return std::ceil(a);
    case Op::ln: return finite(a > 0 ? std::log(a) : std::nan(""), where);
    case Op::round: return std::round(a);
    case Op::sqrt: return finite(std::sqrt(a), where);
    default: return apply_pair(op, a, b, where);
  }
}

Result<Expression> compile_value(Cursor& cursor, const Grammar&, Block& block) {
  Expression expression;
  expression.begin = static_cast<std::uint16_t>(block.code.size());
  KADR_TRY(Compiler(cursor, block).value());
  expression.end = static_cast<std::uint16_t>(block.code.size());
  return expression;
}

}  // namespace kadr
