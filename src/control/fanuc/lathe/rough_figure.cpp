// The figure of G71 and G72: its coordinates, the checks of its shape, and where it meets the levels of the passes (spec/fanuc-t 9.2, 9.3).
// Used by control/fanuc/lathe/rough_passes.

#include "control/fanuc/lathe/rough_figure.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/tolerance.h"

namespace kadr::fanuc {
namespace {

constexpr int crossing_halvings = 60;  // halvings of the part of an arc, which leave no more than its rounding error

bool deeper(double depth, double level) { return depth > level + tol::level; }

}  // namespace

RoughFigure::RoughFigure(const std::vector<ContourPiece>& contour, const Settings& settings)
    : facing_(settings.facing), pockets_(settings.pockets), infeed_(contour.front().kind) {
  const ContourPiece& first = contour.front();
  start_ = first.from;
  origin_ = start_ + settings.allowance;
  if (settings.levels_from_start) (facing_ ? origin_.x : origin_.y) = facing_ ? start_.x : start_.y;
  for (std::size_t i = 1; i < contour.size(); ++i) {
    ContourPiece piece = contour[i];
    piece.from = piece.from + settings.allowance;
    piece.to = piece.to + settings.allowance;
    piece.center = piece.center + settings.allowance;
    if (!piece.is_arc()) piece.kind = MotionKind::feed;  // 9.2 step 7: the whole figure is cut at feed
    pieces_.push_back(piece);
  }
  const Vec2 a = first.to + settings.allowance;
  if (pieces_.empty()) pieces_.push_back({MotionKind::feed, a, a, {}, 0, first.block});
  choose_directions(a);
  std::vector<ContourPiece> turned;
  for (const ContourPiece& piece : pieces_) turned.push_back(in_figure(piece));
  sections_ = monotone(turned);
  deepest_ = begin().point.y;
  for (const ContourPiece& section : sections_) deepest_ = std::max(deepest_, section.to.y);
  fault_block_ = first.block;
  fault_ = first.is_arc() ? FigureFault::first_block : check(settings);
}

/// Chooses the directions of the figure's coordinates: x from A' to the end of the figure, y from S towards A', or if A' is no deeper than
/// S, towards the rest of the figure.
void RoughFigure::choose_directions(Vec2 first) {
  const auto from_origin = [&](Vec2 point) { return in_figure(point); };
  double x = from_origin(pieces_.back().to).x - from_origin(first).x, y = from_origin(first).y;
  for (const ContourPiece& piece : monotone(pieces_)) {
    const Vec2 to = from_origin(piece.to);
    if (std::fabs(x) <= tol::level) x = to.x - from_origin(first).x;
    if (std::fabs(y) <= tol::level) y = to.y;
  }
  along_ = x < 0 ? -1 : 1;
  into_ = y < 0 ? -1 : 1;
}

FigureFault RoughFigure::check(const Settings& settings) {
  const FigureFault x_fault = facing_ ? FigureFault::second_axis : FigureFault::first_axis;
  const FigureFault y_fault = facing_ ? FigureFault::first_axis : FigureFault::second_axis;
  Vec2 permitted = settings.reversal_permitted;
  if (facing_) std::swap(permitted.x, permitted.y);
  const double shifted_start = in_figure(start_ + settings.allowance).y;
  const std::uint32_t last_block = sections_.back().block;
  double farthest = begin().point.x, least = begin().point.y;
  std::uint32_t least_deep = sections_.front().block;
  for (const ContourPiece& section : sections_) {
    fault_block_ = section.block;
    if (farthest - section.to.x > permitted.x + tol::level) return x_fault;
    if (!pockets_ && section.to.y - least > permitted.y + tol::level) return y_fault;
    farthest = std::max(farthest, section.to.x);
    if (settings.levels_from_start && pockets_ && section.block == last_block) continue;
    if (section.to.y < least) least = section.to.y, least_deep = section.block;
  }
  fault_block_ = least_deep;
  return least < shifted_start - tol::level ? FigureFault::over_start : FigureFault::none;
}

Vec2 RoughFigure::in_figure(Vec2 point) const {
  const Vec2 p = point - origin_;
  return facing_ ? Vec2{along_ * p.y, into_ * p.x} : Vec2{along_ * p.x, into_ * p.y};
}

Vec2 RoughFigure::in_plane(Vec2 point) const {
  const double x = along_ * point.x, y = into_ * point.y;
  return origin_ + (facing_ ? Vec2{y, x} : Vec2{x, y});
}

namespace {

/// Returns the direction of rotation of an arc in coordinates of opposite orientation.
MotionKind mirrored(MotionKind kind) {
  if (kind == MotionKind::arc_cw) return MotionKind::arc_ccw;
  return kind == MotionKind::arc_ccw ? MotionKind::arc_cw : kind;
}

}  // namespace

ContourPiece RoughFigure::in_figure(ContourPiece piece) const {
  if ((along_ * into_ < 0) != facing_) piece.kind = mirrored(piece.kind);
  piece.from = in_figure(piece.from);
  piece.to = in_figure(piece.to);
  piece.center = in_figure(piece.center);
  return piece;
}

ContourPiece RoughFigure::in_plane(ContourPiece piece) const {
  if ((along_ * into_ < 0) != facing_) piece.kind = mirrored(piece.kind);
  piece.from = in_plane(piece.from);
  piece.to = in_plane(piece.to);
  piece.center = in_plane(piece.center);
  return piece;
}

/// Returns the point where a section meets the level, which lies between the depths of its ends or is as good as the depth of one of them.
/// An arc is searched by bisection, because its radius may change along it.
FigurePlace RoughFigure::crossing(std::size_t section, double level) const {
  const ContourPiece& piece = sections_[section];
  const double y0 = piece.from.y, y1 = piece.to.y;
  const bool sinks = y0 < y1;
  if (level <= std::min(y0, y1)) return {section, sinks ? 0.0 : 1.0, sinks ? piece.from : piece.to};
  if (!piece.is_arc()) {
    const double part = (level - y0) / (y1 - y0);
    return {section, part, {piece.at(part).x, level}};
  }
  double low = 0, high = 1;
  for (int i = 0; i < crossing_halvings; ++i) {
    const double middle = (low + high) / 2;
    ((piece.at(middle).y > level) == sinks ? high : low) = middle;
  }
  const double part = sinks ? high : low;
  return {section, part, {piece.at(part).x, level}};
}

std::optional<Stretch> RoughFigure::stretch(double level, const FigurePlace& from, const FigurePlace& to) const {
  if (!from.before(to)) return {};
  Stretch found;
  found.begin = begin();
  bool inside = found.open = from.section == 0 && from.part == 0 && deeper(from.point.y, level);
  for (std::size_t i = from.section; i <= to.section; ++i) {
    const bool stays = deeper(sections_[i].to.y, level);
    if (stays == inside) continue;
    const FigurePlace place = crossing(i, level);
    if (inside) {
      found.end = place;
      return found;
    }
    if (i == to.section && place.part >= to.part) return {};
    found.begin = place;
    inside = true;
  }
  if (!inside) return {};
  found.end = end();
  return found;
}

Stretch RoughFigure::stretch_around(double level, const FigurePlace& place) const {
  Stretch found{begin(), end(), false};
  std::size_t i = place.section;
  while (deeper(sections_[i].from.y, level) && i > 0) --i;
  found.open = deeper(sections_[i].from.y, level);
  if (!found.open) found.begin = crossing(i, level);
  i = place.section;
  while (deeper(sections_[i].to.y, level) && i + 1 < sections_.size()) ++i;
  if (!deeper(sections_[i].to.y, level)) found.end = crossing(i, level);
  return found;
}

FigurePlace RoughFigure::ridge(const FigurePlace& from, const FigurePlace& to) const {
  FigurePlace best = from;
  for (std::size_t i = from.section; i < to.section; ++i)
    if (sections_[i].to.y < best.point.y) best = {i, 1, sections_[i].to};
  return to.point.y < best.point.y ? to : best;
}

FigurePlace RoughFigure::after_section(const FigurePlace& from, const FigurePlace& to) const {
  if (from.section == to.section) return to;
  return {from.section + 1, 0, sections_[from.section + 1].from};
}

ContourPiece RoughFigure::section(const FigurePlace& from, const FigurePlace& to) const {
  ContourPiece piece = sections_[from.section];
  const double until = from.section == to.section ? to.part : 1;
  piece.turns *= until - from.part;
  piece.from = from.point;
  if (from.section == to.section) piece.to = to.point;
  return piece;
}

}  // namespace kadr::fanuc
