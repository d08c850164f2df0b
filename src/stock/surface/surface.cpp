// Computes the surface of a stock brick by brick, and joins the results to one mesh, with which the cut part is displayed or measured.

#include "stock/surface/surface.h"

#include <algorithm>
#include <atomic>
#include <memory>

#include "base/thread.h"
#include "stock/surface/surface_part.h"

namespace kadr {
namespace {

using Parts = std::vector<std::unique_ptr<SurfacePart>>;

constexpr std::size_t bricks_at_once = 512;                   // number of bricks whose points are computed before their points are joined
constexpr std::size_t points_expected = brick_lines / 2 * 3;  // estimated number of points in a brick with a surface

/// Calls `work` once for each index; any of the threads may execute the call.
template <class Work>
void each_in_parallel(int threads, std::size_t count, const Work& work) {
  std::atomic<std::size_t> next{0};
  run_parallel(threads, [&](int thread) {
    for (std::size_t i; (i = next++) < count;) work(i, thread);
  });
}

struct Joiner {
  const Lattice& lattice;
  const Parts& parts;
  Surface& surface;

  std::uint32_t point_of(BrickPlace brick, std::array<int, 3> cell, int edge) const;
  void put_face(std::size_t brick, const CrossedEdge& edge, std::uint32_t* to) const;
  double apart_squared(std::uint32_t a, std::uint32_t b) const;
};

/// Returns the number, in the whole mesh, of the point for the sheet that contains the edge `edge` of a cell. The indices `cell` are
/// counted from the corner of `brick`; an index of -1 means the neighbouring brick.
std::uint32_t Joiner::point_of(BrickPlace brick, std::array<int, 3> cell, int edge) const {
  std::array<int*, 3> place{&brick.x, &brick.y, &brick.z};
  for (std::size_t d = 0; d < 3; ++d)
    if (cell[d] < 0) cell[d] += brick_edge, --*place[d];
  // The corners of this cell differ, so the surface crosses the cell: its brick is in the lattice and has a SurfacePart.
  return parts[lattice.at(brick)]->point_of(cell, edge);
}

double Joiner::apart_squared(std::uint32_t a, std::uint32_t b) const {
  const Vec3 d = surface.point(a) - surface.point(b);
  return d.x * d.x + d.y * d.y + d.z * d.z;
}

/// Appends two triangles between the points of the four cells around the edge. The shorter diagonal divides the area between the points.
void Joiner::put_face(std::size_t brick, const CrossedEdge& e, std::uint32_t* to) const {
  const int f = e.family;
  const std::size_t u = std::size_t(f + 1) % 3, v = std::size_t(f + 2) % 3;
  std::array<std::uint32_t, 4> round;
  for (int i = 0; i < 4; ++i) {  // The four cells around a cell edge are visited counter-clockwise about the axis of the edge.
    const int before_u = i == 1 || i == 2, before_v = i >= 2;
    std::array<int, 3> cell{e.x, e.y, e.z};
    cell[u] -= before_u, cell[v] -= before_v;
    round[std::size_t(i)] = point_of(lattice.place(brick), cell, 4 * f + before_u + 2 * before_v);
  }
  if (!e.leaves) std::swap(round[1], round[3]);
  const auto [a, b, c, d] = round;
  const bool across = apart_squared(a, c) <= apart_squared(b, d);
  const std::array<std::uint32_t, 6> corners = across ? std::array{a, b, c, a, c, d} : std::array{a, b, d, b, c, d};
  std::copy(corners.begin(), corners.end(), to);
}

/// Appends the points of a SurfacePart (the surface in one brick) to a surface, and deletes them from the SurfacePart.
void take_points(SurfacePart& part, Surface& surface) {
  part.base = std::uint32_t(surface.made_by.size());
  surface.points.insert(surface.points.end(), part.points.begin(), part.points.end());
  surface.made_by.insert(surface.made_by.end(), part.made_by.begin(), part.made_by.end());
  // Assigning a new vector also frees the memory of the points.
  part.points = std::vector<float>(), part.made_by = std::vector<std::int32_t>();
}

/// Returns true if triangles of the stock may have corners in a brick: in one of its own, or in the next one before these.
bool has_corners(const Stock& stock, std::size_t brick) {
  const BrickPlace p = stock.lattice().place(brick);
  const BrickBox& own = stock.own();
  return p.x < own.end[0] && p.y < own.end[1] && p.z < own.end[2];
}

bool is_own(const Stock& stock, std::size_t brick) { return stock.own().holds(stock.lattice().place(brick)); }

/// Appends the points of neighbouring portions.
void append_others(const Stock& stock, const Surface& others, const Parts& parts, Surface& surface) {
  const std::uint32_t own = std::uint32_t(surface.made_by.size());
  for (std::size_t i = 0; i < parts.size(); ++i)
    if (parts[i] && !is_own(stock, i)) parts[i]->base += own;
  surface.points.insert(surface.points.end(), others.points.begin(), others.points.end());
  surface.made_by.insert(surface.made_by.end(), others.made_by.begin(), others.made_by.end());
  surface.others_points = others.made_by.size();
}

/// Computes the SurfacePart of each brick, and moves the points to the whole surface in batches, so that the points are not stored twice.
Parts parts_of(const Stock& stock, Surface& surface) {
  std::vector<ToolFaces> tools;
  for (std::size_t i = 0; i < stock.tools(); ++i) tools.push_back(faces_of(stock.tool(i)));
  Parts parts(stock.lattice().size());
  std::size_t cut = 0;
  for (std::size_t i = 0; i < parts.size(); ++i) cut += stock.state(i) == Stock::State::mixed;
  // The memory of all points is reserved in advance. Reserved memory costs nothing until it is used, but a vector that grows leaves freed
  // blocks in the heap.
  surface.points.reserve(3 * cut * points_expected), surface.made_by.reserve(cut * points_expected);
  std::vector<PartWork> works(std::size_t(stock.threads()));
  Surface others;
  for (std::size_t first = 0; first < parts.size(); first += bricks_at_once) {
    const std::size_t count = std::min(bricks_at_once, parts.size() - first);
    each_in_parallel(stock.threads(), count, [&](std::size_t i, int thread) {
      if (has_corners(stock, first + i)) parts[first + i] = surface_part(stock, tools, first + i, works[std::size_t(thread)]);
    });
    for (std::size_t i = first; i < first + count; ++i)
      if (parts[i]) take_points(*parts[i], is_own(stock, i) ? surface : others);
  }
  if (stock.is_portion()) append_others(stock, others, parts, surface);
  return parts;
}

}  // namespace

Surface surface_of(const Stock& stock) {
  Surface surface;
  const Parts parts = parts_of(stock, surface);
  std::vector<std::size_t> first_face(parts.size());
  std::size_t faces = 0;
  for (std::size_t i = 0; i < parts.size(); ++i) {
    if (!parts[i] || !is_own(stock, i)) continue;
    first_face[i] = faces, faces += parts[i]->edges.size();
    if (stock.is_portion())
      surface.bricks.push_back(
          {stock.lattice().number(stock.lattice().place(i)), parts[i]->base, 2 * first_face[i], 2 * parts[i]->edges.size()});
  }
  surface.triangles.resize(6 * faces);
  const Joiner joiner{stock.lattice(), parts, surface};
  each_in_parallel(stock.threads(), parts.size(), [&](std::size_t i, int) {
    if (!parts[i] || !is_own(stock, i)) return;
    std::uint32_t* to = surface.triangles.data() + 6 * first_face[i];
    for (const CrossedEdge& e : parts[i]->edges) joiner.put_face(i, e, to), to += 6;
  });
  return surface;
}

}  // namespace kadr
