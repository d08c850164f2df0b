// Computes travel limits and forbidden zones. Used by view/page/page_program; tested by tests/view/machine_bounds_test.cpp.

#include "view/machine_bounds.h"

#include "machine/zones.h"
#include "motion/time/estimate.h"

namespace kadr {
namespace {

// Limit in mm or degrees: a value beyond ±1e299 means an axis without limit, for which AxisProfile has ±1e300.
constexpr double unlimited = 1e299;

std::optional<double> limit(double value) { return value > -unlimited && value < unlimited ? std::optional(value) : std::nullopt; }

SpaceBox space_box(const ZoneBox& box, const AxisRoles& roles) {
  SpaceBox space;
  for (std::size_t i = 0; i < 3; ++i) {
    const int axis = roles.xyz[i];
    if (axis < 0 || !box.has(std::size_t(axis))) continue;
    space.least[i] = limit(box.least[std::size_t(axis)]);
    space.most[i] = limit(box.most[std::size_t(axis)]);
  }
  return space;
}

}  // namespace

MachineBounds machine_bounds(const OpenedProgram& opened, const Control& control) {
  const std::vector<std::string>& names = control.axes();
  const AxisRoles roles = AxisRoles::of(names, control.rotary());
  Extents ends;
  ZoneBox all;
  for (std::size_t i = 0; i < roles.count; ++i) {
    std::tie(ends.least[i], ends.most[i]) = limits_of(opened.machine, opened.setup, names[i]);
    all.axes |= AxisMask{1} << i;
  }
  all.least = ends.least, all.most = ends.most;
  MachineBounds space{space_box(all, roles), {}};
  if (!control.has_machine_parameters()) return space;
  const Zones zones(names, roles, ends, opened.setup);
  if (zones.inside2() || zones.outside2()) space.zones.push_back({2, zones.inside2(), space_box(zones.box2(), roles)});
  if (zones.inside3()) space.zones.push_back({3, true, space_box(zones.box3(), roles)});
  return space;
}

}  // namespace kadr
