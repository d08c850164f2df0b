// The table that maps each function name of a control's file to a C++ function, and the functions that only set a mode.

#include "control/functions/functions.h"

#include <iterator>
#include <utility>

#include "control/functions/cutter_compensation.h"

namespace kadr {
namespace {

/// Wraps a C++ function that needs only an Emitter, so that it fits the table of functions, which are called with an Interpreter.
template <Status (*function)(Emitter&, const Call&)>
Status entry(Interpreter& m, const Call& call) {
  return function(m, call);
}
template <Status (*function)(Interpreter&, const Call&)>
Status entry(Interpreter& m, const Call& call) {
  return function(m, call);
}

constexpr Handler handlers[] = {
#define KADR_FUNCTION_HANDLER(name, ...) entry<functions::name>,
    KADR_FUNCTIONS(KADR_FUNCTION_HANDLER)
#undef KADR_FUNCTION_HANDLER
};
static_assert(std::size(handlers) == static_cast<std::size_t>(Function::count));

Status set_plane(Emitter& m, Plane plane) {
  if (compensates(m.modal) && m.modal.plane != plane) return fail(alarm(AlarmId::compensation_active, m.block->where, "G17, G18, G19"));
  m.modal.plane = plane;
  m.modal.axes = axes_of(plane);
  m.apply_mirror();
  return {};
}

Status set_feed_mode(BlockContext& m, FeedMode mode) {
  Modal& modal = m.modal;
  // The dialect stores a separate feed per minute and per revolution (nct 6.2.1), so the feed in force is exchanged with the stored one.
  if (modal.feed_mode != mode && m.dialect->keeps_both_feeds()) {
    std::swap(modal.feed, modal.other_feed);
    std::swap(modal.feed_known, modal.other_feed_known);
  } else if (modal.feed_mode != mode) {
    modal.feed_known = false;  // a feed in the old unit has no meaning in the new unit
  }
  modal.feed_mode = mode;
  return {};
}

/// Sets the unit of length. G20 and G21 are an alarm during cutter compensation (RS274/NGC), unless the dialect allows them.
Status set_unit(BlockContext& m, const Call& call, bool inch) {
  const bool may_change = m.dialect->units_may_change();
  if (!may_change && compensates(m.modal) && m.modal.inch != inch)
    return fail(alarm(AlarmId::compensation_active, call.where, call.row->code));
  m.modal.inch = m.variables.inch = inch;
  return {};
}

}  // namespace

Handler handler_of(Function function) { return handlers[static_cast<std::size_t>(function)]; }

namespace functions {

// The functions of those addresses whose words have no effect of their own, because other functions read these words.
Status block_number(Emitter&, const Call&) { return {}; }
Status axis(Emitter&, const Call&) { return {}; }
Status center(Emitter&, const Call&) { return {}; }
Status word_of_code(Emitter&, const Call&) { return {}; }
Status formal_parameter(Emitter&, const Call&) { return {}; }
Status code(Emitter&, const Call&) { return {}; }
Status label(Emitter&, const Call&) { return {}; }
Status corrector_word(Emitter&, const Call&) { return {}; }

Status plane_xy(Emitter& m, const Call&) { return set_plane(m, Plane::xy); }
Status plane_zx(Emitter& m, const Call&) { return set_plane(m, Plane::zx); }
Status plane_yz(Emitter& m, const Call&) { return set_plane(m, Plane::yz); }
Status absolute(Emitter& m, const Call&) {
  m.modal.absolute = true;
  return {};
}
Status incremental(Emitter& m, const Call&) {
  m.modal.absolute = false;
  return {};
}
Status centers_absolute(Emitter& m, const Call&) {
  m.modal.centers_absolute = true;
  return {};
}
Status centers_incremental(Emitter& m, const Call&) {
  m.modal.centers_absolute = false;
  return {};
}
Status inch(Emitter& m, const Call& call) { return set_unit(m, call, true); }
Status millimetre(Emitter& m, const Call& call) { return set_unit(m, call, false); }
Status feed_inverse_time(Emitter& m, const Call&) { return set_feed_mode(m, FeedMode::inverse_time); }
Status feed_per_minute(Emitter& m, const Call&) { return set_feed_mode(m, FeedMode::per_minute); }
Status feed_per_revolution(Emitter& m, const Call&) { return set_feed_mode(m, FeedMode::per_revolution); }
Status surface_speed(Emitter& m, const Call&) {
  m.modal.surface_speed = true;
  m.emit(m.surface_speed());
  return {};
}
/// G97: the spindle continues at the speed that G96 gives at the tool's position.
Status spindle_rpm(Emitter& m, const Call&) {
  if (m.modal.surface_speed) m.modal.rpm = m.surface_speed().rpm(m.position.work, m.modal.rpm);
  m.modal.surface_speed = false;
  m.emit(m.surface_speed());
  return {};
}
Status exact_stop_block(Emitter& m, const Call&) {
  m.block_exact = true;
  return {};
}
Status exact_stop_mode(Emitter& m, const Call&) {
  m.modal.exact = true;
  m.modal.blend_tolerance = 0;
  return {};
}
/// G64. The word P is the path tolerance (RS274/NGC; the manual of Mach3 has no P).
Status constant_velocity(Emitter& m, const Call&) {
  const double tolerance = m.length_value('P');
  if (tolerance < 0) return fail(alarm(AlarmId::value_out_of_range, m.where('P'), 'P', tolerance));
  m.modal.exact = false;
  m.modal.blend_tolerance = tolerance;
  return {};
}
Status corner_arc(Emitter& m, const Call&) {
  m.modal.corner_join = CornerJoin::arc;
  return {};
}
Status corner_line(Emitter& m, const Call&) {
  m.modal.corner_join = CornerJoin::straight;
  return {};
}
Status retract_initial(Emitter& m, const Call&) {
  m.modal.retract_initial = true;
  return {};
}
Status retract_level(Emitter& m, const Call&) {
  m.modal.retract_initial = false;
  return {};
}
Status override_permission(Emitter& m, const Call& call) {
  m.modal.override_permission = static_cast<std::uint8_t>(call.row->arg);
  return {};
}
Status override_on(Emitter& m, const Call&) {
  m.modal.override_enabled = true;
  return {};
}
Status override_off(Emitter& m, const Call&) {
  m.modal.override_enabled = false;
  return {};
}

}  // namespace functions
}  // namespace kadr
