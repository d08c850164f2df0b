#pragma once
// What of a blank lies within a box: the blank of a window, which is cut finer than the whole.

#include "stock/blank/blank.h"

namespace kadr {

/// The box's faces are its own where the blank goes on beyond them.
///   returns  nullptr: the box lies beside the blank
std::shared_ptr<const Blank> blank_within(std::shared_ptr<const Blank> blank, const Box3& window);

/// Faces of the window that part the blank; where it ends at the blank's own surface, or beyond it, there is none.
class WindowFaces {
 public:
  WindowFaces(const Box3& window, const Box3& blank);
  /// There the surface of what was cut in the window is none of the part.
  bool hold(const Vec3& at) const;

 private:
  Box3 faces_;
};

}  // namespace kadr
