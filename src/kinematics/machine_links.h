#pragma once
// MachineLinks: the moving parts of a machine, and bounds of their motion. A link is the bed, or what one axis moves, together with
// the next links that it carries; MachineTree gives the order. mm, degrees.
//
//   bed ── X ── Z        tool chain: links 1, 2
//    └──── Y ── A ── C   part chain: links 3, 4, 5

#include <string>
#include <vector>

#include "base/matrix.h"
#include "kinematics/machine_tree.h"

namespace kadr {

/// The pose of a link: a point with the coordinates `place` when all axes are at 0 is now at turn · place + at.
struct LinkPose {
  Mat3 turn;
  Vec3 at;

  Vec3 of(Vec3 place) const { return turn * place + at; }
  Vec3 back(Vec3 place) const { return turned_back(turn, place - at); }
  LinkPose after(const LinkPose& inner) const { return {turn * inner.turn, of(inner.at)}; }
  LinkPose inverse() const { return {transposed(turn), turned_back(turn, -1 * at)}; }
};

/// A ball that encloses a whole body, in the coordinates of the bed.
struct BodyBall {
  Vec3 centre;
  double radius = 0;
};

/// A bound of how the points of a body move, seen from another link: all of them by `together`, and each one by at most `besides`
/// more.
struct Travel {
  Vec3 together;
  double besides = 0;
};

class MachineLinks {
 public:
  explicit MachineLinks(const MachineTree& tree);

  static constexpr std::size_t bed = 0;
  std::size_t count() const { return links_.size(); }
  /// The links that carry the tool and the part.
  std::size_t tool() const { return tool_; }
  std::size_t part() const { return part_; }
  /// Returns the link that an axis moves; the bed if the name is empty or the axis is in neither chain.
  std::size_t moved_by(const std::string& axis) const;
  /// True for the links between bed and tool, without the bed.
  bool carries_tool(std::size_t link) const { return link != bed && link <= tool_; }

  /// Computes the pose of each link.
  void poses(const Axes& axes, std::vector<LinkPose>& poses) const;

  /// Bounds the motion of a body of `link`, seen from the link `from` that carries it, while each axis moves evenly by `by`.
  ///   poses    of the links at the start
  ///   law      no point of the body is then farther from its start than |together| + besides; after a share s of the motion, no
  ///            farther than s times that
  Travel travel(std::size_t link, std::size_t from, const BodyBall& body, const std::vector<LinkPose>& poses, const Axes& by) const;
  /// Returns the innermost link that carries both.
  std::size_t carrier(std::size_t a, std::size_t b) const;
  /// True if each axis of the chains has the same position in both.
  bool same_place(const Axes& a, const Axes& b) const;

 private:
  struct Link {
    MachineJoint joint;  // the joint that moves the link; unset for the bed
    std::size_t carried_by = bed;
    double sense = 1;  // 1 or -1, factor of the joint's positions
  };
  double position(const Link& link, const Axes& axes) const {
    return link.joint.axis < 0 ? 0 : link.sense * axes[static_cast<std::size_t>(link.joint.axis)];
  }
  void add(const std::vector<MachineJoint>& chain, bool of_part);

  std::vector<Link> links_;  // each link comes after its carrier
  std::size_t tool_ = bed, part_ = bed;
};

}  // namespace kadr
