// Stores facts that all blocks of the same shape share, in a small hash table. Used by control/interpreter.

#include "control/block/shapes.h"

namespace kadr {

ShapeFacts* Shapes::of(const ControlDef& def, const Block& block) {
  if (!block.shape) return nullptr;
  if (facts_.empty()) facts_.resize(most);
  constexpr std::uint64_t golden_ratio = 0x9E3779B97F4A7C15;  // a product with the golden ratio has well-distributed high bits (Knuth 6.4)
  constexpr unsigned shift = 64 - 6;
  static_assert(most == 1U << (64 - shift));
  ShapeFacts& facts = facts_[(block.shape.first ^ block.shape.second * 3) * golden_ratio >> shift];
  if (facts.shape == block.shape) [[likely]]
    return &facts;
  facts.shape = block.shape;
  facts.words_right = facts.planned = false;
  facts.functions.reset();
  for (std::uint32_t i = 0; i < block.word_count; ++i) {
    const Word& w = block.words[i];
    const std::int32_t row = w.code < 0 ? -1 : def.row_of(w.address, w.code);
    if (row >= 0) facts.functions.set(static_cast<std::size_t>(def.codes[static_cast<std::size_t>(row)].function));
  }
  return &facts;
}

}  // namespace kadr
