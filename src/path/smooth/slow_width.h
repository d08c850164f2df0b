#pragma once
// SlowWidth: how wide the corners of a chain are rounded along the path: nowhere wider than at the corners nearby, and changing so slowly
// and evenly that the rounded path stays smooth (a saw in the width would cost third derivative, and with it speed).
//
// Kept in parts of 0.1 mm: the least of the corners in each, then no steeper than a slope, then the least and the mean of what lies within
// half a width; between the parts a cubic B-spline, so that the second derivative of
// the rounded path has no jumps. What is settled does not change any more, while the path goes on.

#include <cstddef>
#include <vector>

#include "path/smooth/chain_sums.h"

namespace kadr {

class SlowWidth {
 public:
  /// Nothing known: as wide as can be.
  void begin();
  /// From here on it is found anew, up to a length.
  void open(double end);
  /// At most so wide at a length; not before the settled part.
  void limit(double at, double width);
  void close();
  /// It will not be changed before this length.
  void settle(double before);
  /// Nobody asks for what lies before.
  void forget(double before);

  WidthAt at(double s) const;

  /// So far ahead of a place what limits the width there may lie.
  static double felt();

 private:
  std::size_t part_of(double at) const;
  void level(std::vector<double>& parts, bool mean);

  std::size_t first_ = 0, settled_ = 0;  // parts, counted from length 0: that of front(); before it they are settled
  std::vector<double> raw_, width_;      // of each part: with the slope; in the end
  std::vector<double> now_, next_;       // while it is found
};

}  // namespace kadr
