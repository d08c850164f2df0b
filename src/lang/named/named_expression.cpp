// Compiles expressions of blocks with names by precedence climbing. Used by lang/named/named_parser; tested by tests/lang/named_test.cpp.

#include "lang/named/named_expression.h"

#include <cmath>
#include <cstdlib>

#include "base/ascii.h"
#include "lang/text/encoding.h"

namespace kadr {
namespace {

constexpr int most_depth = 64;
constexpr std::size_t most_steps = 1024;
constexpr int comparison_binding = 1;

}  // namespace

/// The operators with their binding; the greatest number binds strongest. Comparisons bind last, after AND and OR (spec/sinumerik 7.1).
const NamedExpressions::Operator* NamedExpressions::operator_named(std::string_view text) {
  static constexpr Operator rows[] = {{"*", NamedOp::multiply, 11},
                                      {"/", NamedOp::divide, 11},
                                      {"DIV", NamedOp::whole_divide, 11},
                                      {"MOD", NamedOp::modulo, 11},
                                      {"+", NamedOp::add, 10},
                                      {"-", NamedOp::subtract, 10},
                                      {"B_AND", NamedOp::bit_and, 9},
                                      {"B_XOR", NamedOp::bit_xor, 8},
                                      {"B_OR", NamedOp::bit_or, 7},
                                      {"AND", NamedOp::logic_and, 6},
                                      {"XOR", NamedOp::logic_xor, 5},
                                      {"OR", NamedOp::logic_or, 4},
                                      {"<<", NamedOp::join, 3},
                                      {":", NamedOp::chain, 2},
                                      {"==", NamedOp::equal, comparison_binding},
                                      {"<>", NamedOp::not_equal, comparison_binding},
                                      {">=", NamedOp::greater_equal, comparison_binding},
                                      {"<=", NamedOp::less_equal, comparison_binding},
                                      {">", NamedOp::greater, comparison_binding},
                                      {"<", NamedOp::less, comparison_binding}};
  for (const Operator& row : rows)
    if (row.text == text) return &row;
  return nullptr;
}

std::string_view written(NamedOp op) {
  switch (op) {
    case NamedOp::negate: return "-";
    case NamedOp::logic_not: return "NOT";
    case NamedOp::bit_not: return "B_NOT";
    case NamedOp::multiply: return "*";
    case NamedOp::divide: return "/";
    case NamedOp::whole_divide: return "DIV";
    case NamedOp::modulo: return "MOD";
    case NamedOp::add: return "+";
    case NamedOp::subtract: return "-";
    case NamedOp::bit_and: return "B_AND";
    case NamedOp::bit_xor: return "B_XOR";
    case NamedOp::bit_or: return "B_OR";
    case NamedOp::logic_and: return "AND";
    case NamedOp::logic_xor: return "XOR";
    case NamedOp::logic_or: return "OR";
    case NamedOp::join: return "<<";
    case NamedOp::equal: return "==";
    case NamedOp::not_equal: return "<>";
    case NamedOp::greater: return ">";
    case NamedOp::less: return "<";
    case NamedOp::greater_equal: return ">=";
    case NamedOp::less_equal: return "<=";
    case NamedOp::chain: return ":";
  }
  return {};
}

const NamedExpressions::Operator* NamedExpressions::operator_here() const {
  if (begins_name(peek())) return operator_named(name_here());
  for (const std::size_t length : {std::size_t{2}, std::size_t{1}})
    if (const Operator* const found = operator_named(text_.substr(at_, length)); found != nullptr && found->text.size() == length)
      return found;
  return nullptr;
}

Status NamedExpressions::push(NamedStep step) {
  if (block_.code.size() >= most_steps) return fail(alarm(AlarmId::nesting_too_deep, step.where, double{most_depth}));
  block_.code.push_back(std::move(step));
  return {};
}

Status NamedExpressions::expression(NamedExpression& to) {
  to.begin = static_cast<std::uint32_t>(block_.code.size());
  KADR_TRY(sum(comparison_binding));
  to.end = static_cast<std::uint32_t>(block_.code.size());
  return {};
}

Status NamedExpressions::sum(int least) {
  if (++depth_ > most_depth) return fail(alarm(AlarmId::nesting_too_deep, span(at_, at_ + 1), double{most_depth}));
  KADR_TRY(operand());
  bool compared = false;
  for (;;) {
    skip();
    const Operator* const found = at_end() ? nullptr : operator_here();
    if (found == nullptr || found->binding < least) break;
    const std::size_t begin = at_;
    at_ += found->text.size();
    if (found->binding == comparison_binding && std::exchange(compared, true))
      return fail(alarm(AlarmId::comparison_chained, span(begin, at_)));
    KADR_TRY(sum(found->binding + 1));
    KADR_TRY(push({NamedStep::Kind::apply, found->op, 2, 0, {}, span(begin, begin + found->text.size())}));
  }
  --depth_;
  return {};
}

Status NamedExpressions::operand() {
  skip();
  const std::size_t begin = at_;
  const std::string name = name_here();
  const bool negates = peek() == '-', adds = peek() == '+';
  if (!negates && !adds && name != "NOT" && name != "B_NOT") return value();
  at_ += negates || adds ? 1 : name.size();
  if (++depth_ > most_depth) return fail(alarm(AlarmId::nesting_too_deep, span(begin, begin + 1), double{most_depth}));
  KADR_TRY(operand());
  --depth_;
  if (adds) return {};
  const NamedOp op = negates ? NamedOp::negate : name == "NOT" ? NamedOp::logic_not : NamedOp::bit_not;
  return push({NamedStep::Kind::apply, op, 1, 0, {}, span(begin, at_)});
}

Status NamedExpressions::value() {
  const char c = peek();
  const std::size_t begin = at_;
  if (is_digit(c) || c == '.') {
    double number = 0;
    bool whole = false;
    KADR_TRY(number_here(number, whole));
    return push({whole ? NamedStep::Kind::integer : NamedStep::Kind::real, NamedOp::add, 0, number, {}, span(begin, at_)});
  }
  if (c == '\'') return quoted_number();
  if (c == '"') return text_value();
  if (c == '(') {
    ++at_;
    KADR_TRY(sum(comparison_binding));
    skip();
    if (peek() != ')') return at_end() ? not_closed(begin) : syntax();
    ++at_;
    return {};
  }
  if (c == '$' || begins_name(c)) return name_value();
  return syntax();
}

/// Reads 1, 1., .5, 1.5EX-3 (spec/sinumerik 3.2). `whole`: the number has neither a point nor an exponent.
Status NamedExpressions::number_here(double& value, bool& whole) {
  const std::size_t begin = at_;
  std::string digits;
  bool point = false, any = false;
  for (;; ++at_) {
    const char c = peek();
    if (is_digit(c)) any = true;
    else if (c == '.' && !point) point = true;
    else break;
    digits += c;
  }
  if (!any || digits.size() > 40) return fail(alarm(AlarmId::number_damaged, span(begin, at_)));
  whole = !point;
  if (to_upper(peek()) == 'E' && at_ + 1 < text_.size() && to_upper(text_[at_ + 1]) == 'X') {
    at_ += 2;
    whole = false;
    digits += 'e';
    if (peek() == '-' || peek() == '+') digits += text_[at_++];
    if (!is_digit(peek())) return fail(alarm(AlarmId::number_damaged, span(begin, at_)));
    while (is_digit(peek())) digits += text_[at_++];
  }
  value = std::strtod(digits.c_str(), nullptr);
  if (!std::isfinite(value)) return fail(alarm(AlarmId::number_damaged, span(begin, at_)));
  return {};
}

/// Reads 'HFF' and 'B1010'.
Status NamedExpressions::quoted_number() {
  const std::size_t begin = at_++;
  const std::size_t close = text_.find('\'', at_);
  if (close == std::string_view::npos) return not_closed(begin);
  const std::string_view inside = text_.substr(at_, close - at_);
  at_ = close + 1;
  const bool hexadecimal = !inside.empty() && to_upper(inside[0]) == 'H', binary = !inside.empty() && to_upper(inside[0]) == 'B';
  double number = 0;
  for (const char c : inside.substr(inside.empty() ? 0 : 1)) {
    const char letter = to_upper(c);
    const int digit = is_digit(c) ? c - '0' : letter >= 'A' && letter <= 'F' ? letter - 'A' + 10 : 99;
    const int base = hexadecimal ? 16 : 2;
    if (digit >= base) return fail(alarm(AlarmId::number_damaged, span(begin, at_)));
    number = number * base + digit;
  }
  if ((!hexadecimal && !binary) || inside.size() < 2 || inside.size() > 33) return fail(alarm(AlarmId::number_damaged, span(begin, at_)));
  return push({NamedStep::Kind::integer, NamedOp::add, 0, number, {}, span(begin, at_)});
}

Status NamedExpressions::text_value() {
  const std::size_t begin = at_++;
  const std::size_t close = text_.find('"', at_);
  if (close == std::string_view::npos) return not_closed(begin);
  std::string inside(text_.substr(at_, close - at_));
  at_ = close + 1;
  return push({NamedStep::Kind::text, NamedOp::add, 0, 0, std::move(inside), span(begin, at_)});
}

/// Reads a variable, an element of an array, a function with its operands, an R parameter.
Status NamedExpressions::name_value() {
  const std::size_t begin = at_;
  const bool system = peek() == '$';
  if (system) ++at_;
  std::string name = take_name();
  if (name.empty()) return syntax();
  if (!system && name.size() > 1 && name[0] == 'R' && name.find_first_not_of("0123456789", 1) == std::string::npos) {
    if (name.size() > 7) return fail(alarm(AlarmId::number_damaged, span(begin, at_)));
    return push({NamedStep::Kind::parameter, NamedOp::add, 0, std::strtod(name.c_str() + 1, nullptr), {}, span(begin, at_)});
  }
  if (!system && (name == "TRUE" || name == "FALSE"))
    return push({NamedStep::Kind::boolean, NamedOp::add, 0, name == "TRUE" ? 1.0 : 0.0, {}, span(begin, at_)});
  if (system) name = "$" + name;
  const std::size_t after = at_;
  skip();
  std::vector<NamedExpression> inside;
  const auto operands = [&] { return static_cast<std::uint16_t>(inside.size()); };
  if (peek() == '[') {
    KADR_TRY(indices(inside));
    if (name == "R") {
      if (inside.size() != 1) return syntax();
      return push({NamedStep::Kind::parameter, NamedOp::add, 1, 0, {}, span(begin, at_)});
    }
    return push({NamedStep::Kind::name, NamedOp::add, operands(), 0, std::move(name), span(begin, at_)});
  }
  if (peek() == '(') {
    KADR_TRY(arguments(inside));
    return push({NamedStep::Kind::call, NamedOp::add, operands(), 0, std::move(name), span(begin, at_)});
  }
  at_ = after;
  return push({NamedStep::Kind::name, NamedOp::add, 0, 0, std::move(name), span(begin, at_)});
}

Status NamedExpressions::list(std::vector<NamedExpression>& to, char open, char close) {
  const std::size_t begin = at_++;
  constexpr std::size_t most = 500;
  skip();
  if (peek() == close && open == '(') {
    ++at_;
    return {};
  }
  for (;;) {
    skip();
    NamedExpression each;
    if (peek() == ',' || peek() == close) {
      if (open != '(') return syntax();
      each.begin = static_cast<std::uint32_t>(block_.code.size());
      KADR_TRY(push({NamedStep::Kind::omitted, NamedOp::add, 0, 0, {}, span(at_, at_ + 1)}));
      each.end = static_cast<std::uint32_t>(block_.code.size());
    } else {
      KADR_TRY(expression(each));
    }
    to.push_back(each);
    skip();
    if (at_end()) return not_closed(begin);
    if (to.size() > most) return syntax();
    if (peek() == close) break;
    if (peek() != ',') return syntax();
    ++at_;
  }
  ++at_;
  return {};
}

std::string NamedExpressions::name_here() const {
  std::string name;
  if (!begins_name(peek())) return name;
  for (std::size_t i = at_; i < text_.size() && continues_name(text_[i]); ++i) name += to_upper(text_[i]);
  return name;
}

tl::unexpected<Alarm> NamedExpressions::syntax() const {
  const std::string_view found =
      at_end() ? std::string_view("…") : text_.substr(at_, std::max<std::size_t>(1, first_character(text_.substr(at_)).size));
  return fail(alarm(AlarmId::expression_syntax, span(at_, at_ + std::max<std::size_t>(1, at_end() ? 1 : found.size())), found));
}

tl::unexpected<Alarm> NamedExpressions::unexpected() const {
  const std::size_t bytes = std::max<std::size_t>(1, first_character(text_.substr(at_)).size);
  return fail(alarm(AlarmId::unexpected_character, span(at_, at_ + bytes), text_.substr(at_, bytes)));
}

}  // namespace kadr
