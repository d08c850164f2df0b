// G2, G3: converts the words to an arc, and the arc to a Motion. Rules: 2С42 6.6.4 and 6.6.6; Mach3: RS274/NGC; other controls as
// [behaviour] of their file defines.

#include <algorithm>
#include <cmath>

#include "base/tolerance.h"
#include "control/block/arc.h"
#include "control/emitter.h"
#include "control/functions/cutter_compensation.h"
#include "control/functions/functions.h"

namespace kadr {
namespace {

Vec2 in_plane(const Axes& point, PlaneAxes p) { return {point[p.first], point[p.second]}; }

/// Checks that the rotation in force moves the circle only within its plane. A rotation in XY (G68) would tilt a circle in another plane,
/// which is an alarm.
Status turned_in_plane(const BlockContext& m, PlaneAxes axes, Span where, std::string_view code) {
  if (m.transform.leaves(axes)) return fail(alarm(AlarmId::plane_wrong, where, code));
  return {};
}

/// Sets the location of an alarm about an arc's geometry to the whole block.
tl::unexpected<Alarm> placed(const BlockContext& m, Alarm alarm) {
  alarm.where = m.block->where;
  while (alarm.where.end > alarm.where.begin && static_cast<unsigned char>(m.block->text[alarm.where.end - 1]) <= ' ') --alarm.where.end;
  return fail(alarm);
}

class Circular {
 public:
  Circular(Emitter& m, Turn turn) : m_(m), turn_(turn), axes_(m.modal.axes), rule_(m.plain_arc_rule()) {}

  Status run(Span where) {
    if (m_.modal.polar) return fail(alarm(AlarmId::polar_motion, where, turn_ == Turn::cw ? "G2" : "G3"));
    AxisMask named = 0;
    Axes end;
    KADR_TRY(m_.target(end, named));
    const bool corrected = m_.dialect->adds_to_motion(m_);
    const std::uint64_t used =
        m_.letters.axes | m_.letters.centers | (m_.def.behaviour.reads_arc_radius() ? letter_bit('R') : std::uint64_t{0});
    if ((m_.block->letters & used) == 0 && !corrected) return {};  // a block that has only the code sets the mode, and moves nothing
    if (corrected) KADR_TRY(correct(named));
    KADR_TRY(check_arc_at_compensation_ends(m_, where, turn_ == Turn::cw ? "G2" : "G3"));
    KADR_TRY(m_.feed_known(where));
    const Axes& start = m_.position.programmed;
    auto arc = shape(start, end, where);
    if (!arc) return fail(arc.error());
    KADR_TRY(helix(start, end, *arc));
    KADR_TRY(turned_in_plane(m_, axes_, where, turn_ == Turn::cw ? "G2" : "G3"));
    // Under unequal scale factors the path is an ellipse, not a circle (Mach3 10.7.15).
    if (m_.transform.distorts(axes_)) return start_ellipse(*arc, end, named);
    emit_arc_motion(*arc, end, named);
    return {};
  }

 private:
  /// Shifts the end point of the arc by the corrector (offset) that L names (spec/correctors 1). INFERRED: I, J, K give the centre from the
  /// tool's actual position.
  Status correct(AxisMask& named) {
    const auto added = m_.dialect->add_to_motion(m_);
    if (!added) return fail(added.error());
    named |= *added;
    m_.position.programmed = m_.transform.to_programmed(m_.position.work);
    return {};
  }

  Result<PlaneArc> shape(const Axes& start, const Axes& end, Span where) {
    const Vec2 from = in_plane(start, axes_);
    const Vec2 to = in_plane(end, axes_);
    if (m_.def.behaviour.reads_arc_radius() && m_.has('R')) {
      if (has_center(axes_.first) || has_center(axes_.second)) return fail(alarm(AlarmId::not_together, m_.where('R'), "R", "I J K"));
      const auto arc = arc_by_radius(from, to, m_.length_value('R'), turn_, rule_.difference);
      if (!arc) return placed(m_, arc.error());
      return arc;
    }
    if (!has_center(axes_.first) && !has_center(axes_.second)) {
      const auto& letters = m_.letters.center_letter;
      return fail(alarm(AlarmId::center_missing, where, letters[axes_.first], letters[axes_.second]));
    }
    if (!rule_.lead_on_normal && has_center(axes_.normal) && m_.value(m_.letters.center_letter[axes_.normal]) != 0)
      return fail(
          alarm(AlarmId::arc_not_in_plane, m_.where(m_.letters.center_letter[axes_.normal]), m_.letters.center_letter[axes_.normal]));
    const auto arc = arc_around(from, to, {center(axes_.first, from.x), center(axes_.second, from.y)}, turn_, rule_.difference);
    if (!arc) return placed(m_, arc.error());
    return arc;
  }

  bool has_center(std::size_t axis) const { return m_.letters.center_letter[axis] != 0 && m_.has(m_.letters.center_letter[axis]); }

  /// Returns a coordinate of the centre. If the coordinate has no word, the result is the coordinate of the start point (INFERRED for
  /// absolute centres).
  double center(std::size_t axis, double start) const {
    if (!has_center(axis)) return start;
    const double v = m_.length_value(m_.letters.center_letter[axis]);
    return rule_.absolute ? v : start + v;
  }

