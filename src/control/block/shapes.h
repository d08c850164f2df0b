#pragma once
// Shapes: the shape of a block is its list of addresses and codes without the values. Facts that all blocks of a shape share are computed
// once. A long program has few shapes, such as `G1 X Y`, `X Y` and `G2 X Y I J`.

#include <bitset>
#include <vector>

#include "control/block/plan.h"

namespace kadr {

using FunctionSet = std::bitset<static_cast<std::size_t>(Function::count)>;

struct ShapeFacts {
  BlockShape shape;
  FunctionSet functions;     // functions of the codes in the shape
  bool words_right = false;  // nct: the words of this shape may be in one block, whatever their values
  bool planned = false;      // `plan` has been computed and is valid for the motion code `motion_row`
  std::int16_t motion_row = -1;
  Plan plan;
};

/// The shapes of the latest blocks.
class Shapes {
 public:
  /// Returns the facts of a block's shape; nullptr if the block has no shape, because it has more than addresses, codes and numbers.
  ShapeFacts* of(const ControlDef& def, const Block& block);

 private:
  static constexpr std::size_t most = 64;
  std::vector<ShapeFacts> facts_;
};

}  // namespace kadr
