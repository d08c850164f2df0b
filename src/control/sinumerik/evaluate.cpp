// Evaluates expressions (spec/sinumerik 7). Used by control/sinumerik.

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>

#include "base/ascii.h"
#include "control/sinumerik/number.h"
#include "control/sinumerik/sinumerik.h"

namespace kadr::sinumerik {
namespace {

Result<Value> compared(NamedOp op, const Value& a, const Value& b, Span where) {
  int order = 0;
  if (a.type == b.type && (a.type == Type::text || a.type == Type::axis)) {
    order = a.text.compare(b.text);
  } else if (a.type == Type::frame && b.type == Type::frame && (op == NamedOp::equal || op == NamedOp::not_equal)) {
    order = *a.frame == *b.frame ? 0 : 1;
  } else {
    return fail(alarm(AlarmId::operand_type, where, written(op)));
  }
  switch (op) {
    case NamedOp::equal: return boolean(order == 0);
    case NamedOp::not_equal: return boolean(order != 0);
    case NamedOp::greater: return boolean(order > 0);
    case NamedOp::less: return boolean(order < 0);
    case NamedOp::greater_equal: return boolean(order >= 0);
    default: return boolean(order <= 0);
  }
}

Value value_of(Number number) { return {number.type, false, number.value, {}, {}}; }

Result<Value> applied(NamedOp op, const Value& a, const Value& b, Span where) {
  if (op == NamedOp::join) return text_value(joined_text(a) + joined_text(b));
  if (op == NamedOp::chain) {
    if (a.type != Type::frame || b.type != Type::frame) return fail(alarm(AlarmId::operand_type, where, ":"));
    return frame_value(chained(*a.frame, *b.frame));
  }
  const bool numbers = a.is_number() && b.is_number();
  if (!numbers && op >= NamedOp::equal && op <= NamedOp::less_equal) return compared(op, a, b, where);
  Number to;
  const AlarmId fault = numbers ? apply(op, {a.number, a.type}, {b.number, b.type}, to) : AlarmId::operand_type;
  if (fault == AlarmId::operand_type) return fail(alarm(fault, where, written(op)));
  if (fault != no_alarm) return fail(alarm(fault, where));
  return value_of(to);
}

Result<Value> applied_to_one(NamedOp op, const Value& a, Span where) {
  if (!a.is_number()) return fail(alarm(AlarmId::operand_type, where, written(op)));
  return value_of(apply(op, {a.number, a.type}));
}

/// Calls a function of numbers.
///   alarms  operand_type, not_a_number, and those of the function
Result<Value> called(const NumberFunction& function, const std::vector<Value>& operands, Span where) {
  constexpr std::size_t most_operands = 3;
  std::array<double, most_operands> v{};
  if (operands.size() != function.operands ||
      !std::all_of(operands.begin(), operands.end(), [](const Value& one) { return one.is_number(); }))
    return fail(alarm(AlarmId::operand_type, where, function.name));
  std::transform(operands.begin(), operands.end(), v.begin(), [](const Value& one) { return one.number; });
  if (!function.allows(v[0])) return fail(alarm(function.fault, where, v[0]));
  const double to = function.of(v.data());
  if (!std::isfinite(to)) return fail(alarm(AlarmId::not_a_number, where));
  return real(to);
}

bool is_number_text(const std::string& text, double& number) {
  const std::size_t begin = text.find_first_not_of(' '), end = text.find_last_not_of(' ');
  if (begin == std::string::npos) return false;
  std::string plain = text.substr(begin, end + 1 - begin);
  if (plain.find_first_not_of("0123456789.+-eEX") != std::string::npos) return false;
  if (const std::size_t x = plain.find("EX"); x != std::string::npos) plain.replace(x, 2, "e");
  char* stop = nullptr;
  number = std::strtod(plain.c_str(), &stop);
  return stop == plain.c_str() + plain.size() && std::isfinite(number);
}

/// SPRINT("%5.2F", v): %B, %C, %D, %F, %E, %G, %S with width and decimals (spec/sinumerik 6.3).
Result<Value> printed(const std::vector<Value>& v, Span where) {
  if (v.empty() || v[0].type != Type::text) return fail(alarm(AlarmId::operand_type, where, "SPRINT"));
  const std::string& format = v[0].text;
  std::string all;
  std::size_t used = 1;
  for (std::size_t i = 0; i < format.size(); ++i) {
    if (format[i] != '%') {
      all += format[i];
      continue;
    }
    if (i + 1 < format.size() && format[i + 1] == '%') {
      all += format[++i];
      continue;
    }
    std::size_t end = i + 1;
    while (end < format.size() && (is_digit(format[end]) || format[end] == '.' || format[end] == '-' || format[end] == '+')) ++end;
    if (end >= format.size() || end - i > 8 || used >= v.size()) return fail(alarm(AlarmId::operand_type, where, "SPRINT"));
    const std::string shape = format.substr(i, end - i);
    const char kind = static_cast<char>(std::toupper(static_cast<unsigned char>(format[end])));
    const Value& value = v[used++];
    char text[512];
    if (kind == 'S' || kind == 'C' || kind == 'B') {
      const std::string one = kind == 'B' ? (value.number != 0 ? "TRUE" : "FALSE") : joined_text(value);
      std::snprintf(text, sizeof text, (shape + "s").c_str(), one.c_str());
    } else if (kind == 'D' && value.is_number()) {
      std::snprintf(text, sizeof text, (shape + "lld").c_str(), std::llround(value.number));
    } else if ((kind == 'F' || kind == 'E' || kind == 'G') && value.is_number()) {
      const std::string written = shape + static_cast<char>(std::tolower(static_cast<unsigned char>(kind)));
      std::snprintf(text, sizeof text, written.c_str(), value.number);
    } else {
      return fail(alarm(AlarmId::not_available, where, std::string_view("SPRINT " + shape + format[end])));
    }
    all += text;
    i = end;
  }
  return text_value(all);
}

/// Functions of texts (spec/sinumerik 6.3). Returns nullopt if no function has this name.
std::optional<Result<Value>> text_function(const std::string& name, const std::vector<Value>& v, Span where) {
  const auto text = [&](std::size_t i) { return i < v.size() ? joined_text(v[i]) : std::string(); };
  const auto whole = [&](std::size_t i) { return i < v.size() ? std::llround(v[i].number) : 0; };
  const auto place = [](std::size_t at) { return integer(at == std::string::npos ? -1.0 : static_cast<double>(at)); };
  if (name == "STRLEN") return integer(static_cast<double>(text(0).size()));
  if (name == "INDEX") return place(text(0).find(text(1).substr(0, 1)));
  if (name == "RINDEX") return place(text(0).rfind(text(1).substr(0, 1)));
  if (name == "MINDEX") return place(text(0).find_first_of(text(1)));
  if (name == "MATCH") return place(text(0).find(text(1)));
  if (name == "SUBSTR") {
    const std::string all = text(0);
    if (whole(1) < 0 || static_cast<std::size_t>(whole(1)) >= all.size()) return text_value({});
    const auto from = static_cast<std::size_t>(whole(1));
    return text_value(v.size() > 2 && !v[2].omitted ? all.substr(from, static_cast<std::size_t>(std::max<long long>(0, whole(2))))
                                                    : all.substr(from));
  }
  if (name == "TOUPPER" || name == "TOLOWER") {
    std::string all = text(0);
    for (char& c : all)
      c = static_cast<char>(name == "TOUPPER" ? std::toupper(static_cast<unsigned char>(c)) : std::tolower(static_cast<unsigned char>(c)));
    return text_value(all);
  }
  if (name == "NUMBER" || name == "ISNUMBER") {
    double number = 0;
    const bool is = is_number_text(text(0), number);
    if (name == "ISNUMBER") return boolean(is);
    if (!is) return Result<Value>(fail(alarm(AlarmId::text_not_number, where, std::string_view(text(0)))));
    return real(number);
  }
  if (name == "SPRINT") return printed(v, where);
  if (name == "AXNAME") return axis_value(text(0));
  if (name == "AXSTRING") return text_value(text(0));
  return std::nullopt;
}

}  // namespace

std::shared_ptr<Variable> Sinumerik::variable(const std::string& name) {
  const auto found = level().variables.find(name);
  if (found != level().variables.end()) return found->second;
  const auto global = memory.globals.find(name);
  return global == memory.globals.end() ? nullptr : global->second;
}

Result<std::size_t> Sinumerik::element(BlockContext& m, const NamedBlock& block, const std::string& name, const Variable& of,
                                       const std::vector<NamedExpression>& indices, Span where) {
  if (indices.empty() && of.sizes.empty()) return std::size_t{0};
  if (indices.size() != of.sizes.size()) return fail(alarm(AlarmId::index_range, where, std::string_view(name), double(indices.size())));
  std::size_t at = 0;
  for (std::size_t i = 0; i < indices.size(); ++i) {
    const auto value = number(m, block, indices[i], where);
    if (!value) return fail(value.error());
    const double index = std::round(*value);
    if (!(index >= 0) || index >= of.sizes[i]) return fail(alarm(AlarmId::index_range, where, std::string_view(name), index));
    at = at * of.sizes[i] + static_cast<std::size_t>(index);
  }
  return at;
}

Result<double> Sinumerik::number(BlockContext& m, const NamedBlock& block, NamedExpression expression, Span where) {
  const auto value = evaluate(m, block, expression);
  if (!value) return fail(value.error());
  if (!value->is_number()) return fail(alarm(AlarmId::operand_type, where, name_of(value->type)));
  return value->number;
}

Result<Value> Sinumerik::evaluate(BlockContext& m, const NamedBlock& block, NamedExpression expression) {
  auto values = evaluate_all(m, block, expression);
  if (!values) return fail(values.error());
  if (values->empty()) return fail(alarm(AlarmId::expression_syntax, m.block->where, "…"));
  return std::move(values->back());
}

// NOLINTNEXTLINE(readability-function-size): one switch over the kinds of steps
Result<std::vector<Value>> Sinumerik::evaluate_all(BlockContext& m, const NamedBlock& block, NamedExpression expression) {
  std::vector<Value> stack;
  const auto take = [&](std::size_t count) {
    std::vector<Value> top(stack.end() - static_cast<std::ptrdiff_t>(count), stack.end());
    stack.resize(stack.size() - count);
    return top;
  };
  for (std::uint32_t i = expression.begin; i < expression.end; ++i) {
    const NamedStep& step = block.code[i];
    switch (step.kind) {
      case NamedStep::Kind::real: stack.push_back(real(step.number)); break;
      case NamedStep::Kind::integer: stack.push_back(integer(step.number)); break;
      case NamedStep::Kind::boolean: stack.push_back(boolean(step.number != 0)); break;
      case NamedStep::Kind::text: stack.push_back(text_value(step.name)); break;
      case NamedStep::Kind::omitted: {
        Value left_out = integer(0);
        left_out.omitted = true;
        stack.push_back(left_out);
        break;
      }
      case NamedStep::Kind::parameter: {
        double index = step.number;
        if (step.operands == 1) index = std::round(take(1)[0].number);
        if (!(index >= 0) || index >= double{parameter_count}) return fail(alarm(AlarmId::index_range, step.where, "R", index));
        stack.push_back(real(memory.parameters[static_cast<std::size_t>(index)]));
        break;
      }
      case NamedStep::Kind::apply: {
        const std::vector<Value> operands = take(step.operands);
        auto value =
            step.operands == 1 ? applied_to_one(step.op, operands[0], step.where) : applied(step.op, operands[0], operands[1], step.where);
        if (!value) return fail(value.error());
        stack.push_back(std::move(*value));
        break;
      }
      case NamedStep::Kind::name: {
        const std::vector<Value> indices = take(step.operands);
        if (step.name[0] == '$') {
          auto value = read_system(m, step.name, indices, step.where);
          if (!value) return fail(value.error());
          stack.push_back(std::move(*value));
          break;
        }
        const auto found = variable(step.name);
        if (found == nullptr) {
          if (step.name == "PI" && indices.empty()) {
            stack.push_back(real(pi));
            break;
          }
          const bool component = step.name == "TR" || step.name == "FI" || step.name == "RT" || step.name == "SC" || step.name == "MI";
          if (!indices.empty() || (!axis_named(m, step.name) && !component))
            return fail(alarm(AlarmId::name_unknown, step.where, std::string_view(step.name)));
          stack.push_back(axis_value(step.name));
          break;
        }
        if (found->type == Type::text && found->sizes.empty() && indices.size() == 1) {  // one sign of a text
          const std::string& all = found->values[0].text;
          const double at = std::round(indices[0].number);
          if (!(at >= 0) || at >= static_cast<double>(all.size()))
            return fail(alarm(AlarmId::index_range, step.where, std::string_view(step.name), at));
          Value letter = initial_value(Type::character);
          letter.number = static_cast<unsigned char>(all[static_cast<std::size_t>(at)]);
          stack.push_back(letter);
          break;
        }
        if (found->type == Type::frame && indices.size() == found->sizes.size() + 2) {
          std::size_t at = 0;
          for (std::size_t k = 0; k < found->sizes.size(); ++k)
            at = at * found->sizes[k] + static_cast<std::size_t>(std::clamp(std::round(indices[k].number), 0.0, found->sizes[k] - 1.0));
          const Value &axis = indices[indices.size() - 2], &part = indices.back();
          const auto of = axis.type == Type::axis ? axis_named(m, axis.text) : std::nullopt;
          if (!of) return fail(alarm(AlarmId::frame_component, step.where, std::string_view(axis.text)));
          const auto value = component_of(*found->values[at].frame, *of, part.text, step.where);
          if (!value) return fail(value.error());
          stack.push_back(real(*value));
          break;
        }
        if (indices.size() != found->sizes.size())
          return fail(alarm(AlarmId::index_range, step.where, std::string_view(step.name), double(indices.size())));
        std::size_t at = 0;
        for (std::size_t k = 0; k < indices.size(); ++k) {
          const double index = std::round(indices[k].number);
          if (!(index >= 0) || index >= found->sizes[k])
            return fail(alarm(AlarmId::index_range, step.where, std::string_view(step.name), index));
          at = at * found->sizes[k] + static_cast<std::size_t>(index);
        }
        stack.push_back(found->values[at]);
        break;
      }
      case NamedStep::Kind::call: {
        const std::vector<Value> operands = take(step.operands);
        if (const NumberFunction* const function = number_function(step.name)) {
          auto value = called(*function, operands, step.where);
          if (!value) return fail(value.error());
          stack.push_back(std::move(*value));
          break;
        }
        if (auto value = text_function(step.name, operands, step.where)) {
          if (!*value) return fail(value->error());
          stack.push_back(std::move(**value));
          break;
        }
        auto value = frame_function(step.name, operands, m, step.where);
        if (!value) return fail(value.error());
        stack.push_back(std::move(*value));
        break;
      }
    }
  }
  return stack;
}

}  // namespace kadr::sinumerik
