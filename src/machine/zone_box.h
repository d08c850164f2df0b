#pragma once
// ZoneBox: a box in machine coordinates. Finds where a motion first enters it.

#include <optional>

#include "path/curve/machine_path.h"

namespace kadr {

/// The faces belong to the box. It is infinite along axes outside `axes`, and empty if a least value exceeds the greatest.
struct ZoneBox {
  AxisMask axes = 0;
  Axes least{};
  Axes most{};

  bool has(std::size_t axis) const { return (axes >> axis & 1U) != 0; }
  bool empty() const;
  bool holds(const Axes& point) const;

  /// True if the box has no point in common with a box of all axes.
  bool apart(const Extents& box) const;

  /// Returns the box with all faces moved outwards by `margin`, mm or degrees.
  ZoneBox grown(double margin) const;
};

/// Returns the share of the path at which it first meets the box; nullopt if it stays outside.
///   law  exact to rounding for a line; for any other path at most MachinePath::closeness off the box
std::optional<double> first_meeting(const ZoneBox& box, const MachinePath& path);

/// Returns the share of the path at which one axis first passes a value, upwards or downwards; nullopt if it does not.
enum class Side : std::uint8_t { above, below };
std::optional<double> first_passing(const MachinePath& path, std::size_t axis, double value, Side side);

}  // namespace kadr
