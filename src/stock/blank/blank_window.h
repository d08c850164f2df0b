#pragma once
// The part of a blank inside a box: the blank of a window, which is cut finer than the whole part.

#include "stock/blank/blank.h"

namespace kadr {

/// Where the blank extends beyond the box, the result ends at the box's faces.
///   returns  nullptr if the box lies outside the blank
std::shared_ptr<const Blank> blank_within(std::shared_ptr<const Blank> blank, const Box3& window);

/// The faces of a window that cut through the blank. Where the window reaches the blank's own surface, or beyond it, it has no such
/// face.
class WindowFaces {
 public:
  WindowFaces(const Box3& window, const Box3& blank);
  /// True if `at` is on such a face: a surface there comes from the window, and is not a surface of the part.
  bool hold(const Vec3& at) const;

 private:
  Box3 faces_;
};

}  // namespace kadr
