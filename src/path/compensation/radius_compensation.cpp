// RadiusCompensation, input: how motions enter the window, and how the corner between two motions is computed.

#include "path/compensation/radius_compensation.h"

#include <cmath>
#include <utility>

#include "action/by_kind.h"
#include "action/curve.h"
#include "action/take_actions.h"
#include "path/compensation/nose_tip.h"

namespace kadr {
namespace {

bool in_contour(const Motion& m) {
  const bool kind = m.kind == MotionKind::rapid || m.kind == MotionKind::feed || is_arc(m.kind);
  return kind && !(m.detail && m.detail->surface != PathSurface::plane);
}

const std::optional<Vec2>& direction_of(const Motion& m) {
  static const std::optional<Vec2> none;
  return m.detail ? m.detail->direction_vector : none;
}

/// Returns the rule for the corner after the motion `m`. A corner between two rapid motions gets no arc.
CornerJoin join_of(const Motion& m, const Motion& next) {
  const bool rapid = m.kind == MotionKind::rapid && next.kind == MotionKind::rapid;
  return rapid && m.join_corner == CornerJoin::arc ? CornerJoin::extended : m.join_corner;
}

/// Returns a single vector to the point at which the two offsets meet, for inside and outside corners (NCT 15.5.1, 15.5.3, 15.5.4). If the
/// offsets do not meet, the function returns the vector `otherwise`.
JunctionVectors meeting(const OffsetElement& first, const OffsetElement& second, Vec2 point, Vec2 otherwise) {
  return single(intersection(first, second, point).value_or(otherwise));
}

}  // namespace

void RadiusCompensation::drop() {
  for (; now_.count > 0; drop_first()) held(0).waiting.clear();
  now_.zero.reset();
  now_.corner.reset();
  now_.stand = now_.at;
  (void)now_.watch.end();
  now_.astray = true;
}

std::optional<CompensationFault> RadiusCompensation::take(ActionBatch& batch, bool last) {
  warnings_.clear();
  // The usual case: no compensation is active, so only the tool's position is updated.
  if (now_.count == 0 && !now_.zero && !off_contour()) {
    bool any = false;
    for (const Action& action : batch) {
      if (const auto* const m = motion_of(action)) any = any || m->side != 0;
      else any = any || std::holds_alternative<CompensationCheck>(action.what);
    }
    if (!any) {
      take_actions(now_.at, batch.begin(), batch.end());
      now_.stand = now_.at;
      return std::nullopt;
    }
  }
  out_.clear();
  fault_.reset();
  for (Action& action : batch) {
    next(action);
    if (fault_) break;
  }
  if (!fault_ && last) flush({});
  if (last && !fault_) end_watch();
  now_.astray = now_.astray || last;
  std::swap(batch, out_);
  if (fault_) drop();
  return fault_;
}

void RadiusCompensation::next(Action& action) {
  by_kind(
      action, [&](Motion&) { motion(action); },
      [&](CompensationBreak& end) {
        if (end.here) stay();
        else if (end.off) leave();
        else flush(Vec2{});
      },
      [&](CompensationCorner&) { corner(action); },
      [&](CompensationCheck& check) {
        const CompensationCheck from_here = check;
        flush({});
        now_.check = from_here;
      },
      [&](FrameChange& frame) { frame_change(action, frame); },
      [&]<class Other>(Other&) requires IsOneOf<Other, Dwell, Spindle, Speed, CoolantSwitch, ToolSelect, ToolChange, MachineFunction,
                                                AuxiliaryFunction, Stop, Message, SurfaceSpeed, Sync, ZoneChange, Couple, Uncouple> {
        now_.at.take(action);
        if (now_.count == 0) deliver(std::move(action));
        else wait(std::move(action));
      });
}

/// Handles a new coordinate frame. A change of tool length does not affect the path. If the work offset changes, compensation stays active
/// on controls on which only the program may cancel compensation (`entry`).
void RadiusCompensation::frame_change(Action& action, FrameChange& frame) {
  const bool stays = length(in_plane(frame.work) - in_plane(now_.at.work)) <= tol::same_point && frame.placement.turn == now_.at.turn;
  if (!now_.keeps_vector) flush(Vec2{});
  else if (!stays) flush({});
  if (fault_) return;
  now_.at.take(frame);
  if (now_.count > 0) return wait(std::move(action));
  now_.stand.take(frame);
  if (now_.keeps_vector) shift(frame);
  out_.add() = std::move(action);
}

void RadiusCompensation::wait(Action action) {
  auto& waiting = last_held().waiting;
  if (waiting.size() < max_waiting) waiting.push_back(std::move(action));
  else fault(alarm(AlarmId::compensation_buffer, {}), last_held().origin);
}

void RadiusCompensation::motion(Action& action) {
  auto& m = std::get<Motion>(action.what);
  const bool ends = m.side_step == SideStep::ends;
  if ((m.side == 0 && !ends) || !in_contour(m)) return outside_contour(action);
  now_.first = m.first;
  now_.second = m.second;
  now_.keeps_vector =
      m.entry == CompensationApproach::normal || m.entry == CompensationApproach::tangent || m.entry == CompensationApproach::around;
  const Vec2 delta = in_plane(m.to) - in_plane(now_.at.work);
  if (length(delta) > tol::same_point || is_arc(m.kind)) return contour(action);
  const bool named = (m.named & (AxisMask{1} << now_.first | AxisMask{1} << now_.second)) != 0;
  if (named && ends) {
    leave();
    now_.at.take(m);
    deliver(std::move(action));
  } else if (named && !now_.keeps_vector) {  // A block with zero displacement (NCT 15.5.1, 15.5.2) moves the tool to the next vector.
    flush({});
    now_.at.take(m);
    now_.zero = std::move(action);
  } else if (now_.count > 0) {
    now_.at.take(m);
    wait(std::move(action));
  } else {
    now_.at.take(m);
    now_.stand.take(m);
    shift(m, displacement());
    out_.add() = std::move(action);
  }
}

/// Emits a motion without compensation to the programmed point. If the motion has a compensation side and its block programs no axis of the
/// plane, the tool's centre keeps its vector from the programmed point; otherwise this vector becomes zero.
void RadiusCompensation::outside_contour(Action& action) {
  auto& m = std::get<Motion>(action.what);
  const bool stays = m.side != 0 && (m.named & (AxisMask{1} << now_.first | AxisMask{1} << now_.second)) == 0;
  if (now_.keeps_vector) flush({});
  else flush(Vec2{});
  if (fault_) return;
  now_.at.take(m);
  now_.stand.take(m);
  if (stays) shift(m, displacement());
  else now_.vector = now_.tip = {};
  out_.add() = std::move(action);
}

void RadiusCompensation::contour(Action& action) {
  auto& m = std::get<Motion>(action.what);
  // The element is written to the location in the window at which the motion will be stored.
  ContourElement& element = held(now_.count).element;
  construct_in_place(element, [&] { return element_of(m); });
  if (element.start == Vec2{}) {
    const double path_length = length(in_plane(m.to) - in_plane(now_.at.work));
    return fault(alarm(AlarmId::compensation_entry_short, {}, path_length, m.tool_radius), action.origin);
  }
  const Vec2 offset = m.tool_radius * side_normal(element.start, m.side);
  Vec2 start = now_.vector;
  if (now_.count > 0 && now_.corner) {
    const Motion before = last_held().motion;
    const Origin origin = std::exchange(now_.corner, std::nullopt)->origin;
    flush({});
    if (!fault_) round(offset, origin, before.kind == MotionKind::rapid ? m : before);
    start = offset;
  } else if (now_.count > 0) {
    join(m, element);
    const JunctionVectors& end = last_held().end;
    start = end.count > 0 ? end.last() : offset;
  } else if (now_.zero) {
    const auto& like = std::get<Motion>(now_.zero->what);
    if (like.side_step == SideStep::none) watch_step(now_.vector, offset, m, now_.zero->origin, {});
    step(offset, nose_vector(m.nose, m.tool_radius), like, now_.zero->origin);
    now_.zero.reset();
    start = offset;
  } else if (m.side_step == SideStep::begun) {
    step(offset, nose_vector(m.nose, m.tool_radius), m, action.origin);
    start = offset;
  }
  if (!fault_) hold(action, element, start);
}

void RadiusCompensation::hold(Action& action, const ContourElement& element, Vec2 start_vector) {
  Held& now = held(now_.count++);
  now.motion = std::move(std::get<Motion>(action.what));
  now.origin = action.origin;
  // Copies the element only if it is not at this location already. It is elsewhere if the interference check has dropped the blocks between
  // the two motions.
  if (&now.element != &element) now.element = element;
  now.start_vector = start_vector;
  now.end.count = 0;
  now.tip = nose_vector(now.motion.nose, now.motion.tool_radius);
  now.rejoins = now.regular = false;
  now_.at.take(now.motion);
  watch_last();
  if (now.motion.side_step == SideStep::ends) {
    flush(Vec2{});
    end_watch();
  }
  while (!fault_ && now_.count >= looked_at()) release_first();
}

/// Handles G39. If the block of G39 states a direction, the corner is emitted at once. Otherwise the corner is emitted when the next motion
/// is known.
void RadiusCompensation::corner(Action& action) {
  if (now_.count == 0) return;
  const auto& direction = std::get<CompensationCorner>(action.what).direction_vector;
  if (!direction) {
    now_.corner = std::move(action);
    return;
  }
  const Motion before = last_held().motion;
  flush({});
  if (!fault_) round(before.tool_radius * side_normal(1 / length(*direction) * *direction, before.side), action.origin, before);
}

/// Ends the contour, because no motion in the plane follows. The last stored motion ends with `vector`, from the programmed point to the
/// tool. If `vector` is empty, the motion ends with the tool's centre on the perpendicular to the path at its end.
void RadiusCompensation::flush(std::optional<Vec2> vector) {
  if (now_.zero) {
    auto& m = std::get<Motion>(now_.zero->what);
    now_.stand.take(m);
    if (vector) now_.vector = *vector, now_.tip = {};
    shift(m, displacement());
    out_.add() = std::move(*now_.zero);
    now_.zero.reset();
  }
  if (now_.count == 0 || fault_) return;
  Held& last = last_held();
  last.end = single(vector.value_or(last.motion.tool_radius * side_normal(last.element.end, last.motion.side)));
  if (vector) last.tip = {};
  while (!fault_ && now_.count > 0) release_first();
}

/// Handles G40 without a motion in the plane. The tool moves to the vector that is perpendicular to the end of the last block, and then
/// straight to the programmed point (NCT 15.5.3).
void RadiusCompensation::leave() {
  if (now_.count == 0) return flush(Vec2{});
  const Motion like = last_held().motion;
  const Origin origin = last_held().origin;
  std::vector<Action> waiting = std::exchange(last_held().waiting, {});
  flush({});
  if (fault_) return;
  step({}, {}, like, origin);
  end_watch();
  for (Action& action : waiting) deliver(std::move(action));
}

/// Lets the program continue from the tool's current position. The function adds the vector from the programmed point to the tool to the
/// programmed point, and ends cutter compensation.
void RadiusCompensation::stay() {
  flush({});
  if (fault_) return;
  for (ToolPosition* const position : {&now_.at, &now_.stand})
    for (Axes* const axes : {&position->work, &position->machine}) {
      (*axes)[now_.first] += displacement().x;
      (*axes)[now_.second] += displacement().y;
    }
  now_.vector = now_.tip = {};
  end_watch();
}

/// Returns the contour element of a motion, from which the corners are computed. The direction of the element is zero if the motion cannot
/// start compensation because its end point lies within the tool radius.
ContourElement RadiusCompensation::element_of(const Motion& m) const {
  const Vec2 from = in_plane(now_.at.work), to = in_plane(m.to);
  if (m.side_step == SideStep::begins && m.entry == CompensationApproach::tangent) {
    const auto direction = entry_direction(to - from, m.tool_radius, m.side);
    return direction ? ContourElement::line(to - *direction, to) : ContourElement();
  }
  if (!is_arc(m.kind)) return ContourElement::line(from, to);
  return ContourElement::arc(from, to, m.center, m.kind == MotionKind::arc_ccw ? m.turns : -m.turns);
}

/// Computes the vectors at the corner between the last stored motion and the next motion.
void RadiusCompensation::join(const Motion& next, const ContourElement& second) {
  Held& first = last_held();
  const auto vectors = vectors_to(next, second);
  first.regular = vectors && first.watched && first.motion.side == next.side && first.motion.tool_radius == next.tool_radius &&
                  next.side_step == SideStep::none && next.kind != MotionKind::rapid && gentle(first.element, second);
  if (vectors) {
    first.end = now_.check.least_step > 0 ? without_short_steps(*vectors, now_.check.least_step) : *vectors;
  } else if (!now_.check.interference) {
    const bool inside = corner_of(first.element.end, second.start, first.motion.side) == Corner::inside;
    fault(alarm(inside ? AlarmId::compensation_no_intersection : AlarmId::compensation_corner_sharp, {}), first.origin);
  }
}

/// Returns the vectors at the junction with the next motion. The tool radius is the radius of the block that ends at this junction.
std::optional<JunctionVectors> RadiusCompensation::vectors_to(const Motion& next, const ContourElement& second) {
  Held& before = last_held();
  const Motion& m = before.motion;
  const ContourElement& first = before.element;
  const double radius = m.tool_radius, side = m.side;
  if (radius == 0) return single({});
  const bool begins = m.side_step == SideStep::begins, ends = next.side_step == SideStep::ends;
  if ((begins || ends) && (begins ? m.entry : next.entry) == CompensationApproach::around)
    if (auto way = around_end(first, second, radius, side, m.join_corner, begins)) return way;
  if (now_.keeps_vector && ends) return single(radius * side_normal(first.end, side));
  if (now_.keeps_vector && begins && m.entry != CompensationApproach::tangent) return single(radius * side_normal(second.start, side));
  if (now_.keeps_vector && next.side == m.side) return joined(first, second, radius, side, join_of(m, next));
  if (const auto& direction = direction_of(m); begins && direction) {
    const ContourElement in = ContourElement::line(first.to - *direction, first.to);
    return meeting(offset_at_end(in, radius, side), offset_at_start(second, radius, side), first.to,
                   radius * side_normal(second.start, side));
  }
  if (const auto& direction = direction_of(next); ends && direction) {
    const ContourElement out = ContourElement::line(first.to, first.to + *direction);
    return meeting(offset_at_end(first, radius, side), offset_at_start(out, radius, side), first.to, radius * side_normal(first.end, side));
  }
  if (m.side_step == SideStep::holds) return single(before.start_vector);
  if (begins && m.entry == CompensationApproach::square) return single(radius * side_normal(second.start, side));
  if (ends && next.entry == CompensationApproach::square) return single(radius * side_normal(first.end, side));
  if (begins) return start_up(first, second, radius, side);
  if (ends) return cancel(first, second, radius, side);
  if (next.side == m.side) return junction(first, second, radius, side);
  const double other = next.side;
  const auto meet = intersection(offset_at_end(first, radius, side), offset_at_start(second, radius, other), first.to);
  before.rejoins = !meet && first.is_arc;
  return single(meet.value_or(radius * side_normal(second.start, other)));
}

}  // namespace kadr
