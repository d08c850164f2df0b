// End points, arcs of every form, roundings (spec/sinumerik 10, 12). Used by control/sinumerik.

#include <algorithm>
#include <cmath>

#include "base/tolerance.h"
#include "control/functions/cutter_compensation.h"
#include "control/sinumerik/sinumerik.h"

namespace kadr::sinumerik {
namespace {

Vec2 in_plane(const Axes& point, PlaneAxes p) { return {point[p.first], point[p.second]}; }

/// Works out an arc from the words of its block, and emits it.
class ArcMotion {
 public:
  ArcMotion(Emitter& m, Sinumerik& own, Turn turn) : m_(m), own_(own), words_(own.words), turn_(turn), axes_(m.modal.axes) {}

  Status run(Span where) {
    where_ = where;
    AxisMask named = 0;
    Axes end;
    KADR_TRY(m_.target(end, named));
    const bool has_words = named != 0 || centre(axes_.first) || centre(axes_.second) || words_.has("CR") || words_.has("AR") ||
                           words_.has("AP") || words_.has("RP");
    if (!has_words) return {};
    KADR_TRY(check_arc_at_compensation_ends(m_, where, turn_ == Turn::cw ? "G2" : "G3"));
    KADR_TRY(m_.feed_known(where));
    if (m_.transform.leaves(axes_)) return fail(alarm(AlarmId::plane_wrong, where, turn_ == Turn::cw ? "G2" : "G3"));
    if (m_.transform.distorts(axes_)) return fail(alarm(AlarmId::not_together, where, "SCALE", turn_ == Turn::cw ? "G2" : "G3"));
    auto arc = shape(end, named);
    if (!arc) return fail(arc.error());
    if (words_.has("TURN")) {
      const double more = words_.number("TURN");
      if (!(more >= 0 && more <= 999) || more != std::round(more)) return fail(alarm(AlarmId::arc_turns, words_.where("TURN"), more));
      arc->turns += more;
    }
    emit(*arc, end, named);
    return {};
  }

 private:
  bool centre(std::size_t axis) const { return m_.letters.center_letter[axis] != 0 && m_.has(m_.letters.center_letter[axis]); }

  double centre_coordinate(std::size_t axis, double start) const {
    if (!centre(axis)) return start;
    const char letter = m_.letters.center_letter[axis];
    const double v = m_.length_value(letter);
    return words_.forms[static_cast<std::size_t>(letter - 'A')] == WordForm::absolute ? v : start + v;
  }

  Result<PlaneArc> shape(Axes& end, AxisMask& named) {
    const Vec2 from = in_plane(m_.position.programmed, axes_);
    const bool has_centre = centre(axes_.first) || centre(axes_.second);
    const bool has_end = (named >> axes_.first & 1U) != 0 || (named >> axes_.second & 1U) != 0;
    const double unit = m_.unit_scale();
    const Span block = m_.block->where;
    if (words_.has("AP") || words_.has("RP")) {  // about the pole
      if (has_centre || words_.has("CR")) return fail(alarm(AlarmId::arc_two_ways, block, "AP", has_centre ? "I J K" : "CR"));
      return around(from, in_plane(end, axes_), own_.memory.pole);
    }
    if (words_.has("CR")) {
      if (has_centre || words_.has("AR")) return fail(alarm(AlarmId::arc_two_ways, block, "CR", has_centre ? "I J K" : "AR"));
      return arc_by_radius(from, in_plane(end, axes_), words_.number("CR") * unit, turn_, 0.01).map_error([&](Alarm a) {
        return placed(a);
      });
    }
    if (words_.has("AR")) {
      const double angle = words_.number("AR");
      if (has_centre && has_end) return fail(alarm(AlarmId::arc_two_ways, block, "AR", "I J K"));
      if (!(angle > 0 && angle < 360)) return fail(alarm(AlarmId::arc_opening_angle, words_.where("AR"), angle));
      if (!has_centre && !has_end) return fail(alarm(AlarmId::center_missing, block, "I", "J"));
      const double signed_angle = turn_ == Turn::ccw ? angle : -angle;
      if (has_centre) {
        const Vec2 middle{centre_coordinate(axes_.first, from.x), centre_coordinate(axes_.second, from.y)};
        const Vec2 to = middle + rotated(from - middle, signed_angle);
        end[axes_.first] = to.x;
        end[axes_.second] = to.y;
        named |= AxisMask{1} << axes_.first | AxisMask{1} << axes_.second;
        return PlaneArc{middle, angle / 360};
      }
      const Vec2 chord = in_plane(end, axes_) - from;
      if (!(length(chord) > tol::same_point)) return fail(alarm(AlarmId::full_circle_by_radius, block));
      const SinCos half = sincos_deg(signed_angle / 2);
      const double height = 0.5 * half.cos / half.sin;  // distance of the centre from the chord, as a part of it
      return PlaneArc{from + 0.5 * chord + height * Vec2{-chord.y, chord.x}, angle / 360};
    }
    if (!has_centre)
      return fail(alarm(AlarmId::center_missing, block, m_.letters.center_letter[axes_.first], m_.letters.center_letter[axes_.second]));
    if (centre(axes_.normal) && m_.value(m_.letters.center_letter[axes_.normal]) != 0)
      return fail(
          alarm(AlarmId::arc_not_in_plane, m_.where(m_.letters.center_letter[axes_.normal]), m_.letters.center_letter[axes_.normal]));
    const Vec2 middle{centre_coordinate(axes_.first, from.x), centre_coordinate(axes_.second, from.y)};
    if (!has_end) {
      if (!(length(middle - from) > tol::same_point)) return fail(alarm(AlarmId::arc_radius_zero, block));
      return PlaneArc{middle, 1};
    }
    return around(from, in_plane(end, axes_), middle);
  }

