// Compares the points of the material's surface, then the segments of lattice lines, with the wanted part. Used by session and cli.

#include "stock/part/part_compare.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <optional>

#include "base/matrix.h"
#include "base/thread.h"
#include "stock/blank/mesh_blank.h"
#include "stock/part/brick_difference.h"
#include "stock/part/nearest_triangle.h"
#include "stock/part/part_lines.h"
#include "stock/part/points_inside.h"
#include "stock/portion/portion.h"

namespace kadr {
namespace {

constexpr std::size_t points_at_once = 1024;
// Limit in mm: on a line along a wall of the part, rounding errors may look like a difference. A segment counts as such an error if all its
// points are closer to the part's surface than this limit.
constexpr double same_surface = 2e-3;
constexpr double step_of_cell = 0.5;  // distance, in lattice cells, between the points of a segment at which the depth is measured
// Greatest ratio between the depth at a surface point and the depth that nearby lattice lines show; greater than 1, because a groove may
// lie between the lines.
constexpr double between_lines = 2;

constexpr double bytes_of_triangle = 130;  // memory in bytes per triangle: the tree, and the triangle itself twice

/// The position of the greatest depth of one sort of difference. If depths are equal, `order` decides, so that the order of the threads has
/// no influence.
struct Deepest {
  double depth = 0;
  Vec3 at;
  std::int32_t sweep = of_blank;
  std::uint64_t order = ~std::uint64_t{0};

  void take(const Deepest& other) {
    if (other.depth > depth || (other.depth == depth && other.order < order)) *this = other;
  }
};

struct Offences {
  Deepest left_on, gouged;

  void take(const Offences& other) { left_on.take(other.left_on), gouged.take(other.gouged); }
};

/// Result of comparing the lines of one brick: volumes in mm³, depths in mm.
struct BrickFound {
  float left_on = 0, gouged = 0;
  float left_depth = 0, gouge_depth = 0;
};

/// The lattice of the stock, extended by the bricks that the wanted part needs.
struct WiderLattice {
  Lattice lattice;
  BrickPlace stock_at;  // indices of the stock's first brick in the extended lattice
  BrickBox own;         // the bricks whose differences count: of a portion its own ones, and those beyond them outside the stock
};

/// Returns the extended lattice. Of a portion it holds the own bricks and their neighbours.
WiderLattice wider_lattice(const Lattice& own, const Box3& blank, const Box3& part, const std::optional<BrickBox>& portion) {
  const Vec3 size = blank.most - blank.least;
  const double max_excess = std::max({size.x, size.y, size.z});
  Box3 box = blank;
  int before[3];
  for (int d = 0; d < 3; ++d) {
    const double below = std::clamp(along(blank.least, d) - along(part.least, d), 0.0, max_excess);
    before[d] = int(std::ceil(below / own.edge()));
    along(box.least, d) -= before[d] * own.edge();
    along(box.most, d) = std::clamp(along(part.most, d), along(blank.most, d), along(blank.most, d) + max_excess);
  }
  const Lattice whole(box, own.cell());
  WiderLattice wider{whole, {before[0], before[1], before[2]}, whole.held()};
  if (!portion) return wider;
  for (std::size_t d = 0; d < 3; ++d) {
    if (portion->first[d] > 0) wider.own.first[d] = before[d] + portion->first[d];
    if (portion->end[d] < own.bricks(int(d))) wider.own.end[d] = before[d] + portion->end[d];
  }
  wider.lattice = whole.held_only(with_neighbours(wider.own, whole.held()));
  return wider;
}

class PartInComparison {
 public:
  PartInComparison(const Stock& stock, const Surface& surface, const Mesh& part, const WindowFaces* faces)
      : stock_(stock),
        surface_(surface),
        faces_(faces),
        nearest_(part, stock.threads()),
        body_(faces == nullptr ? mesh_blank(part) : blank_within(mesh_blank(part), stock.blank().box())),
        wider_(wider_lattice(stock.lattice(), stock.blank().box(), body_->box(),
                             stock.is_portion() ? std::optional(stock.own()) : std::nullopt)),
        lines_(part, wider_.lattice, faces == nullptr ? std::nullopt : std::optional(body_->box()), stock.threads()),
        part_at_(body_->bricks_at_surface(wider_.lattice)),
        found_(wider_.lattice.size()),
        inside_(points_inside(part, surface.points, stock.threads())) {}

