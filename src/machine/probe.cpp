// Computes the point of a straight path at which a touch probe triggers. Used by machine/virtual_machine; tested by
// tests/machine/probe_test.cpp.

#include "machine/probe.h"

#include <algorithm>
#include <cmath>

#include "base/tolerance.h"

namespace kadr {
namespace {

constexpr int max_rim_steps = 10'000;
constexpr double rim_reached = 1e-10;  // distance of the ball from the top edge of the hole, mm, at which the search along the path stops

/// The path of the centre of the probe's ball. The origin of its coordinates is on the axis of the hole, at the top face.
struct BallCentrePath {
  Vec3 from;
  Vec3 along;     // vector from start to end
  double hole;    // radius of the hole, mm
  double tip;     // radius of the probe's ball, mm
  double bottom;  // Z of the hole's bottom, mm, negative

  Vec3 at(double part) const { return from + part * along; }
  static double off_axis(Vec3 p) { return std::hypot(p.x, p.y); }
};

/// Returns the distance in mm between a point and the workpiece; negative if the point is inside the workpiece.
double clearance(const BallCentrePath& path, Vec3 p) {
  const double rho = BallCentrePath::off_axis(p);
  if (p.z >= 0 && rho >= path.hole) return p.z;
  if (p.z >= 0) return std::min(std::hypot(path.hole - rho, p.z), p.z - path.bottom);
  if (rho >= path.hole || p.z <= path.bottom) return -1;
  return std::min(path.hole - rho, p.z - path.bottom);
}

/// Returns the fraction (0 to 1) of the path at which the ball's centre descends to `level`; nullopt if it does not.
std::optional<double> down_to(const BallCentrePath& path, double level) {
  if (!(path.along.z < 0)) return std::nullopt;
  const double part = (level - path.from.z) / path.along.z;
  return part >= -tol::same_point / std::abs(path.along.z) && part <= 1 ? std::optional(std::max(part, 0.0)) : std::nullopt;
}

std::optional<double> top_face(const BallCentrePath& path) {
  const auto part = down_to(path, path.tip);
  return part && BallCentrePath::off_axis(path.at(*part)) >= path.hole ? part : std::nullopt;
}

std::optional<double> bottom_face(const BallCentrePath& path) {
  const auto part = down_to(path, path.bottom + path.tip);
  return part && BallCentrePath::off_axis(path.at(*part)) <= path.hole - path.tip + tol::same_point ? part : std::nullopt;
}

/// Returns the fraction (0 to 1) of the path at which the ball (radius r) touches the wall of the hole (radius R). At this point the ball's
/// centre leaves the cylinder of radius R − r: the fraction is the greater root of |from + part·along|² = (R − r)² in the XY plane.
std::optional<double> wall(const BallCentrePath& path) {
  const double reach = path.hole - path.tip;
  const Vec2 from{path.from.x, path.from.y}, along{path.along.x, path.along.y};
  const double a = dot(along, along), b = dot(from, along);
  if (reach < 0 || a == 0) return std::nullopt;
  const double rho = length(from);
  const double c = (rho - reach) * (rho + reach);
  const double root_sq = b * b - a * c;
  if (root_sq < 0) return std::nullopt;
  const double root = std::sqrt(root_sq);
  // The root has two equivalent formulas; for each sign of b, the code uses the one that does not subtract nearly equal numbers
  const double part = b > 0 ? -c / (b + root) : (root - b) / a;
  if (!(part >= -tol::same_point / std::sqrt(a) && part <= 1)) return std::nullopt;
  const double z = path.at(part).z;
  return z <= 0 && z > path.bottom ? std::optional(std::max(part, 0.0)) : std::nullopt;
}

/// Returns the fraction (0 to 1) of the path at which the ball touches the rim, the top edge of the hole. Each step of the search advances
/// by the ball's distance from the rim, so the search cannot miss the rim.
std::optional<double> rim(const BallCentrePath& path) {
  const double whole = length(path.along);
  double gone = 0;
  for (int step = 0; step < max_rim_steps && gone <= whole; ++step) {
    const Vec3 p = path.at(gone / whole);
    const double free = std::hypot(BallCentrePath::off_axis(p) - path.hole, p.z) - path.tip;
    if (free < rim_reached) {
      const Vec3 next = path.at((gone + tol::same_point) / whole);
      const bool leaving = std::hypot(BallCentrePath::off_axis(next) - path.hole, next.z) - path.tip >= free;
      if (!leaving) return gone / whole;
      gone += tol::same_point;
    } else {
      gone += free;
    }
  }
  return std::nullopt;
}

}  // namespace

std::optional<double> first_touch(const ProbeHole& hole, Vec3 from, Vec3 to) {
  const Vec3 origin{hole.center_x, hole.center_y, hole.top};
  const BallCentrePath path{from - origin, to - from, hole.diameter / 2, hole.tip_radius, -hole.depth};
  if (length(path.along) == 0) return std::nullopt;
  if (clearance(path, path.from) < path.tip - tol::same_point) return 0.0;
  std::optional<double> first;
  for (const auto touch : {top_face(path), bottom_face(path), wall(path), rim(path)})
    if (touch && (!first || *touch < *first)) first = touch;
  return first;
}

Probe::Probe(const std::vector<std::string>& axes, const AxisRoles& roles, const Setup& setup)
    : roles_(roles), chain_(roles), hole_(setup.probe_hole) {
  for (const auto& [input, signal] : setup.probe) {
    if (!signal) continue;
    for (std::size_t i = 0; i < roles.count; ++i)
      if (const auto found = signal->find(axes[i]); found != signal->end()) switches_.push_back({input, i, found->second});
  }
}

ProbeAnswer Probe::meet(const Axes& from, const Axes& to, int input) const {
  double part = 2;
  const Switch* met = nullptr;
  for (const Switch& signal : switches_) {
    if (input != 0 && signal.input != input) continue;
    const double travel = to[signal.axis] - from[signal.axis];
    const double there = (signal.position - from[signal.axis]) / travel;
    if (travel == 0 || !(there >= 0 && there <= 1) || there >= part) continue;
    part = there;
    met = &signal;
  }
  if (hole_)
    if (const auto touch = first_touch(*hole_, chain_.tip(from), chain_.tip(to)); touch && *touch < part) {
      part = *touch;
      met = nullptr;
    }
  if (part > 1) return {false, to};
  ProbeAnswer answer{true, from, part};
  for (std::size_t i = 0; i < roles_.count; ++i) answer.at[i] += part * (to[i] - from[i]);
  if (met != nullptr) answer.at[met->axis] = met->position;
  return answer;
}

}  // namespace kadr
