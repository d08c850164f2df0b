// Executes compiled lines (calculation.h). Used by control/sinumerik/flow.

#include "control/sinumerik/calculation.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "control/sinumerik/sinumerik.h"

namespace kadr::sinumerik {

void Calculation::forget_all() {
  files_.clear();
  lines_.clear();
  code_.clear();
  forget_variables();
}

Variable* Calculation::variable(std::uint32_t slot) {
  Variable*& known = slots_[slot];
  if (known == &unknown_) known = own_.variable(names_[slot]).get();
  return known;
}

namespace {

/// Returns the place of an element; nullopt if an index is outside its range, or if their number is wrong.
std::optional<std::size_t> element_of(const Variable& of, const Number* indices, std::size_t count) {
  if (count != of.sizes.size()) return std::nullopt;
  std::size_t at = 0;
  for (std::size_t i = 0; i < count; ++i) {
    const double index = std::round(indices[i].value);
    if (!(index >= 0) || index >= of.sizes[i]) return std::nullopt;
    at = at * of.sizes[i] + static_cast<std::size_t>(index);
  }
  return at;
}

constexpr double not_finite = std::numeric_limits<double>::infinity();

bool is_parameter(double index) { return index >= 0 && index < double{parameter_count}; }

}  // namespace

bool Calculation::pushed_variable(const Step& step, Number* stack, std::size_t& count) {
  const Variable* const found = variable(step.index);
  if (found == nullptr) {
    if (step.operands != 0 || names_[step.index] != "PI") return false;
    stack[count++] = {pi, Type::real};
    return true;
  }
  if (found->type > Type::character) return false;
  count -= step.operands;
  const auto at = element_of(*found, stack + count, step.operands);
  if (!at) return false;
  const Value& from = found->values[*at];
  stack[count++] = {from.number, from.type};
  return !from.omitted;
}

/// Returns false if the expression has no number as its value, or causes an alarm.
bool Calculation::value(Code code, Number& to) {
  auto& stack = stack_;
  std::size_t n = 0;
  for (std::uint32_t i = code.begin; i < code.end; ++i) {
    const Step& step = code_[i];
    switch (step.kind) {
      case Step::Kind::number: stack[n++] = step.number; break;
      case Step::Kind::parameter: stack[n++] = {own_.memory.parameters[step.index], Type::real}; break;
      case Step::Kind::parameter_at: {
        const double index = std::round(stack[n - 1].value);
        if (!is_parameter(index)) return false;
        stack[n - 1] = {own_.memory.parameters[static_cast<std::size_t>(index)], Type::real};
        break;
      }
      case Step::Kind::variable:
        if (!pushed_variable(step, stack.data(), n)) return false;
        break;
      case Step::Kind::apply_one: stack[n - 1] = apply(step.op, stack[n - 1]); break;
      case Step::Kind::apply_two:
        --n;
        if (apply(step.op, stack[n - 1], stack[n], stack[n - 1]) != no_alarm) return false;
        break;
      case Step::Kind::function: {
        std::array<double, 3> operands{};
        n -= step.operands;
        for (std::size_t k = 0; k < step.operands; ++k) operands[k] = stack[n + k].value;
        const double result = step.function->allows(operands[0]) ? step.function->of(operands.data()) : not_finite;
        if (!std::isfinite(result)) return false;
        stack[n++] = {result, Type::real};
        break;
      }
    }
  }
  to = stack[0];
  return true;
}

/// Returns the number that the assignment writes to; nullptr if there is none.
double* Calculation::place(const Target& target, Type& type) {
  std::array<Number, 3> indices;
  if (target.indices.size() > indices.size()) return nullptr;
  for (std::size_t i = 0; i < target.indices.size(); ++i)
    if (!value(target.indices[i], indices[i])) return nullptr;
  if (!target.slot) {
    type = Type::real;
    const double index = target.indices.empty() ? target.parameter : std::round(indices[0].value);
    return is_parameter(index) ? &own_.memory.parameters[static_cast<std::size_t>(index)] : nullptr;
  }
  Variable* const found = variable(*target.slot);
  if (found == nullptr || found->type > Type::character) return nullptr;
  type = found->type;
  const auto at = element_of(*found, indices.data(), target.indices.size());
  if (!at) return nullptr;
  found->values[*at].omitted = false;
  return &found->values[*at].number;
}

bool Calculation::write(double* to, Type type, Number value) {
  const auto fits = number_as(type, value.value);
  if (!fits) return false;
  written_.push_back({to, *to});
  *to = *fits;
  return true;
}

void Calculation::undo() {
  for (; !written_.empty(); written_.pop_back()) *written_.back().to = written_.back().before;
}

/// FOR: sets its variable, or counts on if ENDFOR has jumped to it, and ends the loop behind the last value.
std::optional<bool> Calculation::count(const Line& line) {
  const Target& target = line.targets.front();
  Type type = Type::real;
  double* const to = place(target, type);
  Number first, last;
  if (to == nullptr || (type != Type::real && type != Type::integer)) return std::nullopt;
  if (own_.memory.counts_on == line.at) {
    written_.push_back({to, *to});
    *to += 1;
  } else if (!value(target.value, first) || !write(to, type, first)) {
    return std::nullopt;
  }
  if (!value(line.condition, last)) return std::nullopt;
  own_.memory.counts_on.reset();
  return *to > last.value;
}

std::optional<bool> Calculation::execute(const Line& line) {
  Number on;
  switch (line.kind) {
    case Kind::other: return std::nullopt;
    case Kind::nothing: return false;
    case Kind::assign:
      for (const Target& target : line.targets) {
        Type type = Type::real;
        Number result;
        double* const to = place(target, type);
        if (to == nullptr || !value(target.value, result) || !write(to, type, result)) return std::nullopt;
      }
      return false;
    case Kind::jump: return true;
    case Kind::jump_if:
    case Kind::jump_unless:
      return value(line.condition, on) ? std::optional((on.value != 0) == (line.kind == Kind::jump_if)) : std::nullopt;
    case Kind::count: return count(line);
    case Kind::count_on: own_.memory.counts_on = line.target; return true;
    default: return std::nullopt;
  }
}

bool Calculation::call(Interpreter& m, const Call& of) {
  auto [arguments, references] = own_.empty_arguments();
  for (std::size_t i = 0; i < of.arguments.size(); ++i) {
    Number number;
    if (!value(of.arguments[i], number)) return false;
    arguments.push_back({number.type, false, number.value, {}, {}});
    references.push_back(of.references[i].empty() ? nullptr : own_.variable(of.references[i]));
  }
  m.origin = of.origin;
  m.origin.number = static_cast<std::uint32_t>(m.program().blocks());
  m.origin.depth = static_cast<std::uint8_t>(std::min<std::size_t>(m.program().depth(), 255));
  own_.level().acted = true;
  return own_.call(m, of.program, of.name, std::move(arguments), std::move(references), !of.arguments.empty(), 1, {}).has_value();
}

bool Calculation::steer(Interpreter& m, const Line& line) {
  if (m.watches_calls()) return false;
  Level& level = own_.level();
  switch (line.kind) {
    case Kind::call: return call(m, *line.call);
    case Kind::parameters: {
      if (level.executing || level.took_arguments || !level.variables.empty()) return false;
      if (own_.procedure(m, line.call->read)) return true;
      level.took_arguments = false;
      level.variables.clear();
      return false;
    }
    default:  // M17, RET
      if (own_.memory.levels.size() == 1 || level.saved || (level.has_arguments && !level.took_arguments)) return false;
      return own_.leave(m, {}).has_value();
  }
}

bool Calculation::run(Interpreter& m) {
  constexpr std::uint64_t most_at_once = 4096;  // so that the caller may stop the run
  const std::size_t depth = m.program().depth();
  Position now = m.program().position();
  const RepeatedPart* const part =
      !own_.memory.repeated.empty() && own_.memory.repeated.back().depth == depth ? &own_.memory.repeated.back() : nullptr;
  const auto leaves_part = [&](const Position& to) {
    return part != nullptr && (to.offset < part->begin.offset || to.offset >= part->end.offset);
  };
  constexpr std::uint64_t last_blocks = 2;  // by the general path, so that the alarm of an endless program names the right line
  const std::uint64_t left = m.program().repeats_left();
  const std::uint64_t most = std::min(most_at_once, left - std::min(left, last_blocks));
  std::uint64_t done = 0;
  for (std::int32_t at = line_at(m, now); at != 0 && done < most && !leaves_part(now);) {
    Line& line = lines_[static_cast<std::size_t>(at)];
    if (line.label_slot && variable(*line.label_slot) != nullptr) break;
    if (line.kind >= Kind::call) {
      m.flow.jump(line.after);
      if (steer(m, line)) {
        m.flow.pass(done + 1);
        return true;
      }
      break;
    }
    if (line.kind == Kind::other || (line.kind >= Kind::jump && leaves_part(line.target))) break;
    Level& level = own_.level();
    if (!level.executing && line.kind != Kind::nothing) {
      if (level.has_arguments && !level.took_arguments) break;
      level.executing = true;
    }
    const auto jumps = execute(line);
    if (!jumps) {
      undo();
      break;
    }
    written_.clear();
    if (*jumps && line.acts) level.acted = true;
    now = *jumps ? line.target : line.after;
    std::int32_t& follows = *jumps ? line.jumped : line.next;
    if (follows < 0) follows = line_at(m, now);
    at = follows;
    ++done;
  }
  if (m.program().position() != now) m.flow.jump(now);
  if (done == 0) return false;
  m.flow.pass(done);
  return true;
}

}  // namespace kadr::sinumerik
