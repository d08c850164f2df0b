// This file finds a sloped path along which the tool moves down into uncut material near the start of a pass. Used by
// path/pocketing/layers; tested by tests/path/pocketing/ramp_test.cpp.

#include "path/pocketing/plunge_ramp.h"

#include <algorithm>
#include <cmath>

#include "base/tolerance.h"
#include "path/pocketing/links.h"

namespace kadr::area {
namespace {

constexpr double fine = tol::area_wall / 4;  // chord tolerance, mm, of a ramp that may follow a wall
constexpr double coarse = 0.02;              // Chord tolerance, mm, of a ramp away from walls. The greater tolerance gives fewer blocks.
constexpr double shortest = 2, longest = 6;  // bounds of the length of one stroke of a ramp that moves back and forth, in tool radii
constexpr double good_extent = 2;            // extent of a ramp, in tool radii, that is enough, so that the search for a wider ramp ends
constexpr double helices[] = {0.8, 0.5, 0.3, 0.2};  // The helix radii to try, in tool radii. A radius of up to 1 leaves no core.
constexpr double good_helix = 0.5;
constexpr double lines[] = {6, 4, 2, 1, 0.4};  // lengths of straight ramps that the search tries, in tool radii
constexpr int directions = 24;                 // number of ramp directions that the search tries around the start of the pass
// Greatest number of strokes or revolutions. If more are necessary, the slope is too small for a useful program.
constexpr int max_times = 2000;

double length_of_corners(const Polygon& corners) {
  double sum = 0;
  for (std::size_t i = 1; i < corners.size(); ++i) sum += length(corners[i] - corners[i - 1]);
  return sum;
}

double extent_of(const Polygon& corners) {
  Bounds box;
  for (const Vec2 p : corners) box.take(p);
  return std::max(box.most.x - box.least.x, box.most.y - box.least.y);
}

/// Returns the first `most` mm of a path.
Edges beginning(const Edges& path, double most) {
  Edges piece;
  for (const Edge& e : path) {
    const double whole = length_of(e);
    piece.push_back(whole <= most ? e : section(e, 0, most / whole));
    most -= whole;
    if (most <= 0) break;
  }
  return piece;
}

class Search {
 public:
  Search(const Field& field, const Job& job, const Edges& path, double drop)
      : field_(field), job_(job), path_(path), needed_(drop / std::tan(job.ramp_deg * rad_per_deg)) {
    // At a small slope the strokes are longer, which avoids thousands of strokes.
    stroke_ = std::clamp(needed_ / 2, shortest * job.radius, std::max(longest * job.radius, needed_ / 100));
  }

  std::optional<Ramp> run() {
    try_pass();
    if (!found()) try_helices(good_helix);
    if (!found()) try_lines();
    if (!found()) try_boundary();
    if (!found()) try_helices(0);
    return best_;
  }

 private:
  bool found() const { return good_; }

  void offer(const Polygon& corners, bool round, bool good) {
    const double extent = extent_of(corners), once = length_of_corners(corners);
    if (extent < ramp_core * job_.radius || extent <= best_extent_) return;
    const double times = round ? std::ceil(needed_ / once) : 2 * std::ceil(needed_ / once / 2);
    if (!(times <= max_times)) return;
    best_ = Ramp{corners, round, static_cast<int>(times), times * once};
    best_extent_ = extent;
    good_ = good || extent >= good_extent * job_.radius;
  }

  /// Returns the corner points of a path if the path stays in the field; otherwise nullopt.
  std::optional<Polygon> held(const Edges& path) const {
    for (const double chord : {coarse, fine}) {
      Polygon corners = flattened(path, chord);
      if (length(corners.back() - path.back().to) > tol::same_point) corners.push_back(path.back().to);
      if (field_.roomy.holds(corners, tol::area_chord)) return corners;
    }
    return std::nullopt;
  }

  void try_along(const Edges& path) {
    if (path.empty()) return;
    const bool closed = length(path.back().to - path.front().from) < tol::same_point;
    const bool round = closed && length_of(path) <= stroke_;
    if (const auto corners = held(beginning(path, stroke_))) offer(*corners, round, false);
  }

  void try_pass() { try_along(path_); }

  void try_helices(double least) {
    const Vec2 start = path_.front().from;
    for (const double share : helices) {
      const double radius = share * job_.radius;
      for (int i = 0; share >= least && !found() && i < directions; ++i) {
        const Vec2 out = radius * heading(i);
        const double side = job_.direction == Direction::ccw ? 1 : -1;
        const Edges circle{{start, start + 2 * out, side}, {start + 2 * out, start, side}};
        if (const auto corners = held(circle)) offer(*corners, true, share >= good_helix);
      }
    }
  }

  void try_lines() {
    const Vec2 start = path_.front().from;
    for (const double share : lines)
      for (int i = 0; !found() && i < directions; ++i)
        if (const Vec2 end = start + std::min(share * job_.radius, stroke_) * heading(i); holds(field_, {{start, end}}))
          offer({start, end}, false, false);
  }

  void try_boundary() {
    const Vec2 start = path_.front().from;
    for (const Edges& loop : field_.reach)
      for (const Edges& ring : {begun_near(loop, start), reversed(begun_near(loop, start))}) {
        if (found() || ring.empty()) continue;
        Edges path = ring;
        if (length(ring.front().from - start) > tol::same_point) path.insert(path.begin(), Edge{start, ring.front().from});
        try_along(path);
      }
  }

  /// Returns the direction with the number `i` to try. Number 0 is the direction of the pass. The further directions lie on alternating
  /// sides of this direction.
  Vec2 heading(int i) const {
    const int turn = (i + 1) / 2 * (i % 2 == 0 ? 1 : -1);
    return kadr::rotated(direction(path_.front(), 0), 360.0 * turn / directions);
  }

  const Field& field_;
  const Job& job_;
  const Edges& path_;
  double needed_, stroke_ = 0;
  std::optional<Ramp> best_;
  double best_extent_ = 0;
  bool good_ = false;
};

}  // namespace

std::optional<Ramp> ramp_for(const Field& field, const Job& job, const Edges& path, double drop) {
  return Search(field, job, path, drop).run();
}

}  // namespace kadr::area
