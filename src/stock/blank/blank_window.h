#pragma once
// The part of a blank inside a box, the window. This part is the blank of a second cut, which has finer lattice cells than the cut of the
// whole part.

#include "stock/blank/blank.h"

namespace kadr {

/// Returns the part of the blank inside the window. Where the blank extends beyond the window, the result ends at the window's faces.
///   returns  nullptr if the box lies outside the blank
std::shared_ptr<const Blank> blank_within(std::shared_ptr<const Blank> blank, const Box3& window);

/// The faces of a window that cut through the blank. A side of the window that is on or outside the blank's own surface is not one of these
/// faces.
class WindowFaces {
 public:
  WindowFaces(const Box3& window, const Box3& blank);
  /// True if the point `at` is on one of these faces. The surface at this point is then a face of the window, not a surface of the part.
  bool hold(const Vec3& at) const;

 private:
  Box3 faces_;
};

}  // namespace kadr