  /// Reads the helix of the 2С42 (6.6.6). If the arc also moves along the normal axis, K is the lead in mm per revolution, and Z/K must be
  /// a whole number of revolutions.
  Status helix(const Axes& start, const Axes& end, PlaneArc& arc) {
    if (!rule_.lead_on_normal) return {};
    const double rise = std::fabs(end[axes_.normal] - start[axes_.normal]);
    const char letter = m_.letters.center_letter[axes_.normal];
    if (!has_center(axes_.normal)) {
      if (rise <= tol::same_point) return {};
      return fail(alarm(AlarmId::word_missing, m_.block->where, letter, "G2, G3"));
    }
    const double lead = std::fabs(m_.length_value(letter));
    if (rise <= tol::same_point) return fail(alarm(AlarmId::word_unused, m_.where(letter), letter));
    const double turns = rise / lead;
    const double whole = std::round(turns);
    if (!(lead > 0) || whole < 1 || std::fabs(turns - whole) > tol::whole_turns)
      return fail(alarm(AlarmId::turns_not_whole, m_.where(letter), rise, lead));
    arc.turns += whole - 1;  // INFERRED: a helix of several revolutions is the programmed arc, followed by whole circles
    return {};
  }

  /// Starts an ellipse, after checking that the whole ellipse is within reach.
  Status start_ellipse(const PlaneArc& arc, const Axes& end, AxisMask named) {
    EllipseRun::Job job;
    job.first = axes_.first;
    job.second = axes_.second;
    job.center = arc.center;
    job.from = m_.position.programmed;
    job.to = end;
    job.sweep_deg = (turn_ == Turn::ccw ? 360 : -360) * arc.turns;
    job.greatest_scale = std::max(std::fabs(m_.transform.scale[axes_.first]), std::fabs(m_.transform.scale[axes_.second]));
    job.named = named | 1u << axes_.first | 1u << axes_.second;
    const double reach = (length(arc.center) + length(in_plane(end, axes_) - arc.center)) * job.greatest_scale;
    if (!(reach <= farthest)) return fail(alarm(AlarmId::position_out_of_range, m_.block->where, m_.axis_names[axes_.first], reach));
    m_.ellipse_run.start(job);
    return {};
  }

  void emit_arc_motion(const PlaneArc& arc, const Axes& end, AxisMask named) {
    Axes center = m_.position.programmed;
    center[axes_.first] = arc.center.x;
    center[axes_.second] = arc.center.y;
    bool reversed = false;
    Axes work = end;
    if (!m_.transform.identity) {
      reversed = m_.transform.reverses(axes_);
      work = m_.transform.to_work(end);
      center = m_.transform.to_work(center);
    }
    named |= 1u << axes_.first | 1u << axes_.second;
    m_.move_to(end, work, named);
    const bool cw = (turn_ == Turn::cw) != reversed;
    Motion& motion = m_.add_motion(cw ? MotionKind::arc_cw : MotionKind::arc_ccw, named);
    m_.set_feed(motion);
    motion.center = {center[axes_.first], center[axes_.second]};
    motion.turns = arc.turns;
    note_arc_end(m_, motion);
  }

  Emitter& m_;
  Turn turn_;
  PlaneAxes axes_;
  ArcRule rule_;
};

Status circular(Emitter& m, const Call& call, Turn turn, MotionMode mode) {
  if (call.row->modal) {
    m.modal.motion = mode;
    m.modal.motion_row = static_cast<std::int16_t>(call.row - m.def.codes.data());
  }
  m.cycle_memory.row = -1;
  if (m.block_axes_taken) return {};
  return m.dialect->arc(m, call, turn);
}

}  // namespace

ArcRule BlockContext::plain_arc_rule() const {
  const Behaviour& b = def.behaviour;
  const bool as_distance = b.arc_centers == ArcCenters::as_distance, by_code = b.arc_centers == ArcCenters::by_code;
  const bool absolute = (as_distance && modal.absolute) || (by_code && modal.centers_absolute);
  const double difference = modal.inch && b.arc_difference_inch > 0 ? b.arc_difference_inch : b.arc_radius_difference;
  return {true, b.reads_arc_radius(), absolute, b.helix_by_lead(), difference};
}

Status Emitter::plain_arc(Turn turn, Span where) { return Circular(*this, turn).run(where); }

Status functions::arc_cw(Emitter& m, const Call& call) { return circular(m, call, Turn::cw, MotionMode::arc_cw); }
Status functions::arc_ccw(Emitter& m, const Call& call) { return circular(m, call, Turn::ccw, MotionMode::arc_ccw); }

/// G12, G13 (Mach3): the tool moves from the centre by I in the direction +X, along the full circle, and back to the centre. arg: 2
/// clockwise, 3 counter-clockwise.
Status functions::circular_pocket(Emitter& m, const Call& call) {
  if (m.modal.radius_side != 0) return fail(alarm(AlarmId::compensation_active, call.where, call.row->code));
  KADR_TRY(m.feed_known(call.where));
  const double radius = m.length_value('I');
  if (!(radius > 0)) return fail(alarm(AlarmId::value_out_of_range, m.where('I'), 'I', radius));
  const PlaneAxes plane = axes_of(Plane::xy);
  restart_contour_at_tool(m);
  KADR_TRY(turned_in_plane(m, plane, call.where, call.row->code));
  if (m.transform.distorts(plane)) return fail(alarm(AlarmId::not_together, call.where, "G51", call.row->code));
  const Axes middle = m.position.programmed;
  Axes edge = middle;
  edge[0] += radius;
  KADR_TRY(m.straight(MotionKind::feed, edge, 1u));
  const Axes center = m.transform.identity ? middle : m.transform.to_work(middle);
  const bool cw = (call.row->arg == 2) != m.transform.reverses(plane);
  Motion& circle = m.add_motion(cw ? MotionKind::arc_cw : MotionKind::arc_ccw, 3u);
  m.set_feed(circle);
  circle.first = 0;
  circle.second = 1;
  circle.center = {center[0], center[1]};
  circle.turns = 1;
  return m.straight(MotionKind::feed, middle, 1u);
}

}  // namespace kadr
