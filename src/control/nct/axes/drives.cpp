// Programmed axes that drive a machine axis other than their own (exchanged axes) or in reverse; parked axes (spec/nct/20 20.2 to 20.5).
// Used by the rest of control; tested by tests/cases/nct/20-axes.cases.

#include "control/nct/axes/drives.h"

#include <optional>
#include <utility>

#include "control/emitter.h"
#include "control/fanuc/words/coordinates.h"
#include "control/nct/axes/coupling.h"
#include "control/nct/nct.h"

namespace kadr::nct {
namespace {

constexpr AxisMask bit(std::size_t axis) { return AxisMask{1} << axis; }

bool is_main(int role) { return role >= 1 && role <= 3; }  // parameter N0103 gives the role 1, 2 or 3 to the main axes X, Y, Z

/// Returns true if the axis may be exchanged or reversed. A rotary axis that rolls over may not, because its position cannot be converted
/// back. Axes of five-axis functions, followers and masters may not, because other code depends on them.
bool is_free_axis(const BlockContext& m, std::size_t axis) {
  const Nct& nct = nct_of(m);
  const int number = static_cast<int>(axis);
  const FiveAxis& five = fanuc_of(m).settings.five_axis;
  const bool turns_tool = five.group != MachineGroup::none;
  bool coupled = false;
  for (const Follower& f : nct.couplings.followers) coupled = coupled || f.axis == axis || f.master == axis;
  for (const CrossChannelAxis& f : nct.couplings.far) coupled = coupled || (f.link == AxisLink::follows && f.axis == axis);
  const bool rolls = fanuc_of(m).settings.axes[axis].rolls && (m.def.rotary >> axis & 1U) != 0;
  return !coupled && !rolls &&
         !(turns_tool && (five.first.axis == number || five.second.axis == number || is_main(fanuc_of(m).settings.axes[axis].role)));
}

/// Returns the axis with which this axis may be exchanged: the axis that parameter N2104 names.
std::optional<std::size_t> other_of(const BlockContext& m, std::size_t axis) {
  const ParameterStore& store = macro_b_of(m).parameters;
  return axis_numbered(m, store.value(store.named("2104"), m.def.axis_numbers[axis]), axis);
}

/// Returns true if the axis moves in the reversed direction after the exchange (N2105 #0 MMI).
bool moves_reversed(const BlockContext& m, std::size_t axis) {
  const ParameterStore& store = macro_b_of(m).parameters;
  constexpr int mmi = 0;
  return store.bit(store.named("2105"), mmi, m.def.axis_numbers[axis]);
}

/// Returns the machine axis that each programmed axis drives. INFERRED: a reversal applies after the exchange.
AxisDrives drives_of(const BlockContext& m, const Drives& d) {
  AxisDrives all;
  all.reversed = d.mirrored ^ d.far_reversed;
  for (AxisMask left = d.exchanged; left != 0; left &= left - 1) {
    const auto axis = static_cast<std::size_t>(__builtin_ctz(left));
    const auto other = other_of(m, axis);
    if (!other) continue;
    std::swap(all.axis[axis], all.axis[*other]);
    for (const std::size_t a : {axis, *other})
      if (moves_reversed(m, a)) all.reversed ^= bit(a);
  }
  all.is_own = all.reversed == 0 && all.axis == AxisDrives().axis;
  return all;
}

/// Returns true if the axis and the axis that N2104 names may be exchanged, and neither is in another exchange.
bool may_exchange(const BlockContext& m, std::size_t axis) {
  const auto other = other_of(m, axis);
  return other && may_be_exchanged(m, axis) && may_be_exchanged(m, *other);
}

/// Starts or ends the exchange of an axis with an axis of another channel, whose machine coordinate is `machine`. Nothing moves; the
/// programmed coordinates change.
void exchange_cross_channel(BlockContext& m, std::size_t axis, double machine, bool on) {
  Drives& d = nct_of(m).drives;
  d.far = on ? d.far | bit(axis) : d.far & ~bit(axis);
  d.far_reversed = on && moves_reversed(m, axis) ? d.far_reversed | bit(axis) : d.far_reversed & ~bit(axis);
  m.position.machine[axis] = machine;
}

void unpark(BlockContext& m, std::size_t axis) {
  Drives& d = nct_of(m).drives;
  d.parked &= ~bit(axis);
  m.position.machine[axis] = d.standing[axis];
  follow_from_here(m);
}

/// Executes a request of the machine's logic: exchanges, reverses or parks an axis, or ends the exchange, reversal or parking. Returns
/// false if the request is impossible.
bool execute(BlockContext& m, const AxisRequest& request) {
  Drives& d = nct_of(m).drives;
  if (request.machine) {
    exchange_cross_channel(m, request.axis, *request.machine, request.on);
    return true;
  }
  const AxisMask axis = bit(request.axis);
  AxisMask& now = request.link == AxisLink::exchanged ? d.exchanged : request.link == AxisLink::reversed ? d.mirrored : d.parked;
  if (((now & axis) != 0) == request.on) return true;
  if (request.link == AxisLink::parked) {
    if (!request.on) {
      unpark(m, request.axis);
      return true;
    }
    d.standing[request.axis] = m.position.machine[request.axis];
  } else if (request.on && request.link == AxisLink::exchanged && !may_exchange(m, request.axis)) {
    return false;
  } else if (request.on && request.link == AxisLink::reversed && !is_free_axis(m, request.axis)) {
    return false;
  }
  now ^= axis;
  return true;
}

}  // namespace

bool may_be_exchanged(const BlockContext& m, std::size_t axis) {
  const Drives& d = nct_of(m).drives;
  return is_free_axis(m, axis) && ((m.def.rotary | d.far) & bit(axis)) == 0 && fanuc_of(m).driven.of(axis) == axis;
}

void request_axis(BlockContext& m, const std::string& name, AxisLink link, bool on) {
  const ParameterStore& store = macro_b_of(m).parameters;
  for (std::size_t a = 0; a < m.axis_count; ++a) {
    if (m.axis_names[a] != name) continue;
    const double other = store.value(store.named("2104"), m.def.axis_numbers[a]);
    if (link == AxisLink::exchanged && is_cross_channel_axis(m, other)) link_cross_channel(m, {a, static_cast<int>(other), link, 1}, on);
    else nct_of(m).drives.requests.push_back({a, link, on});
  }
}

void execute_requests(Emitter& m) {
  Drives& d = nct_of(m).drives;
  for (const AxisRequest& request : std::exchange(d.requests, {}))
    if (!execute(m, request)) m.warn(warning(AlarmId::axis_not_changed, {}, std::string_view(m.axis_names[request.axis])));
  fanuc_of(m).driven = drives_of(m, d);
  m.refresh_frames();
  m.position.work = m.frames.work_of(m.position.machine);
  m.position.programmed = m.transform.to_programmed(m.position.work);
  m.emit(m.frame_change());
}

void end_drives(Emitter& m) {
  Drives& d = nct_of(m).drives;
  if (fanuc_of(m).driven.is_own && d.parked == 0 && d.far == 0) return;
  while (d.parked != 0) unpark(m, static_cast<std::size_t>(__builtin_ctz(d.parked)));
  d = {};
  execute_requests(m);
}

void keep_parked(BlockContext& m, Motion& motion) {
  const Drives& d = nct_of(m).drives;
  detail_of(m, motion).parked = d.parked;
  for (AxisMask left = d.parked; left != 0; left &= left - 1) {
    const auto axis = static_cast<std::size_t>(__builtin_ctz(left));
    motion.machine[axis] = d.standing[axis];
  }
}

}  // namespace kadr::nct