  PartComparison held();

 private:
  struct Work {
    BrickDifference difference;
    Offences found;
    std::uint32_t hint = 0;
  };
  bool is_inside(std::size_t point, const Vec3& at) const;
  double depth_around(const Vec3& at, bool inside) const;
  void hold_points(std::size_t chunk, std::vector<float>& deviation, Work& work) const;
  void hold_brick(std::size_t brick, Work& work);
  void hold_evenly(std::size_t brick, bool material, Work& work);
  float compare_segments(std::size_t brick, bool gouged, Deepest& deepest, Work& work);
  bool walk(const LineSegment& segment, int family, std::size_t brick, Deepest& deepest, Work& work) const;
  std::optional<std::size_t> of_stock(std::size_t brick) const;
  bool is_own(std::size_t brick) const { return wider_.own.holds(wider_.lattice.place(brick)); }
  std::uint64_t order_among_portions(std::uint64_t order) const;

  const Stock& stock_;
  const Surface& surface_;
  const WindowFaces* faces_;
  NearestTriangle nearest_;
  std::shared_ptr<const Blank> body_;
  WiderLattice wider_;
  PartLines lines_;
  std::vector<bool> part_at_;
  std::vector<BrickFound> found_;
  std::vector<std::uint8_t> inside_;  // for each point of the surface: 1 if the point is inside the wanted part, else 0
};

/// Returns true if a point of the material's surface is inside the wanted part. In a window, the wanted part ends at the faces of the
/// window.
bool PartInComparison::is_inside(std::size_t point, const Vec3& at) const {
  if (inside_[point] == 0 || faces_ == nullptr) return inside_[point] != 0;
  const Box3 box = body_->box();
  for (int d = 0; d < 3; ++d)
    if (!(along(at, d) > along(box.least, d) && along(at, d) < along(box.most, d))) return false;
  return true;
}

/// Returns a limit for the depth of a surface point: the greatest depth in mm on lines of the bricks that the point's cell touches. Surface
/// points are estimated from the exact positions on the lattice lines around them. Where edges meet, some points have an error of a
/// fraction of the cell, so a depth that no line shows cannot be trusted.
double PartInComparison::depth_around(const Vec3& at, bool inside) const {
  const Lattice& lattice = wider_.lattice;
  int low[3], high[3];
  for (int d = 0; d < 3; ++d) {
    const double from_origin = along(at, d) - along(lattice.origin(), d);
    const auto brick = [&](double place) { return std::clamp(int(std::floor(place / lattice.edge())), lattice.first(d), lattice.last(d)); };
    low[d] = brick(from_origin - lattice.cell()), high[d] = brick(from_origin + lattice.cell());
  }
  float deepest = 0;
  for (int z = low[2]; z <= high[2]; ++z)
    for (int y = low[1]; y <= high[1]; ++y)
      for (int x = low[0]; x <= high[0]; ++x) {
        const BrickFound& found = found_[lattice.at({x, y, z})];
        deepest = std::max(deepest, inside ? found.gouge_depth : found.left_depth);
      }
  return double(deepest);
}

void PartInComparison::hold_points(std::size_t chunk, std::vector<float>& deviation, Work& work) const {
  const std::size_t last = std::min((chunk + 1) * points_at_once, surface_.own_points());
  for (std::size_t i = chunk * points_at_once; i < last; ++i) {
    const Vec3 at = surface_.point(i);
    if (faces_ != nullptr && faces_->hold(at)) continue;
    const bool inside = is_inside(i, at);
    const double depth = std::min(nearest_.distance(at, work.hint), between_lines * depth_around(at, inside) + same_surface);
    deviation[i] = float(inside ? -depth : depth);
    (inside ? work.found.gouged : work.found.left_on).take({depth, at, surface_.made_by[i], i});
  }
}

/// Returns the index of the same brick in the stock's lattice; nullopt if the brick is outside the stock, where there was never any
/// material.
std::optional<std::size_t> PartInComparison::of_stock(std::size_t brick) const {
  BrickPlace place = wider_.lattice.place(brick);
  place.x -= wider_.stock_at.x, place.y -= wider_.stock_at.y, place.z -= wider_.stock_at.z;
  return stock_.lattice().holds(place) ? std::optional(stock_.lattice().at(place)) : std::nullopt;
}

void PartInComparison::hold_brick(std::size_t brick, Work& work) {
  const auto own = of_stock(brick);
  const Stock::State state = own ? stock_.state(*own) : Stock::State::empty;
  if (state != Stock::State::mixed && !part_at_[brick]) return hold_evenly(brick, state == Stock::State::full, work);
  take_difference(own ? stock_.brick(*own) : nullptr, state == Stock::State::full, lines_,
                  {wider_.lattice.place(brick), wider_.lattice.corner(brick), wider_.lattice.cell()}, work.difference);
  Offences here;
  BrickFound& found = found_[brick];
  found.left_on = compare_segments(brick, false, here.left_on, work), found.gouged = compare_segments(brick, true, here.gouged, work);
  found.left_depth = float(here.left_on.depth), found.gouge_depth = float(here.gouged.depth);
  if (is_own(brick)) work.found.take(here);
}

/// Handles a brick that is either full of material or empty, and that is wholly inside or wholly outside the wanted part. One line of the
/// brick shows whether the brick is inside the part.
void PartInComparison::hold_evenly(std::size_t brick, bool material, Work& work) {
  const double edge = wider_.lattice.edge(), middle = wider_.lattice.corner(brick).z + 0.5 * edge;
  const auto ranges = lines_.of(wider_.lattice.place(brick), 2, brick_lines / 2 + brick_edge / 2);
  const bool part = std::any_of(ranges.begin(), ranges.end(), [&](const LineRange& r) { return r.from < middle && middle < r.to; });
  if (part == material) return;
  BrickFound& found = found_[brick];
  (part ? found.gouged : found.left_on) = float(edge * edge * edge);
  Deepest here;
  for (std::int32_t line = 0; line < brick_lines; ++line) (void)walk({line, 0, edge, of_blank, of_blank}, 2, brick, here, work);
  (part ? found.gouge_depth : found.left_depth) = float(here.depth);
  if (is_own(brick)) (part ? work.found.gouged : work.found.left_on).take(here);
}

/// Computes the volume of the difference in a brick along the direction whose lines contain most of the difference: lines across a thin
/// layer measure the layer well, lines along the layer hardly meet it. Finds the greatest depth along all three directions, but ignores
/// segments that are numerical errors on lines along a wall.
///   returns  the volume, mm³
float PartInComparison::compare_segments(std::size_t brick, bool gouged, Deepest& deepest, Work& work) {
  const auto of = [&](int family) -> const std::vector<LineSegment>& {
    const LineDifference& d = work.difference.family[std::size_t(family)];
    return gouged ? d.gouged : d.left_on;
  };
  int best = 2;
  for (const int family : {0, 1})
    if (of(family).size() > of(best).size()) best = family;
  double length = 0;
  for (const LineSegment& segment : of(best))
    if (walk(segment, best, brick, deepest, work)) length += segment.to - segment.from;
  for (const int family : {(best + 1) % 3, (best + 2) % 3})
    for (const LineSegment& segment : of(family))
      if (segment.to - segment.from > same_surface) (void)walk(segment, family, brick, deepest, work);
  return float(length * wider_.lattice.cell() * wider_.lattice.cell());
}

/// Measures the depth at the middle of a segment, and in steps along the segment if the depth can exceed the greatest depth found so far.
///   returns  false if the segment is a numerical error on a line along a wall
bool PartInComparison::walk(const LineSegment& segment, int family, std::size_t brick, Deepest& deepest, Work& work) const {
  const double cell = wider_.lattice.cell(), half = (segment.to - segment.from) / 2;
  Vec3 at = wider_.lattice.corner(brick);
  along(at, (family + 1) % 3) += (segment.line % brick_edge + 0.5) * cell;
  along(at, (family + 2) % 3) += (segment.line / brick_edge + 0.5) * cell;
  const double corner = along(at, family);
  const std::uint64_t number = wider_.lattice.number(wider_.lattice.place(brick));
  const auto depth_at = [&](double place) {
    along(at, family) = corner + place;
    const double depth = nearest_.distance(at, work.hint);
    const std::int32_t by = place - segment.from < segment.to - place ? segment.from_by : segment.to_by;
    deepest.take({depth, at, by, (std::uint64_t{1} << 63) + number * brick_lines + std::uint64_t(segment.line)});
    return depth;
  };
  double most = depth_at(segment.from + half);
  if (most > same_surface && most + half < deepest.depth) return true;
  const int steps = int(std::ceil(2 * half / (step_of_cell * cell)));
  for (int i = 0; i <= steps; ++i) most = std::max(most, depth_at(segment.from + 2 * half * i / steps));
  return most > same_surface;
}

PartComparison PartInComparison::held() {
  PartComparison result;
  result.deviation.resize(surface_.point_count());
  const std::size_t chunks = (surface_.own_points() + points_at_once - 1) / points_at_once;
  std::vector<Work> works(std::size_t(stock_.threads()));
  const auto share = [&](std::size_t count, const auto& hold) {
    std::atomic<std::size_t> next{0};
    run_parallel(stock_.threads(), [&](int thread) {
      for (std::size_t i; (i = next++) < count;) hold(i, works[std::size_t(thread)]);
    });
  };
  share(wider_.lattice.size(), [&](std::size_t i, Work& work) { hold_brick(i, work); });
  share(chunks, [&](std::size_t i, Work& work) { hold_points(i, result.deviation, work); });
  Offences all;
  for (const Work& w : works) all.take(w.found);
  const auto offence = [&](const Deepest& d) { return PartOffence{0, d.depth, d.at, d.sweep, order_among_portions(d.order)}; };
  result.left_on = offence(all.left_on), result.gouged = offence(all.gouged);
  for (std::size_t i = 0; i < found_.size(); ++i) {
    if (!is_own(i)) continue;
    const BrickFound& v = found_[i];
    result.left_on.volume += double(v.left_on), result.gouged.volume += double(v.gouged);
    if (stock_.is_portion() && (v.left_on != 0 || v.gouged != 0))
      result.bricks.push_back({wider_.lattice.number(wider_.lattice.place(i)), v.left_on, v.gouged});
  }
  return result;
}

/// Returns the order of a place among the places of all portions. Points are ordered by their bricks, which no two portions have in common.
std::uint64_t PartInComparison::order_among_portions(std::uint64_t order) const {
  constexpr int bits_of_point = 20;  // a brick has at most 4 points in each of its 4096 cells
  if (!stock_.is_portion() || order >= surface_.own_points()) return order;
  const auto after = std::upper_bound(surface_.bricks.begin(), surface_.bricks.end(), order,
                                      [](std::uint64_t point, const SurfaceBrick& b) { return point < b.first_point; });
  const SurfaceBrick& brick = *(after - 1);
  return brick.number << bits_of_point | (order - brick.first_point);
}

}  // namespace

PartComparison compare(const Stock& stock, const Surface& surface, const Mesh& part, const WindowFaces* faces) {
  return PartInComparison(stock, surface, part, faces).held();
}

void PartOffence::take(const PartOffence& other) {
  if (other.deepest < deepest || (other.deepest == deepest && other.order >= order)) return;
  deepest = other.deepest, at = other.at, sweep = other.sweep, order = other.order;
}

PartComparison join_comparisons(std::vector<PartComparison> portions) {
  PartComparison all;
  std::vector<BrickVolumes> bricks;
  for (PartComparison& one : portions) {
    all.left_on.take(one.left_on), all.gouged.take(one.gouged);
    bricks.insert(bricks.end(), one.bricks.begin(), one.bricks.end());
    one.bricks = {};
  }
  std::sort(bricks.begin(), bricks.end(), [](const BrickVolumes& a, const BrickVolumes& b) { return a.number < b.number; });
  for (const BrickVolumes& v : bricks) all.left_on.volume += double(v.left_on), all.gouged.volume += double(v.gouged);
  return all;
}

double bytes_of_comparison(const Box3& stock, double cell, const Mesh& part, ComparedPart held, const std::optional<BrickBox>& portion) {
  const Lattice own(stock, cell);
  const Lattice lattice = held == ComparedPart::window ? own : wider_lattice(own, stock, box_of(part), portion).lattice;
  return double(part.triangle_count()) * bytes_of_triangle + PartLines::bytes(part, lattice) +
         double(lattice.size()) * double(sizeof(BrickFound) + 1);
}

}  // namespace kadr
