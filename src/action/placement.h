#pragma once
// Placement: how work coordinates lie on the machine.

#include <array>
#include <cstdint>
#include <memory>

#include "base/vec.h"

namespace kadr {

/// A rotation of the main axes (nct 10.2.3).
struct FrameTurn {
  std::array<Vec3, 3> rows{Vec3{1, 0, 0}, Vec3{0, 1, 0}, Vec3{0, 0, 1}};  // of the matrix
  std::array<std::int8_t, 3> main{0, 1, 2};                               // axes X, Y, Z by index, -1: none
  friend bool operator==(const FrameTurn&, const FrameTurn&) = default;
};

/// Work coordinates turned with the frame: `turn · work` on the main axes; the others stay. nullptr: as they are.
Axes turned_axes(const FrameTurn& turn, const Axes& work);
inline Axes turned(const FrameTurn* turn, const Axes& work) { return turn == nullptr ? work : turned_axes(*turn, work); }

/// machine = origin + length + work; with a turn, on the main axes: origin + length + turn · (shift + work).
///   law  work_of(machine_of(w)) == w up to rounding
struct Placement {
  Axes origin{};                            // of the work system, machine coordinates, all shifts included that are not turned
  Axes length{};                            // of the tool, by axis
  Axes shift{};                             // turned with it (G52 and G92 of the NCT); zero without a turn
  std::shared_ptr<const FrameTurn> turn{};  // nullptr: none
  friend bool operator==(const Placement&, const Placement&) = default;

  Axes machine_of(const Axes& work) const;
  Axes work_of(const Axes& machine) const;
  /// With a turn the main axes move together.
  AxisMask moved_with(AxisMask named) const;
};

}  // namespace kadr