  /// The end point is reached exactly: the centre moves to the perpendicular bisector of the chord (spec/sinumerik 12.2).
  Result<PlaneArc> around(Vec2 from, Vec2 to, Vec2 middle) const {
    const double radius = length(from - middle);
    auto arc = arc_around(from, to, middle, turn_, std::max(0.01, 0.001 * radius));
    if (!arc) return fail(placed(arc.error()));
    const Vec2 chord = to - from;
    const double across = length(chord);
    if (across <= tol::same_point || !radius_changes(from, to, middle)) return arc;
    const Vec2 half = from + 0.5 * chord;
    const Vec2 normal = 1 / across * Vec2{-chord.y, chord.x};
    return arc_around(from, to, half + dot(middle - half, normal) * normal, turn_, 0.01);
  }

  Alarm placed(Alarm fault) const {
    fault.where = m_.block->where;
    return fault;
  }

  void emit(const PlaneArc& arc, const Axes& end, AxisMask named) { own_.emit_arc(m_, turn_, arc, end, named); }

  Emitter& m_;
  Sinumerik& own_;
  const BlockWords& words_;
  Turn turn_;
  PlaneAxes axes_;
  Span where_;
};

}  // namespace

/// Emits an arc in the plane in force, which the programmable frame neither distorts nor turns out of it. `end` has programmed coordinates.
void Sinumerik::emit_arc(Emitter& m, Turn turn, const PlaneArc& arc, const Axes& end, AxisMask named) {
  const PlaneAxes axes = m.modal.axes;
  Axes middle = m.position.programmed;
  middle[axes.first] = arc.center.x;
  middle[axes.second] = arc.center.y;
  Axes work = end;
  bool reversed = false;
  if (!m.transform.identity) {
    reversed = m.transform.reverses(axes);
    work = m.transform.to_work(end);
    middle = m.transform.to_work(middle);
  }
  named |= AxisMask{1} << axes.first | AxisMask{1} << axes.second;
  m.move_to(end, work, named);
  const bool cw = (turn == Turn::cw) != reversed;
  Motion& motion = m.add_motion(cw ? MotionKind::arc_cw : MotionKind::arc_ccw, named);
  m.set_feed(motion);
  motion.center = {middle[axes.first], middle[axes.second]};
  motion.turns = arc.turns;
  note_arc_end(m, motion);
  if (motion.side != 0 && memory.arc_feed != ArcFeed::centre) {
    const double radius = length(in_plane(work, axes) - motion.center);
    const double inside = (cw ? -1 : 1) * motion.side;  // above 0: the tool is on the side of the centre
    const double path = radius - inside * motion.tool_radius;
    if (radius > tol::same_point && path > 0 && (memory.arc_feed == ArcFeed::contour || inside > 0)) motion.feed *= path / radius;
  }
  const Vec2 arm = in_plane(end, axes) - arc.center;
  memory.direction = turn == Turn::ccw ? Vec2{-arm.y, arm.x} : Vec2{arm.y, -arm.x};
  memory.direction_plane = axes;
  memory.has_direction = true;
}

/// Computes the end point: each word by G90 or G91 or by its own AC, IC (spec/sinumerik 3.3); AP, RP in the plane (12.3).
Status Sinumerik::target(const BlockContext& m, Axes& to, AxisMask& named) const {
  KADR_TRY(m.axis_words(to, named));
  for (std::size_t a = 0; a < m.axis_count; ++a) {
    const char letter = m.letters.axis_letter[a];
    if (letter == 0 || !m.has(letter)) continue;
    const WordForm form = words.forms[static_cast<std::size_t>(letter - 'A')];
    const bool diameter = (m.modal.diameter >> a & 1U) != 0;
    const bool radius_increment = diameter && memory.radius_increments && (form == WordForm::incremental || !m.modal.absolute);
    if (form == WordForm::plain && !words.machine && !radius_increment) continue;
    const bool is_length = m.def.address(letter).unit == WordUnit::length;
    const double value = m.value(letter) * (is_length ? m.unit_scale() : 1.0) * (diameter && !radius_increment ? 0.5 : 1.0);
    const double now = m.position.programmed[a];
    switch (form) {
      case WordForm::plain:
      case WordForm::incremental: to[a] = form == WordForm::plain && (words.machine || m.modal.absolute) ? value : now + value; break;
      case WordForm::direct:
      case WordForm::positive:
      case WordForm::negative: {
        if (form != WordForm::direct && !(value >= 0 && value < 360))
          return fail(alarm(AlarmId::rotary_position_wrong, m.where(letter), form == WordForm::positive ? "ACP" : "ACN", value,
                            form == WordForm::positive ? 16810.0 : 16820.0));
        double way = std::fmod(value - now, 360.0);
        if (form == WordForm::direct && way > 180) way -= 360;
        if (form == WordForm::direct && way <= -180) way += 360;
        if (form == WordForm::positive && way < 0) way += 360;
        if (form == WordForm::negative && way > 0) way -= 360;
        to[a] = now + way;
        break;
      }
      default: to[a] = value; break;
    }
    if (!(std::fabs(to[a]) <= farthest)) return fail(alarm(AlarmId::position_out_of_range, m.where(letter), letter, to[a]));
  }
  if (words.has("AP") || words.has("RP")) {
    const PlaneAxes plane = m.modal.axes;
    const SinCos turn = sincos_deg(memory.polar_angle);
    to[plane.first] = memory.pole.x + memory.polar_radius * turn.cos;
    to[plane.second] = memory.pole.y + memory.polar_radius * turn.sin;
    named |= AxisMask{1} << plane.first | AxisMask{1} << plane.second;
  }
  return within_area(m, to, named);
}

/// Checks an end point against the working area of G25, G26. INFERRED: the tip of the tool counts, in basic coordinates (spec 10).
Status Sinumerik::within_area(const BlockContext& m, const Axes& to, AxisMask named) const {
  const AxisMask limited = (memory.area_below | memory.area_above) & named;
  if (limited == 0 || !memory.area_watched) return {};
  const Axes machine = m.frames.machine_of(m.transform.identity ? to : m.transform.to_work(to));
  for (std::size_t a = 0; a < m.axis_count; ++a) {
    if ((limited >> a & 1U) == 0) continue;
    const double tip = machine[a] - m.frames.length[a];
    const bool below = (memory.area_below >> a & 1U) != 0 && tip < memory.area_least[a] - tol::same_point;
    const bool above = (memory.area_above >> a & 1U) != 0 && tip > memory.area_most[a] + tol::same_point;
    if (below || above)
      return fail(alarm(AlarmId::working_area, m.where(m.letters.axis_letter[a]), std::string_view(m.axis_names[a]), tip,
                        below ? memory.area_least[a] : memory.area_most[a]));
  }
  return {};
}

Status Sinumerik::arc(Emitter& m, const Call& call, Turn turn) { return ArcMotion(m, *this, turn).run(call.where); }

/// Adds the rounding or chamfer of the block to its motion, and notes the direction for CT.
void Sinumerik::note_motion(Emitter& m, Motion& motion) {
  words.moved = true;
  if (m.modal.contour != CompensationPhase::off) {
    note_compensation(m, motion, m.moved_from);
    if (memory.goes_around) motion.entry = CompensationApproach::around;
  }
  const bool cuts = motion.kind == MotionKind::feed || motion.kind == MotionKind::rapid || is_arc(motion.kind);
  const double unit = m.unit_scale();
  double rounding = memory.rounding, chamfer = 0;
  if (words.has("RND")) rounding = words.number("RND") * unit;
  if (words.has("CHR")) chamfer = words.number("CHR") * unit, rounding = 0;
  if (words.has("CHF")) chamfer = -words.number("CHF") * unit, rounding = 0;  // its own length (path/compensation/contour_motion.h)
  if (words.chuck) motion.own_override = motion.no_hold = true;               // G63
  const AxisMask plane = AxisMask{1} << motion.first | AxisMask{1} << motion.second;
  if (cuts && (motion.named & plane) != 0 && (rounding > 0 || chamfer != 0)) {
    auto detail = motion.detail ? std::make_shared<MotionDetail>(*motion.detail) : std::make_shared<MotionDetail>();
    CornerData corner;
    corner.feed = (words.corner_feed > 0 ? words.corner_feed : memory.corner_feed) * memory.override_percent / 100;
    corner.optional = !words.has("RND") && chamfer == 0;
    corner.rounding = rounding * m.transform.corner_scale(m.modal.axes);
    corner.chamfer = chamfer * m.transform.corner_scale(m.modal.axes);
    detail->contour = corner;
    motion.detail = std::move(detail);
  }
  if (words.probe != 0 && motion.kind == MotionKind::feed) {
    motion.kind = MotionKind::probe;
    m.needs_probe = true;
    m.probe_where = words.where("MEAS");
    memory.measured.probe = std::exchange(words.probe, 0);
    memory.measured.touched[static_cast<std::size_t>(memory.measured.probe - 1)] = false;
  }
  const bool plain = m.transform.identity && m.modal.radius_side == 0;
  motion.as_programmed = memory.in_space && plain && motion.kind != MotionKind::probe;
  if (!m.transform.identity || (memory.in_space && !plain)) {
    auto detail = motion.detail ? std::make_shared<MotionDetail>(*motion.detail) : std::make_shared<MotionDetail>();
    detail->programmed = m.position.programmed;
    detail->has_programmed = true;
    motion.detail = std::move(detail);
  }
  if (!is_arc(motion.kind) && (motion.named & plane) != 0) {
    const Axes from = m.transform.to_programmed(previous_);
    const Vec2 way = in_plane(m.position.programmed, m.modal.axes) - in_plane(from, m.modal.axes);
    if (length(way) > tol::same_point) {
      memory.direction = way;
      memory.direction_plane = m.modal.axes;
      memory.has_direction = true;
    }
  }
  previous_ = m.position.work;
}

/// Plain blocks of lines follow each other without further checks while nothing of the dialect acts between them. G54 puts a settable frame
/// in force again, so its data must not have changed since.
bool Sinumerik::lines_follow(const BlockContext& m) const {
  const Level& own = memory.levels.back();
  return own.acted && !own.modal_call && memory.motion == NamedMotion::none && !memory.feed_in_mm && memory.override_percent == 100 &&
         memory.rounding == 0 && !memory.in_space && !memory.holds_tip && (memory.area_below | memory.area_above) == 0 &&
         memory.active == memory.settable[m.modal.work_zero];
}

/// A run of plain lines leaves blocks with these axes to takes_block(), which refuses the axes that the machine lacks.
AxisMask Sinumerik::rolling_axes(const BlockContext& m) const {
  AxisMask missing = 0;
  for (std::size_t a = 0; a < m.def.axes.size(); ++a)
    if (a >= m.axis_count || (missing_axes & letter_bit(m.def.axes[a][0])) != 0) missing |= AxisMask{1} << a;
  return missing;
}

/// A line of a run of plain lines: it has no transformation, so work coordinates are programmed ones.
void Sinumerik::note_line(BlockContext& m) {
  const PlaneAxes plane = m.modal.axes;
  const Axes& now = m.position.programmed;
  const Vec2 way = in_plane(now, plane) - in_plane(previous_, plane);
  if (dot(way, way) > tol::same_point * tol::same_point) {
    memory.direction = way;
    memory.direction_plane = plane;
    memory.has_direction = true;
  }
  previous_[plane.first] = now[plane.first];
  previous_[plane.second] = now[plane.second];
}

ArcRule Sinumerik::arc_rule(const BlockContext& m) const {
  ArcRule rule = m.plain_arc_rule();
  rule.by_words = rule.radius_by_words = false;
  return rule;
}

}  // namespace kadr::sinumerik
