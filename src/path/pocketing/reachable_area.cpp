// Room is an area that is prepared for a fast test whether a polyline stays inside the area. Every move of a path is tested. Used by
// path/pocketing/field; tested by tests/path/pocketing/room_test.cpp.

#include "path/pocketing/reachable_area.h"

#include <algorithm>
#include <cmath>

namespace kadr::area {
namespace {

constexpr double touch = 1e-5;  // Lines whose distance is less than this value, mm, count as meeting. The value is ten units of Clipper.
constexpr std::size_t least_across = 4, most_across = 256;

/// Returns true if the distance between the lines a–b and c–d is, or might be, less than `touch`.
bool may_meet(Vec2 a, Vec2 b, Vec2 c, Vec2 d) {
  // returns true if the points u and v are clearly on the same side of the line p–q
  const auto apart = [](Vec2 p, Vec2 q, Vec2 u, Vec2 v) {
    const Vec2 delta = q - p;
    const double slack = touch * length(delta), at_u = cross(delta, u - p), at_v = cross(delta, v - p);
    return (at_u > slack && at_v > slack) || (at_u < -slack && at_v < -slack);
  };
  if (std::max(a.x, b.x) < std::min(c.x, d.x) - touch || std::max(c.x, d.x) < std::min(a.x, b.x) - touch) return false;
  if (std::max(a.y, b.y) < std::min(c.y, d.y) - touch || std::max(c.y, d.y) < std::min(a.y, b.y) - touch) return false;
  return !apart(a, b, c, d) && !apart(c, d, a, b);
}

}  // namespace

Room::Room(Polygons area) : area_(std::move(area)) {
  for (const Polygon& p : area_)
    for (std::size_t i = 0; i < p.size(); ++i) {
      sides_.push_back({p[i], p[(i + 1) % p.size()]});
      box_.take(p[i]);
    }
  across_ = std::clamp(static_cast<std::size_t>(std::sqrt(static_cast<double>(sides_.size()))), least_across, most_across);
  cells_.resize(across_ * across_);
  for (std::uint32_t i = 0; i < sides_.size(); ++i)
    any_cell(sides_[i].a, sides_[i].b, [&](std::size_t cell) {
      cells_[cell].push_back(i);
      return false;
    });
}

std::size_t Room::column(double x) const {
  const double size = std::max(box_.most.x - box_.least.x, touch);
  return static_cast<std::size_t>(
      std::clamp((x - box_.least.x) / size * static_cast<double>(across_), 0.0, static_cast<double>(across_ - 1)));
}
std::size_t Room::row(double y) const {
  const double size = std::max(box_.most.y - box_.least.y, touch);
  return static_cast<std::size_t>(
      std::clamp((y - box_.least.y) / size * static_cast<double>(across_), 0.0, static_cast<double>(across_ - 1)));
}

template <class Take>
bool Room::any_cell(Vec2 a, Vec2 b, Take take) const {
  if (a.x > b.x) std::swap(a, b);
  const std::size_t first = column(a.x - touch), last = column(b.x + touch);
  const double width = std::max(box_.most.x - box_.least.x, touch) / static_cast<double>(across_);
  for (std::size_t x = first; x <= last; ++x) {
    // The borders of the column of grid cells. The distance between them is slightly greater than the width of the column. The line is
    // divided at the borders.
    const double left = box_.least.x + width * static_cast<double>(x) - touch, right = left + width + 2 * touch;
    const double run = b.x - a.x;
    const double from = x == first || run <= 0 ? 0 : std::clamp((left - a.x) / run, 0.0, 1.0);
    const double to = x == last || run <= 0 ? 1 : std::clamp((right - a.x) / run, 0.0, 1.0);
    const double y0 = a.y + from * (b.y - a.y), y1 = a.y + to * (b.y - a.y);
    for (std::size_t y = row(std::min(y0, y1) - touch); y <= row(std::max(y0, y1) + touch); ++y)
      if (take(x * across_ + y)) return true;
  }
  return false;
}

bool Room::meets_boundary(Vec2 a, Vec2 b) const {
  return any_cell(a, b, [&](std::size_t cell) {
    return std::any_of(cells_[cell].begin(), cells_[cell].end(), [&](std::uint32_t i) { return may_meet(a, b, sides_[i].a, sides_[i].b); });
  });
}

bool Room::surely_holds(const Polygon& line) const {
  if (line.empty() || area_.empty()) return line.empty();
  for (std::size_t i = 1; i < line.size(); ++i)
    if (meets_boundary(line[i - 1], line[i])) return false;
  return contains(area_, line.front());
}

bool Room::holds(const Polygon& line, double most) const {
  if (surely_holds(line)) return true;
  for (const Polygon& outside : lines_outside({line}, area_))
    for (std::size_t i = 1; i < outside.size(); ++i)
      if (length(outside[i] - outside[i - 1]) > most) return false;
  return true;
}

}  // namespace kadr::area
