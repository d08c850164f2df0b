#pragma once
// ToolDirections: stores the axis direction of a tilted tool at even distances along the cutting path. The memory is limited: when it is
// full, every second direction is removed, and the distance between directions doubles.

#include <vector>

#include "action/step.h"
#include "base/vec.h"

namespace kadr {

/// The position of the tool tip, and the direction of the tool axis from the tip towards the spindle.
struct ToolDirection {
  Vec3 at, direction;
};

class ToolDirections {
 public:
  /// Creates an empty list, which stores at most `most` directions.
  explicit ToolDirections(std::size_t most = 240) : most_(most) {}

  /// Processes a motion. Directions are stored only for cutting motions on a machine whose rotary axes turn the tool or the part.
  ///   shift  vector from the work coordinates to the coordinates of the picture, mm
  void take(const Step& step, Vec3 shift);

  /// Returns the stored directions. The result is empty if the tool has always been parallel to Z.
  std::vector<ToolDirection> leaning() const { return leans_ ? all_ : std::vector<ToolDirection>(); }

 private:
  void keep(ToolDirection direction);

  std::size_t most_;
  std::vector<ToolDirection> all_;
  // Three lengths along the path, mm: the distance between stored directions, the path so far, and the location of the next direction to
  // store.
  double step_ = 0.25, travelled_ = 0, next_ = 0;
  bool leans_ = false;
};

}  // namespace kadr
