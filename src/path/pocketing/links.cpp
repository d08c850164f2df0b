// This file computes paths from one pass to the next pass without lifting the tool. Used by path/pocketing/layers and
// path/pocketing/plunge_ramp.

#include "path/pocketing/links.h"

#include <algorithm>
#include <cmath>

#include "base/tolerance.h"

namespace kadr::area {
namespace {

/// A position on a ring (a closed path).
struct Place {
  std::size_t edge = 0;
  double part = 0;
  double far = 1e300;  // distance, mm, between this position and the point to which it is nearest
};

Place nearest(const Edges& ring, Vec2 p) {
  Place best;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const double part = nearest_part(ring[i], p), far = length(at(ring[i], part) - p);
    if (far < best.far) best = {i, part, far};
  }
  return best;
}

/// Returns the position that is `by` mm farther along the ring.
Place ahead(const Edges& ring, Place place, double by) {
  by += place.part * length_of(ring[place.edge]);
  while (by > length_of(ring[place.edge])) {
    by -= length_of(ring[place.edge]);
    place.edge = (place.edge + 1) % ring.size();
  }
  place.part = by / length_of(ring[place.edge]);
  return place;
}

/// Returns the shorter of the two paths along a loop between two positions.
Edges around(const Edges& loop, const Place& from, const Place& to) {
  const Edges ring = begun_at(loop, from.edge, from.part);
  const Place end = nearest(ring, at(loop[to.edge], to.part));
  Edges forth(ring.begin(), ring.begin() + static_cast<std::ptrdiff_t>(end.edge));
  forth.push_back(section(ring[end.edge], 0, end.part));
  Edges back{section(ring[end.edge], end.part, 1)};
  back.insert(back.end(), ring.begin() + static_cast<std::ptrdiff_t>(end.edge) + 1, ring.end());
  return length_of(forth) <= length_of(back) ? forth : reversed(back);
}

void drop_points(Edges& path) {
  std::erase_if(path, [](const Edge& e) { return length(e.to - e.from) < tol::same_point; });
}

constexpr double shares[] = {1, 0.5, 0.25};  // Radii of the arcs to try, as fractions of the largest radius.

Edge quarter(Vec2 from, Vec2 tangent, double radius, double side) {
  const Vec2 normal{-side * tangent.y, side * tangent.x};
  return {from, from + radius * tangent + radius * normal, side * std::tan(pi / 8)};
}

}  // namespace

std::optional<Edges> double_arc(Vec2 from, Vec2 out, Vec2 to, Vec2 in) {
  const Vec2 delta = to - from;
  const double a = 2 * (1 - dot(out, in)), b = dot(delta, out + in), c = dot(delta, delta);
  if (!(b > 0)) return std::nullopt;
  const double reach = a < tol::tangential ? c / (2 * b) : (std::sqrt(b * b + a * c) - b) / a;
  const Vec2 middle = 0.5 * (from + to + reach * (out - in));
  if (!(dot(middle - from, out) > 0) || !(dot(to - middle, in) > 0)) return std::nullopt;
  Edges path = tangent_arc(from, out, middle);
  const Edges second = reversed(tangent_arc(to, -1.0 * in, middle));
  path.insert(path.end(), second.begin(), second.end());
  return path;
}

std::optional<Edges> link_between(const Field& field, Vec2 from, Vec2 to, double detour) {
  const Edges straight{{from, to}};
  if (length(to - from) < tol::same_point) return Edges();
  if (holds(field, straight)) return straight;
  for (const Edges& loop : field.reach) {
    const Place a = nearest(loop, from), b = nearest(loop, to);
    Edges path = around(loop, a, b);
    path.insert(path.begin(), {from, at(loop[a.edge], a.part)});
    path.push_back({at(loop[b.edge], b.part), to});
    drop_points(path);
    if (length_of(path) <= length_of(straight) + detour && holds(field, path)) return path;
  }
  return std::nullopt;
}

Edges begun_near(const Edges& ring, Vec2 p) {
  const Place place = nearest(ring, p);
  return begun_at(ring, place.edge, place.part);
}

Edges begun_at_longest(const Edges& ring) {
  const auto longest = std::max_element(ring.begin(), ring.end(),
                                        [](const Edge& a, const Edge& b) { return length_of(a) < length_of(b) - tol::same_point; });
  return begun_at(ring, static_cast<std::size_t>(longest - ring.begin()), 0.5);
}

std::optional<PassStart> pass_start_from(const Field& field, const Job& job, const Pass& pass, Vec2 from, std::optional<Vec2> out) {
  const double detour = 6 * job.radius;  // A detour of this length, mm, takes less time than a lift.
  if (!pass.closed) {
    const bool turn = !pass.lifted && length(pass.path.back().to - from) < length(pass.path.front().from - from);
    PassStart begun{{}, turn ? reversed(pass.path) : pass.path};
    const auto link = link_between(field, from, begun.path.front().from, detour);
    if (!link) return std::nullopt;
    begun.link = *link;
    return begun;
  }
  const Place near = nearest(pass.path, from);
  if (out && near.far > tol::same_point) {
    const Place place = ahead(pass.path, near, std::min(1.5 * near.far, length_of(pass.path) / 4));
    const Edge& e = pass.path[place.edge];
    const auto arcs = double_arc(from, *out, at(e, place.part), direction(e, place.part));
    if (arcs && near.far < 2 * job.step && holds(field, *arcs)) return PassStart{*arcs, begun_at(pass.path, place.edge, place.part)};
  }
  const auto link = link_between(field, from, at(pass.path[near.edge], near.part), detour);
  if (!link) return std::nullopt;
  return PassStart{*link, begun_at(pass.path, near.edge, near.part)};
}

std::optional<Edge> arc_into(const Field& field, const Job& job, const Edges& path) {
  const Vec2 tangent = direction(path.front(), 0);
  for (const double share : shares)
    for (const double side : {-1.0, 1.0}) {
      const Edge arc = reversed(quarter(path.front().from, -1.0 * tangent, share * job.radius, side));
      if (holds(field, {arc})) return arc;
    }
  return std::nullopt;
}

std::optional<Edge> arc_out_of(const Field& field, const Job& job, const Edges& path) {
  const double side = job.direction == Direction::ccw ? 1 : -1;
  for (const double share : shares) {
    const Edge arc = quarter(path.back().to, direction(path.back(), 1), share * job.radius / 2, side);
    if (holds(field, {arc})) return arc;
  }
  return std::nullopt;
}

}  // namespace kadr::area
