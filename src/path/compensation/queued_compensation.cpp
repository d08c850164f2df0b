// QueuedCompensation, input: how actions enter the queue of LinuxCNC's cutter compensation. Used by path/compensation; tested by
// tests/path/queued_compensation_test.cpp and tests/cases/linuxcnc/compensation.cases.

#include "path/compensation/queued_compensation.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "action/by_kind.h"
#include "action/take_actions.h"

namespace kadr {
namespace {

// least speed of a motion with inverse-time feed, units/min (inverse_time_rate_straight of LinuxCNC)
constexpr double least_speed_by_time = 0.1;
// least programmed length of a motion with inverse-time feed, mm (find_straight_length of LinuxCNC)
constexpr double least_length_by_time = 1e-7;

/// Returns the number of started revolutions of an arc, positive counter-clockwise.
int turn_of(const Motion& m) {
  const int begun = std::max(1, static_cast<int>(std::ceil(m.turns - tol::same_angle)));
  return m.kind == MotionKind::arc_ccw ? begun : -begun;
}

/// True for a turning tool whose tip is not at the centre of its nose radius.
bool has_tip(const Motion& m) { return m.nose != 0 && m.nose != 9; }

/// Returns the vector from a contour point to the tool's centre. `tangent` is the tangent of the contour at this point.
Vec2 offset_from_line(Vec2 tangent, const Motion& m) {
  const double angle = std::atan2(tangent.y, tangent.x) + (m.side > 0 ? pi / 2 : -pi / 2);
  return {m.tool_radius * std::cos(angle), m.tool_radius * std::sin(angle)};
}

}  // namespace

QueuedCompensation::QueuedCompensation(const ToolPosition& start) {
  now_.at = start;
  now_.stands = start.work;
}

std::optional<CompensationFault> QueuedCompensation::take(ActionBatch& batch, Follows follows) {
  warnings_.clear();
  if (!at_work()) {  // The usual case: no compensation is active, so only the tool's position is updated.
    const bool any = std::any_of(batch.begin(), batch.end(), [](const Action& action) {
      const auto* const m = motion_of(action);
      return m != nullptr && m->side != 0;
    });
    if (!any) {
      take_actions(now_.at, batch.begin(), batch.end());
      now_.stands = now_.at.work;
      return std::nullopt;
    }
  }
  out_.clear();
  fault_.reset();
  for (Action& action : batch) {
    if (fault_) follow(action);
    else next(action);
  }
  if (follows == Follows::nothing && !now_.queue.empty()) lose();
  std::swap(batch, out_);
  return fault_;
}

void QueuedCompensation::next(Action& action) {
  origin_ = action.origin;
  if (motion_of(action) != nullptr) {
    motion(action);
  } else if (const auto* const end = std::get_if<CompensationBreak>(&action.what)) {
    end_here(*end);
  } else {
    const bool overtakes = std::holds_alternative<Message>(action.what) || std::holds_alternative<ToolSelect>(action.what);
    now_.at.take(action);
    if (overtakes) out_.add() = std::move(action);
    else wait(action);
  }
  if (fault_) {
    lose();
    follow(action);
  }
}

/// Appends an action to the queue, or emits it if the queue is empty.
void QueuedCompensation::wait(Action& action) {
  Queued queued;
  queued.action = std::move(action);
  if (now_.queue.empty()) deliver(queued);
  else push(queued);
}

/// Ends the contour at G40 or a stop. The queued motions end where the tool is perpendicular to their programmed end point
/// (convert_cutter_compensation_off, convert_stop).
void QueuedCompensation::end_here(const CompensationBreak& end) {
  if (!now_.on || !move_ends(now_.tool)) return;
  now_.start.reset();
  if (!end.off) return;
  now_.on = false;
  end_watch();
}

void QueuedCompensation::motion(Action& action) {
  const auto& m = std::get<Motion>(action.what);
  const bool served = m.kind == MotionKind::rapid || m.kind == MotionKind::feed || m.kind == MotionKind::thread || is_arc(m.kind);
  now_.inch = m.inch;
  if (m.side == 0 || !served) return outside_contour(action);
  Queued queued;
  queued.moves = true;
  queued.action = action;
  const bool enters = m.side_step == SideStep::begins || !now_.on;
  if (enters) {
    deliver_queue();
    now_.first = m.first;
    now_.second = m.second;
  }
  queued.speed = programmed_speed(m);
  if (enters) enter(queued, m);
  else if (is_arc(m.kind)) arc(queued, m);
  else line(queued, m);
  if (!fault_) now_.at.take(m);
}

/// Emits a motion without compensation from the tool's current position to the programmed point.
void QueuedCompensation::outside_contour(Action& action) {
  auto& m = std::get<Motion>(action.what);
  deliver_queue();
  Queued queued;
  queued.moves = true;
  queued.end = in_plane(m.to);
  if (off_contour()) {
    if (!is_arc(m.kind)) queued.speed = programmed_speed(m);
    m.side_step = SideStep::ends;
  }
  now_.on = false;
  now_.at.take(m);
  queued.action = std::move(action);
  deliver(queued);
}

/// Queues the first motion of a contour. If this motion is a line, it leads straight to the tool position next to the line's programmed
/// end.
void QueuedCompensation::enter(Queued& queued, const Motion& m) {
  const Vec2 from = in_plane(now_.at.work), to = in_plane(m.to);
  if (is_arc(m.kind)) {
    const auto entry = entry_arc(from, {to, m.center, turn_of(m)}, m.tool_radius, m.side);
    if (!entry) return void(fault(entry.error()));
    queued.arc = *entry;
    queued.swept = swept_by(from, entry->center, entry->turn, entry->end);
    queued.end = entry->end;
    if (has_tip(m)) queue_lead_in(queued, from);
  } else {
    if (std::hypot(to.x - from.x, to.y - from.y) <= m.tool_radius) return void(fault(alarm(AlarmId::entry_line_within_tool, {})));
    if (m.kind == MotionKind::thread) return void(fault(alarm(AlarmId::compensated_thread, {})));
    const Vec2 normal = offset_from_line(to - from, m);
    // The direction is the normal of the line, as in LinuxCNC's source. A corner therefore cannot make this line go backwards.
    queued.direction = normal;
    queued.end = to + normal;
    now_.start = from;
  }
  now_.on = true;
  now_.tool = queued.end;
  push(queued);
}

/// Queues a line before an entry arc. The line moves the tool's centre to the position of the tip. Without this line the radii at the start
/// and the end of the arc would differ (convert_arc_comp1).
void QueuedCompensation::queue_lead_in(const Queued& arc, Vec2 from) {
  Queued lead_in;
  lead_in.action = arc.action;
  lead_in.moves = true;
  lead_in.end = from;
  lead_in.speed = arc.speed;
  auto& m = std::get<Motion>(lead_in.action.what);
  for (const std::size_t axis : {now_.first, now_.second, third()}) {
    m.to[axis] = now_.at.work[axis];
    m.machine[axis] = now_.at.machine[axis];
  }
  m.kind = MotionKind::feed;
  m.detail.reset();
  now_.start = from;
  push(lead_in);
}

void QueuedCompensation::line(Queued& queued, const Motion& m) {
  const Vec2 from = in_plane(now_.at.work), to = in_plane(m.to);
  if (from == to) {  // Only the third axis or rotary axes move, so the motion ends where the previous motion ends.
    if (m.kind == MotionKind::thread) return void(fault(alarm(AlarmId::compensated_thread, {})));
    queued.end = now_.tool;
    return push(queued);
  }
  const auto corner = corner_to_line(place_before(m), to);
  if (!corner) return void(fault(corner.error()));
  watch_element(queued, m);
  if (corner->kind == CornerKind::outer) {
    if (!move_ends(now_.tool)) return;
    if (m.kind == MotionKind::thread) return void(fault(alarm(AlarmId::compensated_thread, {})));
    go_around_corner(queued, corner->at);
  } else if (corner->kind == CornerKind::inner) {
    if (!move_ends(corner->at)) return;
  } else {
    deliver_queue();
    now_.start = now_.tool;
  }
  queued.direction = to - from;
  queued.end = now_.tool = corner->end;
  push(queued);
}

void QueuedCompensation::arc(Queued& queued, const Motion& m) {
  const Vec2 from = in_plane(now_.at.work), to = in_plane(m.to);
  const QueuedArc programmed{to, m.center, turn_of(m)};
  const auto corner = corner_to_arc(place_before(m), programmed);
  if (!corner) return void(fault(corner.error()));
  watch_element(queued, m);
  if (corner->kind == CornerKind::inner) {
    if (!move_ends(corner->at)) return;
  } else {
    deliver_queue();
    now_.start = now_.tool;
    if (corner->kind == CornerKind::outer) go_around_corner(queued, corner->at);
  }
  queued.arc = {corner->end, m.center, programmed.turn};
  queued.swept = swept_by(from, m.center, programmed.turn, to);
  queued.end = now_.tool = corner->end;
  push(queued);
}

CornerSituation QueuedCompensation::place_before(const Motion& m) const {
  return {in_plane(now_.at.work), now_.tool, m.tool_radius, static_cast<double>(m.side), now_.first_arc, !now_.queue.empty()};
}

/// Returns the speed of a motion with inverse-time feed, mm/min: the programmed length divided by the time. The tool moves at this speed
/// along the compensated path and around the corner. The result is 0 for other feeds.
double QueuedCompensation::programmed_speed(const Motion& m) const {
  if (m.unit != FeedUnit::per_min || m.kind == MotionKind::rapid) return 0;
  double path_length = 0;
  if (is_arc(m.kind)) {
    const Vec2 from{now_.at.work[m.first], now_.at.work[m.second]}, to{m.to[m.first], m.to[m.second]};
    const double deep = m.to[third()] - now_.at.work[third()];
    path_length = std::hypot(std::hypot(m.center.x - from.x, m.center.y - from.y) * swept_by(from, m.center, turn_of(m), to), deep);
  } else {
    for (std::size_t a = 0; a < 3; ++a) path_length = std::hypot(path_length, m.to[a] - now_.at.work[a]);
    if (path_length <= least_length_by_time && !off_contour()) return 0;
  }
  return std::max(least_speed_by_time * unit(), path_length * m.feed);
}

/// Adds an element to GougeDetector, which compares this element with all motions that are emitted later. Only motions at feed along the
/// contour are added; the start and the end of compensation are not added.
void QueuedCompensation::watch_element(Queued& queued, const Motion& m) {
  if (m.kind == MotionKind::rapid) return;
  const Vec2 from = in_plane(now_.at.work), to = in_plane(m.to);
  const ContourElement element = is_arc(m.kind)
                                     ? ContourElement::arc(from, to, m.center, m.kind == MotionKind::arc_ccw ? m.turns : -m.turns)
                                     : ContourElement::line(from, to);
  const std::uint64_t number = now_.watch.contour(element, m.tool_radius, origin_);
  queued.watched = true;
  // The corner rules check the path against the neighbouring elements, so GougeDetector does not compare them.
  queued.known = {number == 0 ? 0 : number - 1, number + 1};
}

/// Discards the queue. The function is called after an alarm or at the end of a file.
void QueuedCompensation::lose() {
  now_.queue.clear();
  now_.start.reset();
  now_.first_arc.reset();
  now_.dropped = true;
  (void)now_.watch.end();
}

/// Updates the positions by an action after an alarm. The action is not executed, but `kadr check` may still analyse it. The tool is
/// assumed to be next to each programmed end.
void QueuedCompensation::follow(const Action& action) {
  if (const auto* const m = motion_of(action)) {
    now_.on = m->side != 0;
    now_.first = m->first;
    now_.second = m->second;
    const Vec2 to = in_plane(m->to), direction = is_arc(m->kind) ? to - m->center : to - in_plane(now_.at.work);
    const double sense = m->kind == MotionKind::arc_ccw ? 1 : -1;
    const Vec2 along = is_arc(m->kind) ? Vec2{-sense * direction.y, sense * direction.x} : direction;
    if (now_.on && !(along == Vec2{})) now_.tool = to + offset_from_line(along, *m);
  }
  now_.at.take(action);
  now_.stands = now_.at.work;
}

}  // namespace kadr
