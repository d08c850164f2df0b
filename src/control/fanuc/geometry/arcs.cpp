// G2, G3: circles, spirals, helices, cones, in any plane and on surfaces (spec/nct/04 4.3). Used by control/fanuc/dialect.

#include "control/fanuc/geometry/arcs.h"

#include <cmath>

#include "base/tolerance.h"
#include "control/emitter.h"
#include "control/fanuc/fanuc.h"
#include "control/fanuc/five_axis/five_axis_functions.h"
#include "control/fanuc/geometry/automatic_geometry.h"
#include "control/fanuc/words/coordinates.h"

namespace kadr::fanuc {
namespace {

constexpr double any_difference = 1e300;
constexpr std::uint32_t max_turns = 99'999'999;

/// The letters of an arc's centre in a plane (4.3, 4.5): the letter for the first axis, that for the second axis, and the letter that the
/// plane does not use.
struct CenterLetters {
  char first, second, other;
};
CenterLetters center_letters(Plane plane) {
  switch (plane) {
    case Plane::zx: return {'K', 'I', 'J'};
    case Plane::yz: return {'J', 'K', 'I'};
    default: return {'I', 'J', 'K'};
  }
}

/// Builds the arc of one block after the transformations (16.0). Start, end and centre are transformed; the sense of rotation is reversed
/// if the determinant of the transformation is negative.
class Arc {
 public:
  Arc(Emitter& m, const Call& call, Turn turn)
      : m_(m), call_(call), programmed_turn_(turn), plane_(m.modal.axes), letters_(center_letters(m.modal.plane)) {
    const bool reversed = m.transform.reverses(plane_);
    turn_ = (turn == Turn::cw) != reversed ? Turn::cw : Turn::ccw;
  }

  Status run() {
    const bool radius_first = m_.def.behaviour.arc_radius_word == ArcRadius::before_centre;
    if (has_geometry_words(m_) || (m_.has('R') && has_center() && !radius_first)) KADR_TRY(geometry());
    const double angle_before = m_.modal.polar_data ? start_angle() : 0;
    fanuc_of(m_).absolute_block = over_determined();
    const Status read = m_.target(end_, named_);
    fanuc_of(m_).absolute_block = false;
    KADR_TRY(read);
    note_positioned(m_, named_);
    const bool has_data = m_.has('R') || has_center();
    const AxisMask both = 1u << plane_.first | 1u << plane_.second;
    const bool in_plane = (named_ & both) != 0;
    if (named_ == 0 && !has_data) return {};  // a block with G2 or G3 alone sets the mode and moves nothing
    if (radius_first && m_.has('R') && (has_center() || m_.has(letters_.other))) warn_center_passed_over();
    if (m_.has(letters_.other) && !(radius_first && m_.has('R')))
      return fail(alarm(AlarmId::arc_not_in_plane, m_.where(letters_.other), letters_.other));
    // 25.17: without a motion in the plane, the tool rotates about its tip
    if (!has_data && !in_plane && fanuc_of(m_).by_direction != 0) return straight_rest();
    if (!has_data && fanuc_of(m_).settings.arc_without_data_straight) {
      m_.warn(warning(AlarmId::arc_is_line, call_.where, call_.row->code));
      return straight_line();
    }
    if (!has_data) return fail(alarm(AlarmId::center_missing, call_.where, letters_.first, letters_.second));
    if (m_.transform.leaves(plane_)) return fail(alarm(AlarmId::plane_wrong, call_.where, call_.row->code));
    from_ = placed_flat(m_.position.programmed);
    to_ = placed_flat(end_);
    if (over_determined()) return meeting_arc();
    polar_turns_ = polar_turns(angle_before);
    if (polar_turns_ && m_.transform.distorts(plane_)) return fail(alarm(AlarmId::not_available, call_.where, "G16 G51"));
    if (m_.has('R') && !polar_turns_ && (!in_plane || length(to_ - from_) <= tol::same_point)) return straight_rest();
    KADR_TRY(m_.feed_known(call_.where));
    auto arc = m_.has('R') ? by_radius() : by_center();
    if (!arc) return fail(arc.error());
    KADR_TRY(turns(*arc));
    KADR_TRY(emit_arc_motion(*arc));
    attach(m_, contour_);
    return {};
  }

 private:
  bool over_determined() const { return contour_.on == SupportingCurve::circle; }

  /// Reads the words of automatic geometry, such as ,C and ,R (chapter 17).
  Status geometry() {
    KADR_TRY(shape_words(m_, contour_));
    const auto over = is_over_determined_arc(m_, m_.has(letters_.first) && m_.has(letters_.second));
    if (!over) return fail(over.error());
    if (m_.modal.surface != PathSurface::plane && (*over || has_shape_words(m_)))
      return fail(alarm(AlarmId::surface_state, call_.where, *over ? "I J R" : ",C ,R"));
    if (!*over) return {};
    if (m_.modal.polar_data) return fail(alarm(AlarmId::not_together, call_.where, "G16", "I J R"));
    contour_.on = SupportingCurve::circle;
    return {};
  }

