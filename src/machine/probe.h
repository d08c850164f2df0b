#pragma once
// What a touch probe meets on a straight line: switch positions of the setup, and a hole in a solid workpiece.
//
//        top ─────┐   r  ┌─────     Where the centre of the tip (a sphere of radius r) touches:
//                 │ ╭──╮ │            the top face at top + r, the wall at distance R − r from the hole's axis,
//                 │ ╰──╯ │            the bottom at top − depth + r, the rim (a circle) at distance r.
//   top − depth   └──────┘

#include <optional>
#include <string>
#include <vector>

#include "action/action.h"
#include "action/axis_roles.h"
#include "config/setup.h"
#include "kinematics/chain.h"

namespace kadr {

/// The part 0..1 of the way from `from` to `to` at which the tip first touches the workpiece; nothing: it stays free.
/// A tip that starts inside the material touches at 0; one that starts in touch and moves away does not.
std::optional<double> first_touch(const ProbeHole& hole, Vec3 from, Vec3 to);

class Probe {
 public:
  Probe(const std::vector<std::string>& axes, const AxisRoles& roles, const Setup& setup);

  /// Work coordinates. Where nothing is met, the end.
  ///   input  1 to 8: only its switch counts; 98, by torque: none; 0: all of them. The workpiece always does (INFERRED)
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
