// Computes expressions, and texts of QS parameters (spec/heidenhain 10). Used by control/heidenhain.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "base/ascii.h"
#include "control/heidenhain/heidenhain.h"

namespace kadr::heidenhain {
namespace {

double degrees(double radians) { return radians / rad_per_deg; }

/// FN 13: the angle whose tangent is a/b, 0 to 360 degrees.
double full_angle(double a, double b) {
  const double angle = degrees(std::atan2(a, b));
  return angle < 0 ? angle + 360 : angle;
}

Result<double> of_one(KlartextOp op, double v, Span where) {
  switch (op) {
    case KlartextOp::negate:
    case KlartextOp::negative: return -v;
    case KlartextOp::sin: return sincos_deg(v).sin;
    case KlartextOp::cos: return sincos_deg(v).cos;
    case KlartextOp::tan: {
      const SinCos turn = sincos_deg(v);
      if (turn.cos == 0) return fail(alarm(AlarmId::tangent_of_right_angle, where, v));
      return turn.sin / turn.cos;
    }
    case KlartextOp::asin:
    case KlartextOp::acos:
      if (!(std::fabs(v) <= 1)) return fail(alarm(AlarmId::argument_above_one, where, v));
      return degrees(op == KlartextOp::asin ? std::asin(v) : std::acos(v));
    case KlartextOp::atan: return degrees(std::atan(v));
    case KlartextOp::square: return v * v;
    case KlartextOp::square_root:
      if (!(v >= 0)) return fail(alarm(AlarmId::root_of_negative, where, v));
      return std::sqrt(v);
    case KlartextOp::natural_log:
    case KlartextOp::log:
      if (!(v > 0)) return fail(alarm(AlarmId::argument_not_positive, where, v));
      return op == KlartextOp::log ? std::log10(v) : std::log(v);
    case KlartextOp::exp: return std::exp(v);
    case KlartextOp::integer: return std::trunc(v);
    case KlartextOp::absolute: return std::fabs(v);
    case KlartextOp::fraction: return v - std::trunc(v);
    default: return v < 0 ? -1.0 : 1.0;  // SGN; of 0: 1 (spec/heidenhain 10.4)
  }
}

Result<double> of_two(KlartextOp op, double a, double b, Span where) {
  switch (op) {
    case KlartextOp::add: return a + b;
    case KlartextOp::subtract: return a - b;
    case KlartextOp::multiply: return a * b;
    case KlartextOp::divide:
    case KlartextOp::remainder:
      if (b == 0) return fail(alarm(AlarmId::division_by_zero, where));
      return op == KlartextOp::divide ? a / b : std::fmod(a, b);
    case KlartextOp::power: return std::pow(a, b);
    case KlartextOp::length: return std::hypot(a, b);
    default: return full_angle(a, b);
  }
}

}  // namespace

Result<double> Heidenhain::evaluate(BlockContext& m, const KlartextBlock& block, KlartextExpression expression) {
  stack_.clear();
  const auto text = [&](std::uint16_t number) -> const std::string& {
    static const std::string nothing;
    const auto found = memory.texts.find(number);
    return found == memory.texts.end() ? nothing : found->second;
  };
  for (std::uint16_t i = expression.begin; i < expression.end; ++i) {
    const KlartextStep& step = block.code[i];
    switch (step.op) {
      case KlartextOp::number: stack_.push_back(step.number); continue;
      case KlartextOp::parameter: {
        const auto read = parameter(m, step.family, step.index, step.where);
        if (!read) return read;
        stack_.push_back(*read);
        continue;
      }
      case KlartextOp::undefined: stack_.push_back(std::isnan(family(step.family)[step.index]) ? 1 : 0); continue;
      case KlartextOp::text_length: stack_.push_back(static_cast<double>(text(step.index).size())); continue;
      case KlartextOp::text_number: {
        const std::string& from = text(step.index);
        char* end = nullptr;
        const double value = std::strtod(from.c_str(), &end);
        if (end == from.c_str()) return fail(alarm(AlarmId::text_not_number, step.where, std::string_view(from)));
        stack_.push_back(value);
        continue;
      }
      case KlartextOp::text_compare: {
        const int order = text(step.index).compare(text(step.second));
        stack_.push_back(order < 0 ? -1 : order > 0 ? 1 : 0);
        continue;
      }
      case KlartextOp::text_find: {
        const std::string& in = text(step.index);
        const double begin = stack_.back();
        const std::size_t at = begin >= 0 ? in.find(text(step.second), static_cast<std::size_t>(begin)) : std::string::npos;
        stack_.back() = static_cast<double>(at == std::string::npos ? in.size() : at);
        continue;
      }
      case KlartextOp::add:
      case KlartextOp::subtract:
      case KlartextOp::multiply:
      case KlartextOp::divide:
      case KlartextOp::remainder:
      case KlartextOp::power:
      case KlartextOp::length:
      case KlartextOp::angle: {
        const double second = stack_.back();
        stack_.pop_back();
        const auto result = of_two(step.op, stack_.back(), second, step.where);
        if (!result) return result;
        stack_.back() = *result;
        break;
      }
      default: {
        const auto result = of_one(step.op, stack_.back(), step.where);
        if (!result) return result;
        stack_.back() = *result;
      }
    }
    if (!std::isfinite(stack_.back())) return fail(alarm(AlarmId::not_a_number, step.where));
  }
  return stack_.back();
}

Status Heidenhain::set_parameter(const KlartextStep& to, double value) {
  double& place = family(to.family)[to.index];
  note_written(to.family, to.index, place);
  // A line Q200=… behind a definition without ~ belongs to the definition (spec/heidenhain 1.2).
  if (to.family == ParameterFamily::q && to.index >= 200 && to.index < first_builder_q && memory.cycle >= 200) memory.defined.set(to.index);
  place = value;
  return {};
}

Result<std::string> Heidenhain::text_value(BlockContext& m, const KlartextBlock& block) {
  std::string all;
  constexpr std::size_t longest = 255;  // characters of a text (spec/heidenhain 10.1)
  for (const TextPiece& piece : block.pieces) {
    const auto number = [&](KlartextExpression of) -> Result<double> { return of ? evaluate(m, block, of) : Result<double>(0.0); };
    const auto first = number(piece.first), second = number(piece.second);
    if (!first) return fail(first.error());
    if (!second) return fail(second.error());
    const auto found = memory.texts.find(piece.index);
    const std::string source = found == memory.texts.end() ? std::string() : found->second;
    switch (piece.kind) {
      case TextPiece::Kind::literal: all += piece.text; break;
      case TextPiece::Kind::parameter: all += source; break;
      case TextPiece::Kind::part: {
        if (!(*first >= 0) || !(*second >= 0)) return fail(alarm(AlarmId::index_range, block.where, "SUBSTR", std::min(*first, *second)));
        const auto begin = static_cast<std::size_t>(std::min<double>(*first, static_cast<double>(source.size())));
        all += source.substr(begin, piece.second ? static_cast<std::size_t>(std::min<double>(*second, longest)) : std::string::npos);
        break;
      }
      case TextPiece::Kind::number: all += fmt::format("{:.{}f}", *first, static_cast<int>(std::clamp(*second, 0.0, 9.0))); break;
    }
  }
  if (all.size() > longest) all.resize(longest);
  return all;
}

}  // namespace kadr::heidenhain
