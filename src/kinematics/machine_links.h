#pragma once
// MachineLinks: the parts of a machine that its axes carry, and how far they can move. A link is the bed, or what one axis moves and
// carries on to the next; MachineTree says which. mm, degrees.
//
//   bed ── X ── Z        tool chain: links 1, 2
//    └──── Y ── A ── C   part chain: links 3, 4, 5

#include <string>
#include <vector>

#include "base/matrix.h"
#include "kinematics/machine_tree.h"

namespace kadr {

/// Where a link is: a place of it, said as all axes stand at 0, is at turn · place + at.
struct LinkPose {
  Mat3 turn;
  Vec3 at;

  Vec3 of(Vec3 place) const { return turn * place + at; }
  Vec3 back(Vec3 place) const { return turned_back(turn, place - at); }
  LinkPose after(const LinkPose& inner) const { return {turn * inner.turn, of(inner.at)}; }
  LinkPose inverse() const { return {transposed(turn), turned_back(turn, -1 * at)}; }
};

/// All of a body lies within it, seen from the bed.
struct BodyBall {
  Vec3 centre;
  double radius = 0;
};

/// By which places of a body move, seen from another link: `together` all of them, and each by no more than `besides`.
struct Travel {
  Vec3 together;
  double besides = 0;
};

class MachineLinks {
 public:
  explicit MachineLinks(const MachineTree& tree);

  static constexpr std::size_t bed = 0;
  std::size_t count() const { return links_.size(); }
  /// What carries the tool, the part.
  std::size_t tool() const { return tool_; }
  std::size_t part() const { return part_; }
  /// That an axis moves; the bed: of no name, or of an axis of neither chain.
  std::size_t moved_by(const std::string& axis) const;
  /// On the way to the tool; the bed is not.
  bool carries_tool(std::size_t link) const { return link != bed && link <= tool_; }

  /// Of each link.
  void poses(const Axes& axes, std::vector<LinkPose>& poses) const;

  /// How a body of `link` moves, seen from `from`, a link that carries it, while each axis moves evenly by `by`.
  ///   poses    of the links at the start
  ///   law      no place of the body is then farther from where it was than |together| + besides, and at a part s of the way no farther
  ///            than s of that
  Travel travel(std::size_t link, std::size_t from, const BodyBall& body, const std::vector<LinkPose>& poses, const Axes& by) const;
  /// The innermost link that carries both.
  std::size_t carrier(std::size_t a, std::size_t b) const;
  /// Whether every axis of the chains stands at the same position in both.
  bool same_place(const Axes& a, const Axes& b) const;

 private:
  struct Link {
    MachineJoint joint;  // that moves it; of the bed none
    std::size_t carried_by = bed;
    double sense = 1;  // of the joint's positions
  };
  double position(const Link& link, const Axes& axes) const {
    return link.joint.axis < 0 ? 0 : link.sense * axes[static_cast<std::size_t>(link.joint.axis)];
  }
  void add(const std::vector<MachineJoint>& chain, bool of_part);

  std::vector<Link> links_;  // each after what carries it
  std::size_t tool_ = bed, part_ = bed;
};

}  // namespace kadr
