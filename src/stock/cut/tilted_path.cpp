// Computes paths of tilted tools. Used by stock/stock and stock/surface.

#include "stock/cut/tilted_path.h"

#include <algorithm>
#include <cmath>

namespace kadr {
namespace {

constexpr int max_parts = 1 << 16;
constexpr double same_direction = 1e-12;  // two unit vectors count as equal if the length of their difference is less than this
constexpr double opposite = 1e-9;         // two unit vectors count as opposite if half the length of their sum is less than this
// On a chord this short, an even motion along the chord replaces the even turn, with an error of at most 1e-6 of the chord.
constexpr double small_chord = 0.02;

/// Returns the length of a vector with the square root as the only library function, because every library rounds the square root alike.
double size_of(Vec3 v) { return std::sqrt(dot(v, v)); }
Vec3 unit_by_root(Vec3 v) { return (1 / size_of(v)) * v; }

/// Returns a unit vector perpendicular to `direction`.
Vec3 any_normal(Vec3 direction) {
  const Vec3 away = std::fabs(direction.x) <= std::fabs(direction.y) ? Vec3{1, 0, 0} : Vec3{0, 1, 0};
  return unit_by_root(cross(away, direction));
}

/// The shortest rotation from one direction to another, applied to vectors perpendicular to the first direction.
class Carry {
 public:
  Carry(Vec3 from, Vec3 to) : middle_(from + to), per_(2 / dot(middle_, middle_)) {}
  Vec3 operator()(Vec3 v) const { return v - (per_ * dot(v, middle_)) * middle_; }

 private:
  Vec3 middle_;
  double per_;
};

}  // namespace

/// Returns the angle in radians by which the tool turns on the path. Here `chord` is the distance between the two unit vectors of the
/// direction. For a short chord the series of 2 asin(chord / 2) is used; for a longer chord the result is an upper bound.
double TiltedPath::turn() const {
  const double chord = size_of(to_direction - from_direction), square = chord * chord;
  return chord < 0.5 ? chord * (1 + square * (1 / 24.0 + square * (3 / 640.0 + square * 5 / 7168.0))) : chord * pi / 2;
}

/// Returns the direction of the tool at the fraction `part` (0 to 1) of the path. The function halves the arc repeatedly, and uses only the
/// square root, which every processor rounds alike.
Vec3 TiltedPath::direction(double part) const {
  if (part <= 0 || from_direction == to_direction) return from_direction;
  if (part >= 1) return to_direction;
  Vec3 a = from_direction, b = to_direction;
  double first = 0, last = 1;
  // Between opposite directions there is no unique shortest arc, so any of the shortest arcs is used.
  const auto middle = [](Vec3 c, Vec3 d) { return size_of(c + d) < 2 * opposite ? any_normal(c) : unit_by_root(c + d); };
  while (size_of(b - a) > small_chord) {
    const double half = (first + last) / 2;
    (part < half ? b : a) = middle(a, b);
    (part < half ? last : first) = half;
  }
  if (size_of(b - a) < same_direction) return a;
  return unit_by_root(a + ((part - first) / (last - first)) * (b - a));
}

int parts_of(const TiltedPath& path, double reach, double bend) {
  const double turn = path.turn(), all = size_of(path.to - path.from) * turn / 4 + reach * turn * turn / 8;
  return int(std::clamp(std::ceil(std::max(turn / max_turn, std::sqrt(all / bend)) - 1e-9), 1.0, double(max_parts)));
}

double reach_of(const ToolShape& tool) {
  double most = 0;
  for (const ConvexBody& body : tool.bodies) most = std::max(most, length(Vec2{body.widest(), std::max(body.top(), -body.bottom())}));
  return most;
}

ToolEnds::ToolEnds(const TiltedPath& path) : from(path.from), to(path.to) {
  const Vec3 z = unit_by_root(path.from_direction + path.to_direction), x = any_normal(z), y = cross(z, x);
  axes_halfway = {x, y, z};
  const Carry back(z, path.from_direction), forth(z, path.to_direction);
  axes_first = {back(x), back(y), path.from_direction};
  axes_last = {forth(x), forth(y), path.to_direction};
}

Box3 box_around(const TiltedPath& path, double low, double high, double radius) {
  Box3 box{{1e300, 1e300, 1e300}, {-1e300, -1e300, -1e300}};
  // Deviation in mm of the path of a point, at the height `high` on the tool, from the chord of this path.
  const double bent = high * path.turn() * path.turn() / 8;
  for (const bool end : {false, true}) {
    const Vec3 tip = end ? path.to : path.from, direction = end ? path.to_direction : path.from_direction;
    for (const double height : {low, high})
      for (int d = 0; d < 3; ++d) {
        const double slope = along(direction, d), at = along(tip, d) + height * slope;
        const double room = radius * std::min(std::sqrt(std::max(1 - slope * slope, 0.0)) + path.turn(), 1.0) + bent;
        along(box.least, d) = std::min(along(box.least, d), at - room);
        along(box.most, d) = std::max(along(box.most, d), at + room);
      }
  }
  return box;
}

AroundTip around_tilted_tip(const TiltedPath& path, double low, double high, double radius) {
  if (path.turn() > max_turn) {
    const double reach = length(Vec2{std::max(high, -low), radius});
    return {reach, reach, reach};
  }
  const Box3 box = box_around({{}, {}, path.from_direction, path.to_direction}, low, high, radius);
  return {std::max({-box.least.x, -box.least.y, box.most.x, box.most.y}), -box.least.z, box.most.z};
}

}  // namespace kadr
