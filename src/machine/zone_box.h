#pragma once
// ZoneBox: a box in machine coordinates, and where a motion first meets it.

#include <optional>

#include "path/curve/machine_path.h"

namespace kadr {

/// Faces included; infinite in the axes that it does not name. Empty where a least value is above the most.
struct ZoneBox {
  AxisMask axes = 0;
  Axes least{};
  Axes most{};

  bool has(std::size_t axis) const { return (axes >> axis & 1U) != 0; }
  bool empty() const;
  bool holds(const Axes& point) const;

  /// It has no point in common with a box of all axes.
  bool apart(const Extents& box) const;

  /// All faces moved outwards by `margin`, mm or degrees.
  ZoneBox grown(double margin) const;
};

/// The part at which the path first meets the box; nothing: it stays out.
///   law  of a line exact to rounding; of any other path at most MachinePath::closeness off the box
std::optional<double> first_meeting(const ZoneBox& box, const MachinePath& path);

/// The part at which one axis first passes a value, upwards or downwards; nothing: it does not.
enum class Side : std::uint8_t { above, below };
std::optional<double> first_passing(const MachinePath& path, std::size_t axis, double value, Side side);

}  // namespace kadr
