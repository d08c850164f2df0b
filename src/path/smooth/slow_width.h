#pragma once
// SlowWidth: the width of the roundings of a chain along the path. It is nowhere wider than the corners nearby allow, and it changes so
// slowly and evenly that the rounded path stays smooth (jumps of the width would increase the third derivative, and so reduce the speed).
//
// Stored in parts of 0.1 mm: first the minimum over the corners in each part, then limited in slope, then the minimum and the mean within
// half a width; between the parts a cubic B-spline, so that the second derivative of the rounded path has no jumps. What is settled does
// not change any more while the path is extended.

#include <cstddef>
#include <vector>

#include "path/smooth/chain_sums.h"

namespace kadr {

class SlowWidth {
 public:
  /// Resets the width to its maximum everywhere.
  void begin();
  /// Recomputes the width from the settled part up to this length.
  void open(double end);
  /// Limits the width at a length; ignored in the settled part.
  void limit(double at, double width);
  void close();
  /// Settles the width before this length: it will not change any more.
  void settle(double before);
  /// Drops the data before this length.
  void forget(double before);

  WidthAt at(double s) const;

  /// Returns how far ahead of a position the width there may be limited from.
  static double felt();

 private:
  std::size_t part_of(double at) const;
  void level(std::vector<double>& parts, bool mean);

  std::size_t first_ = 0, settled_ = 0;  // in parts from length 0: index of the first stored part; end of the settled parts
  std::vector<double> raw_, width_;      // of each part: limited in slope; final
  std::vector<double> now_, next_;       // work space
};

}  // namespace kadr
