// Checks motions against the zones of an NCT machine (nct 22). Used by machine/virtual_machine; tested by
// tests/machine/zones_test.cpp.

#include "machine/zones.h"

#include <algorithm>
#include <utility>

#include "base/tolerance.h"

namespace kadr {
namespace {

/// Returns the limits of zone 3 for the axis from the set-up. The entry for the axis takes precedence over the entry for all axes.
std::optional<std::pair<double, double>> zone3_of(const Setup& setup, const std::string& axis) {
  for (const std::string& name : {axis, std::string("*")})
    if (const auto found = setup.machine.find(name); found != setup.machine.end() && found->second.zone3) return found->second.zone3;
  return std::nullopt;
}

/// Returns the positions of the axis' limit switches from the set-up. The entry for the axis takes precedence over the entry for all axes.
std::optional<std::pair<double, double>> switches_of(const Setup& setup, const std::string& axis) {
  for (const std::string& name : {axis, std::string("*")})
    if (const auto found = setup.machine.find(name); found != setup.machine.end() && found->second.switches) return found->second.switches;
  return std::nullopt;
}

bool is_signal(const Setup& setup, const char* name) {
  const auto found = setup.signals.find(name);
  return found != setup.signals.end() && found->second != 0;
}

/// Returns true if the fraction `part` of the path is less than `other` by more than the rounding error. So if the path reaches several
/// limits at once, the first limit in the order of axes and zones is reported.
bool is_before(double part, double other) {
  constexpr double same = 1e-9;
  return part < other - same;
}

}  // namespace

Zones::Zones(const std::vector<std::string>& names, const AxisRoles& roles, const Extents& ends, const Setup& setup)
    : names_(names), roles_(roles), ends_{0, ends.least, ends.most} {
  constexpr double none = 1e299;  // a value of ±1e300 in AxisProfile means that there is no limit
  for (std::size_t i = 0; i < roles.count; ++i)
    if (ends.least[i] > -none || ends.most[i] < none) ends_.axes |= AxisMask{1} << i;
  for (std::size_t i = 0; i < roles.count; ++i) {
    const auto switches = switches_of(setup, names[i]);
    if (!switches) continue;
    switches_.axes |= AxisMask{1} << i;
    std::tie(switches_.least[i], switches_.most[i]) = *switches;
  }
  const MachineParameters p = machine_parameters(setup, names);
  checks_before_ = p.checks_before;
  if (p.zone2_on && p.zone2_axes != 0) of_parameters_ = zone_of({true, p.outside_forbidden, p.zone2_axes, p.zone2_least, p.zone2_most});
  zone2_ = of_parameters_;
  for (std::size_t i = 0; i < roles.count; ++i) {
    const auto zone = zone3_of(setup, names[i]);
    if (!zone || (p.zone3_axes >> i & 1U) == 0) continue;
    zone3_.axes |= AxisMask{1} << i;
    std::tie(zone3_.least[i], zone3_.most[i]) = *zone;
  }
  suspended2_ = is_signal(setup, "CP_LIM2DIS");
  suspended3_ = is_signal(setup, "CP_LIM3DIS");
}

void Zones::swap_ends(ZoneBox& a, std::size_t axis, ZoneBox& b, std::size_t other) {
  const bool has = a.has(axis), had = b.has(other);
  const auto put = [](ZoneBox& box, std::size_t i, bool on) {
    box.axes = on ? box.axes | AxisMask{1} << i : box.axes & ~(AxisMask{1} << i);
  };
  put(a, axis, had);
  put(b, other, has);
  std::swap(a.least[axis], b.least[other]);
  std::swap(a.most[axis], b.most[other]);
}

void Zones::exchange(std::size_t axis, Zones& with, std::size_t other) {
  std::swap(names_[axis], with.names_[other]);
  swap_ends(ends_, axis, with.ends_, other);
  swap_ends(switches_, axis, with.switches_, other);
}

Zones::Zone2 Zones::zone_of(const ZoneChange& zone) const {
  Zone2 made{zone.on, zone.outside_forbidden, zone.outside_forbidden && zone.axes != 0, {zone.axes, zone.least, zone.most}};
  for (std::size_t i = 0; i < roles_.count; ++i)
    if (made.box.has(i) && zone.least[i] != zone.most[i]) made.nothing_allowed = false;
  return made;
}

void Zones::change(const ZoneChange& zone) {
  if (zone.of_parameters && zone.axes == 0) checks_before_ = zone.on;
  else if (zone.of_parameters) of_parameters_ = zone.on ? zone_of(zone) : Zone2{};
  zone2_ = zone.on && !zone.of_parameters ? zone_of(zone) : of_parameters_;
}

ZoneBox Zones::open2() const { return zone2_.box.grown(-tol::same_point); }
ZoneBox Zones::closed3() const { return zone3_.grown(tol::same_point); }

Status Zones::check(const ToolPosition& from, const Motion& motion) const {
  if (!in_force()) return {};
  const Curve curve(roles_, from.work, motion);
  const MachinePath path(roles_, from, motion, curve);
  if (checks_before_) KADR_TRY(before_start(path, motion.machine));
  return during_motion(path);
}

Status Zones::end_within(const ZoneBox& box, const Axes& end, Ids ids) const {
  for (std::size_t i = 0; i < roles_.count; ++i) {
    if (!box.has(i)) continue;
    if (end[i] > box.most[i] + tol::same_point) return fail(alarm(ids.positive, {}, std::string_view(names_[i])));
    if (end[i] < box.least[i] - tol::same_point) return fail(alarm(ids.negative, {}, std::string_view(names_[i])));
  }
  return {};
}

/// Checks a motion before it starts: first the end point, then the path (nct 22.4).
Status Zones::before_start(const MachinePath& path, const Axes& end) const {
  KADR_TRY(end_within(ends_, end, {AlarmId::zone1_positive, AlarmId::zone1_negative}));
  if (outside2()) {
    KADR_TRY(end_within(zone2_.box, end, {AlarmId::zone2_positive, AlarmId::zone2_negative}));
    if (zone2_.nothing_allowed) {  // zone 2 is a single point, and even this point is forbidden; INFERRED: the alarm names the first axis
      const auto axis = static_cast<std::size_t>(__builtin_ctz(zone2_.box.axes));
      return fail(alarm(AlarmId::zone2_positive, {}, std::string_view(names_[axis])));
    }
  }
  if (inside2() && open2().holds(end)) return fail(alarm(AlarmId::zone2_inside, {}));
  if (inside3() && closed3().holds(end)) return fail(alarm(AlarmId::zone3_inside, {}));
  if (inside2() && first_meeting(open2(), path)) return fail(alarm(AlarmId::zone2_entry, {}));
  if (inside3() && first_meeting(closed3(), path)) return fail(alarm(AlarmId::zone3_entry, {}));
  return {};
}

/// Finds the first limit of the box that an axis exceeds in an outward motion. Updates `first` if the path meets this limit earlier.
void Zones::limits_reached(const MachinePath& path, const ZoneBox& box, Ids ids, Reached& first) const {
  const auto bounds = [&](std::size_t i) {
    const double start = path.start()[i];
    return std::pair{std::min(box.least[i], start) - tol::same_point, std::max(box.most[i], start) + tol::same_point};
  };
  const auto passes = [&](const Extents& whole) {
    for (std::size_t i = 0; i < roles_.count; ++i)
      if (box.has(i) && !path.rolls_over(i) && (whole.most[i] > bounds(i).second || whole.least[i] < bounds(i).first)) return true;
    return false;
  };
  if (!passes(path.rough_extents())) return;
  const Extents whole = path.extents(0, 1);
  for (std::size_t i = 0; i < roles_.count; ++i) {
    if (!box.has(i) || path.rolls_over(i)) continue;
    const auto look = [&](double limit, double passed, Side side, AlarmId id) {
      const auto part = first_passing(path, i, passed, side);
      if (part && is_before(*part, first.part)) first = {*part, alarm(id, {}, std::string_view(names_[i]), limit)};
    };
    const auto [low, high] = bounds(i);
    if (whole.most[i] > high) look(box.most[i], high, Side::above, ids.positive);
    if (whole.least[i] < low) look(box.least[i], low, Side::below, ids.negative);
  }
}

/// Finds the zone that the motion meets first (nct 22.1 to 22.3). With N1001#2 CBM, before_start() has checked the zones, and only the
/// limit switches and, for curves, the limits remain to be checked.
Status Zones::during_motion(const MachinePath& path) const {
  Reached first;
  limits_reached(path, switches_, {AlarmId::switch_positive, AlarmId::switch_negative}, first);
  if (checks_before_ && path.straight()) return first.part <= 1 ? Status(fail(first.alarm)) : Status();
  limits_reached(path, ends_, {AlarmId::zone1_reached_positive, AlarmId::zone1_reached_negative}, first);
  if (outside2()) limits_reached(path, zone2_.box, {AlarmId::zone2_reached_positive, AlarmId::zone2_reached_negative}, first);
  const auto inside = [&](bool in_force, const ZoneBox& box, AlarmId id) {
    const auto part = in_force && !checks_before_ ? first_meeting(box, path) : std::nullopt;
    if (part && is_before(*part, first.part)) first = {*part, alarm(id, {})};
  };
  inside(inside2(), open2(), AlarmId::zone2_reached_inside);
  inside(inside3(), closed3(), AlarmId::zone3_reached_inside);
  return first.part <= 1 ? Status(fail(first.alarm)) : Status();
}

}  // namespace kadr
