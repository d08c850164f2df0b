// Operators and functions of numbers (spec/sinumerik 7). Used by control/sinumerik/evaluate and calculation.

#include "control/sinumerik/number.h"

#include <algorithm>
#include <cmath>
#include <iterator>

#include "base/vec.h"

namespace kadr::sinumerik {
namespace {

constexpr double most_integer = 2147483647;

/// Comparisons of REAL values take values as equal that differ by less than 1E-12 of their size (spec/sinumerik 7.2).
bool nearly_equal(double a, double b) { return std::fabs(a - b) <= 1e-12 * std::max(std::fabs(a), std::fabs(b)); }

std::int64_t bits(double number) { return static_cast<std::int64_t>(std::clamp(std::round(number), -2147483648.0, 4294967295.0)); }

bool compared(NamedOp op, double a, double b) {
  const bool equal = nearly_equal(a, b);
  switch (op) {
    case NamedOp::equal: return equal;
    case NamedOp::not_equal: return !equal;
    case NamedOp::greater: return !equal && a > b;
    case NamedOp::less: return !equal && a < b;
    case NamedOp::greater_equal: return equal || a > b;
    default: return equal || a < b;
  }
}

constexpr double deg = 1 / rad_per_deg;

bool any(double) { return true; }
bool at_most_one(double x) { return std::fabs(x) <= 1; }
bool has_tangent(double x) { return sincos_deg(x).cos != 0; }

const NumberFunction number_functions[] = {
    {"SIN", 1, [](const double* v) { return sincos_deg(v[0]).sin; }, any, no_alarm},
    {"COS", 1, [](const double* v) { return sincos_deg(v[0]).cos; }, any, no_alarm},
    {"TAN", 1, [](const double* v) { return sincos_deg(v[0]).sin / sincos_deg(v[0]).cos; }, has_tangent, AlarmId::tangent_of_right_angle},
    {"ASIN", 1, [](const double* v) { return std::asin(v[0]) * deg; }, at_most_one, AlarmId::argument_above_one},
    {"ACOS", 1, [](const double* v) { return std::acos(v[0]) * deg; }, at_most_one, AlarmId::argument_above_one},
    {"ATAN2", 2,
     [](const double* v) {
       return angle_deg({v[1], v[0]});
     },
     any, no_alarm},
    {"SQRT", 1, [](const double* v) { return std::sqrt(v[0]); }, [](double x) { return x >= 0; }, AlarmId::root_of_negative},
    {"ABS", 1, [](const double* v) { return std::fabs(v[0]); }, any, no_alarm},
    {"POT", 1, [](const double* v) { return v[0] * v[0]; }, any, no_alarm},
    {"TRUNC", 1, [](const double* v) { return std::trunc(v[0]); }, any, no_alarm},
    {"ROUND", 1, [](const double* v) { return std::round(v[0]); }, any, no_alarm},
    {"ROUNDUP", 1, [](const double* v) { return std::ceil(v[0]); }, any, no_alarm},
    {"LN", 1, [](const double* v) { return std::log(v[0]); }, [](double x) { return x > 0; }, AlarmId::argument_not_positive},
    {"EXP", 1, [](const double* v) { return std::exp(v[0]); }, any, no_alarm},
    {"MINVAL", 2, [](const double* v) { return std::min(v[0], v[1]); }, any, no_alarm},
    {"MAXVAL", 2, [](const double* v) { return std::max(v[0], v[1]); }, any, no_alarm},
    {"BOUND", 3, [](const double* v) { return std::max(std::min(v[0], v[1]), std::min(v[2], std::max(v[0], v[1]))); }, any, no_alarm},
};

}  // namespace

const NumberFunction* number_function(std::string_view name) {
  const auto* const row =
      std::find_if(std::begin(number_functions), std::end(number_functions), [&](const NumberFunction& each) { return each.name == name; });
  return row == std::end(number_functions) ? nullptr : row;
}

// NOLINTNEXTLINE(readability-function-size): one switch over all operators
AlarmId apply(NamedOp op, Number a, Number b, Number& to) {
  const double x = a.value, y = b.value;
  const auto is = [&](double value, Type type) {
    to = {value, type};
    return no_alarm;
  };
  const auto truth = [&](bool on) { return is(on ? 1.0 : 0.0, Type::boolean); };
  const auto result = [&](double value) {
    if (!std::isfinite(value)) return AlarmId::not_a_number;
    const bool whole = a.type != Type::real && b.type != Type::real && std::fabs(value) <= most_integer;
    return is(value, whole ? Type::integer : Type::real);
  };
  switch (op) {
    case NamedOp::equal:
    case NamedOp::not_equal:
    case NamedOp::greater:
    case NamedOp::less:
    case NamedOp::greater_equal:
    case NamedOp::less_equal: return truth(compared(op, x, y));
    case NamedOp::multiply: return result(x * y);
    case NamedOp::divide: return y == 0 ? AlarmId::division_by_zero : is(x / y, Type::real);
    case NamedOp::whole_divide: return y == 0 ? AlarmId::division_by_zero : is(std::trunc(x / y), Type::integer);
    case NamedOp::modulo: return y == 0 ? AlarmId::division_by_zero : result(std::fmod(x, y));
    case NamedOp::add: return result(x + y);
    case NamedOp::subtract: return result(x - y);
    case NamedOp::bit_and: return is(static_cast<double>(bits(x) & bits(y)), Type::integer);
    case NamedOp::bit_xor: return is(static_cast<double>(bits(x) ^ bits(y)), Type::integer);
    case NamedOp::bit_or: return is(static_cast<double>(bits(x) | bits(y)), Type::integer);
    case NamedOp::logic_and: return truth(x != 0 && y != 0);
    case NamedOp::logic_xor: return truth((x != 0) != (y != 0));
    case NamedOp::logic_or: return truth(x != 0 || y != 0);
    default: return AlarmId::operand_type;
  }
}

Number apply(NamedOp op, Number a) {
  switch (op) {
    case NamedOp::negate: return {-a.value, a.type == Type::real ? Type::real : Type::integer};
    case NamedOp::logic_not: return {a.value == 0 ? 1.0 : 0.0, Type::boolean};
    default: return {static_cast<double>(~bits(a.value)), Type::integer};
  }
}

std::optional<double> number_as(Type type, double value) {
  switch (type) {
    case Type::integer: {
      const double whole = std::round(value);  // INFERRED: halves are rounded away from zero
      return std::fabs(whole) <= most_integer ? std::optional(whole) : std::nullopt;
    }
    case Type::real: return value;
    case Type::boolean: return value != 0 ? 1.0 : 0.0;
    case Type::character: return value >= 0 && value <= 255 ? std::optional(std::round(value)) : std::nullopt;
    default: return std::nullopt;
  }
}

}  // namespace kadr::sinumerik
