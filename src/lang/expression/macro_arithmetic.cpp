// Executes the operations of custom macros that differ from those of RS274/NGC (spec/nct/23 23.2.2–23.2.5). Used by
// lang/expression/expression.

#include "lang/expression/macro_arithmetic.h"

#include <cmath>

#include "base/vec.h"

namespace kadr {
namespace {

constexpr double least_bits = -4294967297.0;  // least operand of AND, OR, XOR, as printed in nct 23.2.3
constexpr double beyond_bits = 4294967296.0;

/// Converts an operand of AND, OR, XOR to its bits: the operand is rounded to a whole number modulo 2^32. INFERRED: the rounding. The
/// numbers 2^31 … 2^32−1 have the same bits as negative numbers.
Result<std::uint32_t> bits_of(double v, Span where) {
  if (!(v >= least_bits && v < beyond_bits)) return fail(alarm(AlarmId::bits_out_of_range, where, v));
  return static_cast<std::uint32_t>(std::llround(v));
}

/// Converts 32 bits back to a signed number (nct 23.2.3 item 4).
double number_of(std::uint32_t bits) { return static_cast<std::int32_t>(bits); }

Result<double> logic(Op op, double a, double b, Span where) {
  const auto left = bits_of(a, where);
  if (!left) return fail(left.error());
  if (op == Op::bit_not) return number_of(~*left);
  const auto right = bits_of(b, where);
  if (!right) return fail(right.error());
  switch (op) {
    case Op::bit_and: return number_of(*left & *right);
    case Op::bit_or: return number_of(*left | *right);
    default: return number_of(*left ^ *right);
  }
}

Result<double> tangent(double deg, Span where) {
  const SinCos at = sincos_deg(deg);
  // The cosine is exactly 0 at odd multiples of 90°, where the tangent is infinite.
  if (at.cos == 0) return fail(alarm(AlarmId::tangent_of_right_angle, where, deg));
  return at.sin / at.cos;
}

Result<double> arc(Op op, double a, Span where) {
  if (!(std::fabs(a) <= 1)) return fail(alarm(AlarmId::argument_above_one, where, a));
  return (op == Op::arc_sine ? std::asin(a) : std::acos(a)) / rad_per_deg;
}

/// Reads the digits of a number in base `from` as digits in base `to`. Example: the decimal digits 25 read in base 16 are 0x25 = 37
/// (spec/fanuc 5.3).
Result<double> digits_from_to(double a, std::uint64_t from, std::uint64_t to, Span where) {
  constexpr double most = 99'999'999;
  if (!(a >= 0 && a <= (from == 10 ? most : 4294967295.0))) return fail(alarm(AlarmId::value_limit, where, a));
  auto left = static_cast<std::uint64_t>(std::llround(a));
  std::uint64_t value = 0, place = 1;
  for (; left != 0; left /= from, place *= to) {
    if (left % from > 9) return fail(alarm(AlarmId::value_limit, where, a));
    value += left % from * place;
  }
  return static_cast<double>(value);
}

}  // namespace

double remainder_of(double a, double b) {
  constexpr double exact = 9007199254740992;  // 2^53; up to this value every whole number is exact in a double
  if (std::fabs(a) < exact && std::fabs(b) < exact) {
    const auto left = static_cast<std::int64_t>(a), right = static_cast<std::int64_t>(b);
    if (right != 0 && static_cast<double>(left) == a && static_cast<double>(right) == b)
      return std::copysign(static_cast<double>(left % right), a);
  }
  return std::fmod(a, b);
}

Result<double> apply_macro(Op op, double a, double b, Span where) {
  switch (op) {
    case Op::remainder:
      if (b == 0) return fail(alarm(AlarmId::division_by_zero, where));
      return remainder_of(a, b);  // INFERRED: the remainder has the sign of the dividend
    case Op::bit_and:
    case Op::bit_or:
    case Op::bit_xor:
    case Op::bit_not: return logic(op, a, b, where);
    case Op::truncate: return std::trunc(a);
    case Op::away_from_zero: return a < 0 ? std::floor(a) : std::ceil(a);
    case Op::square_root:
      if (a < 0) return fail(alarm(AlarmId::root_of_negative, where, a));
      return std::sqrt(a);
    case Op::sine: return sincos_deg(a).sin;
    case Op::cosine: return sincos_deg(a).cos;
    case Op::tangent: return tangent(a, where);
    case Op::arc_sine:
    case Op::arc_cosine: return arc(op, a, where);
    case Op::arc_sine_turn: {
      const auto angle = arc(Op::arc_sine, a, where);
      return angle && *angle < 0 ? Result<double>(*angle + 360) : angle;
    }
    case Op::arc_tangent: return std::atan(a) / rad_per_deg;
    case Op::logarithm:
      if (!(a > 0)) return fail(alarm(AlarmId::argument_not_positive, where, a));
      return std::log(a);
    case Op::to_bcd: return digits_from_to(a, 10, 16, where);
    case Op::from_bcd: return digits_from_to(a, 16, 10, where);
    default: return fail(alarm(AlarmId::not_a_number, where));
  }
}

}  // namespace kadr
