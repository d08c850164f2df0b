#pragma once
// The values that Grbl keeps in 32 bits (position, work offsets, shifts), each next to Kadr's exact one (spec/grbl 1.3). Only arcs use
// them.

#include <array>
#include <cstddef>
#include <cstdint>

#include "base/vec.h"
#include "lang/block/block.h"

namespace kadr {
class BlockContext;
}

namespace kadr::grbl {

struct CheckedBlock;

inline constexpr std::size_t axes = 3;  // X Y Z of the default build
using Single3 = std::array<float, axes>;

/// Three exact values of Kadr, and Grbl's values of the same axes.
struct SinglePoint {
  std::array<double, axes> exact{};
  Single3 single{};

  /// Takes Kadr's values. Those changed by other means than a block's words (a set-up, a probe) are rounded for Grbl.
  void follow(const Axes& now);
  void take(std::size_t axis, double now, float by_words);
};

struct Singles {
  SinglePoint position, shift;           // machine coordinates; G92
  std::array<SinglePoint, 7> zeros;      // G54 to G59 from index 1
  std::array<SinglePoint, 3> reference;  // G28.1, G30.1: index 1, 2
  double exact_length = 0;
  float length = 0;  // G43.1
  /// The last word of an axis in a series of plain lines, as text: it is converted only when its value is needed.
  struct Unread {
    std::array<char, 15> text{};
    std::uint8_t size = 0;  // 0: none
  };
  std::array<Unread, axes> unread{};

  /// Takes over the interpreter's values before a block.
  void follow(const BlockContext& m, double tool_length);
  /// Records what an executed block has changed.
  void note(const BlockContext& m, const CheckedBlock& block, double tool_length);
  /// Records a motion that consists of nothing but its words, in mm.
  void note_line(const BlockContext& m);
  void read_lines(std::size_t system);
  /// The target of a word on an axis.
  float target(std::size_t axis, float word, std::size_t system, bool absolute) const;
};

/// A word's value as Grbl reads it, in the unit of the block.
float single_of(const Block& block, const Word& word);

}  // namespace kadr::grbl
