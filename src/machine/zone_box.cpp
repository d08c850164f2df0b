// Finds the point at which a motion first meets a box in machine coordinates. Used by machine/zones.

#include "machine/zone_box.h"

#include <algorithm>

namespace kadr {
namespace {

/// Returns the fraction (0 to 1) of a straight path at which the path enters the box. For each axis, the path is between two faces of the
/// box over a range of fractions; the path is in the box over the intersection of these ranges.
std::optional<double> line_meets(const ZoneBox& box, const Axes& from, const Axes& to) {
  double enters = 0, leaves = 1;
  for (std::size_t i = 0; i < max_axes; ++i) {
    if (!box.has(i)) continue;
    const double travel = to[i] - from[i];
    if (travel == 0) {
      if (from[i] < box.least[i] || from[i] > box.most[i]) return std::nullopt;
      continue;
    }
    const auto [first, last] = std::minmax({(box.least[i] - from[i]) / travel, (box.most[i] - from[i]) / travel});
    enters = std::max(enters, first);
    leaves = std::min(leaves, last);
  }
  return enters <= leaves ? std::optional(enters) : std::nullopt;
}

}  // namespace

bool ZoneBox::empty() const {
  for (std::size_t i = 0; i < max_axes; ++i)
    if (has(i) && least[i] > most[i]) return true;
  return false;
}

bool ZoneBox::holds(const Axes& point) const {
  for (std::size_t i = 0; i < max_axes; ++i)
    if (has(i) && !(point[i] >= least[i] && point[i] <= most[i])) return false;
  return true;
}

bool ZoneBox::apart(const Extents& box) const {
  for (std::size_t i = 0; i < max_axes; ++i)
    if (has(i) && (box.most[i] < least[i] || box.least[i] > most[i])) return true;
  return false;
}

ZoneBox ZoneBox::grown(double margin) const {
  ZoneBox box = *this;
  for (std::size_t i = 0; i < max_axes; ++i) {
    if (!has(i)) continue;
    box.least[i] -= margin;
    box.most[i] += margin;
  }
  return box;
}

std::optional<double> first_meeting(const ZoneBox& box, const MachinePath& path) {
  if (box.empty()) return std::nullopt;
  if (path.straight()) return line_meets(box, path.start(), path.end());
  return path.first_not([&](const Extents& piece) { return box.apart(piece); });
}

std::optional<double> first_passing(const MachinePath& path, std::size_t axis, double value, Side side) {
  const double from = path.start()[axis], to = path.end()[axis];
  if (!path.straight())
    return path.first_not(
        [&](const Extents& piece) { return side == Side::above ? piece.most[axis] <= value : piece.least[axis] >= value; });
  if (side == Side::above ? to <= value : to >= value) return std::nullopt;
  return from == to ? 0 : std::clamp((value - from) / (to - from), 0.0, 1.0);
}

}  // namespace kadr
