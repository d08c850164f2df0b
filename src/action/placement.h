#pragma once
// Placement: the transformation between work coordinates and machine coordinates.

#include <array>
#include <cstdint>
#include <memory>

#include "base/vec.h"

namespace kadr {

/// The machine axis that each programmed axis drives, and the axes that are reversed about the machine's zero (nct 20.3, 20.4).
struct AxisDrives {
  std::array<std::int8_t, max_axes> axis;  // by programmed axis: index of the machine axis that it drives; a permutation
  AxisMask reversed = 0;                   // mask of the programmed axes that are reversed
  bool is_own = true;                      // true if each programmed axis drives its own machine axis and none is reversed
  AxisDrives();
  friend bool operator==(const AxisDrives&, const AxisDrives&) = default;

  std::size_t of(std::size_t programmed) const { return static_cast<std::size_t>(axis[programmed]); }
  double sense(std::size_t programmed) const { return (reversed >> programmed & 1U) != 0 ? -1 : 1; }
  Axes driven(const Axes& programmed) const;
  Axes programmed(const Axes& driven) const;
};

/// A rotation of the main axes (nct 10.2.3), and the assignment of the machine axes that execute it.
struct FrameTurn {
  std::array<Vec3, 3> rows{Vec3{1, 0, 0}, Vec3{0, 1, 0}, Vec3{0, 0, 1}};  // rows of the rotation matrix
  std::array<std::int8_t, 3> main{0, 1, 2};                               // indices of the axes X, Y, Z; -1: the channel lacks the axis
  AxisDrives drives;
  friend bool operator==(const FrameTurn&, const FrameTurn&) = default;
};

/// turned_axes() returns the work coordinates rotated by the frame: `turn · work` on the main axes, other axes unchanged.
/// turned_back_axes() is the inverse. turned() also accepts nullptr for `turn`, and then returns `work` unchanged.
Axes turned_axes(const FrameTurn& turn, const Axes& work);
Axes turned_back_axes(const FrameTurn& turn, const Axes& travel);
inline Axes turned(const FrameTurn* turn, const Axes& work) { return turn == nullptr ? work : turned_axes(*turn, work); }

/// The position and direction of the tool in space.
struct Pose {
  Vec3 tip;                 // position of the tool tip, mm
  Vec3 direction{0, 0, 1};  // unit vector along the tool's axis, from the tip towards the holder
};

/// The transformation between work and machine coordinates for a frame that is tilted in space, or for rotary axes that carry the tool or
/// the part (nct 25). Work coordinates refer to the programming frame in force. Implemented in kinematics/five_axis_transform.
class WorkTransform {
 public:
  virtual ~WorkTransform() = default;
  /// Returns true if the fields of the Placement alone determine the axis positions; this object then only computes the pose of the tool.
  virtual bool is_plain() const = 0;
  /// Returns true under tool centre point control. In this case, machine_of() gives the axis positions at each point of a motion (nct
  /// 25.14). Otherwise machine_of() gives them at the end of the motion only, and the axes move evenly to that point.
  virtual bool controls_tip() const = 0;
  /// Converts work coordinates to machine coordinates. `plainly` is the result without this transformation; the rotary positions and all
  /// axes that are not transformed are copied from it.
  virtual Axes machine_of(const Axes& work, const Axes& plainly) const = 0;
  virtual Axes work_of(const Axes& machine, const Axes& plainly) const = 0;
  /// Returns the axes that move if the axes `named` are programmed. If a rotary axis is named, the parameter N3212 FOS decides whether the
  /// linear axes move too.
  virtual AxisMask moved_with(AxisMask named) const = 0;
  /// Returns true if a motion of the axes `named` changes the work coordinates of axes that do not move.
  virtual bool changes_work(AxisMask named) const = 0;
  /// Returns X, Y, Z in the work system, independent of the programming frame (G68.1, G68.2) in force.
  virtual Axes in_system(const Axes& work) const = 0;
  /// Returns the measured position of the work system's origin, in machine coordinates.
  virtual Vec3 zero() const = 0;
  /// Returns true if the directions of the programming frame differ from those of the work system.
  virtual bool has_frame() const = 0;
  /// Returns the pose of the tool relative to the part, which rotates with the table. The coordinates refer to the work system in the
  /// orientation that it had when its zero was measured.
  virtual Pose pose(const Axes& machine) const = 0;
  /// Returns true if rotary axes turn the tool or the part.
  virtual bool has_rotary() const = 0;
  /// Returns the greatest radius, in mm, of the circles on which the rotary axes move the tip near these axis positions.
  virtual double arm(const Axes& machine) const = 0;
  /// Returns the mask of the axes that are rotary.
  virtual AxisMask rotary_axes() const = 0;
};

/// A Placement computes machine = origin + length + work. If the frame is rotated (`turn` is set), the main axes are origin + length + turn
/// · (shift + work), and each value is then assigned to the machine axis that `turn->drives` names.
///   law  work_of(machine_of(w)) == w up to the rounding error
struct Placement {
  Axes origin{};  // origin of the work system in machine coordinates, with all shifts except those in `shift`
  Axes length{};  // tool length by axis, mm
  Axes shift{};   // shift that is rotated together with the work coordinates (G52 and G92 of the NCT); zero without `turn`
  // rotation of the frame; nullptr: no rotation, or a rotation that depends on the rotary axes (see `space`)
  std::shared_ptr<const FrameTurn> turn{};
  // transformation in space, which determines the axis positions unless its is_plain() is true; nullptr: no transformation
  std::shared_ptr<const WorkTransform> space{};
  friend bool operator==(const Placement&, const Placement&) = default;

  Axes machine_of(const Axes& work) const;
  Axes work_of(const Axes& driven) const;
  /// Returns the machine axes that move if the axes `named` are programmed. In a rotated frame, one programmed main axis moves all main
  /// axes.
  AxisMask moved_with(AxisMask named) const;
  /// Returns the machine axis that a programmed axis drives.
  std::size_t driven(std::size_t axis) const { return turn == nullptr ? axis : turn->drives.of(axis); }
  /// Returns true if machine_of() only adds constants to the coordinates, without a rotation or a transformation in space.
  bool is_plain() const { return turn == nullptr && (space == nullptr || space->is_plain()); }
};

}  // namespace kadr
