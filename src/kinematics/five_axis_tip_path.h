#pragma once
// FiveAxisTipPath: the path of the tool tip in one motion with tool centre point control, for modes in which the tip does not simply follow
// the programmed curve while the rotary axes move evenly. The modes are: tool posture control, which keeps the shank in a plane or on a
// cone (NCT 25.16); the cutting point on the programmed curve (nct 25.17); a rotation about a point on the tool's axis (G53.6 R, 25.15).
// spec/nct/25g, 25i, 25j.

#include <memory>
#include <optional>

#include "action/action.h"
#include "kinematics/five_axis_transform.h"

namespace kadr {

/// The change of the tool's direction from one direction to another, and the positions of the rotary axes that produce it. Two rotary
/// solutions give each direction; the path follows the solution that contains the start position.
class DirectionPath {
 public:
  /// Describes an arc: unit vectors of its plane's two axes and of its own axis, and the swept angle in degrees, positive
  /// counter-clockwise.
  struct Cone {
    Vec3 first, second, axis;
    double sweep = 0;
  };
  /// Describes the change of direction from `from` to `to`, which are unit vectors.
  ///   start  programmed positions of the rotary axes at the start
  ///   cone   the arc over which the tool moves on a cone; nullopt: the tool stays in the plane of `from` and `to`
  DirectionPath(const FiveAxisTransform& space, RotaryPair start, Vec3 from, Vec3 to, const std::optional<Cone>& cone);

  Vec3 direction(double part) const;
  /// Returns the rotary positions at the fraction `part` (0 to 1) of the path. Among equivalent positions, it selects those nearest to
  /// `near`; nullopt if no positions give the direction.
  std::optional<RotaryPair> rotary(double part, RotaryPair near) const;

 private:
  std::optional<RotaryPair> on_branch(double part, RotaryPair near, int swaps, bool at_end) const;

  FiveAxis machine_;
  RotaryPair zero_, start_;
  Vec3 from_, to_;
  std::optional<Cone> cone_;
  double angle_ = 0;  // angle between the directions at start and end, radians
  // On a cone, radians: angle of the tool about the cone's axis at the start, and rotation about this axis
  double angle_from_ = 0, turn_ = 0;
  // On a cone, radians: angle between the tool and the cone's axis at the start and at the end
  double inclination_from_ = 0, inclination_to_ = 0;
  int branch_ = 0;                      // number of the rotary solution that contains the start position
  std::optional<double> through_pole_;  // fraction (0 to 1) of the path at which the direction is singular and the two solutions swap
};

class FiveAxisTipPath final : public TipPath {
 public:
  struct Data {
    std::shared_ptr<const FiveAxisTransform> space;
    Axes start{}, end{};  // work coordinates of the motion's ends; positions of axes that roll over are not reduced to one revolution
    bool posture = false;
    std::optional<DirectionPath::Cone> cone;
    // contact: the cutting point follows the curve; begins: contact begins here, so at the start the tip still follows the curve
    bool contact = false, begins = false;
    double radius = 0, corner = 0;  // radius and corner radius of the tool, mm
    Vec3 normal, end_normal;        // unit normals of the surface at the start and at the end of the motion
    std::optional<double> pivot;    // distance from the tip to the point about which the tool rotates, mm, positive away from the holder
  };
  explicit FiveAxisTipPath(const Data& data);

  Axes at(double part, const Axes& on_curve) const override;
  Vec3 normal(double part) const override;
  /// Returns the rotary positions at the end of a motion with tool posture control; nullopt if no rotary positions give the direction.
  std::optional<RotaryPair> end_of_posture() const;

 private:
  RotaryPair pair_of(const Axes& work) const { return d_.space->rotary(work); }
  void set_pair(Axes& work, RotaryPair to) const;
  Vec3 main_of(const Axes& work) const;
  void set_main(Axes& work, Vec3 to) const;

  Data d_;
  std::optional<DirectionPath> direction_path_;
};

/// Returns the vector from the cutting point to the tip of a tool with this radius and corner radius (nct 25.17; INFERRED: the tool's end
/// is a torus).
Vec3 contact_to_tip(Vec3 normal, Vec3 tool, double radius, double corner);
/// Returns the direction `from`, rotated towards `to` by the fraction `part` (0 to 1) of the angle between these two unit vectors.
Vec3 turned_towards(Vec3 from, Vec3 to, double part);

}  // namespace kadr
