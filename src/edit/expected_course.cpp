// ExpectedCourse: what an edited program is expected to do. Used by edit/edit_proof; tested by tests/edit.py.

#include "edit/expected_course.h"

#include <algorithm>
#include <cmath>

namespace kadr {
namespace {

/// True if the axis is at two places. Chords of an arc in the plane may differ along the third axis by the rounding of their computation.
bool is_apart(double a, double b) {
  constexpr double least = 1e-9;  // mm
  return std::abs(a - b) > least;
}

int index_of(const std::vector<std::string>& axes, const char* name) {
  const auto at = std::find(axes.begin(), axes.end(), name);
  return at == axes.end() ? -1 : int(at - axes.begin());
}

}  // namespace

ExpectedCourse::ExpectedCourse(const Edits& edits, const std::vector<std::string>& axes, const Axes& start)
    : edits_(edits), axes_(axes.size()), x_(index_of(axes, "X")), y_(index_of(axes, "Y")), raw_(start), now_(start) {}

void ExpectedCourse::change_state(CourseItem& item) const {
  const auto new_tool = [this](std::uint32_t tool) {
    for (const auto& [from, to] : edits_.tools)
      if (from == tool) return to;
    return tool;
  };
  CourseState& state = item.state;
  const double speed = factor_for(edits_.speeds, state.tool);
  state.speed *= speed;
  if (state.move == CourseMove::feed || state.move == CourseMove::probe) {
    const bool keeps_lead = state.taps && state.unit == FeedUnit::mm_per_min;
    state.feed *= keeps_lead ? speed : state.taps ? 1 : factor_for(edits_.feeds, state.tool);
  }
  state.tool = new_tool(state.tool);
  const bool selects = item.act && item.act->kind == CourseEvent::Kind::other && item.act->text == selected_tool;
  if (selects || (item.act && item.act->kind == CourseEvent::Kind::tool)) {
    CourseEvent changed = *item.act;
    changed.value = new_tool(static_cast<std::uint32_t>(changed.value));
    item.act = std::make_shared<const CourseEvent>(std::move(changed));
  }
}

/// Appends the item at its new position. An axis that the block does not command stays where it is in the new program.
///   commands_all  the motion must reach X and Y even if the old program did not command them
void ExpectedCourse::put(const CourseItem& item, const PlaneMap* map, bool commands_all, ItemRing& to) {
  CourseItem& made = to.add() = item;
  // A copy cuts at the height of the old program, whatever the height at which the last one ended
  const bool cuts_in_copy = is_copy_ && item.kind == CourseItem::Kind::move && item.state.move != CourseMove::rapid;
  const AxisMask named = item.kind == CourseItem::Kind::move ? item.named : 0;
  const auto commanded = [&](int axis) {
    const auto i = static_cast<std::size_t>(axis);
    return axis >= 0 && (commands_all || (named >> i & 1U) != 0 || is_apart(item.to[i], raw_[i]));
  };
  for (std::size_t i = 0; i < axes_; ++i) {
    const bool is_in_plane = int(i) == x_ || int(i) == y_;
    const bool is_commanded = (named >> i & 1U) != 0 || is_apart(item.to[i], raw_[i]) || (commands_all && is_in_plane);
    if (!is_commanded && (is_in_plane || !cuts_in_copy)) made.to[i] = now_[i];
  }
  if (map != nullptr && x_ >= 0 && y_ >= 0 && item.by_work && item.kind == CourseItem::Kind::move) {
    const auto x = std::size_t(x_), y = std::size_t(y_);
    const Vec2 zero{item.zero.x, item.zero.y};
    const Vec2 there = zero + map->point(Vec2{item.to[x], item.to[y]} - zero);
    const bool both = !map->is_quarter() && (commanded(x_) || commanded(y_));
    const bool swaps = map->is_quarter() && map->swaps();
    made.to[x] = both || commanded(swaps ? y_ : x_) ? there.x : now_[x];
    made.to[y] = both || commanded(swaps ? x_ : y_) ? there.y : now_[y];
  }
  raw_ = item.to, now_ = made.to;
}

/// After copies or a reversed contour the tool stands elsewhere. The first motion in X or Y, and any other than a rapid, must lead to where
/// the old program is; before it, rapids along other axes may happen there.
bool ExpectedCourse::must_lead_back(const CourseItem& item) {
  if (!is_elsewhere_ || item.kind != CourseItem::Kind::move || !item.by_work) return false;
  const auto moves = [&](int axis) {
    const auto i = static_cast<std::size_t>(axis);
    return axis >= 0 && ((item.named >> i & 1U) != 0 || is_apart(item.to[i], raw_[i]));
  };
  if (!moves(x_) && !moves(y_) && item.state.move == CourseMove::rapid) return false;
  is_elsewhere_ = false;
  return true;
}

std::optional<std::size_t> ExpectedCourse::piece_of(const CourseItem& item) const {
  if (item.kind == CourseItem::Kind::end || item.origin.file != 0) return std::nullopt;
  for (std::size_t i = 0; i < edits_.pieces.size(); ++i)
    if (item.origin.line >= edits_.pieces[i].first && item.origin.line <= edits_.pieces[i].last) return i;
  return std::nullopt;
}

/// Appends the held piece once for each further place.
void ExpectedCourse::repeat(ItemRing& to) {
  const Axes end = raw_;
  is_copy_ = true;
  for (const PlaneMap& map : edits_.places) {
    raw_ = held_from_;
    bool is_first = true;
    for (const CourseItem& item : held_) {
      const bool moves = item.kind == CourseItem::Kind::move;
      put(item, &map, moves && is_first, to);
      is_first = is_first && !moves;
    }
  }
  is_copy_ = false;
  raw_ = end;
}

void ExpectedCourse::end_piece(ItemRing& to) {
  if (!piece_) return;
  piece_.reset();
  if (edits_.reverses) reverse(to);
  else repeat(to);
  held_.clear();
  is_elsewhere_ = x_ >= 0 && y_ >= 0 && (now_[std::size_t(x_)] != raw_[std::size_t(x_)] || now_[std::size_t(y_)] != raw_[std::size_t(y_)]);
}

/// Appends the held motions in the reverse order, each with the state that it had. Acts before the first motion in the plane and motions
/// that lead to it (the approach) stay before it and lead to the other end.
void ExpectedCourse::reverse(ItemRing& to) {
  const std::uint32_t first = edits_.reverses->first;
  const auto begin = std::find_if(held_.begin(), held_.end(), [first](const CourseItem& item) { return item.origin.line >= first; });
  const Axes end = held_.empty() ? raw_ : held_.back().to;
  const auto x = std::size_t(std::max(x_, 0)), y = std::size_t(std::max(y_, 0));
  Axes from = held_from_;
  raw_ = held_from_;
  for (auto item = held_.begin(); item != begin; ++item) {
    CourseItem led = *item;
    led.to[x] = end[x], led.to[y] = end[y];  // the approach states both
    from = item->to;
    put(led, nullptr, false, to);
  }
  for (auto item = held_.end(); item != begin; --item) {
    CourseItem back = *(item - 1);
    back.to = item - 1 == begin ? from : (item - 2)->to;
    put(back, nullptr, true, to);
  }
  raw_ = end;
}

void ExpectedCourse::take(ItemRing& from, ItemRing& to) {
  for (; !from.empty(); from.pop_front()) {
    CourseItem item = from.front();
    change_state(item);
    const auto piece = piece_of(item);
    if (piece != piece_) {
      end_piece(to);
      if (piece) held_from_ = raw_;
      piece_ = piece;
    }
    if (piece) held_.push_back(item);
    if (piece && edits_.reverses) raw_ = item.to;
    else put(item, edits_.plane ? &*edits_.plane : nullptr, must_lead_back(item), to);
  }
}

}  // namespace kadr
