// Finds the position on its path at which a tool touched a point, and the normal of the tool at this point. Used by
// stock/surface/crossings.

#include "stock/surface/cut_normal.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "base/matrix.h"

namespace kadr {
namespace {

using Form = RoundSolid::Form;

/// Limit in mm: if the distances of two faces from a point differ by less, it is unknown which face cut at this point. This limit is a
/// little more than the 2e-4 mm in the law of stock/cut/upright_rows.h and level_rows.h.
constexpr double same_spot = 3e-4;
// Least component of a normal along the lattice line; if the component is less, the line lies in the face.
constexpr double along_the_line = 0.01;
constexpr int max_steps = 60;
constexpr double same_part = 1e-6;  // limit in mm: two positions on the path closer than this count as equal
constexpr double level = 1e-9;      // a slope of the distance along the path counts as 0 if it is below this fraction of the path length
constexpr double on_axis = 1e-12;   // limit in mm: a point closer to the tool's axis than this counts as on the axis

/// A face of the tool near the point: its distance from the point, and its outward normal in the half plane of radius and height.
struct Near {
  double distance, radial, up;
};

/// The position of the point relative to the tool, with the tool at a given fraction of the path.
struct Seen {
  double x, y, radius, height;  // position relative to the tip, mm
};

struct SweepPath {
  Vec3 start, along;

