#pragma once
// BodyWorld: solid bodies, and the distance between any two of them in any pose. FCL does the geometry (stock/bodies/bodies_library).

#include <memory>
#include <optional>
#include <vector>

#include "config/machine_bodies.h"
#include "kinematics/machine_links.h"
#include "stock/bodies/bodies_library.h"
#include "stock/mesh/mesh.h"
#include "stock/tool/round_solid.h"

namespace kadr {

/// A body of a BodyWorld: its number there, and its pose in the coordinates in which it was described.
struct SolidBody {
  int number = 0;
  LinkPose lies;
  BodyBall ball;       // encloses the body, in those coordinates
  bool convex = true;  // false for a mesh, which may have any shape
};

struct BodyGap {
  double distance = 0;       // mm; negative if they overlap
  Vec3 on_first, on_second;  // the closest points, unless they overlap
};

class BodyWorld {
 public:
  /// Uses the given module.
  ///   pre  it is loaded
  explicit BodyWorld(const KadrBodiesDoor& door);

  /// Returns nullopt if memory runs out. A shape given by a file is a mesh: use the overload below; this one returns nullopt for it.
  std::optional<SolidBody> add(const BodyShape& shape);
  std::optional<SolidBody> add(const Mesh& mesh);
  /// Adds a body of the tool, from its tip upwards along Z.
  std::optional<SolidBody> add(const ConvexBody& body);

  /// `pose` places the coordinates in which the body was described.
  ///   returns  distance 0 if FCL finds no result
  BodyGap gap(const SolidBody& a, const LinkPose& pose_a, const SolidBody& b, const LinkPose& pose_b) const;
  /// Returns by how much the two overlap, mm; 0 if unknown.
  double depth(const SolidBody& a, const LinkPose& pose_a, const SolidBody& b, const LinkPose& pose_b) const;

 private:
  const KadrBodiesDoor* door_;
  std::unique_ptr<KadrBodies, void (*)(KadrBodies*)> bodies_;
};

/// Returns circles of a body of revolution in ascending order, as radius and height. Their hull is the body; lines that lie outside
/// by at most `chord` mm replace its arcs.
std::vector<Vec2> circles_of(const ConvexBody& body, double chord);

}  // namespace kadr
