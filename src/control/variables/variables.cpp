// The variables #1 … #n of Mach3, with its system variables, and the parameters R0 … R9 of the 2С42. Used by control/interpreter,
// control/snapshot_content.

#include "control/variables/variables.h"

#include <algorithm>
#include <cmath>

#include "base/tolerance.h"
#include "base/units.h"

namespace kadr {
namespace {

// the program uses variables with lower numbers freely, because they have no meaning for the control
constexpr std::uint32_t first_system_variable = 1000;

/// Returns how many parameters the control has: ten (R0 to R9), or a thousand for each parameter letter.
std::size_t parameters_of(const Grammar& grammar) {
  constexpr std::size_t of_one_digit = 10;
  return std::max(of_one_digit, grammar.long_parameters.size() * parameters_a_letter);
}

/// Returns `number` as a variable number; 0 if no variable has this number.
std::uint32_t number_of(double number, std::uint32_t highest) {
  const double nearest = std::round(number);
  if (!(nearest >= 1) || nearest > highest || std::fabs(number - nearest) > tol::whole_number) return 0;
  return static_cast<std::uint32_t>(nearest);
}

}  // namespace

Variables::Variables(const ControlDef& def, Journal& journal) : def_(def), journal_(journal) {
  // A control with custom macros has its variables in MacroVariables, so this class has none for it.
  all_.values.resize(def.grammar.has_vacant_variables() ? 1 : def.grammar.variables + 1);
  all_.set.resize(all_.values.size());
  all_.parameters.resize(parameters_of(def.grammar));
  all_.parameters_set.resize(all_.parameters.size());
}

Result<double> Variables::variable(double number, Span where) const {
  const std::uint32_t n = number_of(number, highest());
  if (n == 0) return fail(alarm(AlarmId::variable_unknown, where, number));
  if (inch && n >= first_system_variable && is_length(n)) return all_.values[n] / mm_per_inch;
  return all_.values[n];
}

Result<double> Variables::parameter(int index, Span where) const {
  if (!parameter_set(index)) return fail(alarm(AlarmId::variable_not_set, where, name_of_parameter(index)));
  return raw_parameter(index);
}

Status Variables::set(double number, double value, Span where) {
  const std::uint32_t n = number_of(number, highest());
  if (n == 0) return fail(alarm(AlarmId::variable_unknown, where, number));
  const bool length = n >= first_system_variable && is_length(n);
  set_raw(n, inch && length ? value * mm_per_inch : value);
  return {};
}

void Variables::set_raw(std::uint32_t number, double value) {
  // nothing is set, because a row of the control's file may name a number above the highest variable
  if (number >= all_.values.size()) return;
  journal_.keep(all_.values[number]);
  journal_.keep(all_.set[number]);
  all_.values[number] = value;
  all_.set[number] = 1;
  if (number >= first_system_variable && kind_of(number) != VariableKind::free) frames_changed_ = true;
}

void Variables::set_parameter(int index, double value) {
  const auto i = static_cast<std::size_t>(index);
  journal_.keep(all_.parameters[i]);
  journal_.keep(all_.parameters_set[i]);
  all_.parameters[i] = value;
  all_.parameters_set[i] = 1;
}

std::string Variables::name_of_parameter(int index) const {
  const std::string& letters = def_.grammar.long_parameters;
  if (letters.empty()) return "R" + std::to_string(index);
  const std::string number = std::to_string(index % parameters_a_letter);
  return letters[static_cast<std::size_t>(index / parameters_a_letter)] + (number.size() < 2 ? "0" + number : number);
}

int Variables::parameter_named(const std::string& name) const {
  if (name.size() < 2 || name.find_first_not_of("0123456789", 1) != std::string::npos) return -1;
  const std::string& letters = def_.grammar.long_parameters;
  const int number = name.size() <= 4 ? std::atoi(name.c_str() + 1) : -1;
  if (letters.empty()) return name[0] == 'R' && name.size() == 2 ? number : -1;
  const std::size_t letter = letters.find(name[0]);
  return letter == std::string::npos || number < 0 || name.size() < 3 ? -1 : static_cast<int>(letter) * parameters_a_letter + number;
}

VariableKind Variables::kind_of(std::uint32_t number) const {
  for (const VariableRow& row : def_.variables) {
    const VariableRange& range = row.ranges.front();
    if (number < range.from) continue;
    const std::uint32_t beyond = number - range.from;
    const std::uint32_t nth = range.stride == 0 ? 0 : beyond / range.stride;
    if (nth < range.repeat && beyond - nth * range.stride < range.count) return row.kind;
  }
  return VariableKind::free;
}

bool Variables::is_length(std::uint32_t number) const {
  const VariableKind kind = kind_of(number);
  return kind != VariableKind::free && kind != VariableKind::fixture_number;
}

std::uint32_t Variables::first(VariableKind kind, std::uint32_t nth) const {
  for (const VariableRow& row : def_.variables)
    if (row.kind == kind) return row.ranges.front().from + nth * row.ranges.front().stride;
  return 0;
}

bool Variables::consume_frames_changed() {
  const bool changed = frames_changed_;
  frames_changed_ = false;
  return changed;
}

}  // namespace kadr
