// QueuedCompensation, output: how the queue of LinuxCNC's cutter compensation is corrected and emitted (interp_queue.cc of LinuxCNC's
// source).

#include <cmath>
#include <utility>

#include "action/by_kind.h"
#include "path/compensation/nose_tip.h"
#include "path/compensation/queued_compensation.h"
#include "path/curve/plane_shift.h"

namespace kadr {
namespace {

// greatest difference of the two radii of an arc, in the length unit of the block (move_endpoint_and_flush)
constexpr double radii_apart = 0.01;
constexpr double more_swept_mm = 0.0254;  // How much the swept angle of an arc may exceed the programmed swept angle in a block in mm, rad.
// How much the swept angle of an arc may exceed the programmed swept angle in a block in inches, rad. LinuxCNC's source converts this angle
// like a length.
constexpr double more_swept_inch = 0.001;
constexpr double no_arc = 1e-9;  // Angle in rad. A smaller swept angle counts as a full circle.

/// Returns the vector from the centre of a turning tool's nose to the programmed tip; zero without compensation.
Vec2 tip_of(const Motion& m) { return m.side == 0 ? Vec2{} : nose_vector(m.nose, m.tool_radius); }

double plane_distance(Vec2 a, Vec2 b) { return std::hypot(a.x - b.x, a.y - b.y); }

}  // namespace

/// Moves the ends of all queued motions to the point `to` and emits the motions (move_endpoint_and_flush). Returns false after an alarm.
bool QueuedCompensation::move_ends(Vec2 to) {
  if (now_.queue.empty()) return true;
  for (std::size_t i = 0; i < now_.queue.size(); ++i) {
    Queued& queued = now_.queue[i];
    if (!queued.moves) continue;
    if (!may_end(queued, to)) return false;
    queued.end = to;
    if (queued.arc) queued.arc->end = to;
    if (i == 0) now_.first_arc = queued.arc;
  }
  deliver_queue();
  now_.start = to;
  return true;
}

/// Checks the new end of a queued motion. A line must not go backwards, and the swept angle of an arc must not be greater than programmed.
bool QueuedCompensation::may_end(const Queued& queued, Vec2 to) {
  if (queued.arc) {
    const double before = plane_distance(queued.arc->end, queued.arc->center), now = plane_distance(to, queued.arc->center);
    if (std::fabs(before - now) > radii_apart * unit()) return fault(alarm(AlarmId::offset_arc_radii, {}, before / unit(), now / unit()));
    if (!now_.start || queued.swept == 0) return true;
    const double swept = swept_by(*now_.start, queued.arc->center, queued.arc->turn, to);
    const double more = now_.inch ? more_swept_inch : more_swept_mm;
    return std::fabs(swept) > std::fabs(queued.swept) + more ? fault(alarm(AlarmId::gouge_arc, {})) : true;
  }
  if (!now_.start || dot(queued.direction, to - *now_.start) >= 0) return true;
  const bool rapid = std::get<Motion>(queued.action.what).kind == MotionKind::rapid;
  return fault(alarm(rapid ? AlarmId::gouge_rapid : AlarmId::gouge_feed, {}));
}

void QueuedCompensation::push(Queued& queued) {
  if (now_.queue.size() >= max_queued) return void(fault(alarm(AlarmId::compensation_buffer, {})));
  if (now_.queue.empty()) now_.first_arc = queued.arc;
  now_.queue.push_back(std::move(queued));
}

/// Emits the motion around an outer corner to the point `to`: an arc, or a line at rapid. The feed and the unit are those of the motion
/// `next`. The rotary axes of `next` move in this motion; the third axis does not move.
void QueuedCompensation::go_around_corner(const Queued& next, Vec2 to) {
  Queued round;
  round.action = next.action;
  round.moves = true;
  round.end = to;
  round.speed = next.speed;
  round.watched = next.watched;
  if (next.watched) round.known = {next.known.first, next.known.last - 1};
  auto& m = std::get<Motion>(round.action.what);
  for (const std::size_t axis : {now_.first, now_.second, third()}) {
    m.to[axis] = now_.at.work[axis];
    m.machine[axis] = now_.at.machine[axis];
  }
  m.named = (m.named | AxisMask{1} << now_.first | AxisMask{1} << now_.second) & ~(AxisMask{1} << third());
  m.detail.reset();
  if (m.kind != MotionKind::rapid) {
    m.kind = m.side > 0 ? MotionKind::arc_cw : MotionKind::arc_ccw;
    m.center = in_plane(now_.at.work);
    round.arc = {to, m.center, m.side > 0 ? -1 : 1};
  }
  deliver(round);
  now_.start = to;
}

void QueuedCompensation::deliver_queue() {
  for (Queued& queued : now_.queue) deliver(queued);
  now_.queue.clear();
  now_.start.reset();
}

void QueuedCompensation::deliver(Queued& queued) {
  if (auto* const m = motion_of(queued.action); m != nullptr && queued.moves) {
    move_tool(queued, *m);
    // A new coordinate frame: the tool's coordinates are converted to this frame.
  } else if (auto* const frame = std::get_if<FrameChange>(&queued.action.what)) {
    frame->work[now_.first] += now_.off_contour.x;
    frame->work[now_.second] += now_.off_contour.y;
    now_.stands = frame->work;
  }
  out_.add() = std::move(queued.action);
}

void QueuedCompensation::move_tool(const Queued& queued, Motion& m) {
  const Vec2 tip = tip_of(m), from = in_plane(now_.stands) - tip, to = queued.end;
  double travel = plane_distance(from, to);
  if (queued.arc) {
    m.center = queued.arc->center;
    const int further = std::abs(queued.arc->turn) - 1;
    double swept = std::fabs(swept_by(from, m.center, queued.arc->turn > 0 ? 1 : -1, to));
    if (swept <= no_arc) swept += 2 * pi;
    swept += further * 2 * pi;
    m.turns = swept / (2 * pi);
    travel = swept * plane_distance(from, m.center);
  }
  if (m.kind == MotionKind::thread && m.side != 0) m.kind = MotionKind::feed;
  travel = std::hypot(travel, m.to[third()] - now_.stands[third()]);
  if (queued.speed > 0 && travel > tol::same_point) m.feed = queued.speed / travel;
  if (queued.watched && plane_distance(from, to) > tol::same_point) {
    const double turns = m.kind == MotionKind::arc_ccw ? m.turns : -m.turns;
    const auto piece = [&] { return queued.arc ? PlanePiece::arc(from, to, m.center, turns) : PlanePiece::line(from, to); };
    now_.watch.path(piece, m.tool_radius, queued.action.origin, queued.known);
  }
  if (queued.arc) m.center = m.center + tip;
  now_.off_contour = to + tip - in_plane(m.to);
  shift_in_plane(m, now_.first, now_.second, now_.off_contour, now_.at.turn.get());
  now_.stands = m.to;
  now_.dropped = false;
}

void QueuedCompensation::end_watch() {
  if (const auto cut = now_.watch.end())
    warnings_.push_back({warning(AlarmId::contour_cut, {}, cut->depth, static_cast<double>(cut->contour.line)), cut->tool, cut->contour});
}

}  // namespace kadr
