#pragma once
// What all blocks of one shape have in common, found once: a long program has few shapes (`G1 X Y`, `X Y`, `G2 X Y I J`, …).

#include <bitset>
#include <vector>

#include "control/block/plan.h"

namespace kadr {

using FunctionSet = std::bitset<static_cast<std::size_t>(Function::count)>;

struct ShapeFacts {
  BlockShape shape;
  FunctionSet functions;     // of its codes
  bool words_right = false;  // nct: its words may stand together, whatever their values
  bool planned = false;      // `plan` is good where this motion code is in force
  std::int16_t motion_row = -1;
  Plan plan;
};

/// The shapes met last.
class Shapes {
 public:
  /// Those of a plain block; nullptr of any other.
  ShapeFacts* of(const ControlDef& def, const Block& block);

 private:
  static constexpr std::size_t most = 64;
  std::vector<ShapeFacts> facts_;
};

}  // namespace kadr
