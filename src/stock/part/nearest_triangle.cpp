// A tree of boxes over triangles. For stock/part/part_compare.

#include "stock/part/nearest_triangle.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "stock/part/triangle_distance.h"

namespace kadr {
namespace {

constexpr std::ptrdiff_t leaf_triangles = 4;
constexpr double more_than_rounding = 1 + 1e-9;  // of a square of a distance
constexpr double hair_squared = 1e-18;           // mm²

/// Of the middle, three times.
double middle_along(const Mesh& mesh, std::uint32_t triangle, int axis) {
  double sum = 0;
  for (std::size_t k = 0; k < 3; ++k) sum += along(mesh.corner(triangle, k), axis);
  return sum;
}

}  // namespace

double NearestTriangle::square_to(const Triangle& t, const Vec3& p) {
  Vec3 corner[3];
  for (int k = 0; k < 3; ++k) corner[k] = Vec3{double(t.corner[k][0]), double(t.corner[k][1]), double(t.corner[k][2])} - p;
  return square_to_triangle(corner);
}

double NearestTriangle::square_to(const Node& n, const Vec3& p) {
  double sum = 0;
  for (int d = 0; d < 3; ++d) {
    const double place = along(p, d), off = std::max({double(n.least[d]) - place, place - double(n.most[d]), 0.0});
    sum += off * off;
  }
  return sum;
}

void NearestTriangle::put_leaf(const Mesh& mesh, Node& node, const std::uint32_t* first, const std::uint32_t* last) {
  node.first = std::uint32_t(triangles_.size()), node.count = std::uint32_t(last - first);
  for (const std::uint32_t* t = first; t != last; ++t) {
    Triangle& triangle = triangles_.emplace_back();
    for (std::size_t k = 0; k < 3; ++k)
      for (std::size_t d = 0; d < 3; ++d) triangle.corner[k][d] = mesh.points[3 * std::size_t(mesh.triangles[3 * std::size_t(*t) + k]) + d];
  }
}

void NearestTriangle::build(const Mesh& mesh, std::uint32_t* first, std::uint32_t* last) {
  const std::size_t at = nodes_.size();
  Node node{{1e30f, 1e30f, 1e30f}, {-1e30f, -1e30f, -1e30f}, 0, 0};
  for (const std::uint32_t* t = first; t != last; ++t)
    for (std::size_t k = 0; k < 3; ++k)
      for (std::size_t d = 0; d < 3; ++d) {
        const float place = mesh.points[3 * std::size_t(mesh.triangles[3 * std::size_t(*t) + k]) + d];
        node.least[d] = std::min(node.least[d], place), node.most[d] = std::max(node.most[d], place);
      }
  if (last - first <= leaf_triangles) {
    put_leaf(mesh, node, first, last);
    nodes_.push_back(node);
    return;
  }
  nodes_.push_back(node);
  int axis = 0;
  for (int d = 1; d < 3; ++d)
    if (node.most[d] - node.least[d] > node.most[axis] - node.least[axis]) axis = d;
  std::uint32_t* const middle = first + (last - first) / 2;
  std::nth_element(first, middle, last, [&](std::uint32_t a, std::uint32_t b) {
    const double to_a = middle_along(mesh, a, axis), to_b = middle_along(mesh, b, axis);
    return to_a != to_b ? to_a < to_b : a < b;
  });
  build(mesh, first, middle);
  nodes_[at].first = std::uint32_t(nodes_.size());
  build(mesh, middle, last);
}

NearestTriangle::NearestTriangle(const Mesh& mesh) {
  std::vector<std::uint32_t> order(mesh.triangle_count());
  std::iota(order.begin(), order.end(), 0U);
  triangles_.reserve(order.size());
  nodes_.reserve(order.size());
  build(mesh, order.data(), order.data() + order.size());
}

double NearestTriangle::distance(const Vec3& point, std::uint32_t& hint) const {
  struct Waiting {
    std::uint32_t node;
    double square;
  };
  double best = square_to(triangles_[hint], point);
  const auto is_farther = [&](double square) { return square > best * more_than_rounding + hair_squared; };
  Waiting stack[64];  // halves of 2³² triangles lie no deeper than 32
  int waiting = 0;
  stack[waiting++] = {0, square_to(nodes_[0], point)};
  while (waiting > 0) {
    const Waiting next = stack[--waiting];
    if (is_farther(next.square)) continue;
    const Node& node = nodes_[next.node];
    for (std::uint32_t t = node.first; t < node.first + node.count; ++t) {
      const double square = square_to(triangles_[t], point);
      if (square < best) best = square, hint = t;
    }
    if (node.count != 0) continue;
    Waiting near{next.node + 1, square_to(nodes_[next.node + 1], point)}, far{node.first, square_to(nodes_[node.first], point)};
    if (far.square < near.square) std::swap(near, far);
    if (!is_farther(far.square)) stack[waiting++] = far;
    if (!is_farther(near.square)) stack[waiting++] = near;
  }
  return std::sqrt(best);
}

}  // namespace kadr
