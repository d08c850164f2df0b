// CornerResolver resolves the corners that depend on the next block: calculated intersections, chamfers and roundings. Used by
// session/channel_run; tested by tests/path/corner_resolver_test.cpp.

#include "path/compensation/corner_resolver.h"

#include <cmath>
#include <limits>
#include <utility>

#include "action/by_kind.h"
#include "action/take_actions.h"
#include "base/tolerance.h"
#include "path/compensation/contour_motion.h"
#include "path/curve/plane_shift.h"

namespace kadr {
namespace {

constexpr double square_tolerance = 1e-6;  // greatest cosine of an angle that counts as a right angle

}  // namespace

std::optional<CompensationFault> CornerResolver::take(ActionBatch& batch, Follows follows) {
  put_back(batch);
  const std::size_t begin = now_.held ? 0 : untouched(batch, follows);
  follow(batch, 0, begin);
  // The usual case: no corner can affect an action of the batch, so the batch stays unchanged.
  if (!now_.held && begin == batch.size()) return std::nullopt;
  out_.clear();
  fault_.reset();
  std::size_t i = begin;
  for (; i < batch.size() && !fault_; ++i) next(batch, i, follows);
  if (!fault_ && follows != Follows::more) finish(follows);
  follow(batch, i, batch.size());
  batch.cut(begin);
  if (begin == 0) std::swap(batch, out_);
  else
    for (Action& action : out_) batch.add() = std::move(action);
  return fault_;
}

/// Puts the stored motion back at the start of the batch if the next motion shows that the stored motion ends at its programmed end.
void CornerResolver::put_back(ActionBatch& batch) {
  if (!now_.held || contour_of(held()) != nullptr || now_.held->start.cut > 0 || now_.held->start.calculated) return;
  if (!now_.waiting.empty() || !now_.settled.empty()) return;
  for (const Action& action : batch) {
    const auto* const next = motion_of(action);
    if (next == nullptr) continue;
    if (contour_of(*next) != nullptr) return;
    batch.add_front() = std::move(now_.held->action);
    now_.held.reset();
    return;
  }
}

/// Returns the number of actions at the start of the batch that no corner can affect. These are the actions before the first motion with
/// contour data (NCT 17), or before the last motion, which the next batch may shorten.
std::size_t CornerResolver::untouched(const ActionBatch& batch, Follows follows) const {
  const Motion* before = nullptr;
  std::size_t place = batch.size(), i = 0;
  for (const Action& action : batch) {
    const auto* const m = motion_of(action);
    if (m != nullptr && contour_of(*m) != nullptr) return before != nullptr && may_end_elsewhere(*before) ? place : i;
    if (m != nullptr) before = m, place = i;
    ++i;
  }
  return follows == Follows::more && before != nullptr && may_end_elsewhere(*before) ? place : batch.size();
}

/// Updates the tool's position by the actions with the indices `from` to `end` − 1.
void CornerResolver::follow(const ActionBatch& batch, std::size_t from, std::size_t end) {
  take_actions(now_.at, batch.begin() + from, batch.begin() + end);
}

void CornerResolver::next(ActionBatch& batch, std::size_t place, Follows follows) {
  Action& action = batch[place];
  if (const auto* const m = motion_of(action)) {
    bool open = may_end_elsewhere(*m);
    for (std::size_t i = place + 1; open && i <= batch.size(); ++i) {
      const auto* const following = i < batch.size() ? motion_of(batch[i]) : nullptr;
      if (i == batch.size()) open = follows == Follows::more;
      else if (following != nullptr && !is_over_determined(contour_of(*following))) open = false;
      else if (following != nullptr) break;
    }
    return motion(action, open ? End::open : End::programmed);
  }
  if (now_.held && (ends_look_ahead(action) || now_.waiting.size() == max_waiting)) finish(Follows::nothing);
  now_.at.take(action);
  if (fault_) return;
  if (now_.held) now_.waiting.push_back(std::move(action));
  else out_.add() = std::move(action);
}

/// Returns true for a motion of the tool axis between a motion with a corner and the second element of the corner (spec/heidenhain 6).
bool CornerResolver::waits_at_corner(const Motion& m) const {
  if (!now_.held || !held().corner_first || !is_shaped(contour_of(held())) || now_.waiting.size() == max_waiting) return false;
  const bool same_plane = m.first == held().first && m.second == held().second;
  return same_plane && !is_arc(m.kind) && contour_of(m) == nullptr && length(in_plane(m.to, m) - now_.held->end) <= tol::same_point;
}

void CornerResolver::motion(Action& action, End end) {
  const auto& m = std::get<Motion>(action.what);
  if (waits_at_corner(m)) {
    now_.at.take(m);
    now_.waiting.push_back(std::move(action));
    return;
  }
  bool unfit = is_shaped(contour_of(m)) && !alone_in_plane(m);
  if (unfit && contour_of(m)->optional) {
    without_corner_data(std::get<Motion>(action.what));
    unfit = false;
  }
  const CornerData* const c = contour_of(m);
  std::optional<Start> start = Start{in_plane(now_.at.work, m), {}, 0, false};
  if (now_.held) start = join(action, end);
  else if (is_over_determined(c)) fail(AlarmId::contour_no_intersection, action.origin);
  if (!fault_ && unfit) fail(AlarmId::corner_illegal, action.origin);
  now_.at.take(m);
  if (fault_) return;
  const bool waits = end == End::open || is_shaped(c) || has_only_direction(c);
  if (!waits && c == nullptr && start->cut == 0 && !start->calculated) {
    out_.add() = std::move(action);
    return;
  }
  const Vec2 programmed = in_plane(m.to, m);
  now_.held = Held{std::move(action), *start, programmed};
  if (!waits) release();
}

/// Computes the corner between the stored motion and the next motion. Returns the start of the next motion, or nullopt after an alarm.
std::optional<CornerResolver::Start> CornerResolver::join(const Action& action, End end) {
  const auto& m = std::get<Motion>(action.what);
  const CornerData *const own = contour_of(held()), *const its = contour_of(m);
  const bool same_plane = is_element(m) && m.first == held().first && m.second == held().second;
  const bool calculated = is_over_determined(its) && same_plane;
  const bool fits = same_plane && alone_in_plane(m);
  if (is_shaped(own) && !fits && !own->optional) return failed(AlarmId::corner_illegal, now_.held->action.origin);
  if (has_only_direction(own) && !calculated) return failed(AlarmId::contour_angle_end, now_.held->action.origin);
  if (is_over_determined(its) && !calculated) return failed(AlarmId::contour_no_intersection, action.origin);
  Start start{now_.held->end, {}, 0, calculated};
  if (calculated) {
    const auto first = support_of(held(), now_.held->start.corner, now_.held->end), second = support_of(m, {}, in_plane(m.to, m));
    const auto corner = first ? calculated_corner(*first, *second, {its->farther, its->mirrored}) : std::nullopt;
    if (!corner) return failed(AlarmId::contour_no_intersection, now_.held->action.origin);
    start.corner = *corner;
  }
  CornerElement nothing;
  nothing.from = nothing.to = start.corner;
  if (!is_shaped(own) || !fits) {
    let_go(start.corner, nothing, Certainty::certain);
  } else {
    const auto second = element_from(start.corner, m, end);
    if (!second) return failed(AlarmId::corner_illegal, now_.held->action.origin);
    const bool open = end == End::open || has_only_direction(its);
    const auto inserted = element_at(start.corner, *second, open ? End::open : End::programmed);
    if (!inserted) return std::nullopt;
    start.cut = inserted->second_travel;
    start.direction = second->start;
    let_go(start.corner, *inserted, open && start.cut > 0 ? Certainty::settled_later : Certainty::certain);
  }
  if (fault_) return std::nullopt;
  return start;
}

/// Returns the next motion as an element that starts at the corner. If the end of the motion may still change, only the start and the
/// direction of the element are valid.
std::optional<ContourElement> CornerResolver::element_from(Vec2 corner, const Motion& m, End end) const {
  const CornerData* const c = contour_of(m);
  const Vec2 to = in_plane(m.to, m);
  if (is_arc(m.kind)) {
    const double sense = sense_of(m);
    const bool known = !is_over_determined(c);
    const double turns = known ? m.turns : end == End::open ? 1 : calculated_turns(corner, to, m.center, sense);
    const auto e = ContourElement::arc(corner, known || end == End::programmed ? to : corner, m.center, sense * turns);
    return is_circular(e) ? std::optional(e) : std::nullopt;
  }
  const bool by_direction = c != nullptr && (c->on == SupportingCurve::ray || (c->on == SupportingCurve::line && end == End::open));
  const Vec2 direction = by_direction ? c->direction : to - corner;
  return length(direction) > tol::same_point ? std::optional(ContourElement::line(corner, corner + direction)) : std::nullopt;
}

/// Returns the leg of a chamfer: as stated, or so long that the chamfer itself has the stated length (spec/sinumerik 12.4).
double CornerResolver::chamfer_leg(double chamfer, Vec2 before, Vec2 after) {
  if (chamfer >= 0) return chamfer;
  const double half = std::sqrt(std::max(0.0, (1 + dot(before, after)) / 2));  // sine of half the angle between the two paths
  return -chamfer / (2 * half);
}

/// Returns the chamfer or rounding of the stored motion at its corner.
std::optional<CornerElement> CornerResolver::element_at(Vec2 corner, const ContourElement& second, End end) {
  const CornerData& own = *contour_of(held());
  const auto first = held_element(corner);
  if (first && !is_circular(*first)) return failed(AlarmId::corner_illegal, now_.held->action.origin);
  if (!first) return failed(AlarmId::corner_too_large, now_.held->action.origin);
  if (own.square && (second.is_arc || std::fabs(dot(first->end, second.start)) > square_tolerance))
    return failed(AlarmId::chamfer_not_square, now_.held->action.origin);
  CornerElement nothing;
  nothing.from = nothing.to = corner;
  if (own.rounding > 0 && meet_smoothly(*first, second)) return nothing;
  const double there = second.is_arc ? 1 : std::numeric_limits<double>::infinity();
  const CornerRoom room{whole_travel(*first), end == End::open ? there : whole_travel(second)};
  const auto inserted = own.rounding > 0 ? rounding(*first, second, own.rounding, room)
                                         : chamfer(*first, second, chamfer_leg(own.chamfer, first->end, second.start));
  if (!inserted || !(inserted->second_travel <= room.second + slack(second)))
    return failed(AlarmId::corner_too_large, now_.held->action.origin);
  return inserted;
}

/// Returns the stored motion as an element that ends at the point `end`. Returns nullopt for a line of zero length.
std::optional<ContourElement> CornerResolver::held_element(Vec2 end) const {
  const auto& m = std::get<Motion>(now_.held->action.what);
  const Start& start = now_.held->start;
  if (is_arc(m.kind)) {
    const bool programmed = !start.calculated && end == now_.held->end;
    const double turns = programmed ? m.turns : calculated_turns(start.corner, end, m.center, sense_of(m));
    return ContourElement::arc(start.corner, end, m.center, sense_of(m) * turns);
  }
  return length(end - start.corner) > tol::same_point ? std::optional(ContourElement::line(start.corner, end)) : std::nullopt;
}

/// Emits the stored motion up to the corner, or up to the inserted chamfer or rounding. The waiting actions are emitted after the motion.
void CornerResolver::let_go(Vec2 corner, const CornerElement& inserted, Certainty certainty) {
  const auto element = held_element(corner);
  const Start& start = now_.held->start;
  const bool backwards = element && start.cut > 0 && !element->is_arc && dot(element->start, start.direction) < 0;
  const double path_length = element && !backwards ? whole_travel(*element) : 0, tolerance = element ? slack(*element) : tol::same_point;
  if (!(start.cut <= path_length + tolerance) && start.cut > 0) {
    now_.settled.clear();
    fail(AlarmId::corner_too_large, now_.settled_origin);
    return;
  }
  const double taken = start.cut + inserted.first_travel, rest = path_length - taken;
  if (taken > 0 && !(rest >= -tolerance)) return fail(AlarmId::corner_too_large, now_.held->action.origin);
  for (Action& action : now_.settled) out_.add() = std::move(action);
  now_.settled.clear();
  if (certainty == Certainty::settled_later) now_.settled_origin = now_.held->action.origin;
  Action last = std::move(now_.held->action);
  auto& m = std::get<Motion>(last.what);
  const double feed = m.detail && m.detail->contour ? m.detail->contour->feed : 0;
  without_corner_data(m);
  shift_in_plane(m, m.first, m.second, inserted.from - now_.held->end, now_.at.turn.get());
  if (corner != now_.held->end || taken > 0) m.named |= AxisMask{1} << m.first | AxisMask{1} << m.second;
  if (is_arc(m.kind)) m.turns = std::max(rest, 0.0);
  const bool used_up = taken > 0 && rest <= tolerance && m.side_step == SideStep::none;
  if (length(inserted.to - inserted.from) <= tol::same_point) {
    if (!used_up) forward_action(std::move(last), certainty);
  } else {
    Action between = shaped_like(last, inserted);
    if (feed > 0) std::get<Motion>(between.what).feed = feed;
    if (!used_up) forward_action(std::move(last), certainty);
    forward_action(std::move(between), certainty);
  }
  for (Action& action : now_.waiting) {
    if (auto* const along = motion_of(action))
      shift_in_plane(*along, along->first, along->second, inserted.to - now_.held->end, now_.at.turn.get());
    forward_action(std::move(action), certainty);
  }
  now_.waiting.clear();
  now_.held.reset();
}

/// Returns the chamfer or rounding as a motion with the feed, compensation side and tool of the motion `before`.
Action CornerResolver::shaped_like(const Action& before, const CornerElement& inserted) const {
  Action action = before;
  auto& m = std::get<Motion>(action.what);
  m.kind = inserted.turns == 0 ? MotionKind::feed : inserted.turns > 0 ? MotionKind::arc_ccw : MotionKind::arc_cw;
  m.center = inserted.center;
  m.turns = std::fabs(inserted.turns);
  m.side_step = SideStep::none;
  shift_in_plane(m, m.first, m.second, inserted.to - inserted.from, now_.at.turn.get());
  return action;
}

void CornerResolver::forward_action(Action action, Certainty certainty) {
  if (certainty == Certainty::settled_later) now_.settled.push_back(std::move(action));
  else out_.add() = std::move(action);
}

/// Emits the stored motion with its programmed end, because no later block calculates another end.
void CornerResolver::release() {
  CornerElement nothing;
  nothing.from = nothing.to = now_.held->end;
  let_go(now_.held->end, nothing, Certainty::certain);
}

/// Emits the stored motion, because no motion follows that could form a corner with it. Before an alarm the corner stays as programmed. A
/// line whose end is unknown is not emitted.
void CornerResolver::finish(Follows follows) {
  if (!now_.held) return;
  const CornerData* const c = contour_of(held());
  const Origin origin = now_.held->action.origin;
  if (follows == Follows::nothing && is_shaped(c) && !c->optional) return fail(AlarmId::corner_illegal, origin);
  if (follows == Follows::nothing && has_only_direction(c)) return fail(AlarmId::contour_end_missing, origin);
  if (has_only_direction(c)) drop();
  else release();
}

/// Discards the stored motion, because the control does not execute it.
void CornerResolver::drop() {
  for (Action& action : now_.settled) out_.add() = std::move(action);
  now_.settled.clear();
  now_.waiting.clear();
  now_.held.reset();
}

void CornerResolver::fail(AlarmId id, const Origin& origin) {
  fault_ = CompensationFault{alarm(id, {}), origin};
  drop();
}

std::nullopt_t CornerResolver::failed(AlarmId id, const Origin& origin) {
  fail(id, origin);
  return std::nullopt;
}

/// Returns true if only the axes of the motion's plane and the slave axes of these axes move.
bool CornerResolver::alone_in_plane(const Motion& m) const {
  AxisMask in_it = AxisMask{1} << m.first | AxisMask{1} << m.second;
  if (m.detail && m.detail->rolled != 0) return false;
  for (std::size_t i = 0; m.detail && i < m.detail->followers.size(); ++i)
    if (const Follower& f = m.detail->followers[i]; (in_it >> f.master & 1U) != 0) in_it |= AxisMask{1} << f.axis;
  for (std::size_t i = 0; i < max_axes; ++i)
    if ((in_it >> i & 1U) == 0 && !(std::fabs(m.to[i] - now_.at.work[i]) <= tol::same_point)) return false;
  return true;
}

}  // namespace kadr
