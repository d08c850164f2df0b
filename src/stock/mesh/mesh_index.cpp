// A grid of squares across the lines. For stock/blank/mesh_blank and stock/mesh/mesh_repair.

#include "stock/mesh/mesh_index.h"

#include <algorithm>
#include <cmath>

namespace kadr {
namespace {

constexpr double most_entries = 6;  // of a triangle, on average: long ones across many squares make the grid coarser

/// A corner as it lies to the lines: in the plane across them, and along them.
struct Corner {
  double u, v, w;
};

/// Where an edge is at a place `v` of the plane. By the lower end first, whichever way the triangle goes: two triangles get the same bits.
struct EdgePlace {
  double u, w;
};
EdgePlace edge_place(const Corner& low, const Corner& high, double v) {
  const double share = (v - low.v) / (high.v - low.v);
  const auto between = [&](double a, double b) { return std::clamp(a + share * (b - a), std::min(a, b), std::max(a, b)); };
  return {between(low.u, high.u), between(low.w, high.w)};
}

/// Two edges of a triangle reach over `v`, one upwards and one downwards, or none does.
bool hit_of(const Mesh& mesh, std::size_t triangle, int family, double u, double v, MeshHit& hit) {
  const std::size_t axis_u = std::size_t(family + 1) % 3, axis_v = std::size_t(family + 2) % 3, axis_w = std::size_t(family);
  const float* corner[3];
  int below = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    corner[k] = &mesh.points[3 * std::size_t(mesh.triangles[3 * triangle + k])];
    below += double(corner[k][axis_v]) <= v;
  }
  if (below == 0 || below == 3) return false;
  EdgePlace left{}, right{};
  int turns = 0, right_of_it = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    const float *const p = corner[k], *const q = corner[(k + 1) % 3];
    const Corner a{double(p[axis_u]), double(p[axis_v]), double(p[axis_w])}, b{double(q[axis_u]), double(q[axis_v]), double(q[axis_w])};
    const bool upwards = a.v <= v;
    if (upwards == (b.v <= v)) continue;
    const EdgePlace place = upwards ? edge_place(a, b, v) : edge_place(b, a, v);
    if (u < place.u) right = place, turns += upwards ? 1 : -1, ++right_of_it;
    else left = place;
  }
  if (right_of_it != 1) return false;
  const double share = (u - left.u) / (right.u - left.u);
  hit = {left.w + share * (right.w - left.w), -turns, std::uint32_t(triangle)};
  return true;
}

}  // namespace

std::uint32_t MeshIndex::at(double place, double least, double per, std::uint32_t count) {
  const double square = (place - least) * per;
  return square <= 0 ? 0 : std::min(std::uint32_t(std::min(square, 4e9)), count - 1);
}

void MeshIndex::set_grid(const Box3& box, double squares) {
  const double wide = along(box.most, (family_ + 1) % 3) - least_u_, deep = along(box.most, (family_ + 2) % 3) - least_v_;
  const double edge = std::sqrt(std::max(wide * deep / squares, 1e-12));
  columns_ = std::uint32_t(std::clamp(wide / edge, 1.0, squares));
  rows_ = std::uint32_t(std::clamp(deep / edge, 1.0, std::max(squares / columns_, 1.0)));
  per_u_ = wide > 0 ? columns_ / wide : 0;
  per_v_ = deep > 0 ? rows_ / deep : 0;
}

template <class Visit>
void MeshIndex::each_square(std::size_t triangle, const Visit& visit) const {
  double least[2] = {1e300, 1e300}, most[2] = {-1e300, -1e300};
  for (std::size_t k = 0; k < 3; ++k)
    for (int d = 0; d < 2; ++d) {
      const double place = along(mesh_->corner(triangle, k), (family_ + 1 + d) % 3);
      least[d] = std::min(least[d], place), most[d] = std::max(most[d], place);
    }
  visit(Extent{column(least[0]), column(most[0])}, Extent{row(least[1]), row(most[1])});
}

std::size_t MeshIndex::entries() const {
  std::size_t sum = 0;
  for (std::size_t t = 0; t < mesh_->triangle_count(); ++t)
    each_square(t, [&](Extent u, Extent v) { sum += std::size_t(u.last - u.first + 1) * (v.last - v.first + 1); });
  return sum;
}

void MeshIndex::fill() {
  first_.assign(std::size_t(columns_) * rows_ + 1, 0);
  const auto each = [&](const auto& visit) {
    for (std::size_t t = 0; t < mesh_->triangle_count(); ++t)
      each_square(t, [&](Extent u, Extent v) {
        for (std::uint32_t r = v.first; r <= v.last; ++r)
          for (std::uint32_t c = u.first; c <= u.last; ++c) visit(std::size_t(r) * columns_ + c, std::uint32_t(t));
      });
  };
  each([&](std::size_t square, std::uint32_t) { ++first_[square + 1]; });
  for (std::size_t i = 1; i < first_.size(); ++i) first_[i] += first_[i - 1];
  triangles_.resize(first_.back());
  std::vector<std::uint32_t> next(first_.begin(), first_.end() - 1);
  each([&](std::size_t square, std::uint32_t t) { triangles_[next[square]++] = t; });
}

MeshIndex::MeshIndex(const Mesh& mesh, int family) : mesh_(&mesh), family_(family) {
  const Box3 box = box_of(mesh);
  least_u_ = along(box.least, (family + 1) % 3), least_v_ = along(box.least, (family + 2) % 3);
  const double triangles = double(std::max<std::size_t>(mesh.triangle_count(), 1));
  for (double squares = triangles;; squares = std::max(squares / 4, 1.0)) {
    set_grid(box, squares);
    if (columns_ * rows_ == 1 || double(entries()) <= most_entries * triangles) break;
  }
  fill();
}

void MeshIndex::hits(double u, double v, std::vector<MeshHit>& hits) const {
  const std::size_t square = std::size_t(row(v)) * columns_ + column(u);
  MeshHit hit{};
  for (std::uint32_t i = first_[square]; i < first_[square + 1]; ++i)
    if (hit_of(*mesh_, triangles_[i], family_, u, v, hit)) hits.push_back(hit);
}

}  // namespace kadr
