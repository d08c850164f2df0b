// Computes the poses of a machine's links, and upper bounds of the links' motion. Used by stock/bodies; tested by
// tests/kinematics/machine_links_test.cpp.

#include "kinematics/machine_links.h"

#include <cmath>

namespace kadr {

MachineLinks::MachineLinks(const MachineTree& tree) : links_(1) {
  add(tree.tool(), false);
  tool_ = links_.size() - 1;
  add(tree.part(), true);
  part_ = tree.part().empty() ? bed : links_.size() - 1;
}

/// Adds the links of a chain. For a linear axis that carries the part, the machine file states the direction in which the tool moves as
/// seen from the part, so the part itself moves in the opposite direction. For a rotary axis, the file states the rotation of the part
/// itself.
void MachineLinks::add(const std::vector<MachineJoint>& chain, bool of_part) {
  std::size_t carrier = bed;
  for (const MachineJoint& joint : chain) {
    const double sense = joint.moves.reversed ? -1 : 1;
    links_.push_back({joint, carrier, of_part && !joint.moves.turns ? -sense : sense});
    carrier = links_.size() - 1;
  }
}

std::size_t MachineLinks::moved_by(const std::string& axis) const {
  for (std::size_t i = 1; i < links_.size(); ++i)
    if (links_[i].joint.name == axis) return i;
  return bed;
}

void MachineLinks::poses(const Axes& axes, std::vector<LinkPose>& poses) const {
  poses.resize(links_.size());
  poses[bed] = {};
  for (std::size_t i = 1; i < links_.size(); ++i) {
    const Link& link = links_[i];
    const AxisJoint& moves = link.joint.moves;
    const LinkPose& carrier = poses[link.carried_by];
    const double by = position(link, axes);
    if (!moves.turns) {
      poses[i] = {carrier.turn, carrier.at + by * (carrier.turn * moves.direction)};
    } else {
      const Mat3 turned = Mat3::about(moves.direction, by);
      poses[i] = {carrier.turn * turned, carrier.of(moves.through - turned * moves.through)};
    }
  }
}

/// Adds up the motions of the axes, from the body towards the bed. A linear axis moves all points by the same vector. A rotary axis moves a
/// point by at most the angle times the point's distance from the axis. This distance is at most the distance at the start plus the motion
/// of the point by the axes nearer to the body.
Travel MachineLinks::travel(std::size_t link, std::size_t from, const BodyBall& body, const std::vector<LinkPose>& poses,
                            const Axes& by) const {
  Travel travel;
  for (std::size_t i = link; i != from && i != bed; i = links_[i].carried_by) {
    const double moved = position(links_[i], by);
    if (moved == 0) continue;
    const AxisJoint& moves = links_[i].joint.moves;
    const LinkPose& carrier = poses[links_[i].carried_by];
    const Vec3 direction = carrier.turn * moves.direction;
    if (!moves.turns) {
      travel.together = travel.together + moved * direction;
      continue;
    }
    travel.besides += length(travel.together);
    travel.together = {};
    const double arm = length(cross(direction, body.centre - carrier.of(moves.through))) + body.radius + travel.besides;
    travel.besides += arm * std::fabs(moved) * rad_per_deg;
  }
  return travel;
}

std::size_t MachineLinks::carrier(std::size_t a, std::size_t b) const {
  // Finds the common carrier. A link has a greater number than the link that carries it, so the link with the greater number is replaced by
  // its carrier
  while (a != b) (a > b ? a : b) = links_[a > b ? a : b].carried_by;
  return a;
}

bool MachineLinks::same_place(const Axes& a, const Axes& b) const {
  for (std::size_t i = 1; i < links_.size(); ++i)
    if (position(links_[i], a) != position(links_[i], b)) return false;
  return true;
}

}  // namespace kadr