  /// Adds an over-determined arc. The room `path` computes the start point of the arc, and with it the length (17.3).
  Status meeting_arc() {
    if (m_.transform.distorts(plane_)) return fail(alarm(AlarmId::not_together, call_.where, "G51", "I J R"));
    const Vec2 center{m_.length_value(letters_.first), m_.length_value(letters_.second)};
    KADR_TRY(circle_words(m_, center, {end_[plane_.first], end_[plane_.second]}, contour_));
    KADR_TRY(m_.feed_known(call_.where));
    KADR_TRY(emit_arc_motion({placed_point(center), 0}));
    attach(m_, contour_);
    return {};
  }

  /// Warns that the centre I J K is ignored, because R is in the block (spec/fanuc 3.2).
  void warn_center_passed_over() {
    for (const char letter : {letters_.first, letters_.second, letters_.other})
      if (m_.has(letter)) m_.warn(warning(AlarmId::center_passed_over, m_.where(letter), m_.block->text_of(m_.where(letter))));
  }

  bool has_center() const { return m_.has(letters_.first) || m_.has(letters_.second); }

  /// Returns the polar angle of the start point, in [0, 360) degrees: the polar angle programmed last, or if there is none, the angle of
  /// the tool's position.
  double start_angle() const {
    if (m_.modal.polar_angle_given) return m_.modal.polar_angle;
    const double angle = angle_deg({m_.position.programmed[plane_.first], m_.position.programmed[plane_.second]});
    return angle < 0 ? angle + 360 : angle;
  }

  /// Executes a block with R whose end point is missing or is the start point. According to 4.3 the block has no arc and raises no alarm.
  /// Only the axes outside the plane move.
  Status straight_rest() {
    if (has_shape_words(m_)) return fail(alarm(AlarmId::corner_illegal, call_.where));
    named_ &= ~(1u << plane_.first | 1u << plane_.second);
    if (named_ == 0) return {};
    KADR_TRY(m_.feed_known(call_.where));
    const Axes from = m_.position.work;
    KADR_TRY(m_.straight(MotionKind::feed, end_, named_));
    return control_tip(m_, std::get<Motion>(m_.batch->back().what), from);
  }

  Status straight_line() {
    KADR_TRY(m_.feed_known(call_.where));
    return m_.straight(MotionKind::feed, end_, named_);
  }

  /// Computes the arc from its centre. I, J, K count from the start point, or with CCA=1 from the work origin; they are always radii and
  /// never polar.
  Result<PlaneArc> by_center() {
    if (m_.modal.surface == PathSurface::cylinder) {
      const char letter = m_.has(letters_.first) ? letters_.first : letters_.second;
      return fail(alarm(AlarmId::surface_state, m_.where(letter), letter));
    }
    const bool absolute = fanuc_of(m_).settings.centers_absolute;
    const Axes& here = m_.position.programmed;
    const Vec2 words{m_.length_value(letters_.first), m_.length_value(letters_.second)};
    const Vec2 center = absolute ? words : Vec2{here[plane_.first], here[plane_.second]} + words;
    const double difference = m_.has('L') ? any_difference : fanuc_of(m_).settings.radius_difference;
    auto arc = arc_around(from_, to_, placed_point(center), turn_, difference);
    if (!arc) return placed(arc.error());
    if (polar_turns_ && length(center) <= fanuc_of(m_).settings.radius_difference) arc->turns = *polar_turns_;
    return arc;
  }

  Result<PlaneArc> by_radius() {
    const double radius = m_.length_value('R') * m_.transform.radius_scale(plane_);
    const double most = fanuc_of(m_).settings.radius_shortfall;
    const Vec2 pole = placed_point({});
    if (polar_turns_ && std::fabs(length(from_ - pole) - std::fabs(radius)) <= most) return PlaneArc{pole, *polar_turns_};
    auto arc = arc_by_short_radius({from_, to_, turn_}, radius, most);
    if (!arc) return placed(arc.error());
    return arc;
  }

  /// Returns the number of revolutions of an arc around the pole in G16, if its angle is one revolution or more (5.4); else nullopt.
  /// INFERRED: the swept angle is the difference of the programmed angles.
  std::optional<double> polar_turns(double angle_before) const {
    if (!m_.modal.polar_data || m_.modal.surface == PathSurface::cylinder) return std::nullopt;
    const double sweep = m_.modal.polar_angle - angle_before;
    if (!(std::fabs(sweep) >= 360) || (sweep > 0) != (programmed_turn_ == Turn::ccw)) return std::nullopt;
    return std::fabs(sweep) / 360;
  }

  /// Reads word L, the number of revolutions. An incomplete revolution counts as one revolution (4.3.1).
  Status turns(PlaneArc& arc) {
    if (!m_.has('L')) return {};
    const auto count = m_.whole('L', 1, max_turns);
    if (!count) return fail(count.error());
    arc.turns += *count - 1;
    return {};
  }

