// Restart in mid-program. This file is used by the panel and embedding programs, and tested by tests/session/restart_test.cpp.

#include "session/restart.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/tolerance.h"

namespace kadr {
namespace {

bool same_thing(const InForce& a, const InForce& b) { return a.kind == b.kind && a.name == b.name; }

bool same_value(const InForce& a, const InForce& b) {
  return a.code == b.code && std::fabs(a.value - b.value) <= tol::same_point * (1 + std::fabs(a.value));
}

/// True if two positions differ in any of the first `axes` axes except `normal`, the axis normal to the plane.
bool is_at_other_place(const Axes& a, const Axes& b, std::size_t axes, std::size_t normal) {
  for (std::size_t i = 0; i < axes; ++i)
    if (i != normal && std::fabs(a[i] - b[i]) > tol::same_point) return true;
  return false;
}

}  // namespace

std::optional<Restart> restart_here(Session& session, const Stepping& stepping) {
  if (!stepping.next()) return std::nullopt;
  return Restart{*stepping.next(), session.control().in_force(), session.stand(), session.control().plane_normal()};
}

bool move_over_hole(Session& session, Stepping& stepping, std::uint32_t hole, Restart& restart) {
  Control& control = session.control();
  // The control passes the motions of a canned cycle one at a time from now on, so that this function can count the holes.
  control.return_each_block();
  const std::size_t axes = control.axes().size(), normal = control.plane_normal();
  std::optional<Axes> over;
  std::uint32_t holes = 0;
  bool went_down = false;
  double level = 0;  // coordinate along the tool axis at the end of the cycle's first motion down
  Axes last = control.tool_position().work;
  Session::State state = stepping.begin_block();
  while (state == Session::State::running && control.in_block()) {
    const Axes now = control.tool_position().work;
    const bool moved_down = !is_at_other_place(now, last, axes, normal) && std::fabs(now[normal] - last[normal]) > tol::same_point;
    // A cycle may begin with a motion up to the R level. The position of that motion is not counted as a hole.
    const bool rises = moved_down && now[normal] > last[normal];
    if (!over && !rises) over = now, holes = 1;
    else if (over && !is_at_other_place(now, *over, axes, normal) && !std::exchange(went_down, true)) level = now[normal];
    // False while the tool is at the bottom of a hole. A sideways motion at the bottom does not lead to another hole.
    const bool is_out = now[normal] >= level - tol::same_point;
    if (went_down && is_out && is_at_other_place(now, *over, axes, normal)) over = now, ++holes, went_down = false;
    if (holes == hole) {
      restart.in_force = control.in_force();
      restart.stand = session.stand();
      return true;
    }
    last = now;
    state = session.go_on();
  }
  return false;
}

std::optional<Restart> restart_at(Session& session, Stepping& stepping, const StopPoint& target, std::uint32_t hole) {
  if (stepping.go_to(target) != Session::State::held) return std::nullopt;
  auto restart = restart_here(session, stepping);
  if (!restart || hole == 0) return restart;
  if (!move_over_hole(session, stepping, hole, *restart)) return std::nullopt;
  return restart;
}

std::vector<Difference> differences(const std::vector<InForce>& required, const std::vector<InForce>& now) {
  std::vector<Difference> all;
  const auto found_in = [](const std::vector<InForce>& among, const InForce& one) {
    const auto found = std::find_if(among.begin(), among.end(), [&](const InForce& other) { return same_thing(one, other); });
    return found == among.end() ? std::optional<InForce>() : std::optional(*found);
  };
  for (const InForce& one : required) {
    const auto is = found_in(now, one);
    if (!is || !same_value(one, *is)) all.push_back({one, is});
  }
  for (const InForce& one : now)
    if (!found_in(required, one)) all.push_back({std::nullopt, one});
  return all;
}

std::vector<WayPoint> path_there(const ToolPosition& from, const Restart& to, const WayRules& rules, std::size_t axes) {
  std::vector<WayPoint> path;
  const std::size_t n = to.normal;
  const AxisMask normal = AxisMask{1} << n;
  const double offset = to.stand.machine[n] - to.stand.work[n];
  const double end = to.stand.machine[n], clear = std::max({rules.clearance + offset, end, from.machine[n]});
  const double near = std::min(clear, std::max(end, end + rules.above));
  Axes at = from.machine;
  const auto go = [&](const Axes& machine, AxisMask named, bool rapid) {
    AxisMask moves = 0;
    for (std::size_t a = 0; a < axes; ++a)
      if ((named >> a & 1U) != 0 && std::fabs(machine[a] - at[a]) > tol::same_point) moves |= AxisMask{1} << a;
    if (moves == 0) return;
    at = machine;
    path.push_back({rapid, moves, machine, rapid ? 0 : rules.feed});
  };
  const bool stands_there = !is_at_other_place(at, to.stand.machine, axes, n);
  Axes next = at;
  if (!stands_there) {
    next[n] = clear;
    go(next, normal, true);
    next = to.stand.machine;
    next[n] = clear;
    go(next, ~normal, true);
  }
  next = at;
  next[n] = std::min(at[n], near);
  if (at[n] > near) go(next, normal, true);
  next[n] = end;
  go(next, normal, at[n] < end);  // an upward motion is a rapid, since it leads away from the material
  return path;
}

std::vector<BlockMove> in_work_coordinates(const std::vector<WayPoint>& path, const Restart& to, const ControlDef& def) {
  std::vector<BlockMove> blocks;
  const AxisMask normal = AxisMask{1} << to.normal;
  const auto add = [&](const WayPoint& point) {
    BlockMove& block = blocks.emplace_back(BlockMove{point.rapid, {}, point.feed, point.named == normal});
    for (std::size_t a = 0; a < def.axes.size() && a < max_axes; ++a)
      if ((point.named >> a & 1U) != 0)
        block.to.emplace_back(def.axes[a].front(), point.machine[a] - (to.stand.machine[a] - to.stand.work[a]));
  };
  for (const WayPoint& point : path) add(point);
  const bool none_along = std::none_of(blocks.begin(), blocks.end(), [](const BlockMove& block) { return block.along_tool; });
  // Adds a block without travel, which makes the tool length offset effective.
  if (!path.empty() && none_along) add({true, normal, path.back().machine, 0});
  return blocks;
}

}  // namespace kadr
