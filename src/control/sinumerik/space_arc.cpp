// CIP through a point outside the plane: an arc in space (spec/sinumerik 12.2). The programmable frame is turned into the plane of the arc
// for this motion, and is then as before. Used by control/sinumerik.

#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/tolerance.h"
#include "control/sinumerik/block_run.h"

namespace kadr::sinumerik {
namespace {

/// Returns the point in the coordinates of the turned frame.
Vec3 turned(const Matrix& turn, Vec3 p) {
  const auto column = [&](std::size_t j) { return turn[0][j] * p.x + turn[1][j] * p.y + turn[2][j] * p.z; };
  return {column(0), column(1), column(2)};
}

Vec2 in_plane(Vec3 p, PlaneAxes plane) {
  const double all[] = {p.x, p.y, p.z};
  return {all[plane.first], all[plane.second]};
}

}  // namespace

/// Takes the axis words out of the block, which has no other motion, and leaves the arc to after_block(). `through` and `to`: programmed
/// coordinates.
///   alarms  not_available: with compensation, TRAORI or TURN
///   returns false if the three points are on a line, in their order: the block is a line
Result<bool> BlockRun::arc_in_space(const Axes& through, const Axes& to) {
  if (m_.modal.radius_side != 0 || own_.memory.holds_tip || own_.words.has("TURN"))
    return fail(alarm(AlarmId::not_available, block_.where, "CIP"));
  const Vec3 from = in_space(m_.position.programmed), a = in_space(through) - from, b = in_space(to) - from;
  const Vec3 normal = cross(a, b);
  const double size = std::sqrt(dot(normal, normal)), along = std::sqrt(dot(a, a));
  if (!(size > tol::same_point * std::max(1.0, along))) {
    if (dot(a, b - a) < 0) return fail(alarm(AlarmId::arc_through_point, block_.where));
    return false;
  }
  const Vec3 w = 1 / size * normal, u = 1 / along * a, v = cross(w, u);
  const PlaneAxes plane = m_.modal.axes;
  SpaceArc arc;
  for (const auto& [axis, column] : {std::pair{plane.first, u}, std::pair{plane.second, v}, std::pair{plane.normal, w}}) {
    arc.turn[0][axis] = column.x;
    arc.turn[1][axis] = column.y;
    arc.turn[2][axis] = column.z;
  }
  arc.through = in_space(through);
  arc.to = in_space(to);
  arc.where = block_.where;
  own_.words.space_arc = arc;
  std::uint32_t kept = 0;
  for (std::uint32_t i = 0; i < block_.word_count; ++i) {
    const Word word = block_.words[i];
    if ((m_.letters.axes & letter_bit(word.address)) != 0) {
      block_.letters &= ~letter_bit(word.address);
      continue;
    }
    block_.at[static_cast<std::size_t>(word.address - 'A')] = static_cast<std::uint8_t>(kept);
    block_.words[kept++] = word;
  }
  block_.word_count = kept;
  return true;
}

Status Sinumerik::emit_in_space(Emitter& m, const SpaceArc& arc) {
  KADR_TRY(m.feed_known(arc.where));
  const Frame before = memory.programmable;
  Frame turn;
  turn.linear = arc.turn;
  KADR_TRY(set_programmable(m, chained(before, turn), arc.where));
  const PlaneAxes plane = m.modal.axes;
  Axes end = m.position.programmed;
  const Vec2 from{end[plane.first], end[plane.second]};
  const Vec2 a = in_plane(turned(arc.turn, arc.through), plane) - from, b = in_plane(turned(arc.turn, arc.to), plane) - from;
  const double twice = 2 * cross(a, b), aa = dot(a, a), bb = dot(b, b);
  const Vec2 middle{(b.y * aa - a.y * bb) / twice, (a.x * bb - b.x * aa) / twice};  // from the start point
  const Vec2 first = -1 * middle, last = b - middle;
  double angle = std::atan2(cross(first, last), dot(first, last));
  if (angle <= 0) angle += 2 * std::numbers::pi;
  end[plane.first] = from.x + b.x;
  end[plane.second] = from.y + b.y;
  emit_arc(m, Turn::ccw, PlaneArc{from + middle, angle / (2 * std::numbers::pi)}, end, 0);
  return set_programmable(m, before, arc.where);
}

}  // namespace kadr::sinumerik
