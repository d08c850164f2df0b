// Compiles the expressions of conversational blocks. Used by lang/klartext; tested by tests/lang/klartext_test.cpp.

#include "lang/klartext/klartext_expression.h"

#include <cmath>
#include <utility>

#include "base/vec.h"
#include "lang/block/grammar.h"

namespace kadr {
namespace {

constexpr bool is_space(char c) { return static_cast<unsigned char>(c) <= ' '; }

constexpr std::pair<std::string_view, KlartextOp> functions[] = {
    {"SIN", KlartextOp::sin},        {"COS", KlartextOp::cos},      {"TAN", KlartextOp::tan},          {"ASIN", KlartextOp::asin},
    {"ACOS", KlartextOp::acos},      {"ATAN", KlartextOp::atan},    {"SQRT", KlartextOp::square_root}, {"SQ", KlartextOp::square},
    {"LN", KlartextOp::natural_log}, {"LOG", KlartextOp::log},      {"EXP", KlartextOp::exp},          {"NEG", KlartextOp::negative},
    {"INT", KlartextOp::integer},    {"ABS", KlartextOp::absolute}, {"FRAC", KlartextOp::fraction},    {"SGN", KlartextOp::sign}};

constexpr std::pair<std::string_view, KlartextOp> text_functions[] = {{"STRLEN", KlartextOp::text_length},
                                                                      {"TONUMB", KlartextOp::text_number},
                                                                      {"INSTR", KlartextOp::text_find},
                                                                      {"STRCOMP", KlartextOp::text_compare}};

}  // namespace

void KlartextText::skip() {
  while (at_ < text_.size()) {
    const char c = text_[at_];
    if (c == ';') {
      at_ = std::min(text_.find('\n', at_), text_.size());
    } else if (is_space(c)) {
      ++at_;
    } else if (c == '~') {
      std::size_t look = at_ + 1;
      while (look < text_.size() && text_[look] != '\n' && is_space(text_[look])) ++look;
      if (look < text_.size() && text_[look] != '\n') return;
      at_ = look;
    } else {
      return;
    }
  }
}

bool KlartextText::looks_like(std::string_view what) const {
  if (text_.size() - at_ < what.size()) return false;
  for (std::size_t i = 0; i < what.size(); ++i)
    if (to_upper(text_[at_ + i]) != what[i]) return false;
  return true;
}

bool KlartextText::take_prefix(std::string_view what) {
  skip();
  if (!looks_like(what)) return false;
  at_ += what.size();
  return true;
}

bool KlartextText::take(std::string_view what) {
  skip();
  if (!looks_like(what)) return false;
  const std::size_t after = at_ + what.size();
  if (is_letter(what.back()) && after < text_.size() && is_letter(text_[after])) return false;
  at_ = after;
  return true;
}

std::optional<double> KlartextText::unsigned_number() {
  skip();
  std::uint64_t mantissa = 0;
  int exponent = 0;
  std::size_t digits = 0, look = at_;
  constexpr std::uint64_t most = 100'000'000'000'000'000;
  bool point = false;
  for (; look < text_.size(); ++look) {
    const char c = text_[look];
    if (is_digit(c)) {
      ++digits;
      if (mantissa < most) {
        mantissa = mantissa * 10 + static_cast<std::uint64_t>(c - '0');
        if (point) --exponent;
      } else if (!point) {
        ++exponent;
      }
    } else if ((c == '.' || c == ',') && !point) {
      point = true;
    } else {
      break;
    }
  }
  if (digits == 0) return std::nullopt;
  at_ = look;
  const double value = static_cast<double>(mantissa);
  return exponent == 0 ? value : exponent < 0 ? value / std::pow(10.0, -exponent) : value * std::pow(10.0, exponent);
}

bool KlartextText::at_parameter() const {
  if (peek() != 'Q') return false;
  std::size_t look = 1;
  if (const char family = peek(1); family == 'L' || family == 'R' || family == 'S') ++look;
  while (is_space(peek(look)) && at_ + look < text_.size()) ++look;
  return is_digit(peek(look));
}

Result<KlartextStep> KlartextText::parameter() {
  skip();
  const std::size_t begin = at_;
  if (!at_parameter()) return syntax();
  KlartextStep step;
  step.op = KlartextOp::parameter;
  ++at_;
  std::uint32_t count = 2000;
  switch (peek()) {
    case 'L': step.family = ParameterFamily::ql, count = 500, ++at_; break;
    case 'R': step.family = ParameterFamily::qr, count = 500, ++at_; break;
    case 'S': step.family = ParameterFamily::qs, ++at_; break;
    default: break;
  }
  skip();
  std::uint32_t index = 0;
  for (; is_digit(peek()) && index < 100'000; ++at_) index = index * 10 + static_cast<std::uint32_t>(peek() - '0');
  step.where = span(begin, at_);
  if (index >= count) return fail(alarm(AlarmId::index_range, step.where, "Q", double(index)));
  step.index = static_cast<std::uint16_t>(index);
  return step;
}

void KlartextText::push(KlartextOp op, double number) {
  KlartextStep step;
  step.op = op;
  step.number = number;
  step.where = span(at_ > 0 ? at_ - 1 : 0, at_);
  block_.code.push_back(step);
}

Result<bool> KlartextText::value(double& number, KlartextExpression& expression) {
  skip();
  const std::size_t begin = at_;
  bool minus = false;
  if (peek() == '+' || peek() == '-') {
    minus = peek() == '-';
    ++at_;
    skip();
  }
  if (const auto read = unsigned_number()) {
    number = minus ? -*read : *read;
    return true;
  }
  if (!at_parameter()) {
    at_ = begin;
    return false;
  }
  auto step = parameter();
  if (!step) return fail(step.error());
  if (step->family == ParameterFamily::qs) return syntax();
  expression.begin = code_end();
  block_.code.push_back(*step);
  if (minus) push(KlartextOp::negate);
  expression.end = code_end();
  return true;
}

Status KlartextText::operand() {
  double number = 0;
  KlartextExpression expression;
  const auto read = value(number, expression);
  if (!read) return fail(read.error());
  if (!*read) return syntax();
  if (!expression) push(KlartextOp::number, number);
  return {};
}

Status KlartextText::formula(KlartextExpression& to) {
  to.begin = code_end();
  KADR_TRY(sum());
  if (block_.code.size() > limits::expression_steps)
    return fail(alarm(AlarmId::nesting_too_deep, span(at_, at_ + 1), double{limits::expression_steps}));
  to.end = code_end();
  return {};
}

Status KlartextText::sum() {
  KADR_TRY(product());
  for (;;) {
    skip();
    const char sign = peek();
    if (sign != '+' && sign != '-') return {};
    ++at_;
    KADR_TRY(product());
    push(sign == '+' ? KlartextOp::add : KlartextOp::subtract);
  }
}

Status KlartextText::product() {
  KADR_TRY(power());
  for (;;) {
    skip();
    const char sign = peek();
    const bool divides = take("DIV");
    if (!divides && sign != '*' && sign != '/' && sign != '%') return {};
    if (!divides) ++at_;
    KADR_TRY(power());
    push(divides || sign == '/' ? KlartextOp::divide : sign == '*' ? KlartextOp::multiply : KlartextOp::remainder);
  }
}

Status KlartextText::power() {
  KADR_TRY(signed_value());
  while (take("^")) {
    KADR_TRY(signed_value());
    push(KlartextOp::power);
  }
  return {};
}

/// The sign and functions bind more strongly than ^ (spec/heidenhain 10.4).
Status KlartextText::signed_value() {
  if (++depth_ > static_cast<int>(limits::expression_depth)) {
    return fail(alarm(AlarmId::nesting_too_deep, span(at_, at_ + 1), double{limits::expression_depth}));
  }
  const auto done = [&]() -> Status {
    if (take("-")) {
      KADR_TRY(signed_value());
      push(KlartextOp::negate);
      return {};
    }
    if (take("+")) return signed_value();
    for (const auto& [name, op] : functions)
      if (take(name)) {
        KADR_TRY(signed_value());
        push(op);
        return {};
      }
    return primary();
  }();
  --depth_;
  return done;
}

Status KlartextText::primary() {
  skip();
  const std::size_t begin = at_;
  if (take("(")) {
    KADR_TRY(sum());
    if (!take(")")) return fail(alarm(AlarmId::bracket_not_closed, span(begin, begin + 1)));
    return {};
  }
  for (const auto& [name, op] : text_functions)
    if (take(name)) return text_function(op);
  if (take("PI")) {
    push(KlartextOp::number, pi);
    return {};
  }
  if (const auto number = unsigned_number()) {
    push(KlartextOp::number, *number);
    return {};
  }
  auto step = parameter();
  if (!step) return fail(step.error());
  if (step->family == ParameterFamily::qs) return syntax();
  block_.code.push_back(*step);
  return {};
}

/// Reads SRC_QS10 or SEA_QS11.
Result<std::uint16_t> KlartextText::text_source(std::string_view name) {
  if (!take_prefix(name)) return syntax();
  const auto step = parameter();
  if (!step) return fail(step.error());
  if (step->family != ParameterFamily::qs) return syntax();
  return step->index;
}

Status KlartextText::text_function(KlartextOp op) {
  const std::size_t begin = at_;
  if (!take("(")) return syntax();
  KlartextStep step;
  step.op = op;
  step.where = span(begin, begin + 1);
  const auto source = text_source("SRC_");
  if (!source) return fail(source.error());
  step.index = *source;
  if (op == KlartextOp::text_find || op == KlartextOp::text_compare) {
    const auto other = text_source("SEA_");
    if (!other) return fail(other.error());
    step.second = *other;
  }
  if (op == KlartextOp::text_find) {
    if (take_prefix("BEG")) KADR_TRY(operand());
    else push(KlartextOp::number, 0);
  }
  if (!take(")")) return fail(alarm(AlarmId::bracket_not_closed, span(begin, begin + 1)));
  block_.code.push_back(step);
  return {};
}

Result<std::string> KlartextText::quoted() {
  skip();
  if (peek() != '"') return syntax();
  const std::size_t begin = at_ + 1, end = text_.find('"', begin);
  if (end == std::string_view::npos) return fail(alarm(AlarmId::bracket_not_closed, span(at_, at_ + 1)));
  at_ = end + 1;
  return std::string(text_.substr(begin, end - begin));
}

tl::unexpected<Alarm> KlartextText::syntax() const {
  const std::size_t begin = std::min(at_, text_.size() > 0 ? text_.size() - 1 : 0);
  std::size_t end = begin + 1;
  while (end < text_.size() && end < begin + 20 && !is_space(text_[end])) ++end;
  return fail(alarm(AlarmId::expression_syntax, span(begin, end), text_.substr(begin, end - begin)));
}

}  // namespace kadr
