#pragma once
// TipWays: the tool's path during one motion with tip control where this is more than the motion's curve and evenly moving rotary
// axes. It covers tool posture control, with the shank in a plane or on a cone (NCT 25.16), the cutting point on the curve (25.17),
// and a rotation about a point of the tool's axis (G53.6 R, 25.15). spec/nct/25g, 25i, 25j.

#include <memory>
#include <optional>

#include "action/action.h"
#include "kinematics/part_space.h"

namespace kadr {

/// The path from one tool direction to another, and of the rotary axes that give it: it follows the branch of the solutions that
/// continues the start.
class DirectionWay {
 public:
  /// For an arc: the directions of its plane's axes and of its own axis, and the swept angle in degrees, counter-clockwise positive.
  struct Cone {
    Vec3 first, second, axis;
    double sweep = 0;
  };
  ///   start  present positions of the rotary axes (programmed positions)
  DirectionWay(const PartSpace& space, RotaryPair start, Vec3 from, Vec3 to, const std::optional<Cone>& cone);

  Vec3 direction(double part) const;
  /// Returns the rotary positions at a share of the path, out of all equivalent ones the nearest to `near`; nullopt if no position
  /// gives the direction.
  std::optional<RotaryPair> rotary(double part, RotaryPair near) const;

 private:
  std::optional<RotaryPair> on_branch(double part, RotaryPair near, int swaps, bool at_end) const;

  FiveAxis machine_;
  RotaryPair zero_, start_;
  Vec3 from_, to_;
  std::optional<Cone> cone_;
  double angle_ = 0;                    // between the two directions, radians
  double angle_from_ = 0, turn_ = 0;    // for a cone: rotation about its axis, radians
  double lean_from_ = 0, lean_to_ = 0;  // for a cone: inclination to its axis, radians
  int branch_ = 0;                      // which of the two solutions holds at the start
  std::optional<double> through_pole_;  // share of the path at a singular direction, where the branches swap
};

class TipWays final : public TipWay {
 public:
  struct Data {
    std::shared_ptr<const PartSpace> space;
    Axes start{}, end{};  // work coordinates of the motion's ends; axes with roll-over keep counting
    bool posture = false;
    std::optional<DirectionWay::Cone> cone;
    bool contact = false, begins = false;  // the curve is the path of the cutting point; `begins`: it starts as the path of the tip
    double radius = 0, corner = 0;         // of the tool, mm
    Vec3 normal, end_normal;               // of the surface, unit length
    std::optional<double> pivot;           // mm from the tip, away from the holder: this point of the tool stays fixed
  };
  explicit TipWays(const Data& data);

  Axes at(double part, const Axes& on_curve) const override;
  Vec3 normal(double part) const override;
  /// Returns the final rotary positions under posture control; nullopt if they cannot be reached.
  std::optional<RotaryPair> end_of_posture() const;

 private:
  RotaryPair pair_of(const Axes& work) const { return d_.space->rotary(work); }
  void set_pair(Axes& work, RotaryPair to) const;
  Vec3 main_of(const Axes& work) const;
  void set_main(Axes& work, Vec3 to) const;

  Data d_;
  std::optional<DirectionWay> way_;
};

/// Returns the vector from the cutting point to the tip of a tool with these radii (25.17, INFERRED there: a torus).
Vec3 contact_to_tip(Vec3 normal, Vec3 tool, double radius, double corner);
/// Turns a direction towards another by a share of the angle between them; both have unit length.
Vec3 turned_towards(Vec3 from, Vec3 to, double part);

}  // namespace kadr
