// Reads the numbers of expressions, and executes the operations of RS274/NGC. The operations of custom macros are in macro_arithmetic.

#include "lang/expression/expression.h"

#include <algorithm>
#include <cmath>

#include "base/ascii.h"
#include "base/powers_of_ten.h"
#include "base/vec.h"
#include "lang/expression/macro_arithmetic.h"
#include "lang/text/encoding.h"

namespace kadr {
namespace {

constexpr double nearly = 1e-6;             // greatest difference of two numbers that count as equal; TOLERANCE_EQUAL of LinuxCNC 2.9.3
constexpr std::size_t exact_digits = 15;    // greatest number of digits with which every whole number is exact in a double
constexpr std::size_t number_digits = 300;  // greatest number of digits; a longer number is rejected, because no double needs so many

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
      const double rest = remainder_of(a, b);
      return rest < 0 ? rest + std::fabs(b) : rest;  // in RS274/NGC the remainder is never negative
    }
    case Op::power:
      if (a < 0 && b != std::round(b)) return fail(alarm(AlarmId::power_of_negative, where));
      return finite(std::pow(a, b), where);
    case Op::logic_and: return a != 0 && b != 0 ? 1.0 : 0.0;
    case Op::logic_or: return a != 0 || b != 0 ? 1.0 : 0.0;
    case Op::logic_xor: return (a != 0) != (b != 0) ? 1.0 : 0.0;
    case Op::nearly_equal: return std::fabs(a - b) < nearly ? 1.0 : 0.0;
    case Op::nearly_not_equal: return std::fabs(a - b) < nearly ? 0.0 : 1.0;
    case Op::nearly_greater_equal: return std::fabs(a - b) < nearly || a >= b ? 1.0 : 0.0;
    case Op::nearly_less_equal: return std::fabs(a - b) < nearly || a <= b ? 1.0 : 0.0;
    case Op::atan: return angle_deg({b, a});  // ATAN[a]/[b]
    case Op::atan_turn: {
      const double angle = angle_deg({b, a});
      return angle < 0 ? angle + 360 : angle;
    }
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
    // the quotient is correctly rounded, because the digits as a whole number and the power of ten are exact
    number.value = number.mantissa / powers_of_ten[fraction];
    return true;
  }
  return read_long_number({first, static_cast<std::size_t>(p - first)}, number);
}

bool given_name_follows(const Cursor& cursor) {
  Cursor ahead = cursor;
  if (ahead.peek() != '[') return false;
  ++ahead.at;
  ahead.skip_blanks();
  if (ahead.peek() != '#') return false;
  ++ahead.at;
  ahead.skip_blanks();
  return is_letter(ahead.peek()) && ahead.text.find(']', ahead.at) != std::string_view::npos;
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

}  // namespace kadr
