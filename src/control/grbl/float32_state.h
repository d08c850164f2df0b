#pragma once
// The values that Grbl stores as 32-bit numbers (position, work offsets, shifts), each paired with Kadr's exact value (spec/grbl 1.3). Only
// the computation of arcs uses the 32-bit values.

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
using Float32Triple = std::array<float, axes>;

/// Kadr's exact values of X, Y and Z, and Grbl's 32-bit values of the same quantities.
struct Float32Point {
  std::array<double, axes> exact{};
  Float32Triple single{};

  /// Copies Kadr's values. A value that has changed by other means than the words of a block (a set-up, a probe) is rounded to 32 bits for
  /// Grbl.
  void follow(const Axes& now);
  void take(std::size_t axis, double now, float by_words);
};

struct Float32State {
  Float32Point position, shift;           // position in machine coordinates; shift of G92
  std::array<Float32Point, 7> zeros;      // work offsets of G54 to G59, from index 1
  std::array<Float32Point, 3> reference;  // positions stored by G28.1 (index 1) and G30.1 (index 2)
  double exact_length = 0;
  float length = 0;  // tool length set by G43.1
  /// The text of an axis' last word in a series of simple motion blocks. The text is converted to a number only when the number is needed.
  struct Unread {
    std::array<char, 15> text{};
    std::uint8_t size = 0;  // length of the text; 0: no word is pending
  };
  std::array<Unread, axes> unread{};

  /// Copies the interpreter's position, offsets and tool length before a block.
  void follow(const BlockContext& m, double tool_length);
  /// Records what an executed block has changed.
  void note(const BlockContext& m, const CheckedBlock& block, double tool_length);
  /// Records a motion block that has only axis words and a feed, in mm.
  void note_line(const BlockContext& m);
  void read_lines(std::size_t system);
  /// Returns the target position of an axis, in machine coordinates, from its word; `system` is the index of the work offset in force.
  float target(std::size_t axis, float word, std::size_t system, bool absolute) const;
};

/// Returns a word's value as Grbl reads it, a 32-bit number in the unit of the block.
float single_of(const Block& block, const Word& word);

}  // namespace kadr::grbl
