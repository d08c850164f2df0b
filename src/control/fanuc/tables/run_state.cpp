// Returns the state at the end of a run in the form of a set-up (tests/golden/README.md, `state`).

#include <algorithm>

#include "control/emitter.h"
#include "control/fanuc/fanuc.h"
#include "control/fanuc/words/coordinates.h"
#include "control/macro_b/variables/system_variables.h"

namespace kadr::fanuc {
namespace {

bool is_set(const ToolOffset& o) {
  for (const double v : {o.length, o.length_wear, o.radius, o.radius_wear, o.corner, o.corner_wear, o.length_x, o.length_y, o.length_x_wear,
                         o.length_y_wear, o.tip_position})
    if (v != 0) return true;
  return false;
}

AxisValues by_name(const BlockContext& m, const Axes& axes) {
  AxisValues values;
  for (std::size_t a = 0; a < m.axis_count; ++a) values[m.axis_names[a]] = axes[a];
  return values;
}

void add_zeros(const BlockContext& m, Setup& tables) {
  const auto add = [&](const std::string& name, const Axes& zero, Vec3 angles) {
    if (!any_nonzero(zero) && angles == Vec3{}) return;
    AxisValues& values = tables.work_offsets[name];
    values = by_name(m, zero);
    if (angles.x != 0) values["G17"] = angles.x;
    if (angles.y != 0) values["G18"] = angles.y;
    if (angles.z != 0) values["G19"] = angles.z;
  };
  add("common", m.tables.common, {});
  for (std::size_t i = 1; i < m.tables.zeros.size(); ++i) {
    const std::string name = i <= basic_systems ? "G" + std::to_string(53 + i)
                             : i < all_systems  ? "G54.1 P" + std::to_string(i - basic_systems)
                                                : "G54.2 P" + std::to_string(i - (all_systems - 1));
    add(name, m.tables.zeros[i], m.tables.rotations[i]);
  }
}

const char* name_of(SpindleDir dir) {
  switch (dir) {
    case SpindleDir::cw: return "cw";
    case SpindleDir::ccw: return "ccw";
    default: return "stop";
  }
}

}  // namespace

RunState Fanuc::run_state(const Emitter& m) const {
  RunState s;
  for (std::size_t i = 1; i < m.tables.offsets.size(); ++i)
    if (is_set(m.tables.offsets[i])) s.tables.offsets[static_cast<int>(i)] = m.tables.offsets[i];
  add_zeros(m, s.tables);
  s.tables.parameters = parameters.written();
  s.tables.plane = plane_name(m);
  for (std::size_t a = 0; a < m.axis_count; ++a) s.tables.diameter[m.axis_names[a]] = (m.modal.diameter >> a & 1u) != 0;
  s.tables.tool = static_cast<int>(m.modal.tool);
  for (std::size_t i = 1; i < m.skip_switches.size(); ++i)
    if (m.skip_switches[i]) s.tables.skip.push_back(static_cast<int>(i));
  if (state.five_axis.frame != SpaceFrame::none) {
    const FiveAxisState& five = state.five_axis;
    const auto named = [&](Vec3 v) {
      AxisValues values;
      const double parts[] = {v.x, v.y, v.z};
      for (int role = 1; role <= 3; ++role)
        if (const int axis = main_axis(m, role); axis >= 0) values[m.axis_names[static_cast<std::size_t>(axis)]] = parts[role - 1];
      return values;
    };
    s.frame = {{"origin", named(five.origin)},
               {"x", named(five.turn.column(0))},
               {"y", named(five.turn.column(1))},
               {"z", named(five.turn.column(2))}};
  }
  s.shifts["G92"] = by_name(m, m.modal.new_system);
  s.shifts["G52"] = by_name(m, m.modal.local);
  for (int n = 1; n <= static_cast<int>(max_spindles); ++n) {
    const SpindleState& from = spindle(n);
    if (!from.known && n != 1) continue;
    RunState::SpindleState& to = s.spindles[n];
    const bool is_main = n == state.main_spindle;
    const bool surface = is_main && m.modal.surface_speed && (from.dir == SpindleDir::cw || from.dir == SpindleDir::ccw);
    to.loop = from.loop_closed ? "closed" : "open";
    to.rpm = surface ? css_rpm(m) : from.rpm;
    to.dir = name_of(from.dir);
    to.surface_speed = is_main ? state.surface_speed : 0;
    to.css_axis = is_main ? state.css_axis : 0;
    to.master = from.master;
    if (from.loop_closed) to.angle = from.angle;
  }
  return s;
}

}  // namespace kadr::fanuc