  Seen seen(const Vec3& at, double part) const {
    const double x = at.x - start.x - part * along.x, y = at.y - start.y - part * along.y;
    return {x, y, std::sqrt(x * x + y * y), at.z - start.z - part * along.z};
  }
};

SweepPath path_of(const KeptSweep& sweep) {
  const Vec3 from{double(sweep.from[0]), double(sweep.from[1]), double(sweep.from[2])};
  const Vec3 to{double(sweep.to[0]), double(sweep.to[1]), double(sweep.to[2])};
  return {from, to - from};
}

Near to_side(const BodyFaces::Side& side, double bottom, double radius, double height) {
  if (side.form == Form::cylinder || side.form == Form::cone)
    return {(radius - side.radius) * side.normal_radial + (height - side.height) * side.normal_up, side.normal_radial, side.normal_up};
  if (height >= side.height) return {radius - side.radius - side.circle, 1, 0};
  if (radius <= side.radius) return {bottom - height, 0, -1};
  const double x = radius - side.radius, y = height - side.height, far = std::sqrt(x * x + y * y);
  return {far - side.circle, x / far, y / far};
}

template <class Visit>
void each_face(const BodyFaces& body, const Seen& seen, const Visit& visit) {
  for (const BodyFaces::Side& side : body.sides) visit(to_side(side, body.bottom, seen.radius, seen.height));
  visit(Near{body.bottom - seen.height, 0, -1});
  visit(Near{seen.height - body.top, 0, 1});
}

Near farthest(const BodyFaces& body, const Seen& seen) {
  Near best{-1e30, 0, 0};
  each_face(body, seen, [&](const Near& face) { best = face.distance > best.distance ? face : best; });
  return best;
}

/// Returns the normal of the face as a vector in the tool's coordinates.
Vec3 in_space(const Near& face, const Seen& seen) {
  const double per = seen.radius > on_axis ? face.radial / seen.radius : 0;
  return seen.radius > on_axis ? Vec3{seen.x * per, seen.y * per, face.up} : Vec3{face.radial, 0, face.up};
}

/// The point, and the direction in which the lattice line through the point leaves the material, in the tool's coordinates.
struct PlaceSeen {
  Vec3 at, outward;
};

struct Touching {
  double distance;
  Vec3 normal;  // outward unit normal of the tool's face nearest to the point
};

/// Returns the distance of the point from the body, with the tool at the fraction `part` of the path, and the normal of the nearest face. A
/// line does not cross a plane in which the line lies. So if several faces of the tool are at about the same distance, the result is the
/// face that the line crosses most nearly at a right angle.
Touching at_part(const BodyFaces& body, const SweepPath& path, const PlaceSeen& place, double part) {
  const Seen seen = path.seen(place.at, part);
  const auto square_to = [&](const Vec3& normal) { return -dot(normal, place.outward); };
  const Near face = farthest(body, seen);
  Touching best{face.distance, in_space(face, seen)};
  double squarest = square_to(best.normal);
  if (squarest > along_the_line) return best;
  each_face(body, seen, [&](const Near& other) {
    const Vec3 normal = in_space(other, seen);
    if (other.distance < face.distance - same_spot || square_to(normal) <= squarest) return;
    squarest = square_to(normal), best.normal = normal;
  });
  return best;
}

double nearest_part(double over, double length_squared) { return length_squared > 0 ? std::clamp(over / length_squared, 0.0, 1.0) : 0; }

/// Returns the fraction of the path at which the tool touched the point, if an exact formula exists. On a level path heights are constant,
/// so the result is the fraction at which the tool is nearest in the XY plane; for a ball, the fraction at which the centre is nearest.
/// Returns nullopt in other cases.
std::optional<double> part_at_once(const BodyFaces& body, const SweepPath& path, const Vec3& at) {
  const Vec3 d = path.along, q = at - path.start;
  const double flat = d.x * d.x + d.y * d.y, over = q.x * d.x + q.y * d.y;
  if (d.z == 0) return nearest_part(over, flat);
  if (!body.ball) return std::nullopt;
  const double middle = body.sides.front().height;
  const double part = nearest_part(over + (q.z - middle) * d.z, flat + d.z * d.z);
  const double height = q.z - part * d.z;
  if (height <= middle) return part;
  const double nearest = nearest_part(over, flat), nearest_height = q.z - nearest * d.z;
  if (flat > 0 && nearest_height >= middle && nearest_height <= body.top) return nearest;
  return std::nullopt;
}

/// Returns the slope, along the path, of the distance between the point and the tool.
double growth(const Vec3& normal, const Vec3& travel) { return -(normal.x * travel.x + normal.y * travel.y + normal.z * travel.z); }

/// The distance of the tool from the point, with the tool at the fraction `part` of the path, and the slope of this distance.
struct Probe {
  double part;
  Touching touching;
  double grows;
};

/// Returns a fraction of the path between `before`, where the tool approaches the point, and `after`, where the tool moves away from it;
/// the result is at least `apart` from both. Three methods are used in turn: the intersection of the tangents, which finds corners of the
/// distance function; the zero of the straight line through both slopes, which finds smooth minima; and the middle.
double part_between(const Probe& before, const Probe& after, int step, double apart) {
  const double wide = after.part - before.part, bends = after.grows - before.grows;
  double part = before.part + 0.5 * wide;
  if (step % 3 == 0) part = before.part + (before.touching.distance - after.touching.distance + after.grows * wide) / bends;
  if (step % 3 == 1) part = before.part - wide * before.grows / bends;
  return std::clamp(part, before.part + apart, after.part - apart);
}

Touching touching(const BodyFaces& body, const SweepPath& path, const PlaceSeen& place) {
  if (const auto part = part_at_once(body, path, place.at)) return at_part(body, path, place, *part);
  const auto probe = [&](double part) -> Probe {
    const Seen seen = path.seen(place.at, part);
    const Near face = farthest(body, seen);
    const Vec3 normal = in_space(face, seen);
    return {part, {face.distance, normal}, growth(normal, path.along)};
  };
  Probe before = probe(0), after = probe(1);
  if (before.grows >= 0) return at_part(body, path, place, 0);
  if (after.grows <= 0) return at_part(body, path, place, 1);
  const double size = std::sqrt(dot(path.along, path.along));
  for (int i = 0; i < max_steps && (after.part - before.part) * size > same_part; ++i) {
    const Probe here = probe(part_between(before, after, i, 0.4 * same_part / size));
    if (std::fabs(here.grows) < level * size) return at_part(body, path, place, here.part);
    (here.grows < 0 ? before : after) = here;
  }
  const double bends = after.grows - before.grows;
  return {probe(0.5 * (before.part + after.part)).touching.distance,
          (after.grows / bends) * before.touching.normal + (-before.grows / bends) * after.touching.normal};
}

Vec3 as_unit(const Vec3& v, const Vec3& otherwise) {
  const double size = std::sqrt(v.x * v.x + v.y * v.y + v.z * v.z);
  return size > on_axis ? (1 / size) * v : otherwise;
}

/// Returns the outward normal of the material as a vector in the tool's coordinates.
Vec3 normal_seen(const SweepPath& path, const ToolFaces& tool, const PlaceSeen& place) {
  double nearest = 1e30;
  Vec3 best = place.outward;
  for (const BodyFaces& body : tool) {
    const Touching t = touching(body, path, place);
    if (std::fabs(t.distance) >= nearest) continue;
    nearest = std::fabs(t.distance);
    best = as_unit({-t.normal.x, -t.normal.y, -t.normal.z}, place.outward);
    if (nearest < same_spot && dot(best, place.outward) > 0) break;
  }
  return best;
}

}  // namespace

BodyFaces::BodyFaces(const ConvexBody& body) : bottom(body.bottom()), top(body.top()), widest(body.widest()) {
  for (const RoundSolid& s : body.solids) {
    if (s.form == Form::cylinder) {
      sides.push_back({s.form, s.top_radius, s.bottom, 1, 0, 0});
    } else if (s.form == Form::cone) {
      const double widens = s.top_radius - s.bottom_radius, tall = s.top - s.bottom, slant = std::sqrt(widens * widens + tall * tall);
      sides.push_back({s.form, s.bottom_radius, s.bottom, tall / slant, -widens / slant, 0});
    } else {
      const double middle = s.form == Form::ball ? 0 : s.bottom_radius;
      sides.push_back({s.form, middle, s.top, 0, 0, s.top_radius - middle});
    }
  }
  ball = sides.front().form == Form::ball;
}

ToolFaces faces_of(const ToolShape& tool) { return {tool.bodies.begin(), tool.bodies.end()}; }

namespace {

/// The point and its path in the tool's coordinates; for a tilted tool also the axes of the work coordinates, as seen from the tool half
/// way along the path.
struct AsSeen {
  SweepPath path;
  PlaceSeen place;
  std::optional<ToolAxes> axes;
};

AsSeen as_seen(const KeptSweep& sweep, const CutPlace& place, const TiltedEnds* ends) {
  Vec3 along_line;
  along(along_line, place.family) = place.leaves ? 1 : -1;
  if (ends == nullptr) return {path_of(sweep), {place.at, along_line}, std::nullopt};
  const ToolEnds seen(tilted_path_of(sweep, *ends));
  const Vec3 first = seen.first(place.at), last = seen.last(place.at);
  const auto middle = [](Vec3 a, Vec3 b) { return as_unit(a + b, a); };
  const ToolAxes axes{middle(seen.axes_first[0], seen.axes_last[0]), middle(seen.axes_first[1], seen.axes_last[1]),
                      middle(seen.axes_first[2], seen.axes_last[2])};
  return {{{}, first - last}, {first, ToolEnds::in(axes, along_line)}, axes};
}

}  // namespace

bool cut_at(const KeptSweep& sweep, const ToolFaces& tool, const CutPlace& place, const TiltedEnds* ends) {
  const AsSeen seen = as_seen(sweep, place, ends);
  return std::any_of(tool.begin(), tool.end(), [&](const BodyFaces& body) {
    const Touching t = touching(body, seen.path, seen.place);
    return std::fabs(t.distance) < same_spot && -dot(t.normal, seen.place.outward) > along_the_line;
  });
}

Vec3 cut_normal(const KeptSweep& sweep, const ToolFaces& tool, const CutPlace& place, const TiltedEnds* ends) {
  const AsSeen seen = as_seen(sweep, place, ends);
  const Vec3 normal = normal_seen(seen.path, tool, seen.place);
  if (!seen.axes) return normal;
  const ToolAxes& axes = *seen.axes;
  return normal.x * axes[0] + normal.y * axes[1] + normal.z * axes[2];
}

}  // namespace kadr
