// Builds the outline of the area that an insert sweeps, and intersects it with lines. Used by stock/cut/ring_cut.

#include "stock/cut/ring_sweep.h"

#include <algorithm>
#include <cmath>

namespace kadr {
namespace {

InsertPoint moved(const InsertPoint& p, const InsertPoint& by, double k = 1) { return {p.x + k * by.x, p.z + k * by.z}; }

double inner(const InsertPoint& a, const InsertPoint& b) { return a.x * b.x + a.z * b.z; }

/// Returns a coordinate of a point on a straight edge of which the other coordinate, `at`, is known.
double along_edge(double from, double per, double at, double other_from, double other_to) {
  const double share = std::clamp((at - from) * per, 0.0, 1.0);
  return other_from + share * (other_to - other_from);
}

bool is_between(double at, double a, double b) { return at >= std::min(a, b) && at <= std::max(a, b); }

}  // namespace

RingRange folded(const RingRange& x) {
  if (x.none()) return {};
  if (x.from <= 0 && x.to >= 0) return {0, std::max(-x.from, x.to)};
  return {std::min(std::fabs(x.from), std::fabs(x.to)), std::max(std::fabs(x.from), std::fabs(x.to))};
}

RingSweep::RingSweep(const InsertBody& body, const InsertPoint& from, const InsertPoint& to) {
  const std::size_t n = body.corners.size();
  const InsertPoint delta{to.x - from.x, to.z - from.z};
  const double far = std::sqrt(inner(delta, delta));
  const InsertPoint right =
      // Unit vector perpendicular to the path, to its right. In counter-clockwise order, the normals of the outline in the half circle
      // after this vector point ahead along the path.
      far > 0 ? InsertPoint{delta.z / far, -delta.x / far} : InsertPoint{};
  std::vector<InsertCorner> corners;
  std::vector<InsertPoint> outward;
  for (std::size_t k = 0; k < n; ++k) {
    const InsertCorner& c = body.corners[k];
    const double before = inner(body.outward[(k + n - 1) % n], delta), after = inner(body.outward[k], delta);
    const auto put = [&](bool ahead, const InsertPoint& normal) {
      corners.push_back({moved(c.centre, ahead ? to : from), c.radius});
      outward.push_back(normal);
    };
    const bool splits = (before < 0 && after > 0) || (before > 0 && after < 0);
    if (splits) put(before > 0, before < 0 ? right : InsertPoint{-right.x, -right.z});
    put(splits ? after > 0 : before >= 0 && after >= 0, body.outward[k]);
  }
  for (std::size_t k = 0; k < corners.size(); ++k) {
    const std::size_t next = (k + 1) % corners.size();
    add_edge(corners[k], corners[next], outward[k]);
    if (corners[k].radius > 0)
      arcs_.push_back({corners[k].centre, corners[k].radius, outward[(k + corners.size() - 1) % corners.size()], outward[k]});
  }
}

void RingSweep::add_edge(const InsertCorner& a, const InsertCorner& b, const InsertPoint& outward) {
  const InsertPoint from = moved(a.centre, outward, a.radius), to = moved(b.centre, outward, b.radius);
  const double x = to.x - from.x, z = to.z - from.z;
  edges_.push_back({from, to, outward, x != 0 ? 1 / x : 0, z != 0 ? 1 / z : 0});
}

/// Returns the heights swept at the signed radius x. The circles of the rounded corners lie wholly inside the swept area, so whole circles
/// can be used instead of arcs.
RingRange RingSweep::at_x(double x) const {
  RingRange range;
  for (const Edge& e : edges_) {
    if (!is_between(x, e.from.x, e.to.x)) continue;
    range.include(along_edge(e.from.x, e.per_x, x, e.from.z, e.to.z));
    if (e.per_x == 0) range.include(e.to.z);
  }
  for (const Arc& a : arcs_) {
    const double aside = std::fabs(x - a.centre.x);
    if (aside > a.radius) continue;
    const double half = std::sqrt((a.radius - aside) * (a.radius + aside));
    range.include(a.centre.z - half), range.include(a.centre.z + half);
  }
  return range;
}

RingRange RingSweep::at_z(double z) const {
  RingRange range;
  for (const Edge& e : edges_) {
    if (!is_between(z, e.from.z, e.to.z)) continue;
    range.include(along_edge(e.from.z, e.per_z, z, e.from.x, e.to.x));
    if (e.per_z == 0) range.include(e.to.x);
  }
  for (const Arc& a : arcs_) {
    const double aside = std::fabs(z - a.centre.z);
    if (aside > a.radius) continue;
    const double half = std::sqrt((a.radius - aside) * (a.radius + aside));
    range.include(a.centre.x - half), range.include(a.centre.x + half);
  }
  return range;
}

RingRange RingSweep::between(double low, double high) const {
  RingRange range;
  for (const double z : {low, high}) {
    const RingRange end = at_z(z);
    if (end.from <= end.to) range.include(end.from), range.include(end.to);
  }
  for (const Edge& e : edges_)
    for (const InsertPoint& p : {e.from, e.to})
      if (is_between(p.z, low, high)) range.include(p.x);
  for (const Arc& a : arcs_)
    if (is_between(a.centre.z, low, high)) range.include(a.centre.x - a.radius), range.include(a.centre.x + a.radius);
  return range;
}

RingRange RingSweep::heights() const {
  RingRange range;
  for (const Edge& e : edges_) range.include(e.from.z), range.include(e.to.z);
  for (const Arc& a : arcs_) range.include(a.centre.z - a.radius), range.include(a.centre.z + a.radius);
  return range;
}

}  // namespace kadr
