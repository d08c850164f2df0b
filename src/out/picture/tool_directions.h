#pragma once
// ToolDirections: collects the directions of a tilted tool along the cutting path, at even distances. Its memory is limited: when it is
// full, every other direction is left out.

#include <vector>

#include "action/step.h"
#include "base/vec.h"

namespace kadr {

/// The position of the tip, and the direction from there into the tool.
struct ToolDirection {
  Vec3 at, direction;
};

class ToolDirections {
 public:
  /// Keeps at most `most` directions.
  explicit ToolDirections(std::size_t most = 240) : most_(most) {}

  /// Consumes a motion that cuts on a machine whose rotary axes turn tool or part; any other motion is ignored.
  ///   shift  of the picture's coordinates from those of the work system
  void take(const Step& step, Vec3 shift);

  /// Returns an empty list as long as the tool has been upright, along Z.
  std::vector<ToolDirection> leaning() const { return leans_ ? all_ : std::vector<ToolDirection>(); }

 private:
  void keep(ToolDirection direction);

  std::size_t most_;
  std::vector<ToolDirection> all_;
  double step_ = 0.25, way_ = 0, next_ = 0;  // mm
  bool leans_ = false;
};

}  // namespace kadr
