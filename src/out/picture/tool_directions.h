#pragma once
// ToolDirections: which way the tool leans along the cutting path, at even distances; bounded in memory: when full, every other is left
// out.

#include <vector>

#include "action/step.h"
#include "base/vec.h"

namespace kadr {

/// At a place of the tip, from there into the tool.
struct ToolDirection {
  Vec3 at, direction;
};

class ToolDirections {
 public:
  /// Never holds more than `most`.
  explicit ToolDirections(std::size_t most = 240) : most_(most) {}

  /// A motion that cuts, of a machine whose rotary axes turn tool or part; of any other nothing is kept.
  ///   shift  of the picture's coordinates from those of the work system
  void take(const Step& step, Vec3 shift);

  /// Empty as long as the tool has stood upright, along Z.
  std::vector<ToolDirection> leaning() const { return leans_ ? all_ : std::vector<ToolDirection>(); }

 private:
  void keep(ToolDirection direction);

  std::size_t most_;
  std::vector<ToolDirection> all_;
  double step_ = 0.25, way_ = 0, next_ = 0;  // mm
  bool leans_ = false;
};

}  // namespace kadr
