// Turning tools: their paths in the half plane of a spinning part, and the rings that they remove from the bricks of the part (class
// Stock).

#include <algorithm>
#include <cmath>

#include "stock/cut/ring_cut.h"
#include "stock/stock.h"

namespace kadr {
namespace {

constexpr double room = 1;  // margin in mm around everything that an insert can reach

InsertPoint point_of(const float (&at)[3]) { return {double(at[0]), double(at[2])}; }

/// Returns the greatest distance in mm of the insert's points from the programmed point, along x or z.
double insert_reach(const ToolShape& tool) {
  double most = 0;
  for (const InsertBody& body : tool.insert)
    for (const InsertCorner& c : body.corners) most = std::max({most, std::fabs(c.centre.x) + c.radius, std::fabs(c.centre.z) + c.radius});
  return most;
}

/// Returns the part of a path on which one coordinate is between two limits.
PathPart part_between(double from, double to, double low, double high) {
  if (from == to) return from < low || from > high ? PathPart{1, 0} : PathPart{};
  const double a = (low - from) / (to - from), b = (high - from) / (to - from);
  return {std::max(0.0, std::min(a, b)), std::min(1.0, std::max(a, b))};
}

}  // namespace

/// Stores only the part of the path that can reach material, because single precision has only seven digits. A path that reaches no
/// material is reduced to its start.
void Stock::add_turned(const Sweep& sweep) {
  const double reach = insert_reach(tools_[sweep.tool]) + room, edge = lattice_.edge();
  const Vec3 least = lattice_.origin(),
             most = least + edge * Vec3{double(lattice_.bricks(0)), double(lattice_.bricks(1)), double(lattice_.bricks(2))};
  const double farthest =
      std::hypot(std::max(std::fabs(least.x), std::fabs(most.x)), std::max(std::fabs(least.y), std::fabs(most.y))) + reach;
  const PathPart x = part_between(sweep.from.x, sweep.to.x, -farthest, farthest);
  const PathPart z = part_between(sweep.from.z, sweep.to.z, least.z - reach, most.z + reach);
  PathPart part{std::max(x.first, z.first), std::min(x.last, z.last)};
  if (part.first > part.last) part = {0, 0};
  const Vec3 delta = sweep.to - sweep.from, from = sweep.from + part.first * delta,
             to = part.last == 1 ? sweep.to : sweep.from + part.last * delta;
  keep({{float(from.x), 0, float(from.z - least.z)}, {float(to.x), 0, float(to.z - least.z)}, sweep.tool, sweep.watched, false}, part);
}

/// Adds the sweep to the lists of the bricks that its ring may reach.
void Stock::bin_turned(std::size_t sweep) {
  const KeptSweep s = sweeps_[sweep];
  const double edge = lattice_.edge();
  for (const InsertBody& body : tools_[s.tool].insert) {
    const RingSweep ring(body, point_of(s.from), point_of(s.to));
    const RingRange heights = ring.heights();
    const int low = int(std::floor(std::max(heights.from / edge, double(lattice_.first(2)))));
    const int high = int(std::floor(std::min(heights.to / edge, double(lattice_.last(2)))));
    for (int z = low; z <= high; ++z) {
      const RingRange radii = folded(ring.between(z * edge, (z + 1) * edge));
      if (radii.none()) continue;
      for (int y = lattice_.first(1); y <= lattice_.last(1); ++y)
        for (int x = lattice_.first(0); x <= lattice_.last(0); ++x) {
          const BrickRing own = brick_ring(lattice_.origin().x + x * edge, lattice_.origin().y + y * edge, edge);
          if (own.nearest <= radii.to && own.farthest >= radii.from) put_in_bin(lattice_.at({x, y, z}), sweep);
        }
    }
  }
}

/// Executes one sweep of a turning tool in one brick.
///   returns  true if the brick changed
bool Stock::turn(std::int32_t number, std::size_t b, Brick& material, Worker* worker) const {
  const KeptSweep s = sweeps_[std::size_t(number)];
  Vec3 corner = lattice_.corner(b);
  corner.z -= lattice_.origin().z;
  bool changed = false;
  for (const InsertBody& body : tools_[s.tool].insert) {
    const RingSweep ring(body, point_of(s.from), point_of(s.to));
    RingOutcome outcome;
    outcome.watched = worker != nullptr && (s.watched || body.part != ToolPart::cutting);
    outcome.least_piece = least_piece();
    cut_ring(material, scale_, corner, ring, number, outcome);
    changed = changed || outcome.changed;
    if (worker == nullptr) continue;
    if (outcome.changed) worker->count(number, outcome.length, outcome.longest, 0);
    if (!outcome.any()) continue;
    const double from_zero = lattice_.origin().z;
    const Box3 around{{outcome.radii.from, 0, outcome.heights.from + from_zero}, {outcome.radii.to, 0, outcome.heights.to + from_zero}};
    worker->touches.push_back({std::uint32_t(number), body.part, around, outcome.length * lattice_.cell() * lattice_.cell(), true});
  }
  return changed;
}

}  // namespace kadr
