#include "path/radius_compensation.h"

#include <cmath>
#include <utility>

#include "base/tolerance.h"
#include "path/curve.h"

namespace kadr {
namespace {

bool in_contour(const Motion& m) {
  const bool kind = m.kind == MotionKind::rapid || m.kind == MotionKind::feed || is_arc(m.kind);
  return kind && !(m.detail && m.detail->surface != PathSurface::plane);
}

const std::optional<Vec2>& direction_of(const Motion& m) {
  static const std::optional<Vec2> none;
  return m.detail ? m.detail->way : none;
}

/// One vector, inside or outside alike: where the offsets meet (15.5.1, 15.5.3, 15.5.4).
JunctionVectors meeting(const OffsetElement& first, const OffsetElement& second, Vec2 point, Vec2 otherwise) {
  return single(intersection(first, second, point).value_or(otherwise));
}

}  // namespace

void RadiusCompensation::drop() {
  while (count_ > 0) {
    held(0).waiting.clear();
    drop_first();
  }
  zero_.reset();
  corner_.reset();
  stand_ = at_;
  end_watch();
}

std::optional<CompensationFault> RadiusCompensation::take(ActionBatch& batch, bool last) {
  warnings_.clear();
  if (count_ == 0 && !zero_) {  // mostly: nothing to do but to know where the tool stands
    bool any = false;
    for (const Action& action : batch) {
      if (const auto* const m = std::get_if<Motion>(&action.what)) any = any || m->side != 0;
      else any = any || std::holds_alternative<ContourCheck>(action.what);
    }
    if (!any) {
      for (const Action& action : batch) at_.take(action);
      stand_ = at_;
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
  if (last) end_watch();
  std::swap(batch, out_);
  if (fault_) drop();
  return fault_;
}

void RadiusCompensation::next(Action& action) {
  if (std::holds_alternative<Motion>(action.what)) return motion(action);
  if (const auto* const end = std::get_if<ContourBreak>(&action.what)) {
    if (end->off) leave();
    else flush(Vec2{});
    return;
  }
  if (std::holds_alternative<ContourCorner>(action.what)) return corner(action);
  if (const auto* const check = std::get_if<ContourCheck>(&action.what)) {
    flush({});
    check_ = *check;
    return;
  }
  if (std::holds_alternative<FrameChange>(action.what)) flush(Vec2{});
  if (fault_) return;
  at_.take(action);
  if (count_ == 0) hand_out(std::move(action));
  else wait(std::move(action));
}

void RadiusCompensation::wait(Action action) {
  auto& waiting = last_held().waiting;
  if (waiting.size() < most_waiting) waiting.push_back(std::move(action));
  else fault(AlarmId::compensation_buffer, last_held().action.origin);
}

/// Programmed actions as they are; those that compensation moves have been moved.
void RadiusCompensation::hand_out(Action action) {
  stand_.take(action);
  out_.add() = std::move(action);
}

void RadiusCompensation::motion(Action& action) {
  auto& m = std::get<Motion>(action.what);
  const bool ends = m.side_step == SideStep::ends;
  if ((m.side == 0 && !ends) || !in_contour(m)) {
    flush(Vec2{});
    if (fault_) return;
    at_.take(m);
    hand_out(std::move(action));
    return;
  }
  first_ = m.first;
  second_ = m.second;
  const Vec2 way = in_plane(m.to) - in_plane(at_.work);
  if (length(way) > tol::same_point || is_arc(m.kind)) return contour(action);
  const bool named = (m.named & (AxisMask{1} << first_ | AxisMask{1} << second_)) != 0;
  if (named && ends) {
    leave();
    at_.take(m);
    hand_out(std::move(action));
  } else if (named) {  // zero displacement (15.5.1, 15.5.2): the way to the next vector is its own
    flush({});
    at_.take(m);
    zero_ = std::move(action);
  } else if (count_ > 0) {
    at_.take(m);
    wait(std::move(action));
  } else {
    at_.take(m);
    stand_.take(m);
    shift(m, vector_);
    out_.add() = std::move(action);
  }
}

void RadiusCompensation::contour(Action& action) {
  auto& m = std::get<Motion>(action.what);
  const ContourElement element = element_of(m);
  const Vec2 beside = m.tool_radius * side_normal(element.start, m.side);
  Vec2 start = vector_;
  if (count_ > 0 && corner_) {
    const Motion before = last_held().motion();
    const Origin origin = std::exchange(corner_, std::nullopt)->origin;
    flush({});
    if (!fault_) round(beside, origin, before.kind == MotionKind::rapid ? m : before);
    start = beside;
  } else if (count_ > 0) {
    join(m, element);
    const JunctionVectors& end = last_held().end;
    start = end.count > 0 ? end.last() : beside;
  } else if (zero_) {
    watch_step(vector_, beside, m, zero_->origin);
    step(beside, std::get<Motion>(zero_->what), zero_->origin);
    zero_.reset();
    start = beside;
  } else if (m.side_step == SideStep::begun) {
    step(beside, m, action.origin);
    start = beside;
  }
  if (fault_) return;
  at_.take(m);
  const bool ends = m.side_step == SideStep::ends;
  Held& now = held(count_++);
  now.action = std::move(action);
  now.element = element;
  now.start_vector = start;
  now.end.count = 0;
  now.rejoins = false;
  watch_last();
  if (ends) flush(Vec2{});
  if (ends) end_watch();
  while (!fault_ && count_ >= looked_at()) release_first();
}

/// What stands between the last motion and the next: known now.
void RadiusCompensation::join(const Motion& next, const ContourElement& second) {
  Held& first = last_held();
  const auto vectors = vectors_to(next, second);
  if (vectors) first.end = check_.least_step > 0 ? without_short_steps(*vectors, check_.least_step) : *vectors;
  else if (!check_.interference) fault(AlarmId::compensation_no_intersection, first.action.origin);
}

std::span<const CompensatedBlock> RadiusCompensation::checked_blocks() {
  for (std::size_t i = 0; i < count_; ++i) {
    const Held& h = held(i);
    const Motion& m = h.motion();
    const bool plain = m.side_step == SideStep::none || m.side_step == SideStep::holds;
    const bool known = i + 1 < count_ || h.end.count > 0;
    blocks_[i] = {&h.element, m.tool_radius, static_cast<double>(m.side), plain, h.start_vector, known ? &h.end : nullptr};
  }
  return {blocks_.data(), count_};
}

/// The first of the window is checked against those behind it, and goes. 15.5.7.
void RadiusCompensation::release_first() {
  const Mended mended = check_.interference ? mend_first() : Mended::sound;
  Held& first = held(0);
  if (mended != Mended::sound) {
    const Origin origin = held(mended == Mended::first_fails ? 0 : 1).action.origin;
    if (mended == Mended::next_fails && check_.further == 0) (void)let_go(first);  // looking further the alarm comes before it
    if (!fault_) fault(first.end.count > 0 ? AlarmId::compensation_interference : AlarmId::compensation_no_intersection, origin);
    return;
  }
  if (!let_go(first)) return;
  const JunctionVectors& vectors = first.end;
  for (Action& action : first.waiting) {
    stand_.take(action);
    if (auto* const m = std::get_if<Motion>(&action.what)) shift(*m, vectors.first());
    out_.add() = std::move(action);
  }
  first.waiting.clear();
  vector_ = vectors.first();
  for (std::size_t i = 1; i < vectors.count && count_ > 1; ++i) {
    watch_step(vector_, vectors.at[i], held(1).motion(), held(1).action.origin);
    step(vectors.at[i], held(1).motion(), held(1).action.origin);
  }
  vector_ = vectors.last();
  drop_first();
}

/// Joins the first of the window with a later one, if that mends it; the blocks between are dropped, their actions are not.
RadiusCompensation::Mended RadiusCompensation::mend_first() {
  const auto window = checked_blocks();
  Held& first = held(0);
  const auto join = check_interference(window, check_.further, check_.always_alarm);
  if (join && join->next > 1) {
    first.end = join->vectors;
    for (std::size_t i = 1; i < join->next; ++i)
      for (Action& action : std::exchange(held(i).waiting, {})) first.waiting.push_back(std::move(action));
    held(join->next).start_vector = join->start_vector;
    const std::size_t dropped = join->next - 1;
    for (std::size_t i = 1; i + dropped < count_; ++i) std::swap(held(i), held(i + dropped));
    count_ -= dropped;
  }
  if (first.end.count == 0 || (checked_blocks()[0].plain && goes_back(blocks_[0]))) return Mended::first_fails;
  return join ? Mended::sound : Mended::next_fails;
}

/// G39: with a direction of its own at once; else when the next motion is known.
void RadiusCompensation::corner(Action& action) {
  if (count_ == 0) return;
  const auto& way = std::get<ContourCorner>(action.what).way;
  if (!way) {
    corner_ = std::move(action);
    return;
  }
  const Motion before = last_held().motion();
  flush({});
  if (!fault_) round(before.tool_radius * side_normal(1 / length(*way) * *way, before.side), action.origin, before);
}

/// From the vector in force to another one, about the programmed point (15.5.6).
void RadiusCompensation::round(Vec2 to, const Origin& origin, const Motion& like) {
  const double swept = angle_deg({dot(vector_, to), cross(vector_, to)});  // counter-clockwise
  const bool cw = like.side > 0;
  const double turns = (cw ? -swept : swept) / 360;
  const Vec2 point = in_plane(stand_.work);
  step(to, like, origin);
  auto* const m = out_.empty() ? nullptr : std::get_if<Motion>(&out_.back().what);
  if (m == nullptr || turns == 0) return;
  m->kind = cw ? MotionKind::arc_cw : MotionKind::arc_ccw;
  m->center = point;
  m->turns = turns < 0 ? turns + 1 : turns;
}

/// Nothing follows in the plane: the last held motion ends with this vector, by default perpendicular to its end.
void RadiusCompensation::flush(std::optional<Vec2> vector) {
  if (zero_) {
    auto& m = std::get<Motion>(zero_->what);
    stand_.take(m);
    shift(m, vector.value_or(vector_));
    out_.add() = std::move(*zero_);
    zero_.reset();
    vector_ = vector.value_or(vector_);
  }
  if (count_ == 0 || fault_) return;
  const Held& last = last_held();
  const Motion& m = last.motion();
  last_held().end = single(vector.value_or(m.tool_radius * side_normal(last.element.end, m.side)));
  while (!fault_ && count_ > 0) release_first();
}

/// G40 without a motion in the plane: beside the end of the last block, then straight to its point (15.5.3).
void RadiusCompensation::leave() {
  if (count_ == 0) return flush(Vec2{});
  const Motion like = last_held().motion();
  const Origin origin = last_held().action.origin;
  std::vector<Action> behind = std::exchange(last_held().waiting, {});
  flush({});
  if (fault_) return;
  step({}, like, origin);
  end_watch();
  for (Action& action : behind) hand_out(std::move(action));
}

bool RadiusCompensation::let_go(Held& held) {
  auto& m = std::get<Motion>(held.action.what);
  const Vec2 end_vector = held.end.first();
  stand_.take(m);
  if (is_arc(m.kind)) {
    if (held.rejoins && !rejoin(m, held, end_vector)) {
      fault(AlarmId::compensation_turn, held.action.origin);
      return false;
    }
    if (!held.rejoins) {
      const double turns = compensated_turns(held.element, held.start_vector, end_vector);
      if (turns * held.element.turns > 0) m.turns = std::fabs(turns);
      else m.kind = MotionKind::feed, m.turns = 0;  // the tool does not fit in: no interference check (15.5.7, IEN=0)
    }
  }
  if (held.watched) {
    const ContourElement& e = held.element;
    const Vec2 from = e.from + held.start_vector, to = e.to + end_vector;
    const double turns = m.kind == MotionKind::arc_ccw ? m.turns : -m.turns;
    if (length(to - from) > tol::same_point || m.turns > 0)
      watch_.path(is_arc(m.kind) ? ContourElement::arc(from, to, m.center, turns) : ContourElement::line(from, to), m.tool_radius,
                  held.action.origin);
  }
  shift(m, end_vector);
  out_.add() = std::move(held.action);
  return true;
}

/// Motions at feed along the contour; neither the way in nor the way out, nor what is next to a change of side.
void RadiusCompensation::watch_last() {
  Held& now = last_held();
  const Motion& m = now.motion();
  const bool plain = m.side_step != SideStep::begins && m.side_step != SideStep::ends;
  now.watched = plain && m.kind != MotionKind::rapid && m.tool_radius > 0;
  if (count_ > 1 && held(count_ - 2).motion().side * m.side < 0) {
    held(count_ - 2).watched = now.watched = false;
    end_watch();
  }
  if (now.watched) watch_.contour(now.element, m.tool_radius, now.action.origin);
}

void RadiusCompensation::watch_step(Vec2 from, Vec2 to, const Motion& like, const Origin& origin) {
  const Vec2 point = in_plane(stand_.work);
  if (like.kind == MotionKind::rapid || length(to - from) <= tol::same_point) return;
  watch_.path(ContourElement::line(point + from, point + to), like.tool_radius, origin);
}

void RadiusCompensation::end_watch() {
  if (const auto cut = watch_.end())
    warnings_.push_back({warning(AlarmId::contour_cut, {}, cut->depth, static_cast<double>(cut->contour)), cut->tool});
}

/// A change of side without intersection after an arc: its ends are joined by an arc of the programmed radius (15.5.4).
bool RadiusCompensation::rejoin(Motion& m, const Held& held, Vec2 end_vector) const {
  const ContourElement& e = held.element;
  const Vec2 a = e.from + held.start_vector, b = e.to + end_vector, chord = b - a;
  const double way = length(chord), radius = e.start_radius;
  if (way > 2 * radius + tol::same_point || way == 0) return false;
  const double height = std::sqrt(std::max(radius * radius - way * way / 4, 0.0));
  const double minor = std::fabs(e.turns) <= 0.5 ? 1 : -1;  // INFERRED: as the programmed sweep
  const Vec2 center = 0.5 * (a + b) + minor * e.sense() * height / way * left_of(chord);
  const double half = std::asin(std::min(way / (2 * radius), 1.0)) / rad_per_deg / 180;
  m.turns = minor > 0 ? half : 1 - half;
  m.center = center;
  return true;
}

/// A straight motion in the plane to the programmed point plus a vector.
void RadiusCompensation::step(Vec2 vector, const Motion& like, const Origin& origin) {
  if (length(vector - vector_) <= tol::same_point) return;
  Action& action = out_.add();
  action.origin = origin;
  Motion m = like;
  if (is_arc(m.kind)) m.kind = MotionKind::feed;
  m.named = AxisMask{1} << first_ | AxisMask{1} << second_;
  m.detail.reset();
  m.turns = 0;
  m.exact = m.in_position = false;
  m.to = stand_.work;
  m.machine = stand_.machine;
  shift(m, vector);
  action.what = std::move(m);
  vector_ = vector;
}

/// Moves the end of a motion in the plane; in machine coordinates as the frame is turned.
void RadiusCompensation::shift(Motion& m, Vec2 vector) const {
  if (vector == Vec2{}) return;
  const FrameRotation* const rotation = at_.rotation.get();
  const Axes before = turned(rotation, m.to);
  m.to[first_] += vector.x;
  m.to[second_] += vector.y;
  const Axes now = turned(rotation, m.to);
  for (std::size_t i = 0; i < max_axes; ++i) m.machine[i] += now[i] - before[i];
}

ContourElement RadiusCompensation::element_of(const Motion& m) const {
  const Vec2 from = in_plane(at_.work), to = in_plane(m.to);
  if (!is_arc(m.kind)) return ContourElement::line(from, to);
  return ContourElement::arc(from, to, m.center, m.kind == MotionKind::arc_ccw ? m.turns : -m.turns);
}

/// At the junction with the next motion. The radius is that in force in the block that ends there.
std::optional<JunctionVectors> RadiusCompensation::vectors_to(const Motion& next, const ContourElement& second) {
  const Held& before = last_held();
  const Motion& m = before.motion();
  const ContourElement& first = before.element;
  const double radius = m.tool_radius, side = m.side;
  if (radius == 0) return single({});
  const bool begins = m.side_step == SideStep::begins, ends = next.side_step == SideStep::ends;
  if (const auto& way = direction_of(m); begins && way) {
    const ContourElement in = ContourElement::line(first.to - *way, first.to);
    return meeting(offset_at_end(in, radius, side), offset_at_start(second, radius, side), first.to,
                   radius * side_normal(second.start, side));
  }
  if (const auto& way = direction_of(next); ends && way) {
    const ContourElement out = ContourElement::line(first.to, first.to + *way);
    return meeting(offset_at_end(first, radius, side), offset_at_start(out, radius, side), first.to, radius * side_normal(first.end, side));
  }
  if (m.side_step == SideStep::holds) return single(before.start_vector);
  if (begins) return start_up(first, second, radius, side);
  if (ends) return cancel(first, second, radius, side);
  if (next.side == m.side) return junction(first, second, radius, side);
  const double other = next.side;
  const auto meet = intersection(offset_at_end(first, radius, side), offset_at_start(second, radius, other), first.to);
  last_held().rejoins = !meet && first.is_arc;
  return single(meet.value_or(radius * side_normal(second.start, other)));
}

}  // namespace kadr
