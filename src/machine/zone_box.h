#pragma once
// ZoneBox: a box in machine coordinates, and the search for the point at which a motion first enters the box.

#include <optional>

#include "path/curve/machine_path.h"

namespace kadr {

/// A box whose faces belong to it. The box is unlimited along axes that are not in `axes`, and empty if a `least` exceeds its `most`.
struct ZoneBox {
  AxisMask axes = 0;
  Axes least{};
  Axes most{};

  bool has(std::size_t axis) const { return (axes >> axis & 1U) != 0; }
  bool empty() const;
  bool holds(const Axes& point) const;

  /// Returns true if this box and `box` have no common point.
  ///   pre  `box` has a least and a greatest position for every axis; no axis of it is unlimited
  bool apart(const Extents& box) const;

  /// Returns a copy of this box with all faces moved outwards by `margin`, mm or degrees.
  ZoneBox grown(double margin) const;
};

/// Returns the fraction (0 to 1) of the path at which the path first meets the box; nullopt if the path stays outside.
///   law  exact to the rounding error for a straight path; for any other path the point is at most MachinePath::closeness away from the box
std::optional<double> first_meeting(const ZoneBox& box, const MachinePath& path);

/// Returns the fraction (0 to 1) of the path at which one axis first exceeds a value (`above`) or falls below it (`below`); nullopt if the
/// axis never does.
enum class Side : std::uint8_t { above, below };
std::optional<double> first_passing(const MachinePath& path, std::size_t axis, double value, Side side);

}  // namespace kadr
