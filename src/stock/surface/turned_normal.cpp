// Finds the face of a ring that is nearest to a point. Used by stock/surface/crossings.

#include "stock/surface/turned_normal.h"

#include <algorithm>
#include <cmath>

#include "stock/cut/ring_sweep.h"

namespace kadr {
namespace {

/// Limit in mm: if the distances of two faces from a point differ by less, it is unknown which face cut at this point.
constexpr double same_face = 3e-4;
constexpr double on_the_axis = 1e-12;  // limit in mm: a point closer to the axis of the part than this counts as on the axis

struct NearFace {
  double distance = 1e30;
  double square = -1;  // component of the normal along the lattice line, positive towards the side without material
  Vec3 normal;         // unit vector that points outward from the material
};

double distance_from(const RingSweep::Edge& e, const InsertPoint& p) {
  const double x = e.to.x - e.from.x, z = e.to.z - e.from.z, squared = x * x + z * z;
  const double share = squared > 0 ? std::clamp(((p.x - e.from.x) * x + (p.z - e.from.z) * z) / squared, 0.0, 1.0) : 0;
  const double dx = p.x - e.from.x - share * x, dz = p.z - e.from.z - share * z;
  return std::sqrt(dx * dx + dz * dz);
}

/// Returns true if the direction is between the two normals of the arc, which are less than 180° apart.
bool is_within(const RingSweep::Arc& a, const InsertPoint& d) {
  return a.first.x * d.z - a.first.z * d.x >= 0 && d.x * a.last.z - d.z * a.last.x >= 0;
}

/// Replaces `best` by `face` if `face` is nearer. If both faces are at about the same distance, the face that the line crosses more nearly
/// at a right angle is used.
void take_nearer(NearFace& best, const NearFace& face) {
  if (face.distance < best.distance - same_face || (face.distance < best.distance + same_face && face.square > best.square)) best = face;
}

}  // namespace

Vec3 turned_normal(const KeptSweep& sweep, const ToolShape& tool, const CutPlace& place, const Vec3& from_axis) {
  const double x = place.at.x + from_axis.x, y = place.at.y + from_axis.y, radius = std::sqrt(x * x + y * y);
  Vec3 along_line;
  along(along_line, place.family) = place.leaves ? 1 : -1;
  NearFace best;
  best.normal = along_line;
  const InsertPoint from{double(sweep.from[0]), double(sweep.from[2])}, to{double(sweep.to[0]), double(sweep.to[2])};
  for (const InsertBody& body : tool.insert) {
    const RingSweep ring(body, from, to);
    for (const double side : {1.0, -1.0}) {
      const InsertPoint p{side * radius, place.at.z};
      const auto see = [&](double distance, const InsertPoint& outward) {
        const double per = radius > on_the_axis ? -side * outward.x / radius : 0;
        const Vec3 normal{x * per, y * per, -outward.z};
        take_nearer(best, {distance, along(normal, place.family) * along(along_line, place.family), normal});
      };
      for (const RingSweep::Edge& e : ring.edges()) see(distance_from(e, p), e.outward);
      for (const RingSweep::Arc& a : ring.arcs()) {
        const InsertPoint d{p.x - a.centre.x, p.z - a.centre.z};
        const double far = std::sqrt(d.x * d.x + d.z * d.z);
        if (far > on_the_axis && is_within(a, d)) see(std::fabs(far - a.radius), {d.x / far, d.z / far});
      }
    }
  }
  return best.normal;
}

}  // namespace kadr
