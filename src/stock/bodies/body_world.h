#pragma once
// BodyWorld: a set of solid bodies, and the distance between any two of them in any pose. The library FCL computes the distances
// (stock/bodies/bodies_library).

#include <memory>
#include <optional>
#include <vector>

#include "config/machine/machine_bodies.h"
#include "kinematics/machine_links.h"
#include "stock/bodies/bodies_library.h"
#include "stock/mesh/mesh.h"
#include "stock/tool/round_solid.h"

namespace kadr {

/// A body of a BodyWorld: its number in the BodyWorld, and its pose in the coordinates of its description (machine file, mesh or tool).
struct SolidBody {
  int number = 0;
  LinkPose pose;
  BodyBall ball;       // sphere that encloses the body, in the coordinates of the description
  bool convex = true;  // true if the body is convex; a mesh may have any shape, so it is not assumed to be convex
};

struct BodyGap {
  double distance = 0;       // distance in mm; negative if the two bodies overlap
  Vec3 on_first, on_second;  // the closest points of the two bodies, mm; not set if the bodies overlap
};

class BodyWorld {
 public:
  /// Creates an empty set of bodies, whose distances are computed by the given module kadr-bodies.so.
  ///   pre  the module is loaded
  explicit BodyWorld(const KadrBodiesInterface& door);

  /// Adds a body to the set. Returns nullopt if memory runs out, or if the shape is given by a mesh file; for a mesh, call add(const
  /// Mesh&).
  std::optional<SolidBody> add(const BodyShape& shape);
  std::optional<SolidBody> add(const Mesh& mesh);
  /// Adds a body of the tool. The origin of the tool's coordinates is the tip, and Z is along the tool's axis.
  std::optional<SolidBody> add(const ConvexBody& body);

  /// Computes the distance between two bodies. `pose_a` and `pose_b` are the poses of the coordinates in which each body was described.
  ///   returns  the distance and the closest points; the distance is 0 if FCL finds no result
  BodyGap gap(const SolidBody& a, const LinkPose& pose_a, const SolidBody& b, const LinkPose& pose_b) const;
  /// Returns the depth in mm by which the two bodies overlap; 0 if the depth is unknown.
  double depth(const SolidBody& a, const LinkPose& pose_a, const SolidBody& b, const LinkPose& pose_b) const;

 private:
  const KadrBodiesInterface* door_;
  std::unique_ptr<KadrBodies, void (*)(KadrBodies*)> bodies_;
};

/// Returns circles of a body of revolution in ascending order, as radius and height; the convex hull of the circles replaces the body.
/// Straight lines that are at most `chord` mm outside replace the body's arcs.
std::vector<Vec2> circles_of(const ConvexBody& body, double chord);

}  // namespace kadr
