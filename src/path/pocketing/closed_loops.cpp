// This file joins the edges of a drawing to closed contours. Used by path/pocketing/mill.

#include "path/pocketing/closed_loops.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>

#include "base/tolerance.h"
#include "path/pocketing/polygon.h"

namespace kadr::area {
namespace {

/// The number of an end of an edge: 2·index is the start point of the edge `index`, and 2·index + 1 is its end point.
using End = std::size_t;
constexpr End none = static_cast<End>(-1);

Vec2 point_of(const Edges& edges, End end) { return end % 2 == 0 ? edges[end / 2].from : edges[end / 2].to; }

/// Finds ends of edges by their position. It uses a grid of squares whose side is the permitted gap.
class EndIndex {
 public:
  EndIndex(const Edges& edges, double gap) : edges_(edges), gap_(gap) {}
  void add(End end) { squares_[square(point_of(edges_, end))].push_back(end); }

  /// Returns the ends of other edges whose distance from this end is at most the permitted gap.
  std::vector<End> near(End end) const {
    std::vector<End> found;
    const Vec2 p = point_of(edges_, end);
    const auto [x, y] = square(p);
    for (long dx = -1; dx <= 1; ++dx)
      for (long dy = -1; dy <= 1; ++dy) {
        const auto there = squares_.find({x + dx, y + dy});
        if (there == squares_.end()) continue;
        for (const End other : there->second)
          if (other != end && length(point_of(edges_, other) - p) <= gap_) found.push_back(other);
      }
    return found;
  }

