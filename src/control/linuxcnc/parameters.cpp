// Reads and writes the parameters: the numbered ones #1 … #5601, and the named ones #<name> (spec/linuxcnc 4).

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>

#include "base/ascii.h"
#include "base/code_literals.h"
#include "base/units.h"
#include "control/emitter.h"
#include "control/linuxcnc/linuxcnc.h"
#include "lang/expression/element_symbols.h"

namespace kadr::linuxcnc {
namespace {

constexpr int last_parameter = 5601;

double per_unit(const BlockContext& m) { return m.modal.inch ? mm_per_inch : 1; }

/// Returns the coordinate of the position `of` on one axis, in the unit of the program. #5420 … have these values.
double position(const BlockContext& m, const Axes& of, std::size_t axis) {
  if (axis >= m.axis_count) return 0;
  return is_rotary_place(axis) ? of[axis] : of[axis] / per_unit(m);
}

/// Returns the value of a parameter #5400 … #5413, which have the data of the tool in the spindle. `n`: number of the parameter minus 5400.
double of_tool(const BlockContext& m, const LinuxCnc& control, int n) {
  if (n == 0) return m.modal.tool;
  const Tool* const tool = control.tool(m.modal.tool);
  if (tool == nullptr || m.modal.tool == 0) return 0;
  if (n <= 9) return tool->offset[static_cast<std::size_t>(n - 1)] / control.table_unit(static_cast<std::size_t>(n - 1));
  const double others[] = {tool->diameter / control.machine.unit, tool->front, tool->back, tool->orientation};
  return others[n - 10];
}

std::optional<double> predefined(const BlockContext& m, const LinuxCnc& control, std::string_view name);

constexpr const char* out_of_range = "Parameter number out of range";

}  // namespace

Result<double> LinuxCnc::read_variable(Emitter& m, double number, Span where) const {
  if (VariableNames::is_named(number)) {
    const NameKind kind = kind_of(m, number);
    const std::map<double, double>& of = kind == NameKind::common ? globals_ : level().named;
    if (const auto found = of.find(number); found != of.end()) return found->second;
    const std::string name = m.def.grammar.named_variables->name_of(number);
    if (kind == NameKind::own) return predefined(m, *this, name).value_or(0);
    // A name exists from its assignment on, even within the same block (spec/linuxcnc 4.2).
    for (const Assignment& a : m.block->assignments)
      if (a.where.begin < where.begin && m.block->code[a.target.begin].number == number) return 0.0;
    return fault(AlarmId::rs274_parameter, where, fmt::format("Named parameter #<{}> not defined", name));
  }
  const double nearest = std::round(number);
  if (std::fabs(number - nearest) > whole_within) return fault(AlarmId::rs274_parameter, where, "Non integer value for integer");
  if (!(nearest >= 1 && nearest <= last_parameter)) return fault(AlarmId::rs274_parameter, where, out_of_range);
  const auto n = static_cast<int>(nearest);
  if (n <= static_cast<int>(max_arguments)) return level().arguments[static_cast<std::size_t>(n)];
  if (n >= 5400 && n <= 5413) return of_tool(m, *this, n - 5400);
  if (n >= 5420 && n <= 5428) {
    if (m.modal.radius_side != 0)
      return fault(AlarmId::rs274_compensation, where, "Cannot read current position with cutter radius compensation on");
    return position(m, m.position.programmed, static_cast<std::size_t>(n - 5420));
  }
  if (n >= 5061 && n <= 5069) return position(m, probed, static_cast<std::size_t>(n - 5061));
  return m.variables.raw(static_cast<std::uint32_t>(n));
}

Status LinuxCnc::write_variable(BlockContext& m, double number, double value, Span where) {
  if (VariableNames::is_named(number)) {
    const NameKind kind = kind_of(m, number);
    if (kind == NameKind::own)
      return fault(AlarmId::rs274_parameter, where,
                   fmt::format("Cannot assign to read-only parameter #<{}>", m.def.grammar.named_variables->name_of(number)));
    std::map<double, double>& of = kind == NameKind::common ? globals_ : level().named;
    const auto known = of.find(number);
    if (known == of.end()) m.journal.on_undo([&of, number] { of.erase(number); });
    else m.journal.on_undo([&of, number, before = known->second] { of[number] = before; });
    of[number] = value;
    return {};
  }
  const double nearest = std::round(number);
  if (std::fabs(number - nearest) > whole_within) return fault(AlarmId::rs274_parameter, where, "Non integer value for integer");
  if (!(nearest >= 1 && nearest <= last_parameter)) return fault(AlarmId::rs274_parameter, where, out_of_range);
  const auto n = static_cast<std::size_t>(nearest);
  if ((n >= 5400 && n <= 5413) || (n >= 5420 && n <= 5428)) return fault(AlarmId::rs274_parameter, where, "Parameter is readonly");
  if (n <= max_arguments) {
    m.journal.keep(level().arguments[n]);
    level().arguments[n] = value;
    return {};
  }
  m.variables.set_raw(static_cast<std::uint32_t>(n), value);
  (void)m.variables.consume_frames_changed();  // a work offset that a parameter has changed comes into force only with its code G54 …
  return {};
}

/// Returns the kind of a named parameter. The result is stored for each name, because comparing texts takes time.
LinuxCnc::NameKind LinuxCnc::kind_of(const BlockContext& m, double number) const {
  const auto index = static_cast<std::size_t>(number - first_named_variable);
  if (index >= name_kinds_.size()) name_kinds_.resize(index + 1, NameKind::unknown);
  NameKind& kind = name_kinds_[index];
  if (kind != NameKind::unknown) return kind;
  const std::string name = m.def.grammar.named_variables->name_of(number);
  return kind = predefined(m, *this, name) ? NameKind::own : name.starts_with('_') ? NameKind::common : NameKind::local;
}

/// EXISTS: the result is true for a named parameter that is defined, and for a numbered parameter whose number is in range.
Result<double> LinuxCnc::number_of_element(const BlockContext& m, double symbol, double index, Span where) const {
  if (symbol == symbol_own_number && VariableNames::is_named(index)) return fault(AlarmId::rs274_parameter, where, out_of_range);
  if (symbol == symbol_own_number) return index;
  if (symbol == symbol_number_exists) return index >= 1 && index <= last_parameter ? 1.0 : 0.0;
  if (level().named.contains(index) || globals_.contains(index)) return 1.0;
  return predefined(m, *this, m.def.grammar.named_variables->name_of(index)) ? 1.0 : 0.0;
}

namespace {

/// Returns the value of a named parameter that LinuxCNC defines and that shows a mode (spec/linuxcnc 4.3); nullopt if `name` is not such a
/// parameter.
// NOLINTNEXTLINE(readability-function-size): a table
std::optional<double> mode_named(const BlockContext& m, const LinuxCnc& control, std::string_view name) {
  const Modal& modal = m.modal;
  if (name == "_motion_mode") return control.state.motion;
  if (name == "_plane") return control.code_in_force(m, 2);
  if (name == "_ccomp") return modal.radius_side == 0 ? 40_g : modal.radius_side < 0 ? 41_g : 42_g;
  if (name == "_metric") return modal.inch ? 0 : 1;
  if (name == "_imperial") return modal.inch ? 1 : 0;
  if (name == "_absolute") return modal.absolute ? 1 : 0;
  if (name == "_incremental") return modal.absolute ? 0 : 1;
  if (name == "_inverse_time") return modal.feed_mode == FeedMode::inverse_time ? 1 : 0;
  if (name == "_units_per_minute") return modal.feed_mode == FeedMode::per_minute ? 1 : 0;
  if (name == "_units_per_rev") return modal.feed_mode == FeedMode::per_revolution ? 1 : 0;
  if (name == "_coord_system") return control.code_in_force(m, 12);
  if (name == "_retract_r_plane") return modal.retract_initial ? 0 : 1;
  if (name == "_retract_old_z") return modal.retract_initial ? 1 : 0;
  if (name == "_spindle_rpm_mode") return modal.surface_speed ? 0 : 1;
  if (name == "_spindle_css_mode") return modal.surface_speed ? 1 : 0;
  if (name == "_ijk_absolute_mode") return modal.centers_absolute ? 1 : 0;
  if (name == "_lathe_diameter_mode") return control.code_in_force(m, 15) == 7_g ? 1 : 0;
  if (name == "_lathe_radius_mode") return control.code_in_force(m, 15) == 8_g ? 1 : 0;
  if (name == "_spindle_on") return modal.spindle == SpindleDir::cw || modal.spindle == SpindleDir::ccw ? 1 : 0;
  if (name == "_spindle_cw") return modal.spindle == SpindleDir::cw ? 1 : 0;
  if (name == "_mist") return modal.mist ? 1 : 0;
  if (name == "_flood") return modal.flood ? 1 : 0;
  if (name == "_speed_override") return modal.override_enabled && (modal.override_permission & 2) != 0 ? 1 : 0;
  if (name == "_feed_override") return modal.override_enabled && (modal.override_permission & feed_permission) != 0 ? 1 : 0;
  if (name == "_adaptive_feed") return 0;
  if (name == "_feed_hold") return 1;
  if (name == "_feed") return modal.feed_known ? modal.feed / (modal.feed_mode == FeedMode::inverse_time ? 1 : per_unit(m)) : 0;
  if (name == "_rpm") return std::fabs(modal.rpm);
  return std::nullopt;
}

/// Returns the position that LinuxCNC reports. Under cutter compensation this is the tool's position, not the programmed point (current_x
/// of LinuxCNC's source).
Axes current_point(const BlockContext& m, Axes at) {
  if (m.modal.contour == CompensationPhase::following) {
    at[m.modal.compensation_axes.first] += m.modal.compensation_vector.x;
    at[m.modal.compensation_axes.second] += m.modal.compensation_vector.y;
  }
  return at;
}

std::optional<double> place_named(const BlockContext& m, const LinuxCnc& control, std::string_view name) {
  constexpr std::string_view letters = "xyzabcuvw";
  if (name.size() == 2 && letters.find(name[1]) != std::string_view::npos)
    return position(m, current_point(m, m.position.programmed), letters.find(name[1]));
  // LinuxCNC has parameters #<_abs_x> … #<_abs_c>, but none for U, V, W
  if (name.starts_with("_abs_") && name.size() == 6 && letters.find(name[5]) < axis_u)
    return position(m, current_point(m, m.position.machine), letters.find(name[5]));
  if (name == "_tool_offset")
    return std::any_of(control.state.length.begin(), control.state.length.end(), [](double v) { return v != 0; }) ? 1 : 0;
  if (name == "_current_tool") return m.modal.tool;
  if (name == "_selected_tool") return m.modal.tool_selected;
  const auto pocket = [&](std::uint32_t number) {
    const Tool* const tool = control.tool(number);
    return tool == nullptr ? -1.0 : tool->pocket;
  };
  if (name == "_current_pocket") return pocket(m.modal.tool);
  if (name == "_selected_pocket") return pocket(m.modal.tool_selected);
  return std::nullopt;
}

/// Returns the value of the parameter `_ini[section]key`, which is the value of a key in the ini file. The letter case of the name is lost
/// when the name is read, so section and key are searched in capitals.
std::optional<double> of_ini(const Ini& ini, std::string_view name) {
  const std::size_t close = name.find(']');
  if (close == std::string_view::npos) return std::nullopt;
  std::string capitals(name);
  for (char& c : capitals) c = to_upper(c);
  constexpr std::size_t begin = 5;  // position in the name at which the section begins, after the five characters `_INI[`
  return ini.number(capitals.substr(begin, close - begin), capitals.substr(close + 1));
}

std::optional<double> predefined(const BlockContext& m, const LinuxCnc& control, std::string_view name) {
  if (!name.starts_with('_')) return std::nullopt;
  if (control.machine.parameters_of_ini && name.starts_with("_ini[")) return of_ini(control.machine.ini, name);
  if (name == "_vmajor") return 2.9;
  if (name == "_vminor" || name == "_remap_level") return 0;
  if (name == "_metric_machine") return control.machine.unit == 1 ? 1 : 0;
  if (name == "_task") return 1;
  if (name == "_line") return m.block->position.line;
  if (name == "_call_level") return static_cast<double>(control.flow.calls.size());
  if (name == "_value") return control.state.value;
  if (name == "_value_returned") return control.state.value_returned ? 1 : 0;
  if (const auto mode = mode_named(m, control, name)) return mode;
  return place_named(m, control, name);
}

}  // namespace

void LinuxCnc::add_variables(Emitter& m, FinalState& ending, const std::vector<std::string>& watch) {
  for (int n = 1; n <= static_cast<int>(max_arguments); ++n)
    if (const double v = level().arguments[static_cast<std::size_t>(n)]; v != 0) ending.variables.emplace_back("#" + std::to_string(n), v);
  for (const auto* const all : {&globals_, &level().named})
    for (const auto& [number, value] : *all)
      ending.variables.emplace_back("#<" + m.def.grammar.named_variables->name_of(number) + ">", value);
  for (const std::string& name : watch) {
    if (!name.starts_with("#")) continue;
    double number = std::strtod(name.c_str() + 1, nullptr);
    if (name.starts_with("#<") && name.ends_with(">"))
      number = m.def.grammar.named_variables->number_of(std::string_view(name).substr(2, name.size() - 3)).value_or(0);
    if (const auto value = read_variable(m, number, {})) ending.variables.emplace_back(name, *value);
  }
}

}  // namespace kadr::linuxcnc
