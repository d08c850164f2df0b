// APPR and DEP: smooth approach to a contour, and departure from it (spec/heidenhain 8). Used by control/heidenhain.

#include <cmath>

#include "base/tolerance.h"
#include "control/flow/program_file.h"
#include "control/functions/cutter_compensation.h"
#include "control/heidenhain/block_run.h"
#include "lang/block/block_reader.h"
#include "lang/klartext/klartext_parser.h"

namespace kadr::heidenhain {
namespace {

constexpr int most_looked_at = 20;  // blocks without motion in the plane before the first element

Vec2 left_of(Vec2 v) { return {-v.y, v.x}; }

}  // namespace

/// Returns the direction, of length 1 in programmed coordinates, in which the contour begins at a point after the block.
Result<Vec2> BlockRun::direction_ahead(const Axes& from) {
  const tl::unexpected<Alarm> missing = fail(alarm(AlarmId::element_missing, m_.block->where, std::string_view("APPR " + read_.name)));
  const ProgramFile& file = m_.program().file(m_.program().reader());
  BlockReader reader(file.source(), file.grammar(), file.reader().encoding());
  reader.seek(m_.program().position());
  const auto block = std::make_unique<Block>();
  // The first element is read from the point where the approach ends; pole and position are those that it will meet.
  const Axes before = m_.position.programmed;
  const Modes modes = own_.memory;
  m_.position.programmed = from;
  std::optional<Vec2> found;
  for (int i = 0; i < most_looked_at && !found; ++i) {
    const auto got = reader.next(*block);
    if (!got || *got == BlockReader::Got::end) break;
    const auto read = own_.block_at(m_, block->position);
    if (!read) continue;
    BlockRun element(m_, own_, *read);
    Axes to;
    AxisMask named = 0;
    const auto line = [&](const Status& known) {
      const Vec2 way = in_plane(to, plane_) - in_plane(from, plane_);
      if (known && (named & mask_of(plane_)) != 0 && length(way) > tol::same_point) found = 1 / length(way) * way;
    };
    const auto about = [&](Vec2 centre, Turn sense) {
      const Vec2 arm = in_plane(from, plane_) - centre;
      if (length(arm) > tol::same_point) found = (sense == Turn::ccw ? 1 : -1) / length(arm) * left_of(arm);
    };
    const auto sense = element.turn();
    switch (read->kind) {
      case KlartextKind::line: line(element.target(to, named)); break;
      case KlartextKind::polar_line: line(element.polar_target(to, named)); break;
      case KlartextKind::centre: (void)element.centre(); break;
      case KlartextKind::circle:
      case KlartextKind::polar_circle:
        if (own_.memory.has_pole && sense) about(own_.memory.pole, *sense);
        break;
      case KlartextKind::radius_circle: {
        const auto radius = element.number("R");
        if (!sense || !radius || !element.target(to, named)) break;
        const auto arc = arc_by_radius(in_plane(from, plane_), in_plane(to, plane_), *radius * m_.unit_scale(), *sense, circle_deviation);
        if (arc) about(arc->center, *sense);
        break;
      }
      default: break;
    }
  }
  m_.position.programmed = before;
  static_cast<Modes&>(own_.memory) = modes;
  if (!found) return missing;
  return *found;
}

Status BlockRun::line_in_plane(Vec2 to, bool rapid) {
  Axes end = m_.position.programmed;
  end[plane_.first] = to.x;
  end[plane_.second] = to.y;
  if (rapid) return m_.straight(MotionKind::rapid, end, mask_of(plane_));
  KADR_TRY(m_.feed_known(m_.block->where));
  return m_.straight(MotionKind::feed, end, mask_of(plane_));
}

Status BlockRun::arc_in_plane(Vec2 to, Vec2 centre, Turn sense) {
  Axes end = m_.position.programmed;
  end[plane_.first] = to.x;
  end[plane_.second] = to.y;
  KADR_TRY(m_.feed_known(m_.block->where));
  const auto arc = arc_around(in_plane(m_.position.programmed, plane_), to, centre, sense, circle_deviation);
  if (!arc) return fail(arc.error());
  own_.emit_arc(m_, sense, *arc, end, mask_of(plane_), plane_);
  return {};
}

Status BlockRun::approach() {
  const std::string form = read_.name.starts_with('P') ? read_.name.substr(1) : read_.name;
  const bool left = has("RL"), right = has("RR");
  Axes to;
  AxisMask named = 0;
  KADR_TRY(read_.name.starts_with('P') ? polar_target(to, named) : target(to, named));
  const auto direction = direction_ahead(to);
  if (!direction) return fail(direction.error());
  const Vec2 ahead = *direction, end = in_plane(to, plane_);
  // Everything is worked out in programmed coordinates; a mirror image changes both the side and the sense of the arcs.
  const double side = left ? 1 : right ? -1 : 0;
  const double radius = side == 0 ? 0 : own_.tool_radius(m_);
  const Vec2 out = (side < 0 ? -1 : 1) * left_of(ahead);
  const Vec2 point = end + radius * out;  // the tool centre at the first contour point
  const bool rapid_before = own_.memory.moved_at_rapid;
  const double feed = m_.modal.feed, feed_before = own_.memory.feed_before;
  const auto first_part = [&](Vec2 at) -> Status {  // PS to PH
    if (m_.modal.radius_side != 0) KADR_TRY(run_code(-40, m_.block->where));
    const std::size_t normal = plane_.normal;
    Axes there = m_.position.programmed;
    AxisMask moved = mask_of(plane_);
    there[plane_.first] = at.x;
    there[plane_.second] = at.y;
    if ((named >> normal & 1U) != 0) there[normal] = to[normal], moved |= AxisMask{1} << normal;
    if (rapid_before && form != "LCT") return m_.straight(MotionKind::rapid, there, moved);
    KADR_TRY(m_.feed_known(m_.block->where));
    if (form != "LCT" && feed_before > 0) m_.modal.feed = feed_before;
    const Status done = m_.straight(MotionKind::feed, there, moved);
    m_.modal.feed = feed;
    return done;
  };
  const auto begin_side = [&]() -> Status {
    if (side == 0) return {};
    return run_code(left ? -41 : -42, m_.block->where);
  };
  if (form == "LT" || form == "LN") {
    const auto size = number("LEN");
    if (!size) return fail(size.error());
    const double by = *size * m_.unit_scale();
    KADR_TRY(first_part(point + by * (form == "LT" ? -1.0 * ahead : out)));
    KADR_TRY(begin_side());
    return line_in_plane(end, rapid_);
  }
  const auto size = number("R");
  if (!size) return fail(size.error());
  const double arc_radius = std::fabs(*size) * m_.unit_scale();
  if (!(arc_radius > tol::same_point)) return fail(alarm(AlarmId::arc_radius_zero, m_.block->where));
  const double flip = *size < 0 ? -1 : 1;
  const Vec2 centre = point + flip * arc_radius * out;
  const Turn sense = dot(left_of(ahead), flip * out) > 0 ? Turn::ccw : Turn::cw;
  Vec2 begin;
  if (form == "CT") {
    const auto angle = number("CCA");
    if (!angle) return fail(angle.error());
    begin = centre + rotated(point - centre, sense == Turn::ccw ? -*angle : *angle);
  } else {
    const Vec2 from = in_plane(m_.position.programmed, plane_), arm = from - centre;
    const double distance = length(arm);
    if (!(distance > arc_radius)) return fail(alarm(AlarmId::radius_too_small, m_.block->where, arc_radius, distance));
    const double angle = std::acos(arc_radius / distance) / rad_per_deg;
    begin = centre + arc_radius / distance * rotated(arm, sense == Turn::ccw ? angle : -angle);
  }
  KADR_TRY(first_part(begin));
  KADR_TRY(arc_in_plane(point, centre, sense));
  KADR_TRY(begin_side());
  return side == 0 ? Status() : line_in_plane(end, false);
}

Status BlockRun::departure() {
  Memory& memory = own_.memory;
  if (!memory.has_direction || !(memory.direction_plane == plane_))
    return fail(alarm(AlarmId::element_missing, m_.block->where, std::string_view("DEP " + read_.name)));
  const std::string form = read_.name.starts_with('P') ? read_.name.substr(1) : read_.name;
  Axes to;
  AxisMask named = 0;
  KADR_TRY(read_.name.starts_with('P') ? polar_target(to, named) : target(to, named));
  const Vec2 ahead = 1 / length(memory.direction) * memory.direction;
  const double side = m_.modal.radius_side < 0 ? 1 : m_.modal.radius_side > 0 ? -1 : 0;
  const double radius = side == 0 ? 0 : own_.tool_radius(m_);
  const Vec2 out = (side < 0 ? -1 : 1) * left_of(ahead);
  const Vec2 point = in_plane(m_.position.programmed, plane_) + radius * out;
  if (side != 0) KADR_TRY(run_code(-40, m_.block->where));
  const auto others = [&](Vec2 at) -> Status {
    Axes there = m_.position.programmed;
    AxisMask moved = mask_of(plane_);
    there[plane_.first] = at.x;
    there[plane_.second] = at.y;
    if ((named >> plane_.normal & 1U) != 0) there[plane_.normal] = to[plane_.normal], moved |= AxisMask{1} << plane_.normal;
    KADR_TRY(m_.feed_known(m_.block->where));
    return m_.straight(rapid_ ? MotionKind::rapid : MotionKind::feed, there, moved);
  };
  if (form == "LT" || form == "LN") {
    const auto size = number("LEN");
    if (!size) return fail(size.error());
    return others(point + *size * m_.unit_scale() * (form == "LT" ? ahead : out));
  }
  const auto size = number("R");
  if (!size) return fail(size.error());
  const double arc_radius = std::fabs(*size) * m_.unit_scale();
  if (!(arc_radius > tol::same_point)) return fail(alarm(AlarmId::arc_radius_zero, m_.block->where));
  const double flip = *size < 0 ? -1 : 1;
  const Vec2 centre = point + flip * arc_radius * out;
  const Turn sense = dot(left_of(ahead), flip * out) > 0 ? Turn::ccw : Turn::cw;
  if (side != 0) KADR_TRY(line_in_plane(point, false));  // the contour ends square to its last element
  if (form == "CT") {
    const auto angle = number("CCA");
    if (!angle) return fail(angle.error());
    return arc_in_plane(centre + rotated(point - centre, sense == Turn::ccw ? *angle : -*angle), centre, sense);
  }
  const Vec2 end = in_plane(to, plane_), arm = end - centre;
  const double distance = length(arm);
  if (!(distance > arc_radius)) return fail(alarm(AlarmId::radius_too_small, m_.block->where, arc_radius, distance));
  const double angle = std::acos(arc_radius / distance) / rad_per_deg;
  KADR_TRY(arc_in_plane(centre + arc_radius / distance * rotated(arm, sense == Turn::ccw ? -angle : angle), centre, sense));
  return others(end);
}

}  // namespace kadr::heidenhain
