// Finds the intersections (hits) of all triangles with the lattice lines, and sorts the hits by line. Used by stock/part/part_compare.

#include "stock/part/part_lines.h"

#include <algorithm>
#include <atomic>
#include <cmath>

#include "base/matrix.h"
#include "base/thread.h"
#include "stock/blank/mesh_blank.h"
#include "stock/brick/brick.h"
#include "stock/mesh/triangle_across.h"
#include "stock/stock.h"

namespace kadr {
namespace {

constexpr std::size_t shares = 8;  // number of portions into which the triangles are divided for the threads

/// Clips the segments to the window in the same way as blank_within().
void clip(std::vector<LineRange>& ranges, std::size_t first, double least, double most) {
  std::size_t kept = first;
  for (std::size_t i = first; i < ranges.size(); ++i) {
    const LineRange within{std::max(ranges[i].from, least), std::min(ranges[i].to, most)};
    if (within.from < within.to) ranges[kept++] = within;
  }
  ranges.resize(kept);
}

}  // namespace

PartLines::PartLines(const Mesh& solid, const Lattice& lattice, const std::optional<Box3>& window, int threads)
    : cell_(lattice.cell()), first_(lattice.held().first) {
  for (int d = 0; d < 3; ++d)
    for (int i = lattice.first(d) * brick_edge; i < (lattice.last(d) + 1) * brick_edge; ++i) {
      BrickPlace brick;
      (d == 0 ? brick.x : d == 1 ? brick.y : brick.z) = i / brick_edge;
      places_[std::size_t(d)].push_back(along(lattice.corner(brick), d) + (i % brick_edge + 0.5) * cell_);
    }
  std::array<std::vector<Hit>, 3 * shares> found;
  const auto share = [&](std::size_t count, const auto& work) {
    std::atomic<std::size_t> next{0};
    run_parallel(threads, [&](int) {
      for (std::size_t i; (i = next++) < count;) work(i);
    });
  };
  const std::size_t count = solid.triangle_count();
  share(found.size(),
        [&](std::size_t i) { find(solid, int(i / shares), count * (i % shares) / shares, count * (i % shares + 1) / shares, found[i]); });
  share(3, [&](std::size_t family) { order(int(family), std::span(found).subspan(family * shares, shares), window); });
}

/// Returns the index of the first lattice point along the axis that is not before the position.
std::size_t PartLines::first_from(int axis, double place) const {
  const std::vector<double>& all = places_[std::size_t(axis)];
  const double guess = std::clamp((place - all.front()) / cell_, 0.0, double(all.size()));
  std::size_t i = std::size_t(guess);
  while (i > 0 && all[i - 1] >= place) --i;
  while (i < all.size() && all[i] < place) ++i;
  return i;
}

void PartLines::find(const Mesh& solid, int family, std::size_t first, std::size_t last, std::vector<Hit>& hits) const {
  const int axis_u = (family + 1) % 3, axis_v = (family + 2) % 3;
  const std::vector<double>&all_u = places_[std::size_t(axis_u)], &all_v = places_[std::size_t(axis_v)];
  TriangleRow row;
  for (std::size_t t = first; t < last; ++t) {
    const TriangleAcross triangle(solid, t, family);
    const double most_v = triangle.most_v();
    for (std::size_t v = first_from(axis_v, triangle.least_v()); v < all_v.size() && all_v[v] < most_v; ++v) {
      if (!triangle.row(all_v[v], row)) continue;
      for (std::size_t u = first_from(axis_u, row.left.u); u < all_u.size() && all_u[u] < row.right.u; ++u)
        hits.push_back({row.place(all_u[u]), std::uint32_t(v * all_u.size() + u), std::uint32_t(t), row.turn});
    }
  }
}

void PartLines::order(int family, const std::span<std::vector<Hit>>& found, const std::optional<Box3>& window) {
  const int axis_u = (family + 1) % 3, axis_v = (family + 2) % 3;
  const std::vector<double>&all_u = places_[std::size_t(axis_u)], &all_v = places_[std::size_t(axis_v)];
  std::vector<std::size_t> next(all_u.size() * all_v.size() + 1, 0);
  for (const std::vector<Hit>& hits : found)
    for (const Hit& h : hits) ++next[h.line + 1];
  for (std::size_t i = 1; i < next.size(); ++i) next[i] += next[i - 1];
  std::vector<MeshHit> ordered(next.back());
  for (std::vector<Hit>& hits : found) {
    for (const Hit& h : hits) ordered[next[h.line]++] = {h.place, h.turn, h.triangle};
    hits = std::vector<Hit>();  // frees the memory of the copied hits before the next list of hits is copied
  }
  Family& all = families_[std::size_t(family)];
  all.first.assign(next.size(), 0);
  const auto within = [&](int axis, double place) {
    return !window || (place > along(window->least, axis) && place < along(window->most, axis));
  };
  for (std::size_t line = 0; line + 1 < next.size(); ++line) {
    const std::size_t first = all.ranges.size(), from = line == 0 ? 0 : next[line - 1];
    if (next[line] > from && within(axis_u, all_u[line % all_u.size()]) && within(axis_v, all_v[line / all_u.size()])) {
      take_ranges(ordered.data() + from, ordered.data() + next[line], all.ranges);
      if (window) clip(all.ranges, first, along(window->least, family), along(window->most, family));
    }
    all.first[line + 1] = all.ranges.size();
  }
}

std::span<const LineRange> PartLines::of(BrickPlace brick, int family, int line) const {
  const std::array<int, 3> place{brick.x, brick.y, brick.z};
  const std::size_t axis_u = std::size_t(family + 1) % 3, axis_v = std::size_t(family + 2) % 3;
  const std::size_t u = std::size_t((place[axis_u] - first_[axis_u]) * brick_edge + line % brick_edge),
                    v = std::size_t((place[axis_v] - first_[axis_v]) * brick_edge + line / brick_edge);
  const Family& all = families_[std::size_t(family)];
  const std::size_t number = v * places_[axis_u].size() + u;
  return {all.ranges.data() + all.first[number], all.ranges.data() + all.first[number + 1]};
}

/// Returns the memory in bytes for an estimated number of hits. Lines along an axis meet a triangle about as often as the triangle's area,
/// seen along the axis, contains lattice cells. For a triangle that extends out of the lattice, the part of its bounding rectangle inside
/// the lattice is used instead.
double PartLines::bytes(const Mesh& solid, const Lattice& lattice) {
  // The factor 2 is needed because a vector may reserve twice the memory of its content.
  constexpr double bytes_of_hit = 2 * (sizeof(Hit) + sizeof(MeshHit));
  double hits = 0;
  for (std::size_t t = 0; t < solid.triangle_count(); ++t) {
    const Vec3 a = solid.corner(t, 0), b = solid.corner(t, 1), c = solid.corner(t, 2), normal = cross(b - a, c - a);
    double within[3];  // extent of the triangle inside the lattice along each axis, mm
    bool reaches_out = false;
    for (int d = 0; d < 3; ++d) {
      const double least = std::min({along(a, d), along(b, d), along(c, d)}), most = std::max({along(a, d), along(b, d), along(c, d)});
      const double begin = along(lattice.origin(), d) + lattice.first(d) * lattice.edge(),
                   end = along(lattice.origin(), d) + (lattice.last(d) + 1) * lattice.edge();
      reaches_out = reaches_out || least < begin || most > end;
      within[d] = std::max(std::min(most, end) - std::max(least, begin), 0.0);
    }
    for (int d = 0; d < 3; ++d) hits += reaches_out ? within[(d + 1) % 3] * within[(d + 2) % 3] : std::fabs(along(normal, d)) / 2;
  }
  return hits / (lattice.cell() * lattice.cell()) * bytes_of_hit;
}

}  // namespace kadr
