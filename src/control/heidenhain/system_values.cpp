// Q parameters that the control sets, and FN 18 (spec/heidenhain 10.5, 10.6). Used by control/heidenhain.

#include <cmath>

#include "control/heidenhain/heidenhain.h"

namespace kadr::heidenhain {

double Heidenhain::tool_radius(const BlockContext& m) const {
  const double own = m.modal.tool < m.tables.offsets.size() ? m.tables.offsets[m.modal.tool].whole_radius() : 0;
  return own + memory.delta_radius;
}

Result<double> Heidenhain::cutter_radius(BlockContext& m, Span where) const {
  const double radius = tool_radius(m);
  m.use.note(UseKind::radius, m.modal.tool, m.origin, radius == 0);
  if (!(radius > 0)) return fail(alarm(AlarmId::cycle_tool_radius, where, double(m.modal.tool)));
  return radius;
}

double Heidenhain::tool_length(const BlockContext& m) const {
  const double own = m.modal.tool < m.tables.offsets.size() ? m.tables.offsets[m.modal.tool].whole_length() : 0;
  return own + memory.delta_length;
}

Result<double> Heidenhain::feed_per_turn(const BlockContext& m, double per_tooth, Span where) const {
  const auto teeth = teeth_.find(m.modal.tool);
  if (teeth == teeth_.end() || !(teeth->second > 0)) return fail(alarm(AlarmId::not_available, where, "FZ"));
  return per_tooth * teeth->second;
}

Result<double> Heidenhain::parameter(const BlockContext& m, ParameterFamily which, std::uint16_t index, Span where) const {
  const double value = family(which)[index];
  if (which == ParameterFamily::q && index >= 108 && index <= 114) {
    switch (index) {
      case 108: return tool_radius(m);
      case 109: return m.modal.tool == 0 ? -1.0 : static_cast<double>(m.modal.axes.normal);
      case 110:
        return m.modal.spindle == SpindleDir::cw    ? 0.0
               : m.modal.spindle == SpindleDir::ccw ? 1.0
                                                    : static_cast<double>(memory.spindle_code);
      case 111: return m.modal.flood || m.modal.mist ? 1.0 : 0.0;
      case 113: return memory.inch_outermost ? 1.0 : 0.0;
      case 114: return tool_length(m);
      default: break;
    }
  }
  if (std::isnan(value)) return fail(alarm(AlarmId::variable_not_set, where, std::string_view("Q" + std::to_string(index))));
  return value;
}

/// FN 18: SYSREAD. What Kadr does not list is 0, as on the control (spec/heidenhain 10.6).
Result<double> Heidenhain::system_value(BlockContext& m, double id, double number, double index, Span where) const {
  const auto axis = [&]() -> std::size_t { return index >= 1 && index <= 9 ? static_cast<std::size_t>(index) - 1 : max_axes; };
  const auto group = static_cast<int>(id), row = static_cast<int>(number);
  const std::size_t a = axis();
  switch (group) {
    case 10:
      if (row == 103) return index >= 0 && memory.given(static_cast<std::size_t>(index)) ? 1.0 : 0.0;
      return row == 3 ? static_cast<double>(memory.cycle) : row == 1 ? (m.modal.inch ? 1.0 : 0.0) : 0.0;
    case 20:
      switch (row) {
        case 1: return static_cast<double>(m.modal.tool);
        case 2: return static_cast<double>(m.modal.tool_selected);
        case 3: return static_cast<double>(m.modal.axes.normal);
        case 4: return m.modal.rpm;
        case 5: return parameter(m, ParameterFamily::q, 110, where);
        case 8: return parameter(m, ParameterFamily::q, 111, where);
        case 9: return m.modal.feed;
        default: return 0.0;
      }
    case 50: {
      const auto tool = static_cast<std::size_t>(index >= 0 ? index : m.modal.tool);
      if (tool >= m.tables.offsets.size()) return 0.0;
      const ToolOffset& of = m.tables.offsets[tool];
      switch (row) {
        case 1: return of.length;
        case 2: return of.radius;
        case 3: return of.corner;
        case 4: return of.length_wear;
        case 5: return of.radius_wear;
        default: return 0.0;
      }
    }
    case 60: return row == 1 ? static_cast<double>(m.modal.tool) : row == 4 ? memory.delta_length : row == 5 ? memory.delta_radius : 0.0;
    case 200:
      if (row == 1) return index == 1 && m.modal.tool < m.tables.offsets.size() ? m.tables.offsets[m.modal.tool].radius : tool_radius(m);
      return index == 1 && m.modal.tool < m.tables.offsets.size() ? m.tables.offsets[m.modal.tool].length : tool_length(m);
    case 210:
      if (row == 2) return memory.rotation;
      if (row == 3) return static_cast<double>(memory.mirrored);
      if (row == 4) return a < max_axes ? memory.scale[a] : 1.0;
      return row == 6 && memory.tilted ? 1.0 : 0.0;
    case 220: return row == 2 && a < max_axes ? memory.shift[a] : 0.0;
    case 240: return a < m.axis_count ? m.position.machine[a] : 0.0;
    case 270: return a < m.axis_count ? m.position.programmed[a] : 0.0;
    case 280: return memory.holds_tip ? 1.0 : 0.0;
    default: return 0.0;
  }
}

}  // namespace kadr::heidenhain
