#pragma once
// SlowWidth is the width of the roundings of a chain of corners, as a function of the path length. The width is nowhere greater than the
// nearby corners allow. It changes so slowly and evenly that the rounded path stays smooth. A jump of the width would increase the third
// derivative of the path and therefore reduce the speed.
//
// The path is divided into intervals of 0.1 mm. The computation has four steps. Each interval gets the least of the limits of its corners.
// The slope of the width along the path is limited. Each interval gets the minimum of the intervals within half a width around it. Each
// interval gets the mean of the same intervals. A cubic B-spline interpolates between the intervals, so that the second derivative of the
// rounded path has no jumps. Settled values do not change any more when the path is extended.

#include <cstddef>
#include <vector>

#include "path/smooth/chain_sums.h"

namespace kadr {

class SlowWidth {
 public:
  /// Resets the width to its maximum along the whole path.
  void begin();
  /// Starts a new computation of the width, from the end of the settled range to the path length `end`, mm.
  void open(double end);
  /// Limits the width at the path length `at`, mm. The call has no effect in the settled range.
  void limit(double at, double width);
  void close();
  /// Settles the width before the path length `before`: in this range the width does not change any more.
  void settle(double before);
  /// Removes the data before the path length `before`, mm.
  void forget(double before);

  WidthAt at(double s) const;

  /// Returns a width, mm, that the path does not exceed from the path length `from` to `to`. It is greater than the greatest width by no
  /// more than the width changes along two intervals.
  double greatest(double from, double to) const;

  /// Returns the greatest distance, mm, at which a limit still affects the width.
  static double felt();

 private:
  std::size_t part_of(double at) const;
  void level(std::vector<double>& parts, bool mean);

  // Numbers of intervals, counted from the path length 0: the first interval that is stored, and the first interval whose width may still
  // change.
  std::size_t first_ = 0, settled_ = 0;
  std::vector<double> raw_, width_;  // Widths in mm, one per interval: `raw_` after the slope limit, `width_` the final width.
  std::vector<double> now_, next_;   // temporary values of the minimum and mean filters
};

}  // namespace kadr
