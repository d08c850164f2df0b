// The passes of G71, G72 (spec/fanuc-t 9.2 to 9.4) and G73 (9.5). Used by control/fanuc/lathe/lathe_rough.

#include "control/fanuc/lathe/rough_passes.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/tolerance.h"

namespace kadr::fanuc {
namespace {

ContourPiece displaced(ContourPiece piece, Vec2 by) {
  piece.from = piece.from + by;
  piece.to = piece.to + by;
  piece.center = piece.center + by;
  return piece;
}

bool has_no_length(const ContourPiece& piece) { return piece.from == piece.to && piece.turns < 0.5; }

}  // namespace

RoughPasses::RoughPasses(RoughFigure figure, const Plan& plan)
    : figure_(std::move(figure)),
      plan_(plan),
      // INFERRED: if A' lies before S+δ, the tool is fed in at A', because at S+δ it would meet the figure's material
      entry_x_(std::min(0.0, figure_.begin().point.x)),
      at_(figure_.start()),
      planned_(figure_.start_in_figure()) {
  if (!(plan_.clearance > 0)) plan_.clearance = plan_.back;
}

std::optional<RoughStep> RoughPasses::next() {
  for (;;) {
    if (done_ == ordered_) {
      if (stage_ == Stage::done) return {};
      done_ = ordered_ = 0;
      order_more();
    } else if (const auto step = execute(orders_[done_]); step) {
      return step;
    }
  }
}

/// Returns the next motion of an order, and nothing if this motion has no length and ends no pass.
std::optional<RoughStep> RoughPasses::execute(Order& order) {
  RoughStep step;
  bool finished = true;
  switch (order.path) {
    case Path::line: step.motion = {order.kind, at_, figure_.in_plane(order.to), {}, 0, 0}; break;
    case Path::home: step.motion = {order.kind, at_, figure_.start(), {}, 0, 0}; break;
    case Path::follow:
      step.motion = figure_.in_plane(figure_.section(order.from, order.until));
      order.from = figure_.after_section(order.from, order.until);
      finished = !order.from.before(order.until);
      break;
    case Path::whole_figure:
      step.motion = displaced(figure_.pieces()[piece_++], shift_);
      finished = piece_ == figure_.pieces().size();
      break;
  }
  step.ends_pass = finished && order.ends_pass;
  if (finished) ++done_;
  if (has_no_length(step.motion) && !step.ends_pass) return {};
  at_ = step.motion.to;
  return step;
}

void RoughPasses::line(MotionKind kind, Vec2 to) {
  orders_[ordered_++] = {Path::line, kind, to, {}, {}, false};
  planned_ = to;
}

void RoughPasses::follow(const FigurePlace& from, const FigurePlace& until) {
  if (from.before(until)) orders_[ordered_++] = {Path::follow, MotionKind::feed, until.point, from, until, false};
  planned_ = until.point;
  left_ = until;
}

void RoughPasses::order_more() {
  switch (stage_) {
    case Stage::to_shifted_start:
      line(MotionKind::rapid, {0, 0});
      left_ = figure_.begin();
      stage_ = Stage::levels;
      return;
    case Stage::levels:
      if (!(figure_.pockets() ? order_pocket_level() : order_level())) stage_ = Stage::along_figure;
      return;
    case Stage::along_figure:
      order_along_figure();
      stage_ = plan_.further ? Stage::further : Stage::home;
      return;
    case Stage::further:
      order_further();
      stage_ = Stage::home;
      return;
    default:
      order_home();
      stage_ = Stage::done;
      return;
  }
}

/// Orders the cut at the next level, steps 2 to 5 of 9.2. Returns false if this level would reach or pass A'.
bool RoughPasses::order_level() {
  const double depth = level(number_ + 1);
  if (depth >= figure_.begin().point.y - tol::level) return false;
  ++number_;
  const auto stretch = figure_.stretch(depth, figure_.begin(), figure_.end());
  line(figure_.infeed(), {entry_x_, depth});
  line(MotionKind::feed, {stretch->end.point.x, depth});
  line(MotionKind::feed, {planned_.x - plan_.back, depth - plan_.back});
  line(MotionKind::rapid, {entry_x_, planned_.y});
  orders_[ordered_ - 1].ends_pass = true;
  return true;
}

// ---- type II (9.3). The stretches of all levels form a tree: a stretch contains those of the next level that lie within its ends. They
// are cut in this order: a stretch, then what it contains, then the next stretch of the same level. Level 0, which is not cut, is the root.

/// Finds the next stretch to be cut, and from where the tool goes there. Returns false after the last one.
bool RoughPasses::find_stretch() {
  if (!begun_) {
    const auto first = figure_.stretch(0, figure_.begin(), figure_.end());
    if (!first) return false;
    stretch_ = *first;
    begun_ = true;
  }
  for (;;) {
    if (const auto inner = figure_.stretch(level(number_ + 1), stretch_.begin, stretch_.end); inner) {
      entry_ = stretch_.begin;
      cut_at_entry_ = level(number_);
      ++number_;
      stretch_ = *inner;
      return true;
    }
    if (!find_next_sibling()) return false;
    if (number_ > 0) return true;
  }
}

/// Goes on to the next stretch of the same level in the same stretch of the level before, or where there is none, to that of a level
/// before.
bool RoughPasses::find_next_sibling() {
  for (;; --number_) {
    const Stretch outer =
        number_ > 0 ? figure_.stretch_around(level(number_ - 1), stretch_.begin) : Stretch{figure_.begin(), figure_.end()};
    if (const auto sibling = figure_.stretch(level(number_), stretch_.end, outer.end); sibling) {
      entry_ = figure_.ridge(stretch_.end, sibling->begin);
      cut_at_entry_ = entry_.point.y;
      stretch_ = *sibling;
      return true;
    }
    if (number_ == 0) return false;
    stretch_ = outer;
  }
}

bool RoughPasses::order_pocket_level() {
  if (!find_stretch()) return false;
  const double depth = level(number_);
  last_open_ = stretch_.open;
  stretch_.open ? order_infeed() : order_entry_into_pocket();
  line(MotionKind::feed, {stretch_.end.point.x, depth});
  left_ = stretch_.end;
  if (stretch_.end.point.y <= depth + tol::level) {  // otherwise the figure ends below the level
    const Stretch outer = figure_.stretch_around(level(number_ - 1), stretch_.begin);
    const auto sibling = figure_.stretch(depth, stretch_.end, outer.end);
    follow(stretch_.end, sibling ? figure_.ridge(stretch_.end, sibling->begin) : outer.end);
  }
  line(MotionKind::feed, {planned_.x, planned_.y - plan_.back});
  orders_[ordered_ - 1].ends_pass = true;
  return true;
}

void RoughPasses::rise_to(double depth) {
  if (planned_.y > depth) line(MotionKind::rapid, {planned_.x, depth});
}

/// Returns the greatest depth at which the tool may go at rapid from where it left the figure to another place of the figure: by the escape
/// above every ridge between. The words of 9.3 do not mention such a ridge, which lies there only if the figure ends behind it.
double RoughPasses::clear_depth(const FigurePlace& place) const {
  return (place.before(left_) ? figure_.ridge(place, left_) : figure_.ridge(left_, place)).point.y - plan_.back;
}

void RoughPasses::order_infeed() {
  rise_to(clear_depth(figure_.begin()));
  line(MotionKind::rapid, {entry_x_, planned_.y});
  line(figure_.infeed(), {entry_x_, level(number_)});
}

/// Orders the motion to the ridge before a pocket and down along the figure to the pocket. At rapid the tool goes no deeper than has been
/// cut there: where the level before begins at A', A' itself may not have been cut yet.
void RoughPasses::order_entry_into_pocket() {
  const Vec2 to = entry_.point;
  const double approach = std::min(to.y - plan_.clearance, cut_at_entry_);
  rise_to(std::min(approach, clear_depth(entry_)));
  line(MotionKind::rapid, {to.x, planned_.y});
  line(MotionKind::rapid, {to.x, approach});
  line(MotionKind::feed, to);
  follow(entry_, stretch_.begin);
}

/// Orders step 7 of 9.2, the pass along the figure. After a pocket the tool first returns to S+δ (9.3).
void RoughPasses::order_along_figure() {
  if (figure_.pockets()) {
    rise_to(last_open_ ? clear_depth(figure_.begin()) : 0.0);
    line(MotionKind::rapid, {entry_x_, planned_.y});
  }
  if (!plan_.along_figure) return;
  line(figure_.infeed(), figure_.begin().point);
  orders_[ordered_++] = {Path::whole_figure, MotionKind::feed, figure_.end().point, {}, {}, false};
  planned_ = figure_.end().point;
}

/// Orders the pass that takes off the rough allowance. INFERRED: it begins at S, from which the tool goes to A' as in the other passes.
void RoughPasses::order_further() {
  order_home();
  piece_ = 0;
  shift_ = *plan_.further;
  const auto shifted = [&](const FigurePlace& place) { return figure_.in_figure(figure_.in_plane(place.point) + shift_); };
  line(figure_.infeed(), shifted(figure_.begin()));
  orders_[ordered_++] = {Path::whole_figure, MotionKind::feed, shifted(figure_.end()), {}, {}, false};
  planned_ = shifted(figure_.end());
}

/// Orders the motion back to S. If a ridge of the figure is higher than its end, or the figure ends before S, the straight way would lead
/// through stock: the tool first moves out to the depth of S+δ.
void RoughPasses::order_home() {
  if (plan_.along_figure) {
    const Vec2 ridge_point = figure_.in_plane(figure_.ridge(figure_.begin(), figure_.end()).point) + shift_;
    const double ridge = figure_.in_figure(ridge_point).y;
    if (ridge < planned_.y - tol::level || planned_.x < figure_.start_in_figure().x) rise_to(0);
  }
  orders_[ordered_++] = {Path::home, MotionKind::rapid, {}, {}, {}, true};
}

// ---- G73

PatternPasses::PatternPasses(std::vector<ContourPiece> contour, const Plan& plan)
    : contour_(std::move(contour)), plan_(plan), at_(contour_.front().from) {}

Vec2 PatternPasses::shift() const {
  if (plan_.passes < 2) return plan_.allowance;  // 9.5
  return plan_.allowance + double(plan_.passes - 1 - pass_) / (plan_.passes - 1) * plan_.relief;
}

std::optional<RoughStep> PatternPasses::next() {
  if (pass_ > plan_.passes) return {};
  const Vec2 start = contour_.front().from;
  RoughStep step;
  if (pass_ == plan_.passes) {
    step = {{MotionKind::rapid, at_, start, {}, 0, 0}, true};
    ++pass_;
  } else if (next_ == 0) {
    step = {{MotionKind::rapid, at_, start + shift(), {}, 0, 0}, pass_ > 0};
    ++next_;
  } else {
    ContourPiece piece = contour_[next_ - 1];
    piece.from = at_;
    piece.to = piece.to + shift();
    piece.center = piece.center + shift();
    if (!piece.is_arc() && next_ > 1) piece.kind = MotionKind::feed;
    step.motion = piece;
    if (++next_ > contour_.size()) next_ = 0, ++pass_;
  }
  at_ = step.motion.to;
  return step;
}

}  // namespace kadr::fanuc
