// Sorts the triangles of a mesh into the squares of a grid in the plane across the lines, so that a line is intersected only with the
// triangles of its square. Used by stock/blank/mesh_blank and stock/mesh/mesh_repair.

#include "stock/mesh/mesh_index.h"

#include <algorithm>
#include <cmath>

namespace kadr {
namespace {

// Greatest mean number of grid squares that contain the same triangle. If long triangles cross more squares, a coarser grid is used.
constexpr double max_entries = 6;

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
    if (columns_ * rows_ == 1 || double(entries()) <= max_entries * triangles) break;
  }
  fill();
}

void MeshIndex::hits(double u, double v, std::vector<MeshHit>& hits) const {
  const std::size_t square = std::size_t(row(v)) * columns_ + column(u);
  TriangleRow across;
  for (std::uint32_t i = first_[square]; i < first_[square + 1]; ++i)
    if (TriangleAcross(*mesh_, triangles_[i], family_).row(v, across) && across.holds(u))
      hits.push_back({across.place(u), across.turn, triangles_[i]});
}

}  // namespace kadr
