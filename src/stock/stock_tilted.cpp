// Sweeps of tilted tools: how a sweep is stored, which bricks it reaches, and how it is executed in a brick (class Stock).

#include <algorithm>
#include <cassert>
#include <cmath>
#include <functional>

#include "base/matrix.h"
#include "stock/cut/tilted_cut.h"
#include "stock/cut/tilted_division.h"
#include "stock/stock.h"

namespace kadr {
namespace {

constexpr double bend_of_cell = 1.0 / 100;
constexpr double greatest_bend = 2.5e-3;  // greatest permitted bend in mm; see most_bend()
// Accuracy in mm of positions that upright tools cut: a little over twice the 2e-4 mm of the law in stock/cut/upright_rows.h and
// level_rows.h.
constexpr float upright_agree = 5e-4f;
constexpr float tilted_agree_cell = 2e-3f;  // error that the bend and an estimated position may add, as a fraction of the cell size

struct BodyHeights {
  double low, high, radius;

  /// Returns the distance of a position, in the tool's coordinates, from the body, mm.
  double distance(Vec3 at) const {
    const double aside = std::max(length(Vec2{at.x, at.y}) - radius, 0.0), beyond = std::max({low - at.z, at.z - high, 0.0});
    return length(Vec2{aside, beyond});
  }
  /// Returns a lower bound, in mm, of the distance of a straight path from the body. Along the path, the distance is a convex function, so
  /// the search for its least value can halve the path. The bound may be too small by at most about `enough` mm.
  double distance(Vec3 first, Vec3 last, double enough) const {
    double begin = 0, end = 1;
    const auto at = [&](double part) { return distance(first + part * (last - first)); };
    const double size = length(last - first);
    while ((end - begin) * size > enough) {
      const double a = begin + (end - begin) * 0.45, b = begin + (end - begin) * 0.55;
      if (at(a) < at(b)) end = b;
      else begin = a;
    }
    return at((begin + end) / 2) - (end - begin) * size / 2;
  }
};

BodyHeights heights_of(const ConvexBody& body) { return {body.bottom(), body.top(), body.widest()}; }

AroundTip around_all(const ToolShape& tool, const TiltedPath& path) {
  AroundTip all{0, 0, 0};
  for (const ConvexBody& body : tool.bodies) {
    const AroundTip one = around_tilted_tip(path, body.bottom(), body.top(), body.widest());
    all = {std::max(all.sideways, one.sideways), std::max(all.below, one.below), std::max(all.above, one.above)};
  }
  return all;
}

}  // namespace

/// Returns the greatest permitted bend in mm: the distance between the true curve of a material point, in the tool's coordinates, and the
/// chord that replaces the curve.
double Stock::most_bend() const { return std::min(bend_cell_ * bend_of_cell, greatest_bend); }

float Stock::families_agree() const {
  return tilted_ends_.empty() ? upright_agree : upright_agree + float(2 * most_bend()) + tilted_agree_cell * scale_.cell;
}

/// Divides the sweep into parts and stores them. The number of parts does not depend on the position of the bricks, so stocks that are
/// divided for the same cell size store the same sweeps.
void Stock::add_tilted(const Sweep& sweep) {
  const ToolShape& tool = tools_[sweep.tool];
  const TiltedPath path{sweep.from - lattice_.origin(), sweep.to - lattice_.origin(), sweep.from_direction, sweep.to_direction};
  const double edge = lattice_.edge();
  const Vec3 most{lattice_.bricks(0) * edge, lattice_.bricks(1) * edge, lattice_.bricks(2) * edge};
  const int count = parts_of(path, reach_of(tool), most_bend());
  for (int i = 0; i < count; ++i) {
    const TiltedPath all = path.between(double(i) / count, double(i + 1) / count);
    const PathPart part = part_that_reaches(all.from, all.to - all.from, around_all(tool, all), most);
    const TiltedPath one = all.between(part.first, part.last);
    KeptSweep stored{};
    TiltedEnds ends{std::uint32_t(sweeps_.size()), {}, {}};
    for (int d = 0; d < 3; ++d) {
      stored.from[d] = float(along(one.from, d)), stored.to[d] = float(along(one.to, d));
      ends.from[d] = float(along(one.from_direction, d)), ends.to[d] = float(along(one.to_direction, d));
    }
    stored.tool = sweep.tool, stored.watched = sweep.watched, stored.leans = true;
    keep(stored, part);
    tilted_ends_.push_back(ends);
  }
}

const TiltedEnds& Stock::tilted_ends(std::size_t sweep) const {
  // The list tilted_ends_ has one element for each sweep of a tilted tool. An estimated index is tried before the list is searched: in most
  // programs, all sweeps after the first sweep of a tilted tool have tilted tools too.
  const std::size_t guess = sweep - tilted_ends_.front().sweep;
  if (guess < tilted_ends_.size() && tilted_ends_[guess].sweep == sweep) return tilted_ends_[guess];
  const auto found =
      std::lower_bound(tilted_ends_.begin(), tilted_ends_.end(), sweep, [](const TiltedEnds& e, std::size_t s) { return e.sweep < s; });
  assert(found != tilted_ends_.end() && found->sweep == sweep);
  return *found;
}

TiltedPath tilted_path_of(const KeptSweep& s, const TiltedEnds& ends) {
  const auto vec = [](const float(&v)[3]) { return Vec3{double(v[0]), double(v[1]), double(v[2])}; };
  const auto direction = [&](const float(&v)[3]) {
    const Vec3 d = vec(v);
    return (1 / std::sqrt(dot(d, d))) * d;
  };
  return {vec(s.from), vec(s.to), direction(ends.from), direction(ends.to)};
}

void Stock::bin_tilted(std::size_t i) {
  const TiltedPath path = tilted_path_of(sweeps_[i], tilted_ends(i));
  const ToolEnds ends(path);
  const double edge = lattice_.edge(), half_diagonal = edge / 2 * std::sqrt(3.0) * (1 + path.turn()) + lattice_.cell() / 100;
  for (const ConvexBody& body : tools_[sweeps_[i].tool].bodies) {
    const BodyHeights heights = heights_of(body);
    const Box3 box = box_around(path, heights.low, heights.high, heights.radius);
    int low[3], high[3];
    for (int d = 0; d < 3; ++d) {
      low[d] = int(std::floor(std::max(along(box.least, d) / edge, double(lattice_.first(d)))));
      high[d] = int(std::floor(std::min(along(box.most, d) / edge, double(lattice_.last(d)))));
    }
    for (int z = low[2]; z <= high[2]; ++z)
      for (int y = low[1]; y <= high[1]; ++y)
        for (int x = low[0]; x <= high[0]; ++x) {
          const std::size_t b = lattice_.at({x, y, z});
          if (states_[b] == State::empty) continue;
          const Vec3 middle = edge * Vec3{x + 0.5, y + 0.5, z + 0.5};
          if (heights.distance(ends.first(middle), ends.last(middle), edge / 4) < half_diagonal) put_in_bin(b, i);
        }
  }
}

/// Returns the sweep in the coordinates of the brick. A path that is much longer than its part near the brick is shortened to this part.
TiltedSweepInBrick Stock::tilted_sweep_in_brick(std::size_t number, std::size_t b) const {
  const KeptSweep s = sweeps_[number];
  const Vec3 corner = lattice_.corner(b) - lattice_.origin();
  const double edge = lattice_.edge();
  TiltedPath path = tilted_path_of(s, tilted_ends(number));
  path.from = path.from - corner, path.to = path.to - corner;
  AroundTip around{0, 0, 0};
  const Vec3 forth = path.to - path.from;
  const double far = std::sqrt(dot(forth, forth));
  if (far > clipped_above * edge) around = around_all(tools_[s.tool], path);
  if (far > clipped_above * (edge + 2 * around.sideways)) {
    const PathPart part = part_that_reaches(path.from, forth, around, {edge, edge, edge});
    path = path.between(part.first, part.last);
  }
  return {path, around, TiltedSweep(path, {}, edge), local_sweep(path.from, path.to, around, edge)};
}

bool Stock::may_reach(std::size_t sweep, const TiltedSweepInBrick& here, float top) const {
  const std::vector<TiltedBody>& bodies = tilted_[sweeps_[sweep].tool];
  return std::any_of(bodies.begin(), bodies.end(), [&](const TiltedBody& b) { return kadr::may_reach(here.sweep, b, scale_, top); });
}

/// Removes from one brick the material that one body of the tool sweeps.
void Stock::cut_tilted(std::size_t number, std::size_t i, const TiltedSweepInBrick& here, Brick& material, CutOutcome& outcome) const {
  const std::uint16_t tool = sweeps_[number].tool;
  const TiltedBody& body = tilted_[tool][i];
  if (!kadr::may_reach(here.sweep, body, scale_, material.top)) return;
  // Lines over which the tool turns in a part of the path are cut with the two halves of this part. In each half, the permitted gap is
  // twice as long (TiltedOver::apart).
  const std::function<void(const TiltedPath&, const TiltedSweep&, const LocalSweep&, const LineSet*)> cut =
      [&](const TiltedPath& path, const TiltedSweep& sweep, const LocalSweep& tip, const LineSet* only) {
        const LineSet later = cut_brick_tilted(material, scale_, {sweep, body, tip, swept_[tool][i], only}, std::int32_t(number), outcome);
        if (!later.any) return;
        for (const double first : {0.0, 0.5}) {
          const TiltedPath half = path.between(first, first + 0.5);
          cut(half, TiltedSweep(half, {}, lattice_.edge()), local_sweep(half.from, half.to, here.around, lattice_.edge()), &later);
        }
      };
  const TiltedDivision division = division_of(here.sweep, body);
  if (division.parts == 1) return cut(here.path, here.sweep, here.tip, nullptr);
  for (std::size_t part = 0; part < std::size_t(division.parts); ++part) {
    const TiltedPath path = here.path.between(division.share[part], division.share[part + 1]);
    const TiltedSweep sweep(path, {}, lattice_.edge());
    if (kadr::may_reach(sweep, body, scale_, material.top))
      cut(path, sweep, local_sweep(path.from, path.to, here.around, lattice_.edge()), nullptr);
  }
}

}  // namespace kadr