 private:
  std::pair<long, long> square(Vec2 p) const { return {std::lround(p.x / gap_), std::lround(p.y / gap_)}; }
  const Edges& edges_;
  double gap_;
  std::map<std::pair<long, long>, std::vector<End>> squares_;
};

/// Pairs the ends that have no partner yet. Returns a fault if an end has several possible partners.
std::optional<DrawingFault> pair_ends(const Edges& edges, double gap, std::vector<End>& partner) {
  EndIndex index(edges, gap);
  for (End end = 0; end < partner.size(); ++end)
    if (partner[end] == none) index.add(end);
  for (End end = 0; end < partner.size(); ++end) {
    if (partner[end] != none) continue;
    std::vector<End> near = index.near(end);
    std::erase_if(near, [&](End other) { return partner[other] != none || other / 2 == end / 2; });
    if (near.empty()) continue;
    if (near.size() > 1) {
      const Vec2 p = point_of(edges, end);
      return DrawingFault{alarm(AlarmId::contour_branch, {}, p.x, p.y), edges[end / 2].line};
    }
    partner[end] = near[0];
    partner[near[0]] = end;
  }
  return std::nullopt;
}

/// Returns the chain of edges from `start` to an end that has no partner, or back to `start`.
Edges follow(const Edges& edges, End start, const std::vector<End>& partner, std::vector<bool>& used) {
  Edges chain;
  for (End at = start; at != none && !used[at / 2]; at = partner[at ^ 1]) {
    used[at / 2] = true;
    chain.push_back(at % 2 == 0 ? edges[at / 2] : reversed(edges[at / 2]));
    if (chain.size() > 1) chain.back().from = chain[chain.size() - 2].to;
  }
  return chain;
}

double turning_area(const Edges& loop) { return area_of({flattened(loop, tol::contour_gap)}); }

/// Returns a point at which two edges cross or touch; nullopt if they have no such point. The common end of two consecutive edges does not
/// count.
std::optional<Vec2> crossing(const Edge& a, const Edge& b, bool b_follows, bool a_follows) {
  for (const Vec2 p : meetings(a, b)) {
    const bool shared = (b_follows && length(p - a.to) < tol::contour_gap) || (a_follows && length(p - b.to) < tol::contour_gap);
    if (!shared) return p;
  }
  return std::nullopt;
}

struct Placed {
  const Edges* loop;
  std::size_t index;
  Bounds box;
  const Edge& edge() const { return (*loop)[index]; }
  bool before(const Placed& other) const { return loop == other.loop && (index + 1) % loop->size() == other.index; }
};

std::optional<DrawingFault> first_crossing(const std::vector<Edges>& loops) {
  std::vector<Placed> all;
  for (const Edges& loop : loops)
    for (std::size_t i = 0; i < loop.size(); ++i) all.push_back({&loop, i, bounds_of({loop[i]})});
  std::sort(all.begin(), all.end(), [](const Placed& a, const Placed& b) { return a.box.least.x < b.box.least.x; });
  for (std::size_t i = 0; i < all.size(); ++i)
    for (std::size_t j = i + 1; j < all.size() && all[j].box.least.x <= all[i].box.most.x + tol::same_point; ++j) {
      if (!all[i].box.near(all[j].box, tol::same_point)) continue;
      if (const auto p = crossing(all[i].edge(), all[j].edge(), all[i].before(all[j]), all[j].before(all[i])))
        return DrawingFault{alarm(AlarmId::contour_crosses, {}, p->x, p->y), std::max(all[i].edge().line, all[j].edge().line)};
    }
  return std::nullopt;
}

DrawingFault open_end(const std::vector<Edges>& open) {
  const Vec2 at = open[0].back().to;
  double nearest = length(open[0].front().from - at);
  for (std::size_t i = 1; i < open.size(); ++i)
    nearest = std::min(nearest, std::min(length(open[i].front().from - at), length(open[i].back().to - at)));
  return {alarm(AlarmId::contour_open_end, {}, at.x, at.y, nearest), open[0].back().line};
}

}  // namespace

tl::expected<Chains, DrawingFault> chained(const Edges& edges) {
  std::vector<End> partner(2 * edges.size(), none);
  for (const double gap : {10 * tol::same_point, tol::contour_gap})
    if (const auto fault = pair_ends(edges, gap, partner)) return tl::unexpected(*fault);
  std::vector<bool> used(edges.size());
  Chains chains;
  for (End end = 0; end < partner.size(); ++end)
    if (partner[end] == none && !used[end / 2]) chains.open.push_back(follow(edges, end, partner, used));
  for (End end = 0; end < partner.size(); end += 2)
    if (!used[end / 2]) {
      chains.closed.push_back(follow(edges, end, partner, used));
      chains.closed.back().front().from = chains.closed.back().back().to;
    }
  return chains;
}

tl::expected<std::vector<Zone>, DrawingFault> zones_of(const Chains& chains) {
  if (!chains.open.empty()) return tl::unexpected(open_end(chains.open));
  if (const auto fault = first_crossing(chains.closed)) return tl::unexpected(*fault);
  std::vector<Polygon> outlines;
  for (const Edges& loop : chains.closed) outlines.push_back(flattened(loop, tol::contour_gap));
  std::vector<std::vector<std::size_t>> around(outlines.size());  // for each loop, the indices of the loops that enclose this loop
  for (std::size_t i = 0; i < outlines.size(); ++i)
    for (std::size_t j = 0; j < outlines.size(); ++j)
      if (i != j && contains({outlines[j]}, outlines[i].front())) around[i].push_back(j);
  std::vector<Zone> zones;
  std::map<std::size_t, std::size_t> zone_of;
  const auto oriented = [](const Edges& loop, bool ccw) { return (turning_area(loop) > 0) == ccw ? loop : reversed(loop); };
  for (std::size_t i = 0; i < outlines.size(); ++i)
    if (around[i].size() % 2 == 0) {
      zone_of[i] = zones.size();
      zones.push_back({{oriented(chains.closed[i], true)}});
    }
  for (std::size_t i = 0; i < outlines.size(); ++i)
    if (around[i].size() % 2 == 1)
      for (const std::size_t j : around[i])
        if (around[j].size() + 1 == around[i].size()) zones[zone_of[j]].loops.push_back(oriented(chains.closed[i], false));
  return zones;
}

}  // namespace kadr::area
