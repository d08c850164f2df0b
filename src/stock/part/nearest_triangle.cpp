// A tree of boxes over triangles. For stock/part/part_compare.

#include "stock/part/nearest_triangle.h"

#include <algorithm>
#include <cmath>

#include "stock/cut/lanes.h"
#include "stock/part/triangle_distance.h"

namespace kadr {
namespace {

constexpr std::uint32_t of_triangles = std::uint32_t{1} << 31;
constexpr float nowhere = 1e30f;
constexpr float rounding_of_places = 0x1p-21f;   // of the farthest place: the point's, the box's and their difference's
constexpr double more_than_rounding = 1 + 4e-6;  // of a square of a distance, in single precision
constexpr double hair_squared = 1e-18;           // mm²

/// Boxes that are farther hold nothing nearer.
float limit_of(double square) { return float(square * more_than_rounding + hair_squared); }

/// Half of them, by the middles along the longest side; whole nodes, so that few have room left.
template <class Placed>
Placed* halved(Placed* first, Placed* last) {
  const std::ptrdiff_t count = last - first, nodeful = 4;
  if (count <= 1) return last;
  Placed* const middle = first + (count <= nodeful ? count : (count / 2 + nodeful - 1) / nodeful * nodeful);
  if (middle == last) return last;
  float least[3] = {nowhere, nowhere, nowhere}, most[3] = {-nowhere, -nowhere, -nowhere};
  for (const Placed* p = first; p != last; ++p)
    for (int d = 0; d < 3; ++d) least[d] = std::min(least[d], p->middle[d]), most[d] = std::max(most[d], p->middle[d]);
  int axis = 0;
  for (int d = 1; d < 3; ++d)
    if (most[d] - least[d] > most[axis] - least[axis]) axis = d;
  std::nth_element(first, middle, last, [axis](const Placed& a, const Placed& b) {
    return a.middle[axis] != b.middle[axis] ? a.middle[axis] < b.middle[axis] : a.triangle < b.triangle;
  });
  return middle;
}

}  // namespace

double NearestTriangle::square_to(const Triangle& t, const Vec3& p) {
  Vec3 corner[3];
  for (int k = 0; k < 3; ++k) corner[k] = Vec3{double(t.corner[k][0]), double(t.corner[k][1]), double(t.corner[k][2])} - p;
  return square_to_triangle(corner);
}

std::uint32_t NearestTriangle::put_triangle(const Mesh& mesh, std::uint32_t number, Node& node, int child) {
  Triangle triangle;
  for (std::size_t d = 0; d < 3; ++d) {
    float least = nowhere, most = -nowhere;
    for (std::size_t k = 0; k < 3; ++k) {
      const float place = mesh.points[3 * std::size_t(mesh.triangles[3 * std::size_t(number) + k]) + d];
      triangle.corner[k][d] = place, least = std::min(least, place), most = std::max(most, place);
    }
    node.least[d][child] = least - pad_, node.most[d][child] = most + pad_;
  }
  triangles_.push_back(triangle);
  return of_triangles | std::uint32_t(triangles_.size() - 1);
}

/// Four triangles or fewer are children themselves.
std::uint32_t NearestTriangle::build(const Mesh& mesh, Placed* first, Placed* last) {
  const auto at = std::uint32_t(nodes_.size());
  nodes_.emplace_back();
  Node node;
  std::fill(&node.least[0][0], &node.least[0][0] + 3 * width, nowhere);
  std::fill(&node.most[0][0], &node.most[0][0] + 3 * width, -nowhere);
  std::fill(node.child, node.child + width, of_triangles);
  if (last - first <= width) {
    for (int i = 0; first + i != last; ++i) node.child[i] = put_triangle(mesh, first[i].triangle, node, i);
    return nodes_[at] = node, at;
  }
  Placed* const half = halved(first, last);
  Placed* const parts[width + 1] = {first, halved(first, half), half, halved(half, last), last};
  for (int i = 0; i < width; ++i) {
    if (parts[i] == parts[i + 1]) continue;
    const std::uint32_t child = node.child[i] = build(mesh, parts[i], parts[i + 1]);
    for (int d = 0; d < 3; ++d) {
      const Node& below = nodes_[child];
      node.least[d][i] = *std::min_element(below.least[d], below.least[d] + width);
      node.most[d][i] = *std::max_element(below.most[d], below.most[d] + width);
    }
  }
  return nodes_[at] = node, at;
}

NearestTriangle::NearestTriangle(const Mesh& mesh) {
  float farthest = 0;
  for (const float place : mesh.points) farthest = std::max(farthest, std::fabs(place));
  pad_ = farthest * rounding_of_places;
  std::vector<Placed> order(mesh.triangle_count());
  for (std::size_t t = 0; t < order.size(); ++t) {
    order[t].triangle = std::uint32_t(t);
    for (std::size_t d = 0; d < 3; ++d) {
      float sum = 0;
      for (std::size_t k = 0; k < 3; ++k) sum += mesh.points[3 * std::size_t(mesh.triangles[3 * t + k]) + d];
      order[t].middle[d] = sum;
    }
  }
  triangles_.reserve(order.size());
  nodes_.reserve(order.size() / 5 * 2 + 2);
  build(mesh, order.data(), order.data() + order.size());
}

double NearestTriangle::distance(const Vec3& point, std::uint32_t& hint) const {
  using lanes::Quad;
  struct Waiting {
    float square;
    std::uint32_t child;
  };
  const std::uint32_t began = hint;
  double best = square_to(triangles_[began], point);
  float limit = limit_of(best);
  const Quad none{}, place[3] = {none + float(point.x), none + float(point.y), none + float(point.z)};
  Waiting stack[64];  // quarters of 2³¹ triangles lie no deeper than 16
  int waiting = 0;
  stack[waiting++] = {0, 0};
  while (waiting > 0) {
    const Waiting next = stack[--waiting];
    if (next.square > limit) continue;
    if ((next.child & of_triangles) != 0) {
      const std::uint32_t t = next.child & ~of_triangles;
      if (t == began) continue;
      const double square = square_to(triangles_[t], point);
      if (square < best) best = square, limit = limit_of(best), hint = t;
      continue;
    }
    const Node& node = nodes_[next.child];
    Quad sum{};
    for (int d = 0; d < 3; ++d) {
      const Quad below = *reinterpret_cast<const Quad*>(node.least[d]) - place[d],
                 above = place[d] - *reinterpret_cast<const Quad*>(node.most[d]);
      Quad off = below > above ? below : above;
      off = off > none ? off : none;
      sum += off * off;
    }
    // Whether a box is near enough cannot be foreseen: so all are put down, and those that are too far written over.
    const int first = waiting;
    for (int i = 0; i < width; ++i) {
      stack[waiting] = {sum[i], node.child[i]};
      waiting += int(sum[i] <= limit);
    }
    if (waiting < first + 2) continue;
    int nearest = first;
    for (int i = first + 1; i < waiting; ++i) nearest = stack[i].square < stack[nearest].square ? i : nearest;
    std::swap(stack[nearest], stack[waiting - 1]);  // on top
  }
  return std::sqrt(best);
}

}  // namespace kadr
