// RadiusCompensation, output: after the interference check, the first motion of the window is shifted by its vectors and emitted.

#include <algorithm>
#include <cmath>
#include <utility>

#include "action/by_kind.h"
#include "path/compensation/nose_tip.h"
#include "path/compensation/radius_compensation.h"
#include "path/curve/plane_shift.h"

namespace kadr {
namespace {

/// Returns the motion of an action, so that the caller can change it. If the action is not a motion, a new motion replaces its content.
Motion& motion_in(Action& action) {
  if (auto* const m = motion_of(action)) return *m;
  return action.what.emplace<Motion>();
}

}  // namespace

std::span<const CompensatedBlock> RadiusCompensation::checked_blocks() {
  for (std::size_t i = 0; i < now_.count; ++i) {
    const Held& h = held(i);
    const bool plain = h.motion.side_step == SideStep::none || h.motion.side_step == SideStep::holds;
    const bool known = i + 1 < now_.count || h.end.count > 0;
    blocks_[i] = {&h.element, h.motion.tool_radius, static_cast<double>(h.motion.side), plain, h.start_vector, known ? &h.end : nullptr};
  }
  return {blocks_.data(), now_.count};
}

/// Checks the first motion of the window against the later motions. Emits the first motion, the actions that follow it, and the path around
/// the corner.
void RadiusCompensation::release_first() {
  const RepairOutcome mended = now_.check.interference ? mend_first() : RepairOutcome::sound;
  Held& first = held(0);
  if (mended != RepairOutcome::sound) {
    const Origin origin = held(mended == RepairOutcome::first_fails ? 0 : 1).origin;
    // If N1404 sets no look-ahead beyond the next junction, the alarm comes after the first motion. Otherwise it comes before this motion
    // is emitted.
    if (mended == RepairOutcome::next_fails && now_.check.further == 0) (void)let_go(first);
    const AlarmId id = first.end.count > 0 ? AlarmId::compensation_interference : AlarmId::compensation_no_intersection;
    if (!fault_) fault(alarm(id, {}), origin);
    return;
  }
  if (first.end.round) now_.round_first = first.motion;  // The motion is copied here, because let_go() moves it out of `first`.
  const bool corner_first = first.motion.corner_first;
  if (!let_go(first)) return;
  if (!corner_first) emit_waiting(first);
  now_.regular_start = first.regular;
  now_.radius_before = first.motion.tool_radius;
  go_around_corner(first);
  if (corner_first) emit_waiting(first);
  drop_first();
}

/// Emits the actions between a motion and the next motion of the contour, with the vector at which the tool is.
void RadiusCompensation::emit_waiting(Held& first) {
  for (Action& action : first.waiting) {
    now_.stand.take(action);
    if (auto* const m = motion_of(action)) shift(*m, displacement());
    if (auto* const frame = std::get_if<FrameChange>(&action.what)) shift(*frame);
    out_.add() = std::move(action);
  }
  first.waiting.clear();
}

/// Moves the tool around the corner at the end of `first`, from the first compensation vector at this corner to the last vector. Straight
/// moves have the feed and kind of the next motion; an arc has the feed of the next motion, or of the first motion if the next motion is
/// rapid or unknown.
void RadiusCompensation::go_around_corner(const Held& first) {
  const bool follows = now_.count > 1;
  if (first.end.round) {
    const bool next_cuts =
        follows && held(1).motion.kind != MotionKind::rapid && held(1).motion.side != 0;  // no side: it ends compensation
    const Motion& like = next_cuts ? held(1).motion : now_.round_first;
    return round(first.end.last(), follows ? held(1).origin : first.origin, like);
  }
  const ContourSpan known = first.regular ? ContourSpan{first.number, first.number + 1} : ContourSpan{};
  for (std::size_t i = 1; i < first.end.count && follows; ++i) {
    watch_step(now_.vector, first.end.at[i], held(1).motion, held(1).origin, known);
    step(first.end.at[i], now_.tip, held(1).motion, held(1).origin);
  }
  now_.vector = first.end.last();
}

/// Joins the first motion of the window with a later motion if the join resolves an interference (NCT 15.5.7). The motions between the two
/// are dropped, but the actions after the dropped motions remain.
RadiusCompensation::RepairOutcome RadiusCompensation::mend_first() {
  Held& first = held(0);
  const auto join = check_interference(checked_blocks(), now_.check.further, now_.check.always_alarm);
  if (join && join->next > 1) {
    first.end = join->vectors;
    first.regular = false;
    for (std::size_t i = 1; i < join->next; ++i)
      for (Action& action : std::exchange(held(i).waiting, {})) first.waiting.push_back(std::move(action));
    held(join->next).start_vector = join->start_vector;
    const std::size_t dropped = join->next - 1;
    for (std::size_t i = 1; i + dropped < now_.count; ++i) std::swap(held(i), held(i + dropped));
    now_.count -= dropped;
  }
  if (first.end.count == 0 || (checked_blocks()[0].plain && moves_backwards(blocks_[0]))) return RepairOutcome::first_fails;
  return join ? RepairOutcome::sound : RepairOutcome::next_fails;
}

/// Emits a motion of the window, shifted by its vectors, and keeps the vectors at its end.
///   returns  false if the function raised an alarm
bool RadiusCompensation::let_go(Held& held) {
  Motion& m = held.motion;
  const Vec2 end_vector = held.end.first();
  const Vec2 tip = m.side_step == SideStep::holds ? now_.tip : held.tip;
  const bool of_contour = now_.keeps_vector && m.side_step == SideStep::none && m.tool_radius != 0;
  if (of_contour && !fits(held.element, held.start_vector, end_vector, m.tool_radius, m.side)) {
    fault(alarm(AlarmId::compensation_gouge, {}, m.tool_radius), held.origin);
    return false;
  }
  now_.stand.take(m);
  const bool arc = is_arc(m.kind);
  // If the vector to the tip changes during an arc, the radius of the tip's arc changes with the angle (INFERRED: as with a new tool
  // radius, NCT 15.5.2). The centre of this arc is that of the arc without the change.
  const Vec2 arc_vector = end_vector + (tip - now_.tip);
  if (held.rejoins && arc && !rejoin(m, held, arc_vector)) {
    fault(alarm(AlarmId::compensation_turn, {}), held.origin);
    return false;
  }
  if (!held.rejoins && arc) turn_to(m, held, arc_vector);
  if (!arc || arc_vector == end_vector) watch_path(held, end_vector);
  if (is_arc(m.kind)) m.center = m.center + now_.tip;
  now_.vector = end_vector;
  now_.tip = tip;
  shift(m, displacement());
  Action& action = out_.add();
  action.origin = held.origin;
  motion_in(action) = std::move(m);
  return true;
}

/// Computes the swept angle of a compensated arc. If the interference check is off (NCT 15.5.7, IEN=0), and the tool does not fit into the
/// arc, the arc becomes a line.
void RadiusCompensation::turn_to(Motion& m, const Held& held, Vec2 end_vector) const {
  const double turns = compensated_turns(held.element, held.start_vector, end_vector);
  if (turns * held.element.turns > 0) m.turns = std::fabs(turns);
  else m.kind = MotionKind::feed, m.turns = 0;
}

/// Handles a change of side without an intersection after an arc: an arc of the programmed radius joins the compensated ends (NCT 15.5.4).
/// Returns false if the ends are too far apart for such an arc.
bool RadiusCompensation::rejoin(Motion& m, const Held& held, Vec2 end_vector) const {
  const ContourElement& e = held.element;
  const Vec2 a = e.from + held.start_vector, b = e.to + end_vector, chord = b - a;
  const double chord_length = length(chord), radius = e.start_radius;
  if (chord_length > 2 * radius + tol::same_point || chord_length == 0) return false;
  const double height = std::sqrt(std::max(radius * radius - chord_length * chord_length / 4, 0.0));
  // INFERRED: the arc is at most half a circle if the programmed arc is at most half a circle; otherwise it is more than half a circle.
  const double minor = std::fabs(e.turns) <= 0.5 ? 1 : -1;
  const Vec2 center = 0.5 * (a + b) + minor * e.sense() * height / chord_length * left_of(chord);
  const double half = std::asin(std::min(chord_length / (2 * radius), 1.0)) / rad_per_deg / 180;
  m.turns = minor > 0 ? half : 1 - half;
  m.center = center;
  return true;
}

/// Moves the tool from the current compensation vector to the vector `to` along an arc about the programmed point (NCT 15.5.6).
void RadiusCompensation::round(Vec2 to, const Origin& origin, const Motion& like) {
  // The angle that the arc sweeps, in degrees; counter-clockwise is positive.
  const double swept = angle_deg({dot(now_.vector, to), cross(now_.vector, to)});
  const bool cw = like.side > 0;
  const double turns = (cw ? -swept : swept) / 360;
  const Vec2 point = in_plane(now_.stand.work);
  const std::size_t count_before = out_.size();
  step(to, now_.tip, like, origin);
  if (out_.size() == count_before || turns == 0) return;
  auto& m = std::get<Motion>(out_.back().what);
  m.kind = cw ? MotionKind::arc_cw : MotionKind::arc_ccw;
  m.center = point + now_.tip;
  m.turns = turns < 0 ? turns + 1 : turns;
}

/// Emits a straight motion in the plane to the programmed point plus `vector` and `tip`, and keeps these two vectors. If the tool is there
/// already, no motion is emitted.
void RadiusCompensation::step(Vec2 vector, Vec2 tip, const Motion& like, const Origin& origin) {
  const Vec2 travel = vector + tip - displacement();
  if (length(travel) <= tol::same_point) {
    if (length(vector - now_.vector) > tol::same_point) now_.vector = vector, now_.tip = tip;
    return;
  }
  Action& action = out_.add();
  action.origin = origin;
  Motion& m = motion_in(action) = like;
  if (is_arc(m.kind)) m.kind = MotionKind::feed;
  m.named = AxisMask{1} << now_.first | AxisMask{1} << now_.second;
  m.detail.reset();
  m.turns = 0;
  m.exact = m.in_position = false;
  m.to = now_.stand.work;
  m.machine = now_.stand.machine;
  now_.vector = vector;
  now_.tip = tip;
  shift(m, displacement());
}

/// Emits an action without changes. The caller must already have shifted motions by the compensation.
void RadiusCompensation::deliver(Action action) {
  now_.stand.take(action);
  out_.add() = std::move(action);
}

void RadiusCompensation::shift(Motion& m, Vec2 by) const { shift_in_plane(m, now_.first, now_.second, by, now_.at.turn.get()); }

/// Shifts the coordinates of a new frame. The coordinates of the tool are the programmed coordinates plus the displacement.
void RadiusCompensation::shift(FrameChange& frame) const {
  frame.work[now_.first] += displacement().x;
  frame.work[now_.second] += displacement().y;
}

/// Decides whether GougeDetector checks the last motion for cuts into the contour. Motions at feed along the contour are checked. Not
/// checked are the start and the end of compensation, the two motions at a change of side, and a motion that keeps its vector (G38),
/// because it leaves the contour on purpose.
void RadiusCompensation::watch_last() {
  Held& now = last_held();
  const Motion& m = now.motion;
  const bool plain = m.side_step == SideStep::none || m.side_step == SideStep::begun;
  if (m.side_step == SideStep::begins || m.side_step == SideStep::begun) now_.astray = false;
  now.watched = plain && !now_.astray && m.kind != MotionKind::rapid && m.tool_radius > 0;
  if (now_.count > 1 && held(now_.count - 2).motion.side * m.side < 0) {
    held(now_.count - 2).watched = now.watched = false;
    end_watch();
  }
  if (now.watched) now.number = now_.watch.contour(now.element, m.tool_radius, now.origin);
}

void RadiusCompensation::watch_path(const Held& held, Vec2 end_vector) {
  if (!held.watched) return;
  const Motion& m = held.motion;
  // The smaller radius is used, because with a new D word the tool radius changes during the motion.
  const double radius = std::min(m.tool_radius, now_.radius_before);
  // Where compensation stops, the tip of a turning tool is at the programmed point, the nose centre is not (fanuc-t 7.4).
  const Vec2 center = held.tip - nose_vector(m.nose, m.tool_radius);
  const Vec2 from = held.element.from + held.start_vector, to = held.element.to + end_vector + center;
  const double turns = m.kind == MotionKind::arc_ccw ? m.turns : -m.turns;
  ContourSpan known;
  if (is_arc(m.kind) == held.element.is_arc && is_on_offset(held.element, held.start_vector, end_vector, m.tool_radius, m.side))
    known = {held.number - (now_.regular_start ? 1 : 0), held.number + (held.regular ? 1 : 0)};
  if (is_arc(m.kind)) now_.watch.path([&] { return PlanePiece::arc(from, to, m.center, turns); }, radius, held.origin, known);
  else if (length(to - from) > tol::same_point) now_.watch.path([&] { return PlanePiece::line(from, to); }, radius, held.origin, known);
}

void RadiusCompensation::watch_step(Vec2 from, Vec2 to, const Motion& like, const Origin& origin, ContourSpan known) {
  const Vec2 point = in_plane(now_.stand.work);
  if (like.kind == MotionKind::rapid || length(to - from) <= tol::same_point) return;
  now_.watch.path([&] { return PlanePiece::line(point + from, point + to); }, like.tool_radius, origin, known);
}

void RadiusCompensation::end_watch() {
  if (const auto cut = now_.watch.end())
    warnings_.push_back({warning(AlarmId::contour_cut, {}, cut->depth, static_cast<double>(cut->contour.line)), cut->tool, cut->contour});
}

}  // namespace kadr
