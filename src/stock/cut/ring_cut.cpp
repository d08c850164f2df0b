// Removes a ring from the lattice lines of a brick. Used by stock/stock.

#include "stock/cut/ring_cut.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace kadr {
namespace {

constexpr int rings_between_tops = 8;
constexpr float no_position = 1e30f;

/// The interval of each lattice line of a family that the ring removes; `from` is greater than `to` if the line misses the ring.
struct LineTakings {
  std::array<float, brick_lines> from, to;
  bool any = false;

  LineTakings() { from.fill(no_position), to.fill(-no_position); }
  void put(int line, double low, double high, double edge) {
    if (!(low < high && low < edge && high > 0)) return;
    from[std::size_t(line)] = float(low), to[std::size_t(line)] = float(high);
    any = true;
  }
};

class RingCutter {
 public:
  RingCutter(Brick& brick, const BrickScale& scale, const Vec3& corner, const RingSweep& sweep, std::int32_t by, RingOutcome& outcome)
      : brick_(brick), scale_(scale), corner_(corner), sweep_(sweep), by_(by), outcome_(outcome), edge_(double(scale.edge)) {}

  void cut() {
    const BrickRing own = brick_ring(corner_.x, corner_.y, edge_);
    const RingRange reached = folded(sweep_.between(corner_.z, corner_.z + edge_));
    if (reached.none() || reached.from > own.farthest || reached.to < own.nearest) return;
    if (!outcome_.watched && holds_all(own)) return clear();
    cut_upright_lines(reached);
    cut_level_lines();
    if (outcome_.changed && ++brick_.cuts_since >= rings_between_tops) refresh_tops(brick_, scale_.cell);
  }

 private:
  double place(int i) const { return double(scale_.place[i]); }
  bool holds_all(const BrickRing& own) const;
  void clear();
  void cut_upright_lines(const RingRange& reached);
  void cut_level_lines();
  void take(int family, const LineTakings& takings);
  void take_further(int family, const LineTakings& takings);
  void note(int family, int line, float from, float to);

