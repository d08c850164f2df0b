// Removes points of a surface by merging each point into a neighbour. Used by stock/surface/simplified_surface.

#include "stock/surface/decimation.h"

#include <algorithm>
#include <cmath>

#include "stock/mesh/point_weld.h"
#include "stock/part/triangle_distance.h"

namespace kadr {
namespace {

constexpr std::uint32_t no_index = ~std::uint32_t{0};
constexpr std::uint32_t most_around = 40;  // greatest permitted number of triangles around a point
constexpr std::size_t max_tried = 3;       // number of neighbours into which a merge of each point is tried, the best neighbour first
// A neighbour is not tried if its distance from the planes around the point is more than this multiple of the permitted distance.
constexpr double worth_trying = 3;
constexpr int max_passes = 60;
constexpr double least_height = 1e-3;  // least ratio of a triangle's height to its longest side: thinner triangles have no reliable normal
constexpr double turned_little = 0.2;  // least cosine of the angle between the normals of a triangle before and after a merge

Vec3 normal_of(const Vec3& a, const Vec3& b, const Vec3& c) { return cross(b - a, c - a); }

}  // namespace

Decimation::Decimation(const Mesh& exact)
    : exact_(exact),
      corners_(exact.triangles),
      first_(exact.point_count() + 1),
      count_(exact.point_count()),
      holds_(exact.triangle_count(), no_index),
      next_(exact.point_count(), no_index),
      waits_(exact.point_count()),
      touched_(exact.point_count()),
      mark_(exact.point_count()) {
  for (const std::uint32_t p : corners_) ++count_[p];
  for (std::size_t p = 0; p < count_.size(); ++p) first_[p + 1] = first_[p] + count_[p];
  around_.resize(corners_.size());
  std::fill(count_.begin(), count_.end(), 0U);
  for (std::size_t i = 0; i < corners_.size(); ++i) around_[first_[corners_[i]] + count_[corners_[i]]++] = std::uint32_t(i / 3);
}

bool Decimation::has(std::uint32_t triangle, std::uint32_t p) const {
  const std::uint32_t* const c = &corners_[3 * std::size_t(triangle)];
  return c[0] == p || c[1] == p || c[2] == p;
}

/// Collects the triangles around the point, and the neighbours of the point.
///   returns  false if the triangles do not form a single closed fan
bool Decimation::look_around(std::uint32_t u) {
  star_.clear(), ring_.clear();
  ++question_;
  for (std::uint32_t i = first_[u]; i < first_[u] + count_[u]; ++i) {
    const std::uint32_t t = around_[i];
    const std::uint32_t* const c = &corners_[3 * std::size_t(t)];
    const Vec3 n = normal_of(point(c[0]), point(c[1]), point(c[2]));
    const double size = std::sqrt(square_of(n));
    star_.push_back({t, size > 0 ? (1 / size) * n : Vec3{}});
    for (int k = 0; k < 3; ++k)
      if (c[k] != u && mark_[c[k]] != question_) mark_[c[k]] = question_, ring_.push_back(c[k]);
  }
  return star_.size() >= 3 && ring_.size() == star_.size();
}

/// Returns true if the surface remains a manifold without doubled edges after u is merged into v. The condition is that the only common
/// neighbours of u and v are the two points that form triangles with both.
bool Decimation::may_go(std::uint32_t u, std::uint32_t v) {
  if (count_[u] + count_[v] - 4 > most_around) return false;
  ++question_;
  for (const std::uint32_t p : ring_) mark_[p] = question_;
  std::uint32_t common = 0, of_both = 0;
  const std::uint32_t met = ++question_;
  for (std::uint32_t i = first_[v]; i < first_[v] + count_[v]; ++i) {
    const bool both = has(around_[i], u);
    of_both += both;
    for (std::size_t k = 0; k < 3; ++k) {
      const std::uint32_t p = corners_[3 * std::size_t(around_[i]) + k];
      if (p == u || p == v) continue;
      if (both && count_[p] <= 3) return false;
      if (mark_[p] == met - 1) ++common, mark_[p] = met;
    }
  }
  return common == 2 && of_both == 2;
}

/// Builds the new triangles of a merge. Returns false if one of these triangles would be turned over or be too thin.
bool Decimation::take_fresh(std::uint32_t u, std::uint32_t v) {
  fresh_.clear();
  for (const Around& a : star_) {
    if (has(a.triangle, v)) continue;
    Fresh f{a.triangle, {}};
    for (std::size_t k = 0; k < 3; ++k) {
      const std::uint32_t p = corners_[3 * std::size_t(a.triangle) + k];
      f.corner[k] = point(p == u ? v : p);
    }
    const Vec3 n = normal_of(f.corner[0], f.corner[1], f.corner[2]);
    const double size = std::sqrt(square_of(n));
    double longest = 0;
    for (std::size_t k = 0; k < 3; ++k) longest = std::max(longest, square_of(f.corner[(k + 1) % 3] - f.corner[k]));
    if (size < least_height * longest || dot(n, a.normal) < turned_little * size) return false;
    fresh_.push_back(f);
  }
  return !fresh_.empty();
}

/// Returns true if u and all points assigned to its triangles are close enough to the new triangles, and finds for each of these points the
/// nearest new triangle.
bool Decimation::hold_all(std::uint32_t u, double most_off) {
  held_.clear();
  const double most = most_off * most_off;
  const auto hold = [&](std::uint32_t p) {
    const Vec3 at = point(p);
    double nearest = 1e300;
    std::size_t by = 0;
    for (std::size_t i = 0; i < fresh_.size(); ++i) {
      const Vec3 seen[3] = {fresh_[i].corner[0] - at, fresh_[i].corner[1] - at, fresh_[i].corner[2] - at};
      const double square = square_to_triangle(seen);
      if (square < nearest) nearest = square, by = i;
    }
    held_.push_back({p, by});
    return nearest <= most;
  };
  if (!hold(u)) return false;
  for (const Around& a : star_)
    for (std::uint32_t p = holds_[a.triangle]; p != no_index; p = next_[p])
      if (!hold(p)) return false;
  return true;
}

void Decimation::drop_from(std::uint32_t p, std::uint32_t triangle) {
  const auto begin = around_.begin() + std::ptrdiff_t(first_[p]), end = begin + std::ptrdiff_t(count_[p]);
  std::copy(std::find(begin, end, triangle) + 1, end, std::find(begin, end, triangle));
  --count_[p];
}

void Decimation::execute(std::uint32_t u, std::uint32_t v) {
  const auto first = std::uint32_t(around_.size());
  for (std::uint32_t i = first_[v], end = first_[v] + count_[v]; i < end; ++i)
    if (const std::uint32_t t = around_[i]; !has(t, u)) around_.push_back(t);
  for (const Around& a : star_) {
    std::uint32_t* const c = &corners_[3 * std::size_t(a.triangle)];
    holds_[a.triangle] = no_index;
    if (!has(a.triangle, v)) {
      std::replace(c, c + 3, u, v);
      around_.push_back(a.triangle);
      continue;
    }
    for (int k = 0; k < 3; ++k)
      if (c[k] != u && c[k] != v) drop_from(c[k], a.triangle);
    std::fill(c, c + 3, no_index);
  }
  first_[v] = first, count_[v] = std::uint32_t(around_.size()) - first;
  count_[u] = 0;
  for (const Held& h : held_) {
    std::uint32_t& holds = holds_[fresh_[h.by].triangle];
    next_[h.point] = holds, holds = h.point;
  }
  for (const std::uint32_t p : ring_) waits_[p] = touched_[p] = 1;
}

bool Decimation::try_point(std::uint32_t u, double most_off) {
  if (!look_around(u)) return false;
  candidates_.clear();
  for (const std::uint32_t v : ring_) {
    const Vec3 delta = point(v) - point(u);
    double off = 0;
    for (const Around& a : star_) off = std::max(off, std::fabs(dot(a.normal, delta)));
    if (off <= worth_trying * most_off) candidates_.push_back({off, v});
  }
  const std::size_t tried = std::min(candidates_.size(), max_tried);
  std::partial_sort(candidates_.begin(), candidates_.begin() + std::ptrdiff_t(tried), candidates_.end(),
                    [](const Candidate& a, const Candidate& b) { return a.off != b.off ? a.off < b.off : a.point < b.point; });
  for (std::size_t i = 0; i < tried; ++i) {
    const std::uint32_t v = candidates_[i].point;
    if (!may_go(u, v) || !take_fresh(u, v) || !hold_all(u, most_off)) continue;
    execute(u, v);
    return true;
  }
  return false;
}

/// Removes points in several passes. Points next to a removed point are not tried again before the next pass, so that the triangles grow
/// evenly and do not form fans.
void Decimation::go(double most_off, const StopToken& stop) {
  std::fill(waits_.begin(), waits_.end(), std::uint8_t{1});
  for (int pass = 0, any = 1; pass < max_passes && any != 0 && !stop.requested(); ++pass) {
    any = 0;
    std::fill(touched_.begin(), touched_.end(), std::uint8_t{0});
    for (std::uint32_t u = 0; u < count_.size(); ++u) {
      if (!waits_[u] || touched_[u] || count_[u] == 0) continue;
      waits_[u] = 0;
      any |= int(try_point(u, most_off));
    }
  }
}

Mesh Decimation::mesh() const {
  Mesh mesh{exact_.points, {}};
  for (std::size_t i = 0; i < corners_.size(); i += 3)
    if (corners_[i] != no_index) mesh.triangles.insert(mesh.triangles.end(), {corners_[i], corners_[i + 1], corners_[i + 2]});
  drop_unused(mesh);
  return mesh;
}

}  // namespace kadr
