#pragma once
// ToolDirections: stores the axis direction of a tilted tool at even distances along the cutting path. Memory is limited: when it is
// full, every second direction is removed and the distance between directions doubles.

#include <vector>

#include "action/step.h"
#include "base/vec.h"

namespace kadr {

/// The position of the tool tip, and the direction from the tip towards the spindle.
struct ToolDirection {
  Vec3 at, direction;
};

class ToolDirections {
 public:
  /// Stores at most `most` directions.
  explicit ToolDirections(std::size_t most = 240) : most_(most) {}

  /// Consumes a motion. Stores directions only for cutting motions on a machine whose rotary axes rotate the tool or the part.
  ///   shift  vector from work coordinates to the picture's coordinates
  void take(const Step& step, Vec3 shift);

  /// Returns the stored directions; empty if the tool has always been parallel to Z.
  std::vector<ToolDirection> leaning() const { return leans_ ? all_ : std::vector<ToolDirection>(); }

 private:
  void keep(ToolDirection direction);

  std::size_t most_;
  std::vector<ToolDirection> all_;
  double step_ = 0.25, way_ = 0, next_ = 0;  // mm: distance between stored directions; path length so far; path length at the next one
  bool leans_ = false;
};

}  // namespace kadr
