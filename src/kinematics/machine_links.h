#pragma once
// MachineLinks: the moving links of a machine, and upper bounds of the links' motion. A link is the machine bed, or the component that one
// axis moves; each link carries the next link of its chain. MachineTree defines the order of the chains. Units: mm, degrees.
//
// Example of two chains from the bed:
//   bed ── X ── Z        tool chain: links 1, 2
//    └──── Y ── A ── C   part chain: links 3, 4, 5

#include <string>
#include <vector>

#include "base/matrix.h"
#include "kinematics/machine_tree.h"

namespace kadr {

/// The pose of a link. A point of the link that is at `place` when all axes are at 0 is now at turn · place + at.
struct LinkPose {
  Mat3 turn;
  Vec3 at;

  Vec3 of(Vec3 place) const { return turn * place + at; }
  Vec3 back(Vec3 place) const { return turned_back(turn, place - at); }
  LinkPose after(const LinkPose& inner) const { return {turn * inner.turn, of(inner.at)}; }
  LinkPose inverse() const { return {transposed(turn), turned_back(turn, -1 * at)}; }
};

/// A sphere that encloses a whole solid body, in the coordinates of the bed.
struct BodyBall {
  Vec3 centre;
  double radius = 0;
};

/// An upper bound for the motion of a body, seen from another link. Every point of the body moves by the vector `together`, and in addition
/// by at most `besides` mm in any direction.
struct Travel {
  Vec3 together;
  double besides = 0;
};

class MachineLinks {
 public:
  explicit MachineLinks(const MachineTree& tree);

  static constexpr std::size_t bed = 0;
  std::size_t count() const { return links_.size(); }
  /// tool() returns the link that carries the tool. part() returns the link that carries the part.
  std::size_t tool() const { return tool_; }
  std::size_t part() const { return part_; }
  /// Returns the link that an axis moves. Returns the bed if the name is empty, or if the axis belongs neither to the tool chain nor to the
  /// part chain.
  std::size_t moved_by(const std::string& axis) const;
  /// Returns true if the link is on the chain from the bed to the tool. The bed itself does not count.
  bool carries_tool(std::size_t link) const { return link != bed && link <= tool_; }

  /// Computes the pose of every link for these axis positions.
  void poses(const Axes& axes, std::vector<LinkPose>& poses) const;

  /// Bounds the motion of a body on `link`, seen from the link `from` that carries `link`, while each axis moves evenly by `by`.
  ///   poses    poses of all links at the start of the motion
  ///   law      at the end, no point of the body is farther from its start than |together| + besides; after a fraction s (0 to 1) of the
  ///            motion, no point is farther than s times this sum
  Travel travel(std::size_t link, std::size_t from, const BodyBall& body, const std::vector<LinkPose>& poses, const Axes& by) const;
  /// Returns the last link, in the order from the bed, that carries both `a` and `b`. A link also carries itself.
  std::size_t carrier(std::size_t a, std::size_t b) const;
  /// Returns true if each axis of the two chains has the same position in `a` and in `b`.
  bool same_place(const Axes& a, const Axes& b) const;

 private:
  struct Link {
    MachineJoint joint;  // the joint that moves the link; unset for the bed
    std::size_t carried_by = bed;
    double sense = 1;  // 1 or -1: factor for the axis position, from the sense in which the link moves
  };
  double position(const Link& link, const Axes& axes) const {
    return link.joint.axis < 0 ? 0 : link.sense * axes[static_cast<std::size_t>(link.joint.axis)];
  }
  void add(const std::vector<MachineJoint>& chain, bool of_part);

  std::vector<Link> links_;  // the links in an order in which each link comes after the link that carries it
  std::size_t tool_ = bed, part_ = bed;
};

}  // namespace kadr