  Brick& brick_;
  const BrickScale& scale_;
  Vec3 corner_;
  const RingSweep& sweep_;
  std::int32_t by_;
  RingOutcome& outcome_;
  double edge_;
};

/// Returns true if the sweep removes the whole brick: the brick's rectangle of radii and heights lies inside the swept outline on one side
/// of the axis. Testing the corners is enough, because the outline is convex.
bool RingCutter::holds_all(const BrickRing& own) const {
  for (const double side : {1.0, -1.0}) {
    bool all = true;
    for (const double radius : {own.nearest, own.farthest}) {
      const RingRange range = sweep_.at_x(side * radius);
      all = all && range.from <= corner_.z && range.to >= corner_.z + edge_;
    }
    if (all) return true;
  }
  return false;
}

void RingCutter::clear() {
  const BrickLines& upright = brick_.family[2];
  for (int i = 0; i < brick_lines; ++i) outcome_.length += std::max(double(upright.to[i]) - double(upright.from[i]), 0.0);
  for (const FurtherInterval& f : upright.further) outcome_.length += double(f.to) - double(f.from);
  for (BrickLines& lines : brick_.family) {
    std::fill(lines.from, lines.from + brick_lines, -1.f), std::fill(lines.to, lines.to + brick_lines, -1.f);
    lines.further.clear();
  }
  brick_.top_of_square.fill(-1.f);
  brick_.top = -1;
  outcome_.changed = true;
  outcome_.longest = scale_.edge;
}

/// Cuts lines along Z with the outline on both sides of the axis. The two intervals of a line may overlap, so each is removed separately.
void RingCutter::cut_upright_lines(const RingRange& reached) {
  const BrickLines& lines = brick_.family[2];
  LineTakings right, left;
  for (int line = 0; line < brick_lines; ++line) {
    if (lines.further.empty() && !(lines.from[line] < lines.to[line])) continue;
    const double x = corner_.x + place(line % brick_edge), y = corner_.y + place(line / brick_edge), radius = std::sqrt(x * x + y * y);
    if (radius < reached.from || radius > reached.to) continue;
    const RingRange a = sweep_.at_x(radius), b = sweep_.at_x(-radius);
    right.put(line, a.from - corner_.z, a.to - corner_.z, edge_);
    left.put(line, b.from - corner_.z, b.to - corner_.z, edge_);
  }
  take(2, right);
  take(2, left);
}

/// Cuts lines along X and Y. A line through the hole of the ring meets the ring in two intervals, one on each side of the hole; any other
/// line meets the ring in one interval.
void RingCutter::cut_level_lines() {
  std::array<RingRange, brick_edge> at_height;
  for (int i = 0; i < brick_edge; ++i) at_height[std::size_t(i)] = folded(sweep_.at_z(corner_.z + place(i)));
  for (const int family : {1, 0}) {
    const BrickLines& lines = brick_.family[std::size_t(family)];
    LineTakings ahead, behind;
    const double along_corner = family == 0 ? corner_.x : corner_.y, across_corner = family == 0 ? corner_.y : corner_.x;
    for (int line = 0; line < brick_lines; ++line) {
      if (lines.further.empty() && !(lines.from[line] < lines.to[line])) continue;
      const RingRange& radii = at_height[std::size_t(family == 0 ? line / brick_edge : line % brick_edge)];
      if (radii.none()) continue;
      const double across = std::fabs(across_corner + place(family == 0 ? line % brick_edge : line / brick_edge));
      if (across >= radii.to) continue;
      const double far = std::sqrt((radii.to - across) * (radii.to + across));
      const double near = radii.from > across ? std::sqrt((radii.from - across) * (radii.from + across)) : -far;
      ahead.put(line, near - along_corner, far - along_corner, edge_);
      if (near >= 0) behind.put(line, -far - along_corner, -near - along_corner, edge_);
    }
    take(family, ahead);
    take(family, behind);
  }
}

/// Removes one interval from each lattice line of a family, also from the further intervals of material.
void RingCutter::take(int family, const LineTakings& takings) {
  if (!takings.any) return;
  BrickLines& lines = brick_.family[std::size_t(family)];
  if (!lines.further.empty()) take_further(family, takings);
  for (int line = 0; line < brick_lines; ++line) {
    const float from = takings.from[std::size_t(line)], to = takings.to[std::size_t(line)], low = lines.from[line], high = lines.to[line];
    if (!(from < to && low < high && from < high && to > low)) continue;
    note(family, line, std::max(from, low), std::min(to, high));
    if (from <= low && to >= high) {
      lines.from[line] = lines.to[line] = -1;
    } else if (from <= low) {
      lines.from[line] = to, lines.from_by[line] = by_;
    } else {
      if (to < high) lines.further.push_back({line, to, high, by_, lines.to_by[line]});
      lines.to[line] = from, lines.to_by[line] = by_;
    }
  }
}

void RingCutter::take_further(int family, const LineTakings& takings) {
  std::vector<FurtherInterval>& further = brick_.family[std::size_t(family)].further;
  for (std::size_t k = 0, count = further.size(); k < count; ++k) {
    const FurtherInterval f = further[k];
    const float from = takings.from[std::size_t(f.line)], to = takings.to[std::size_t(f.line)];
    if (!(from < to && from < f.to && to > f.from)) continue;
    note(family, f.line, std::max(from, f.from), std::min(to, f.to));
    if (from <= f.from && to >= f.to) {
      further[k].to = f.from;
    } else if (from <= f.from) {
      further[k].from = to, further[k].from_by = by_;
    } else {
      further[k].to = from, further[k].to_by = by_;
      if (to < f.to) further.push_back({f.line, to, f.to, by_, f.to_by});
    }
  }
  std::erase_if(further, [](const FurtherInterval& f) { return f.to <= f.from; });
}

/// Records an interval that was removed from a lattice line.
void RingCutter::note(int family, int line, float from, float to) {
  outcome_.changed = true;
  const double length = double(to) - double(from), lane = place(line % brick_edge), row = place(line / brick_edge);
  if (family == 2) outcome_.length += length;
  outcome_.longest = std::max(outcome_.longest, to - from);
  if (!outcome_.watched) return;
  if (family == 2) {
    if (length < outcome_.least_piece) return;
    const double x = corner_.x + lane, y = corner_.y + row;
    outcome_.radii.include(std::sqrt(x * x + y * y));
    outcome_.heights.include(corner_.z + double(from)), outcome_.heights.include(corner_.z + double(to));
    return;
  }
  const double across = family == 0 ? corner_.y + lane : corner_.x + row, corner = family == 0 ? corner_.x : corner_.y;
  const RingRange ends = folded({corner + double(from), corner + double(to)});
  const double nearest = std::sqrt(ends.from * ends.from + across * across), farthest = std::sqrt(ends.to * ends.to + across * across);
  if (farthest - nearest < outcome_.least_piece) return;
  outcome_.radii.include(nearest), outcome_.radii.include(farthest);
  outcome_.heights.include(corner_.z + (family == 0 ? row : lane));
}

}  // namespace

BrickRing brick_ring(double x, double y, double edge) {
  const auto nearest = [&](double at) { return at > 0 ? at : at + edge < 0 ? -at - edge : 0; };
  const auto farthest = [&](double at) { return std::max(std::fabs(at), std::fabs(at + edge)); };
  const double near_x = nearest(x), near_y = nearest(y), far_x = farthest(x), far_y = farthest(y);
  return {std::sqrt(near_x * near_x + near_y * near_y), std::sqrt(far_x * far_x + far_y * far_y)};
}

void cut_ring(Brick& brick, const BrickScale& scale, const Vec3& corner, const RingSweep& sweep, std::int32_t by, RingOutcome& outcome) {
  RingCutter(brick, scale, corner, sweep, by, outcome).cut();
}

}  // namespace kadr