  Status emit_arc_motion(const PlaneArc& arc) {
    // The usual case: no mirroring, scaling, rotation or interpolation on a surface is in force, so the end point is not transformed.
    if (m_.transform.identity && m_.modal.surface == PathSurface::plane) {
      const Axes from = m_.position.work;
      return control_tip(m_, move(arc, end_), from);
    }
    if (m_.modal.surface != PathSurface::plane) KADR_TRY(uncompensated_surface(m_));
    const Axes before = m_.position.programmed;
    Axes work = transformed(m_, end_);
    KADR_TRY(m_.within_reach(work));
    const bool cw = turn_ == Turn::cw;
    if (m_.modal.surface == PathSurface::polar)
      work =
          polar_work(m_, work, fanuc_of(m_).state.surface_angle + swept_about_pole({from_, to_, arc.center, cw ? -arc.turns : arc.turns}));
    const Axes from = m_.position.work;
    Motion& motion = move(arc, work);
    KADR_TRY(control_tip(m_, motion, from));
    if (m_.modal.surface == PathSurface::cylinder) motion.center = in_axes(arc.center);
    if (m_.modal.surface != PathSurface::plane) finish_surface(m_, motion, before);
    return {};
  }

  /// Moves the tool to the arc's end and adds the motion.
  Motion& move(const PlaneArc& arc, const Axes& work) {
    named_ |= 1u << plane_.first | 1u << plane_.second;
    m_.move_to(end_, work, named_);
    Motion& motion = m_.add_motion(turn_ == Turn::cw ? MotionKind::arc_cw : MotionKind::arc_ccw, named_);
    m_.set_feed(motion);
    motion.center = arc.center;
    motion.turns = arc.turns;
    if (!controls_tip(fanuc_of(m_).state.five_axis.tip_control))
      motion.along = fanuc_of(m_).settings.feed_along_helix ? FeedAlong::all_axes : FeedAlong::arc;
    if (turns_evenly(arc)) motion.along = FeedAlong::turn;
    return motion;
  }

  /// Returns true if the arc has a constant angular velocity, not a constant speed along the path. According to 4.3 this holds for an arc
  /// whose radius changes although L does not request a spiral. INFERRED: the programmed feed is the feed at the start of the arc. Returns
  /// false for a helix and for an arc in cylindrical interpolation.
  bool turns_evenly(const PlaneArc& arc) const {
    const AxisMask in_plane = AxisMask{1} << plane_.first | AxisMask{1} << plane_.second;
    const bool flat = (named_ & ~in_plane) == 0 && m_.modal.surface == PathSurface::plane;
    return m_.def.behaviour.arc_angle_even && flat && !m_.has('L') && !controls_tip(fanuc_of(m_).state.five_axis.tip_control) &&
           radius_changes(from_, to_, arc.center);
  }

  /// Applies mirroring, scaling and rotation to a programmed point of the plane, in mm. Must not be called in cylindrical interpolation.
  Vec2 placed_point(Vec2 programmed) const { return m_.transform.identity ? programmed : m_.transform.to_work(programmed, plane_); }

  /// Applies mirroring, scaling and rotation to a programmed point. In cylindrical interpolation the result is a point in mm on the
  /// unrolled surface.
  Vec2 placed_flat(const Axes& programmed) const {
    return m_.transform.identity ? flat_point(m_, programmed) : flat_point(m_, m_.transform.to_work(programmed));
  }

  /// Converts a point of the unrolled cylinder (mm) to the units of the two axes, mm and degrees.
  Vec2 in_axes(Vec2 flat) const {
    const double mm_per_degree = m_.modal.surface_radius * rad_per_deg;
    const auto is_rotary = [&](std::size_t axis) { return (m_.def.rotary >> axis & 1u) != 0; };
    return {is_rotary(plane_.first) ? flat.x / mm_per_degree : flat.x, is_rotary(plane_.second) ? flat.y / mm_per_degree : flat.y};
  }

  tl::unexpected<Alarm> placed(Alarm alarm) const {
    alarm.where = m_.block->where;
    return fail(alarm);
  }

  Emitter& m_;
  const Call& call_;
  Turn programmed_turn_;
  Turn turn_;  // sense of rotation of the arc after mirroring, because the points from_ and to_ are mirrored too
  PlaneAxes plane_;
  CenterLetters letters_;
  Axes end_{};
  AxisMask named_ = 0;
  Vec2 from_, to_;
  std::optional<double> polar_turns_;
  CornerData contour_;
};

}  // namespace

Result<PlaneArc> arc_by_short_radius(const ArcEnds& ends, double radius, double shortfall) {
  const double half = length(ends.to - ends.from) / 2, r = std::fabs(radius);
  if (r < half - tol::same_point) {
    if (half * 2 - r - r > shortfall) return fail(alarm(AlarmId::radius_too_small, {}, r, half));
    return PlaneArc{ends.from + (r / (2 * half)) * (ends.to - ends.from), 0.5};
  }
  return arc_by_radius(ends.from, ends.to, radius, ends.turn, tol::same_point);
}

Status arc(Emitter& m, const Call& call, Turn turn) { return Arc(m, call, turn).run(); }

}  // namespace kadr::fanuc
