#pragma once
// Computes the point of a straight path at which a touch probe triggers: at switch positions from the set-up, or at a solid workpiece with
// one drilled hole. At the workpiece, the contact decides where the centre of the probe's ball (radius r) is: on the top face at the height
// top + r; on the wall at the distance R − r from the axis of the hole (radius R); on the bottom at the height top − depth + r; on the rim
// (top edge of the hole) at the distance r from the rim. Section through the hole:
//
//        top ─────┐   r  ┌─────
//                 │ ╭──╮ │
//                 │ ╰──╯ │
//   top − depth   └──────┘

#include <optional>
#include <string>
#include <vector>

#include "action/action.h"
#include "action/axis_roles.h"
#include "config/setup/setup.h"
#include "kinematics/chain.h"

namespace kadr {

/// Returns the fraction (0 to 1) of the path at which the probe's ball first touches the workpiece; nullopt if the ball does not touch the
/// workpiece. A ball that starts inside the material touches at 0. A ball that starts in contact and moves away does not touch.
std::optional<double> first_touch(const ProbeHole& hole, Vec3 from, Vec3 to);

class Probe {
 public:
  Probe(const std::vector<std::string>& axes, const AxisRoles& roles, const Setup& setup);

  /// Returns the answer for a straight path in work coordinates: the point at which the ball touches a switch or the workpiece; the end of
  /// the path if it touches nothing.
  ///   input  number of the probe input: with 1 to 8 only the switches of this input trigger, with 98 (probing by torque) no switch, with 0
  ///          all. INFERRED: the workpiece triggers with every number
  ProbeAnswer meet(const Axes& from, const Axes& to, int input = 0) const;

 private:
  struct Switch {
    int input;
    std::size_t axis;
    double position;
  };
  AxisRoles roles_;
  Chain chain_;
  std::vector<Switch> switches_;
  std::optional<ProbeHole> hole_;
};

}  // namespace kadr
