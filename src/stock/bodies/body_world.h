#pragma once
// BodyWorld: solid bodies and the distance between two of them, wherever they are. The geometry is FCL's (stock/bodies/bodies_library).

#include <memory>
#include <optional>
#include <vector>

#include "config/machine_bodies.h"
#include "kinematics/machine_links.h"
#include "stock/bodies/bodies_library.h"
#include "stock/mesh/mesh.h"
#include "stock/tool/round_solid.h"

namespace kadr {

/// A body of the world: its number there, and how it lies in the coordinates that it was described in.
struct SolidBody {
  int number = 0;
  LinkPose lies;
  BodyBall ball;       // around it, in those coordinates
  bool convex = true;  // a mesh may be anything
};

struct BodyGap {
  double distance = 0;       // mm; below 0: they overlap
  Vec3 on_first, on_second;  // the places nearest to each other, unless they do
};

class BodyWorld {
 public:
  /// What there is of the module.
  ///   pre  it is there
  explicit BodyWorld(const KadrBodiesDoor& door);

  /// Nothing: there is not enough memory. A shape that is a file is a mesh: the one below.
  std::optional<SolidBody> add(const BodyShape& shape);
  std::optional<SolidBody> add(const Mesh& mesh);
  /// Of the tool, from its tip upwards along Z.
  std::optional<SolidBody> add(const ConvexBody& body);

  /// `pose`: of the coordinates that the body was described in.
  ///   returns  where FCL finds none a distance of 0
  BodyGap gap(const SolidBody& a, const LinkPose& pose_a, const SolidBody& b, const LinkPose& pose_b) const;
  /// By how much they overlap, mm; 0: not known.
  double depth(const SolidBody& a, const LinkPose& pose_a, const SolidBody& b, const LinkPose& pose_b) const;

 private:
  const KadrBodiesDoor* door_;
  std::unique_ptr<KadrBodies, void (*)(KadrBodies*)> bodies_;
};

/// Circles of a body of revolution, upwards: radius and height of each. Their hull is the body, where arcs are lines about them by at most
/// `chord` mm.
std::vector<Vec2> circles_of(const ConvexBody& body, double chord);

}  // namespace kadr
