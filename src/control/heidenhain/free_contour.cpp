// FK programming: FL, FLT, FC, FCT whose words determine the element by itself (spec/heidenhain 14). An element that only later ones would
// determine is refused. Used by control/heidenhain.

#include <cmath>

#include "base/tolerance.h"
#include "control/heidenhain/block_run.h"

namespace kadr::heidenhain {
namespace {

Vec2 left_side(Vec2 v) { return {-v.y, v.x}; }

}  // namespace

/// Executes an element. Its start is the tool's position; AN, or the element before it, gives its direction there.
Status BlockRun::free_contour() {
  const bool tangential = read_.name.ends_with('T');
  const tl::unexpected<Alarm> unsolved = fail(alarm(AlarmId::not_available, m_.block->where, "FK"));
  Axes to;
  AxisMask named = 0;
  if (has("PR") || has("PA")) return unsolved;
  KADR_TRY(target(to, named));
  const Memory& memory = own_.memory;
  std::optional<Vec2> ahead;
  if (tangential) {
    if (!memory.has_direction || !(memory.direction_plane == plane_))
      return fail(alarm(AlarmId::tangent_missing, m_.block->where, std::string_view(read_.name)));
    ahead = 1 / length(memory.direction) * memory.direction;
  } else if (has("AN")) {
    const auto angle = number("AN");
    if (!angle) return fail(angle.error());
    if (read_.find("AN")->incremental) return unsolved;
    const SinCos turned = sincos_deg(*angle);
    ahead = Vec2{turned.cos, turned.sin};
  }
  return read_.name.starts_with("FL") ? free_line(to, named, ahead) : free_arc(to, named, ahead);
}

Status BlockRun::free_line(Axes to, AxisMask named, std::optional<Vec2> ahead) {
  const tl::unexpected<Alarm> unsolved = fail(alarm(AlarmId::not_available, m_.block->where, "FK"));
  const bool x = (named >> plane_.first & 1U) != 0, y = (named >> plane_.second & 1U) != 0;
  const Vec2 from = in_plane(m_.position.programmed, plane_);
  if (!(x && y)) {
    if (!ahead) return unsolved;
    Vec2 end;
    if (has("LEN")) {
      const auto size = number("LEN");
      if (!size) return fail(size.error());
      if (x || y) return unsolved;
      end = from + *size * m_.unit_scale() * *ahead;
    } else if (x || y) {
      const double along = x ? ahead->x : ahead->y, way = x ? to[plane_.first] - from.x : to[plane_.second] - from.y;
      if (!(std::fabs(along) > tol::tangential) || !(way / along > 0)) return unsolved;
      end = from + way / along * *ahead;
      if (x) end.x = to[plane_.first];
      else end.y = to[plane_.second];
    } else {
      return unsolved;
    }
    to[plane_.first] = end.x;
    to[plane_.second] = end.y;
  }
  return straight_to(to, named | mask_of(plane_));
}

/// An arc: its centre by CCX, CCY or by the radius and the direction at its start; its end by X, Y or by the angle CCA.
Status BlockRun::free_arc(Axes to, AxisMask named, std::optional<Vec2> ahead) {
  const tl::unexpected<Alarm> unsolved = fail(alarm(AlarmId::not_available, m_.block->where, "FK"));
  const bool has_end = (named & mask_of(plane_)) == mask_of(plane_);
  const Vec2 from = in_plane(m_.position.programmed, plane_);
  const auto size = number("R");
  if (!size) return fail(size.error());
  const double radius = *size * m_.unit_scale();
  if (!has("DR")) return unsolved;
  const auto sense = turn();
  if (!sense) return fail(sense.error());
  KADR_TRY(arc_allowed());
  const double left = *sense == Turn::ccw ? 1 : -1;
  Vec2 centre;
  if (has("CCX") && has("CCY")) {
    const auto first = number("CCX"), second = number("CCY");
    if (!first) return fail(first.error());
    if (!second) return fail(second.error());
    centre = m_.unit_scale() * Vec2{*first, *second};
  } else if (ahead && radius > 0 && !has("CCX") && !has("CCY")) {
    centre = from + left * radius * left_side(*ahead);
  } else if (has_end && radius > 0) {
    const auto arc = arc_by_radius(from, in_plane(to, plane_), radius, *sense, circle_deviation);
    if (!arc) return unsolved;
    centre = arc->center;
  } else {
    return unsolved;
  }
  if (!has_end) {
    if (!has("CCA") || (named & mask_of(plane_)) != 0) return unsolved;
    const auto angle = number("CCA");
    if (!angle) return fail(angle.error());
    const Vec2 end = centre + rotated(from - centre, left * std::fabs(*angle));
    to[plane_.first] = end.x;
    to[plane_.second] = end.y;
  }
  const auto arc = arc_around(from, in_plane(to, plane_), centre, *sense, circle_deviation);
  if (!arc) return unsolved;
  own_.emit_arc(m_, *sense, *arc, to, named | mask_of(plane_), plane_);
  return {};
}

}  // namespace kadr::heidenhain
