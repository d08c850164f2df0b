#pragma once
// Placement: how work coordinates lie on the machine.

#include <array>
#include <cstdint>
#include <memory>

#include "base/vec.h"

namespace kadr {

/// Which axis of the machine each programmed one drives, and which of them backwards, about the machine's zero (nct 20.3, 20.4).
struct AxisDrives {
  std::array<std::int8_t, max_axes> axis;  // a permutation
  AxisMask reversed = 0;                   // programmed axes
  bool is_own = true;                      // each its own, forwards
  AxisDrives();
  friend bool operator==(const AxisDrives&, const AxisDrives&) = default;

  std::size_t of(std::size_t programmed) const { return static_cast<std::size_t>(axis[programmed]); }
  double sense(std::size_t programmed) const { return (reversed >> programmed & 1U) != 0 ? -1 : 1; }
  Axes driven(const Axes& programmed) const;
  Axes programmed(const Axes& driven) const;
};

/// A rotation of the main axes (nct 10.2.3), and the axes that then carry it out.
struct FrameTurn {
  std::array<Vec3, 3> rows{Vec3{1, 0, 0}, Vec3{0, 1, 0}, Vec3{0, 0, 1}};  // of the matrix
  std::array<std::int8_t, 3> main{0, 1, 2};                               // axes X, Y, Z by index, -1: none
  AxisDrives drives;
  friend bool operator==(const FrameTurn&, const FrameTurn&) = default;
};

/// Work coordinates turned with the frame: `turn · work` on the main axes; the others stay. nullptr: as they are.
Axes turned_axes(const FrameTurn& turn, const Axes& work);
Axes turned_back_axes(const FrameTurn& turn, const Axes& way);
inline Axes turned(const FrameTurn* turn, const Axes& work) { return turn == nullptr ? work : turned_axes(*turn, work); }

/// Of the tool in space.
struct Pose {
  Vec3 tip;                 // mm
  Vec3 direction{0, 0, 1};  // from the tip into the tool, of length 1
};

/// How work coordinates lie in the part and on the machine where they are turned in space, or rotary axes take the tool or the part along
/// (nct 25). Work coordinates are those of the programming frame in force. kinematics/part_space makes them.
class WorkSpace {
 public:
  virtual ~WorkSpace() = default;
  /// Only seen from here: the Placement itself says where the axes stand.
  virtual bool is_plain() const = 0;
  /// The tip is led: along a motion the axes stand where machine_of() says, at each of its points (nct 25.14). Else at its end, and go
  /// there evenly.
  virtual bool leads_tip() const = 0;
  /// The positions of these axes count, whatever work coordinates the others have.
  virtual Axes machine_of(const Axes& work, const Axes& plainly) const = 0;
  virtual Axes work_of(const Axes& machine, const Axes& plainly) const = 0;
  /// Axes that move with these; the rotary ones may move the others, or leave them where they are (N3212 FOS).
  virtual AxisMask moved_with(AxisMask named) const = 0;
  /// Work coordinates of axes that stand change with these.
  virtual bool changes_work(AxisMask named) const = 0;
  /// X, Y, Z in the work system, whatever the programming frame is (G68.1, G68.2).
  virtual Axes in_system(const Axes& work) const = 0;
  /// Where its zero is on the machine, as that was measured.
  virtual Vec3 zero() const = 0;
  /// The programming frame's directions lie otherwise than those of the work system.
  virtual bool has_frame() const = 0;
  /// Where the tool is in the part, which turns with its table: in the work system as it lies where that was measured.
  virtual Pose pose(const Axes& machine) const = 0;
  /// There are rotary axes that turn the tool or the part.
  virtual bool has_rotary() const = 0;
  /// Radius, mm, by which a degree of the rotary axes moves the tip at most, about where the axes stand.
  virtual double arm(const Axes& machine) const = 0;
  /// Those of the rotary axes.
  virtual AxisMask rotary_axes() const = 0;
};

/// machine = origin + length + work; with a turn, on the main axes: origin + length + turn · (shift + work); then as the axes are driven.
///   law  work_of(machine_of(w)) == w up to rounding
struct Placement {
  Axes origin{};                             // of the work system, machine coordinates, all shifts included that are not turned
  Axes length{};                             // of the tool, by axis
  Axes shift{};                              // turned with it (G52 and G92 of the NCT); zero without a turn
  std::shared_ptr<const FrameTurn> turn{};   // of directions; nullptr: none, or they change with the rotary axes
  std::shared_ptr<const WorkSpace> space{};  // nullptr: there is no more to say; one that is not plain says where the axes stand
  friend bool operator==(const Placement&, const Placement&) = default;

  Axes machine_of(const Axes& work) const;
  Axes work_of(const Axes& driven) const;
  /// Axes of the machine that move with these programmed ones: with a turn the main axes together.
  AxisMask moved_with(AxisMask named) const;
  /// The axis of the machine that a programmed one drives.
  std::size_t driven(std::size_t axis) const { return turn == nullptr ? axis : turn->drives.of(axis); }
  /// A sum, axis by axis.
  bool is_plain() const { return turn == nullptr && (space == nullptr || space->is_plain()); }
};

}  // namespace kadr
