#include "path/radius_compensation.h"

#include <cmath>
#include <utility>

#include "base/tolerance.h"
#include "path/curve.h"
#include "path/plane_shift.h"

namespace kadr {
namespace {

JunctionVectors one(Vec2 vector) {
  JunctionVectors v;
  v.add(vector);
  return v;
}

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
  return one(intersection(first, second, point).value_or(otherwise));
}

}  // namespace

void RadiusCompensation::drop() {
  held_.reset();
  zero_.reset();
  corner_.reset();
  waiting_.clear();
}

std::optional<CompensationFault> RadiusCompensation::take(ActionBatch& batch, bool last) {
  if (!held_ && !zero_) {  // mostly: nothing to do but to know where the tool stands
    bool any = false;
    for (const Action& action : batch)
      if (const auto* const m = std::get_if<Motion>(&action.what); m != nullptr && m->side != 0) any = true;
    if (!any) {
      for (const Action& action : batch) at_.take(action);
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
  if (std::holds_alternative<FrameChange>(action.what)) flush(Vec2{});
  at_.take(action);
  if (!held_) {
    out_.add() = std::move(action);
    return;
  }
  wait(std::move(action));
}

void RadiusCompensation::wait(Action action) {
  if (waiting_.size() < most_waiting) waiting_.push_back(std::move(action));
  else fault_ = CompensationFault{alarm(AlarmId::compensation_buffer, {}), held_->action.origin};
}

void RadiusCompensation::motion(Action& action) {
  auto& m = std::get<Motion>(action.what);
  const bool ends = m.side_step == SideStep::ends;
  if ((m.side == 0 && !ends) || !in_contour(m)) {
    flush(Vec2{});
    at_.take(m);
    out_.add() = std::move(action);
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
    out_.add() = std::move(action);
  } else if (named) {  // zero displacement (15.5.1, 15.5.2): the way to the next vector is its own
    flush({});
    at_.take(m);
    zero_ = std::move(action);
  } else if (held_) {
    at_.take(m);
    wait(std::move(action));
  } else {
    at_.take(m);
    shift(m, vector_);
    out_.add() = std::move(action);
  }
}

void RadiusCompensation::contour(Action& action) {
  auto& m = std::get<Motion>(action.what);
  const ContourElement element = element_of(m);
  const Vec2 beside = m.tool_radius * side_normal(element.start, m.side);
  Vec2 start = vector_;
  if (held_ && corner_) {
    const Motion before = std::get<Motion>(held_->action.what);
    const Origin origin = std::exchange(corner_, std::nullopt)->origin;
    flush({});
    if (!fault_) round(beside, origin, before.kind == MotionKind::rapid ? m : before);
    start = beside;
  } else if (held_) {
    const auto vectors = vectors_to(m, element);
    if (!vectors) {
      fault_ = CompensationFault{alarm(AlarmId::compensation_no_intersection, {}), held_->action.origin};
      return;
    }
    end_held(*vectors, &m, action.origin);
    start = vectors->last();
  } else if (zero_) {
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
  held_ = Held{std::move(action), element, start, false};
  if (ends) end_held(one({}), nullptr, {});
}

/// The held motion ends with the first vector, what waits is done there, the next motion goes round the corner.
void RadiusCompensation::end_held(const JunctionVectors& vectors, const Motion* next, const Origin& origin) {
  if (!let_go(vectors.first())) return;
  for (Action& action : waiting_) {
    if (auto* const m = std::get_if<Motion>(&action.what)) shift(*m, vectors.first());
    out_.add() = std::move(action);
  }
  waiting_.clear();
  vector_ = vectors.first();
  for (std::size_t i = 1; i < vectors.count && next != nullptr; ++i) step(vectors.at[i], *next, origin);
  vector_ = vectors.last();
}

/// G39: with a direction of its own at once; else when the next motion is known.
void RadiusCompensation::corner(Action& action) {
  if (!held_) return;
  const auto& way = std::get<ContourCorner>(action.what).way;
  if (!way) {
    corner_ = std::move(action);
    return;
  }
  const Motion before = std::get<Motion>(held_->action.what);
  flush({});
  if (!fault_) round(before.tool_radius * side_normal(1 / length(*way) * *way, before.side), action.origin, before);
}

/// From the vector in force to another one, about the programmed point (15.5.6).
void RadiusCompensation::round(Vec2 to, const Origin& origin, const Motion& like) {
  const double swept = angle_deg({dot(vector_, to), cross(vector_, to)});  // counter-clockwise
  const bool cw = like.side > 0;
  const double turns = (cw ? -swept : swept) / 360;
  const Vec2 point = in_plane(at_.work);
  step(to, like, origin);
  auto* const m = out_.empty() ? nullptr : std::get_if<Motion>(&out_.back().what);
  if (m == nullptr || turns == 0) return;
  m->kind = cw ? MotionKind::arc_cw : MotionKind::arc_ccw;
  m->center = point;
  m->turns = turns < 0 ? turns + 1 : turns;
}

/// Nothing follows in the plane: the held motion ends with this vector, by default perpendicular to its end.
void RadiusCompensation::flush(std::optional<Vec2> vector) {
  if (zero_) {
    shift(std::get<Motion>(zero_->what), vector.value_or(vector_));
    out_.add() = std::move(*zero_);
    zero_.reset();
    vector_ = vector.value_or(vector_);
  }
  if (!held_) return;
  const auto& m = std::get<Motion>(held_->action.what);
  end_held(one(vector.value_or(m.tool_radius * side_normal(held_->element.end, m.side))), nullptr, {});
}

/// G40 without a motion in the plane: beside the end of the last block, then straight to its point (15.5.3).
void RadiusCompensation::leave() {
  if (!held_) return flush(Vec2{});
  const Motion like = std::get<Motion>(held_->action.what);
  const Origin origin = held_->action.origin;
  std::vector<Action> behind = std::exchange(waiting_, {});
  flush({});
  if (fault_) return;
  step({}, like, origin);
  for (Action& action : behind) out_.add() = std::move(action);
}

bool RadiusCompensation::let_go(Vec2 end_vector) {
  Held held = std::move(*held_);
  held_.reset();
  auto& m = std::get<Motion>(held.action.what);
  if (is_arc(m.kind)) {
    const bool fits = held.rejoins ? rejoin(m, held, end_vector) : true;
    if (!fits) {
      fault_ = CompensationFault{alarm(AlarmId::compensation_turn, {}), held.action.origin};
      return false;
    }
    if (!held.rejoins) {
      const double turns = compensated_turns(held.element, held.start_vector, end_vector);
      if (turns * held.element.turns > 0) m.turns = std::fabs(turns);
      else m.kind = MotionKind::feed, m.turns = 0;  // the tool does not fit in: no interference check (15.5.7, IEN=0)
    }
  }
  shift(m, end_vector);
  out_.add() = std::move(held.action);
  return true;
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
  m.to = at_.work;
  m.machine = at_.machine;
  shift(m, vector);
  action.what = std::move(m);
  vector_ = vector;
}

/// Moves the end of a motion in the plane; in machine coordinates as the frame is turned.
void RadiusCompensation::shift(Motion& m, Vec2 vector) const { shift_in_plane(m, first_, second_, vector, at_.rotation.get()); }

ContourElement RadiusCompensation::element_of(const Motion& m) const {
  const Vec2 from = in_plane(at_.work), to = in_plane(m.to);
  if (!is_arc(m.kind)) return ContourElement::line(from, to);
  return ContourElement::arc(from, to, m.center, m.kind == MotionKind::arc_ccw ? m.turns : -m.turns);
}

/// At the junction with the next motion. The radius is that in force in the block that ends there.
std::optional<JunctionVectors> RadiusCompensation::vectors_to(const Motion& next, const ContourElement& second) {
  const auto& m = std::get<Motion>(held_->action.what);
  const ContourElement& first = held_->element;
  const double radius = m.tool_radius, side = m.side;
  if (radius == 0) return one({});
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
  if (m.side_step == SideStep::holds) return one(held_->start_vector);
  if (begins) return start_up(first, second, radius, side);
  if (ends) return cancel(first, second, radius, side);
  if (next.side == m.side) return junction(first, second, radius, side);
  const double other = next.side;
  const auto meet = intersection(offset_at_end(first, radius, side), offset_at_start(second, radius, other), first.to);
  held_->rejoins = !meet && first.is_arc;
  return one(meet.value_or(radius * side_normal(second.start, other)));
}

}  // namespace kadr
