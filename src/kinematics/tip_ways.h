#pragma once
// TipWays: where the tool is along one motion that leads its tip, when that is more than the motion's curve and an even way of the rotary
// axes: the shank in a plane or on a cone (tool posture control, NCT 25.16), the cutting point on the curve (25.17), the tool turned about
// a point of its axis (G53.6 R, 25.15). spec/nct/25g, 25i, 25j.

#include <memory>
#include <optional>

#include "action/action.h"
#include "kinematics/part_space.h"

namespace kadr {

/// The way of a direction from one to another, and of the rotary axes that give it: the branch of the solutions that goes on from the
/// start.
class DirectionWay {
 public:
  /// Of an arc: the directions of its plane's axes, and of its own; degrees that it sweeps, counter-clockwise positive.
  struct Cone {
    Vec3 first, second, axis;
    double sweep = 0;
  };
  ///   start  where the rotary axes stand (programmed positions)
  DirectionWay(const PartSpace& space, RotaryPair start, Vec3 from, Vec3 to, const std::optional<Cone>& cone);

  Vec3 direction(double part) const;
  /// Nothing: no position of the axes gives that direction. `near`: of all equal positions the nearest to these.
  std::optional<RotaryPair> rotary(double part, RotaryPair near) const;

 private:
  std::optional<RotaryPair> on_branch(double part, RotaryPair near, int swaps, bool at_end) const;

  FiveAxis machine_;
  RotaryPair zero_, start_;
  Vec3 from_, to_;
  std::optional<Cone> cone_;
  double angle_ = 0;                    // between the two, radians
  double angle_from_ = 0, turn_ = 0;    // of a cone: about its axis, radians
  double lean_from_ = 0, lean_to_ = 0;  // inclination to it, radians
  int branch_ = 0;                      // which of two solutions, at the start
  std::optional<double> through_pole_;  // the part at which it goes through a singular direction: there the branches change
};

class TipWays final : public TipWay {
 public:
  struct Data {
    std::shared_ptr<const PartSpace> space;
    Axes start{}, end{};  // work coordinates of the motion's ends; axes that roll over count on
    bool posture = false;
    std::optional<DirectionWay::Cone> cone;
    bool contact = false, begins = false;  // the curve is that of the cutting point; `begins`: from where it is the tip's
    double radius = 0, corner = 0;         // of the tool, mm
    Vec3 normal, end_normal;               // of the surface, of length 1
    std::optional<double> pivot;           // mm from the tip, away from the holder: that point of the tool stands
  };
  explicit TipWays(const Data& data);

  Axes at(double part, const Axes& on_curve) const override;
  Vec3 normal(double part) const override;
  /// Where posture control brings the rotary axes; nothing: it cannot.
  std::optional<RotaryPair> end_of_posture() const;

 private:
  RotaryPair pair_of(const Axes& work) const { return d_.space->rotary(work); }
  void set_pair(Axes& work, RotaryPair to) const;
  Vec3 main_of(const Axes& work) const;
  void set_main(Axes& work, Vec3 to) const;

  Data d_;
  std::optional<DirectionWay> way_;
};

/// From the cutting point to the tip of a tool with these radii (25.17, INFERRED there: a torus).
Vec3 contact_to_tip(Vec3 normal, Vec3 tool, double radius, double corner);
/// From a direction towards another, both of length 1.
Vec3 turned_towards(Vec3 from, Vec3 to, double part);

}  // namespace kadr
