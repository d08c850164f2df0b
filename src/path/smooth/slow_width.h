#pragma once
// SlowWidth: the width of the roundings of a chain of corners, as a function of the path length. The width nowhere exceeds what the nearby
// corners allow. It changes so slowly and evenly that the rounded path stays smooth: a jump of the width would increase the path's third
// derivative, and so reduce the speed.
//
// The path is divided into intervals of 0.1 mm. Each interval gets the least of the limits of its corners. Then the slope of the width
// along the path is limited. Then each interval gets the minimum, and after that the mean, of the intervals within half a width around it.
// A cubic B-spline interpolates between the intervals, so that the second derivative of the rounded path has no jumps. Settled values do
// not change any more when the path is extended.

#include <cstddef>
#include <vector>

#include "path/smooth/chain_sums.h"

namespace kadr {

class SlowWidth {
 public:
  /// Resets the width to its maximum everywhere.
  void begin();
  /// Starts a new computation of the width, from the end of the settled range to the length `end`.
  void open(double end);
  /// Limits the width at the length `at`; ignored in the settled range.
  void limit(double at, double width);
  void close();
  /// Settles the width before the length `before`: there the width will not change any more.
  void settle(double before);
  /// Drops the data before the length `before`.
  void forget(double before);

  WidthAt at(double s) const;

  /// Returns the greatest distance at which a limit still affects the width, mm.
  static double felt();

 private:
  std::size_t part_of(double at) const;
  void level(std::vector<double>& parts, bool mean);

  // interval indices, counted from length 0: the first stored interval; the end of the settled intervals
  std::size_t first_ = 0, settled_ = 0;
  std::vector<double> raw_, width_;  // one per interval: raw_ after the slope limit; width_ the final width
  std::vector<double> now_, next_;   // temporary values of the filters
};

}  // namespace kadr
