// Computes a vertex that fits the tangent planes of its crossings best, by least squares. Used by stock/surface.

#include "stock/surface/cell_vertex.h"

#include <algorithm>

namespace kadr {
namespace {

/// Weight of the mean of the crossings in the least-squares fit; the weight of one tangent plane is 1. If normals differ by less than the
/// square root of this weight, about 3°, the surface counts as flat.
constexpr double weight_of_middle = 0.003;

/// Least length of the mean of the unit normals of a smooth face: normals that differ by less than about 40° belong to one face.
constexpr double smooth_mean = 0.94;

/// In a concave region, the vertex is between two points: the mean of the crossings, which is on a chord (fraction 0), and the point where
/// the tangent planes meet (fraction 1). This constant is the fraction for the vertex. The true surface is at the fraction 1/2. Two thirds
/// of the height that the chord between two vertices cuts off are added, so that the flat faces between the vertices enclose as much volume
/// as the curved surface.
constexpr double share_of_tangents = 5.0 / 6;

/// A symmetric matrix, stored as its upper triangle by rows.
struct Symmetric {
  double a, b, c, d, e, f;

  Symmetric inverse() const {
    const double A = d * f - e * e, B = c * e - b * f, C = b * e - c * d, per = 1 / (a * A + b * B + c * C);
    return {A * per, B * per, C * per, (a * f - c * c) * per, (b * c - a * e) * per, (a * d - b * b) * per};
  }
  std::array<double, 3> times(const std::array<double, 3>& v) const {
    return {a * v[0] + b * v[1] + c * v[2], b * v[0] + d * v[1] + e * v[2], c * v[0] + e * v[1] + f * v[2]};
  }
};

}  // namespace

void CellVertex::add(const Crossing& crossing) {
  const double n0 = double(crossing.normal[0]), n1 = double(crossing.normal[1]), n2 = double(crossing.normal[2]);
  const double p0 = double(crossing.at[0]), p1 = double(crossing.at[1]), p2 = double(crossing.at[2]);
  const double far = n0 * p0 + n1 * p1 + n2 * p2;
  square_[0] += n0 * n0, square_[1] += n0 * n1, square_[2] += n0 * n2;
  square_[3] += n1 * n1, square_[4] += n1 * n2, square_[5] += n2 * n2;
  right_[0] += far * n0, right_[1] += far * n1, right_[2] += far * n2;
  normals_[0] += n0, normals_[1] += n1, normals_[2] += n2;
  sum_[0] += p0, sum_[1] += p1, sum_[2] += p2;
  ++count_;
  made_by_ = std::max(made_by_, crossing.by);
}

std::array<double, 3> CellVertex::place(const std::array<double, 3>& low, double cell) const {
  const double middle = weight_of_middle * count_;
  const Symmetric planes{square_[0], square_[1], square_[2], square_[3], square_[4], square_[5]};
  const Symmetric inverse = Symmetric{planes.a + middle, planes.b, planes.c, planes.d + middle, planes.e, planes.f + middle}.inverse();
  const std::array<double, 3> centre{sum_[0] / count_, sum_[1] / count_, sum_[2] / count_};
  std::array<double, 3> at = centre;
  const double turns = normals_[0] * normals_[0] + normals_[1] * normals_[1] + normals_[2] * normals_[2];
  const bool smooth = turns > smooth_mean * smooth_mean * count_ * count_;
  // Each iteration reduces the influence of the mean of the crossings on the vertex.
  for (int round = 0; round < (smooth ? 2 : 4); ++round) {
    const std::array<double, 3> there = planes.times(at);
    const std::array<double, 3> step = inverse.times({right_[0] - there[0], right_[1] - there[1], right_[2] - there[2]});
    for (std::size_t d = 0; d < 3; ++d) at[d] += step[d];
  }
  const double outwards = normals_[0] * (at[0] - centre[0]) + normals_[1] * (at[1] - centre[1]) + normals_[2] * (at[2] - centre[2]);
  if (smooth && outwards < 0)
    for (std::size_t d = 0; d < 3; ++d) at[d] = centre[d] + share_of_tangents * (at[d] - centre[d]);
  for (std::size_t d = 0; d < 3; ++d) at[d] = std::clamp(at[d], low[d], low[d] + cell);
  return at;
}

}  // namespace kadr
