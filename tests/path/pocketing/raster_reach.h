#pragma once
// RasterReach: finds the parts of a zone that a path leaves although the tool could cut them. It works point by point on a grid, with
// distances to exact lines and arcs. It shares no polygon, offset or field with the milling that it judges.

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "path/pocketing/mill.h"

namespace kadr::area {

class RasterReach {
 public:
  RasterReach(const std::vector<Zone>& zones, const Job& job, double cell = 0.2) : job_(job), cell_(cell) {
    for (const Zone& zone : zones)
      for (const Edges& loop : zone.loops)
        for (const Edge& e : loop) {
          sides_.push_back(e);
          if (!e.open) walls_.push_back(e);
          box_.take(e);
        }
    across_ = static_cast<std::size_t>(std::ceil((box_.most.x - box_.least.x) / cell_)) + 1;
    up_ = static_cast<std::size_t>(std::ceil((box_.most.y - box_.least.y) / cell_)) + 1;
    inside_.assign(across_ * up_, false);
    for (std::size_t row = 0; row < up_; ++row) fill(row);
    constexpr int direction_count = 120;
    for (int i = 0; i < direction_count; ++i)
      directions_.push_back({std::cos(2 * std::numbers::pi * i / direction_count), std::sin(2 * std::numbers::pi * i / direction_count)});
  }

  /// Returns the area in mm² that the tool can reach and the moves leave, for the worst layer. Cusps of up to `cusp` mm do not count.
  double left(const std::vector<Move>& moves, double cusp) const {
    double most = 0;
    for (const double level : levels_of(job_)) most = std::max(most, left_at(level, moves, cusp));
    return most;
  }

  /// Returns the area in mm² that the tool can reach.
  double reachable() const {
    std::size_t count = 0;
    for (std::size_t i = 0; i < inside_.size(); ++i)
      if (inside_[i] && can_be_cut(point(i))) ++count;
    return static_cast<double>(count) * cell_ * cell_;
  }

 private:
  static constexpr double same_level = 0.01;  // mm: levels are rounded to the digits of a Z word
  static constexpr double margin = 0.02;      // mm: a point that is reached by less than this is ignored, and so is a gap of this width

  Vec2 point(std::size_t i) const {
    return box_.least + cell_ * Vec2{static_cast<double>(i % across_) + 0.5, static_cast<double>(i / across_) + 0.5};
  }

  /// Fills a row by the even-odd rule: crossings with chords much shorter than a cell is wide.
  void fill(std::size_t row) {
    const double y = point(row * across_).y;
    std::vector<double> crossings;
    for (const Edge& e : sides_) {
      const int chords = e.bulge == 0 ? 1 : 400;
      for (int i = 0; i < chords; ++i) {
        const Vec2 a = at(e, double(i) / chords), b = i + 1 == chords ? e.to : at(e, double(i + 1) / chords);
        if ((a.y > y) != (b.y > y)) crossings.push_back(a.x + (y - a.y) / (b.y - a.y) * (b.x - a.x));
      }
    }
    std::sort(crossings.begin(), crossings.end());
    for (std::size_t i = row * across_; i < (row + 1) * across_; ++i)
      inside_[i] = (std::lower_bound(crossings.begin(), crossings.end(), point(i).x) - crossings.begin()) % 2 == 1;
  }

  double left_at(double level, const std::vector<Move>& moves, double cusp) const {
    std::vector<bool> left = inside_;
    for (std::size_t i = 1; i < moves.size(); ++i) {
      const Vec3 from = moves[i - 1].to, to = moves[i].to;
      if (moves[i].kind == MoveKind::rapid || std::abs(from.z - level) > same_level || std::abs(to.z - level) > same_level) continue;
      cut({{from.x, from.y}, {to.x, to.y}, moves[i].bulge}, job_.radius + cusp, left);
    }
    std::size_t count = 0;
    for (std::size_t i = 0; i < left.size(); ++i)
      if (left[i] && can_be_cut(point(i))) ++count;
    return static_cast<double>(count) * cell_ * cell_;
  }

  void cut(const Edge& e, double radius, std::vector<bool>& left) const {
    Bounds box;
    box.take(e);
    const auto index = [&](double from, double to, std::size_t most) {
      return static_cast<std::size_t>(std::clamp((to - from) / cell_, 0.0, static_cast<double>(most)));
    };
    const std::size_t right = index(box_.least.x, box.most.x + radius + cell_, across_ - 1),
                      top = index(box_.least.y, box.most.y + radius + cell_, up_ - 1);
    for (std::size_t row = index(box_.least.y, box.least.y - radius, up_ - 1); row <= top; ++row)
      for (std::size_t column = index(box_.least.x, box.least.x - radius, across_ - 1); column <= right; ++column)
        if (const std::size_t i = row * across_ + column; left[i] && distance(e, point(i)) <= radius) left[i] = false;
  }

  /// Returns true if a tool at some position near p cuts p and touches no wall. The tool may be in the zone or beyond an open side.
  /// There is no wall between the tool and p, because p is nearer than every wall.
  bool can_be_cut(Vec2 p) const {
    const double off_walls = job_.radius + job_.allowance + margin;
    for (const double share : {1.0, 0.7, 0.3, 0.0})
      for (const Vec2& direction : directions_) {
        const Vec2 centre = p + share * (job_.radius - margin) * direction;
        if (std::all_of(walls_.begin(), walls_.end(), [&](const Edge& wall) { return distance(wall, centre) >= off_walls; })) return true;
        if (share == 0) break;
      }
    return false;
  }

  const Job& job_;
  double cell_;
  Edges sides_, walls_;
  Bounds box_;
  std::size_t across_ = 0, up_ = 0;
  std::vector<bool> inside_;
  std::vector<Vec2> directions_;  // unit vectors in all directions
};

}  // namespace kadr::area
