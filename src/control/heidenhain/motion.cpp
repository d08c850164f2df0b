// Lines, circles, polar words (spec/heidenhain 3 to 6). Used by control/heidenhain.

#include <algorithm>
#include <cmath>

#include "base/tolerance.h"
#include "control/functions/cutter_compensation.h"
#include "control/heidenhain/block_run.h"

namespace kadr::heidenhain {
/// With M126 a rotary axis takes the shorter way to a position below 360 degrees (spec/heidenhain 3.8).
double BlockRun::short_way(std::size_t axis, double to) const {
  if (!own_.memory.shortest || (m_.def.rotary >> axis & 1U) == 0) return to;
  const double now = m_.position.programmed[axis];
  double way = std::fmod(to - now, 360.0);
  if (way > 180) way -= 360;
  if (way <= -180) way += 360;
  return now + way;
}

Status BlockRun::target(Axes& to, AxisMask& named) {
  to = m_.position.programmed;
  named = 0;
  for (const KlartextWord& word : read_.words) {
    for (std::size_t a = 0; a < m_.def.axes.size(); ++a) {
      if (word.name != word_name(m_.def.axes[a])) continue;
      if (a >= m_.axis_count || (own_.missing_axes & letter_bit(m_.def.axes[a][0])) != 0)
        return fail(alarm(AlarmId::axis_not_named, word.where, m_.def.axes[a][0]));
      const auto read = own_.value(m_, read_, word);
      if (!read) return fail(read.error());
      const bool rotary = (m_.def.rotary >> a & 1U) != 0;
      const double value = *read * (rotary ? 1.0 : m_.unit_scale());
      to[a] = word.incremental ? m_.position.programmed[a] + value : short_way(a, value);
      named |= AxisMask{1} << a;
      if (!(std::fabs(to[a]) <= farthest)) return fail(alarm(AlarmId::position_out_of_range, word.where, m_.def.axes[a][0], to[a]));
    }
  }
  return {};
}

/// LP, CTP: PR and PA about the pole; a missing one is that of the present position (spec/heidenhain 5.1).
Status BlockRun::polar_target(Axes& to, AxisMask& named) {
  KADR_TRY(target(to, named));
  if (!has("PR") && !has("PA")) return {};
  Memory& memory = own_.memory;
  if (!memory.has_pole) return fail(alarm(AlarmId::pole_missing, m_.block->where));
  const Vec2 arm = in_plane(m_.position.programmed, plane_) - memory.pole;
  double radius = length(arm), angle = std::atan2(arm.y, arm.x) / rad_per_deg;
  for (const Name name : {Name("PR"), Name("PA")}) {
    const KlartextWord* const word = read_.find(name);
    if (word == nullptr) continue;
    const auto read = own_.value(m_, read_, *word);
    if (!read) return fail(read.error());
    const double value = *read * (name == "PR" ? m_.unit_scale() : 1);
    double& of = name == "PR" ? radius : angle;
    of = word->incremental ? of + value : value;
  }
  const SinCos turn = sincos_deg(angle);
  to[plane_.first] = memory.pole.x + radius * turn.cos;
  to[plane_.second] = memory.pole.y + radius * turn.sin;
  named |= mask_of(plane_);
  return {};
}

/// M103: the part of the feed along the negative tool axis is at most F times the factor (spec/heidenhain 3.8).
double BlockRun::limited_feed(const Axes& to) const {
  const double feed = m_.modal.feed, factor = own_.memory.plunge;
  if (!(factor > 0)) return feed;
  double all = 0;
  for (std::size_t a = 0; a < 3 && a < m_.axis_count; ++a) {
    const double way = to[a] - m_.position.programmed[a];
    all += way * way;
  }
  const double down = m_.position.programmed[plane_.normal] - to[plane_.normal];
  if (!(down > tol::same_point)) return feed;
  return std::min(feed, feed * factor * std::sqrt(all) / down);
}

Status BlockRun::straight_to(const Axes& to, AxisMask named) {
  if (named == 0) return {};
  if (own_.memory.holds_tip && own_.five_axis.group == MachineGroup::none && (named & m_.def.rotary) != 0)
    return fail(alarm(AlarmId::no_five_axes, m_.block->where, "M128"));
  if (rapid_) return m_.straight(MotionKind::rapid, to, named);
  KADR_TRY(m_.feed_known(m_.block->where));
  const double feed = m_.modal.feed;
  m_.modal.feed = limited_feed(to);
  const Status moved = m_.straight(MotionKind::feed, to, named);
  m_.modal.feed = feed;
  return moved;
}

/// M91, M92: machine coordinates; the tool length does not act (spec/heidenhain 3.7).
Status BlockRun::machine_line() {
  Axes to;
  AxisMask named = 0;
  const Axes before = m_.position.programmed;
  m_.position.programmed = m_.position.machine;  // increments count from the machine position
  const Status read = target(to, named);
  m_.position.programmed = before;
  KADR_TRY(read);
  if (named == 0) return {};
  if (from_reference_)
    for (std::size_t a = 0; a < m_.axis_count; ++a)
      if ((named >> a & 1U) != 0) to[a] += m_.tables.reference[1][a];
  if (!rapid_) KADR_TRY(m_.feed_known(m_.block->where));
  return m_.to_machine(rapid_ ? MotionKind::rapid : MotionKind::feed, to, named, 0);
}

/// M140 MB: retracts along the tool axis (spec/heidenhain 3.8).
Status BlockRun::retract() {
  Axes to = m_.position.programmed;
  const std::size_t axis = plane_.normal;
  const AxisMask named = AxisMask{1} << axis;
  const auto feed = number("MF");
  if (!feed) return fail(feed.error());
  const double before = m_.modal.feed;
  const FeedMode mode = m_.modal.feed_mode;
  const bool rapid = !has("MF");
  if (!rapid) m_.modal.feed = *feed * m_.unit_scale(), m_.modal.feed_mode = FeedMode::per_minute;
  Status moved;
  if (has("MBMAX")) {
    Axes machine = m_.position.machine;
    if (!(own_.most[axis] < 1e300)) return fail(alarm(AlarmId::not_available, m_.block->where, "M140 MB MAX"));
    machine[axis] = own_.most[axis];
    moved = m_.to_machine(rapid ? MotionKind::rapid : MotionKind::feed, machine, named, 0);
  } else {
    const auto by = number("MB");
    if (!by) return fail(by.error());
    to[axis] += *by * m_.unit_scale();
    moved = m_.straight(rapid ? MotionKind::rapid : MotionKind::feed, to, named);
  }
  m_.modal.feed = before;
  m_.modal.feed_mode = mode;
  return moved;
}

/// CC: centre and pole. One coordinate leaves the other as it was (spec/heidenhain 4.1).
Status BlockRun::centre() {
  Memory& memory = own_.memory;
  Axes to;
  AxisMask named = 0;
  KADR_TRY(target(to, named));
  PlaneAxes plane = plane_;
  if ((named & AxisMask{1} << plane_.normal) != 0) {  // CC Y Z: another plane
    if ((named & 3U) == 2U) plane = axes_of(Plane::yz);
    else if ((named & 3U) == 1U) plane = axes_of(Plane::zx);
  }
  const Vec2 here = in_plane(m_.position.programmed, plane);
  const bool keeps = memory.has_pole && memory.pole_plane == plane && named != 0;
  Vec2 pole = keeps ? memory.pole : here;
  if ((named >> plane.first & 1U) != 0) pole.x = to[plane.first];
  if ((named >> plane.second & 1U) != 0) pole.y = to[plane.second];
  memory.pole = pole;
  memory.pole_plane = plane;
  memory.has_pole = true;
  return {};
}

Result<Turn> BlockRun::turn() {
  const KlartextWord* const word = read_.find("DR");
  if (word == nullptr) return fail(alarm(AlarmId::word_missing, m_.block->where, "DR", "C"));
  return word->number < 0 ? Turn::cw : Turn::ccw;
}

Status BlockRun::arc_allowed() const {
  KADR_TRY(check_arc_at_compensation_ends(m_, m_.block->where, "RL, RR"));
  KADR_TRY(m_.feed_known(m_.block->where));
  if (m_.transform.distorts(plane_)) return fail(alarm(AlarmId::not_together, m_.block->where, "CYCL DEF 26", "C"));
  return {};
}

Status BlockRun::circle() {
  Memory& memory = own_.memory;
  if (!memory.has_pole) return fail(alarm(AlarmId::pole_missing, m_.block->where));
  const auto sense = turn();
  if (!sense) return fail(sense.error());
  Axes to;
  AxisMask named = 0;
  KADR_TRY(target(to, named));
  return around_pole(to, named, *sense, memory.pole_plane);
}

Status BlockRun::around_pole(const Axes& end, AxisMask named, Turn sense, PlaneAxes plane) {
  KADR_TRY(arc_allowed());
  const Vec2 from = in_plane(m_.position.programmed, plane), to = in_plane(end, plane);
  auto arc = arc_around(from, to, own_.memory.pole, sense, circle_deviation);
  if (!arc) {
    Alarm fault = arc.error();
    fault.where = m_.block->where;
    return fail(fault);
  }
  own_.emit_arc(m_, sense, *arc, end, named, plane);
  return {};
}

/// CP: about the pole at the radius of the present position; IPA may be several turns (spec/heidenhain 5.2).
Status BlockRun::polar_circle() {
  Memory& memory = own_.memory;
  if (!memory.has_pole) return fail(alarm(AlarmId::pole_missing, m_.block->where));
  const KlartextWord* const word = read_.find("PA");
  const auto sense = turn();
  if (!sense) return fail(sense.error());
  Axes to;
  AxisMask named = 0;
  KADR_TRY(target(to, named));
  KADR_TRY(arc_allowed());
  const Vec2 arm = in_plane(m_.position.programmed, plane_) - memory.pole;
  const double radius = length(arm);
  if (!(radius > tol::same_point)) return fail(alarm(AlarmId::arc_radius_zero, m_.block->where));
  double degrees = 360;
  const auto angle = number("PA");
  if (!angle) return fail(angle.error());
  const double sign = *sense == Turn::ccw ? 1 : -1;
  if (word != nullptr && word->incremental) {
    if (*angle * sign < 0) return fail(alarm(AlarmId::value_out_of_range, word->where, "IPA", *angle));
    degrees = std::fabs(*angle);
  } else if (word != nullptr) {
    degrees = std::fmod(sign * (*angle - std::atan2(arm.y, arm.x) / rad_per_deg), 360.0);
    if (degrees < tol::same_angle) degrees += 360;
  }
  const bool whole = std::fabs(std::remainder(degrees, 360.0)) <= tol::same_angle;
  const Vec2 end = whole ? memory.pole + arm : memory.pole + rotated(arm, sign * std::fmod(degrees, 360.0));
  to[plane_.first] = end.x;
  to[plane_.second] = end.y;
  own_.emit_arc(m_, *sense, {memory.pole, degrees / 360}, to, named | mask_of(plane_), plane_);
  return {};
}

/// CR: by radius; below 0 the arc is longer than half a circle (spec/heidenhain 4.2).
Status BlockRun::radius_circle() {
  const auto sense = turn();
  const auto radius = number("R");
  if (!sense) return fail(sense.error());
  if (!radius) return fail(radius.error());
  if (!has("R")) return fail(alarm(AlarmId::word_missing, m_.block->where, "R", "CR"));
  Axes to;
  AxisMask named = 0;
  KADR_TRY(target(to, named));
  KADR_TRY(arc_allowed());
  const auto arc =
      arc_by_radius(in_plane(m_.position.programmed, plane_), in_plane(to, plane_), *radius * m_.unit_scale(), *sense, circle_deviation);
  if (!arc) {
    Alarm fault = arc.error();
    fault.where = m_.block->where;
    return fail(fault);
  }
  own_.emit_arc(m_, *sense, *arc, to, named, plane_);
  return {};
}

/// CT, CTP: leaves the last element tangentially (spec/heidenhain 4.3).
Status BlockRun::tangent_circle() {
  Memory& memory = own_.memory;
  const bool polar = read_.kind == KlartextKind::polar_tangent_circle;
  if (!memory.has_direction || !(memory.direction_plane == plane_))
    return fail(alarm(AlarmId::tangent_missing, m_.block->where, polar ? "CTP" : "CT"));
  Axes to;
  AxisMask named = 0;
  KADR_TRY(polar ? polar_target(to, named) : target(to, named));
  KADR_TRY(arc_allowed());
  const Vec2 from = in_plane(m_.position.programmed, plane_), chord = in_plane(to, plane_) - from;
  const Vec2 ahead = 1 / length(memory.direction) * memory.direction, left{-ahead.y, ahead.x};
  const double across = dot(chord, left);
  if (std::fabs(across) <= tol::same_point) {
    if (dot(chord, ahead) <= 0) return fail(alarm(AlarmId::tangent_missing, m_.block->where, polar ? "CTP" : "CT"));
    return straight_to(to, named);
  }
  const Vec2 centre = from + dot(chord, chord) / (2 * across) * left;
  const Turn sense = across > 0 ? Turn::ccw : Turn::cw;
  const auto arc = arc_around(from, in_plane(to, plane_), centre, sense, circle_deviation);
  if (!arc) return fail(arc.error());
  own_.emit_arc(m_, sense, *arc, to, named, plane_);
  return {};
}

/// RND and CHF of the next block: the corner at the end of this block's motion (spec/heidenhain 6).
Status BlockRun::corner_words() {
  const ProgramIndex& all = own_.index(m_);
  if (!all.has_corners()) return {};
  const auto place = all.corner_after(m_.block->position.offset);
  if (!place) return {};
  const auto corner = own_.block_at(m_, place->at);
  if (!corner) return {};  // the block itself reports what is wrong
  for (const bool rounds : {true, false}) {
    const KlartextWord* const word = corner->find(rounds ? "R" : "CHF");
    if (word == nullptr || (corner->kind == KlartextKind::rounding) != rounds) continue;
    if (!rounds && place->beside_arc) return fail(alarm(AlarmId::corner_illegal, m_.block->where));
    const auto size = own_.value(m_, *corner, *word);
    if (!size) return fail(size.error());
    (rounds ? own_.corner_rounding : own_.corner_chamfer) = std::max(0.0, *size * m_.unit_scale());
    if (const KlartextWord* const feed = corner->find("F")) {
      const auto value = own_.value(m_, *corner, *feed);
      if (!value) return fail(value.error());
      if (!(*value > 0)) return fail(alarm(AlarmId::value_out_of_range, m_.block->where, "F", *value));
      own_.corner_feed = *value * m_.unit_scale();
    }
  }
  return {};
}

}  // namespace kadr::heidenhain
