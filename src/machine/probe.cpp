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
struct Way {
  Vec3 from;
  Vec3 along;     // vector from start to end
  double hole;    // radius of the hole, mm
  double tip;     // radius of the probe's ball, mm
  double bottom;  // Z of the hole's bottom, mm, negative

  Vec3 at(double part) const { return from + part * along; }
  static double off_axis(Vec3 p) { return std::hypot(p.x, p.y); }
};

/// Returns the distance in mm between a point and the workpiece; negative if the point is inside the workpiece.
double clearance(const Way& way, Vec3 p) {
  const double rho = Way::off_axis(p);
  if (p.z >= 0 && rho >= way.hole) return p.z;
  if (p.z >= 0) return std::min(std::hypot(way.hole - rho, p.z), p.z - way.bottom);
  if (rho >= way.hole || p.z <= way.bottom) return -1;
  return std::min(way.hole - rho, p.z - way.bottom);
}

/// Returns the fraction (0 to 1) of the path at which the ball's centre descends to `level`; nullopt if it does not.
std::optional<double> down_to(const Way& way, double level) {
  if (!(way.along.z < 0)) return std::nullopt;
  const double part = (level - way.from.z) / way.along.z;
  return part >= -tol::same_point / std::abs(way.along.z) && part <= 1 ? std::optional(std::max(part, 0.0)) : std::nullopt;
}

std::optional<double> top_face(const Way& way) {
  const auto part = down_to(way, way.tip);
  return part && Way::off_axis(way.at(*part)) >= way.hole ? part : std::nullopt;
}

std::optional<double> bottom_face(const Way& way) {
  const auto part = down_to(way, way.bottom + way.tip);
  return part && Way::off_axis(way.at(*part)) <= way.hole - way.tip + tol::same_point ? part : std::nullopt;
}

/// Returns the fraction (0 to 1) of the path at which the ball (radius r) touches the wall of the hole (radius R). At this point the ball's
/// centre leaves the cylinder of radius R − r: the fraction is the greater root of |from + part·along|² = (R − r)² in the XY plane.
std::optional<double> wall(const Way& way) {
  const double reach = way.hole - way.tip;
  const Vec2 from{way.from.x, way.from.y}, along{way.along.x, way.along.y};
  const double a = dot(along, along), b = dot(from, along);
  if (reach < 0 || a == 0) return std::nullopt;
  const double rho = length(from);
  const double c = (rho - reach) * (rho + reach);
  const double root_sq = b * b - a * c;
  if (root_sq < 0) return std::nullopt;
  const double root = std::sqrt(root_sq);
  // Of two equivalent formulas, the code uses the one without cancellation of digits
  const double part = b > 0 ? -c / (b + root) : (root - b) / a;
  if (!(part >= -tol::same_point / std::sqrt(a) && part <= 1)) return std::nullopt;
  const double z = way.at(part).z;
  return z <= 0 && z > way.bottom ? std::optional(std::max(part, 0.0)) : std::nullopt;
}

/// Returns the fraction (0 to 1) of the path at which the ball touches the rim, the top edge of the hole. Each step of the search advances
/// by the ball's distance from the rim, so the search cannot miss the rim.
std::optional<double> rim(const Way& way) {
  const double whole = length(way.along);
  double gone = 0;
  for (int step = 0; step < max_rim_steps && gone <= whole; ++step) {
    const Vec3 p = way.at(gone / whole);
    const double free = std::hypot(Way::off_axis(p) - way.hole, p.z) - way.tip;
    if (free < rim_reached) {
      const Vec3 next = way.at((gone + tol::same_point) / whole);
      const bool leaving = std::hypot(Way::off_axis(next) - way.hole, next.z) - way.tip >= free;
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
  const Way way{from - origin, to - from, hole.diameter / 2, hole.tip_radius, -hole.depth};
  if (length(way.along) == 0) return std::nullopt;
  if (clearance(way, way.from) < way.tip - tol::same_point) return 0.0;
  std::optional<double> first;
  for (const auto touch : {top_face(way), bottom_face(way), wall(way), rim(way)})
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
    const double way = to[signal.axis] - from[signal.axis];
    const double there = (signal.position - from[signal.axis]) / way;
    if (way == 0 || !(there >= 0 && there <= 1) || there >= part) continue;
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
