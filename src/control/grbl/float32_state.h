#pragma once
// The values that Grbl stores as 32-bit numbers (position, work offsets, shifts). Each value is paired with Kadr's exact value (spec/grbl
// 1.3). Only the computation of arcs uses the 32-bit values.

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

inline constexpr std::size_t axes = 3;  // number of axes: Grbl's default build has X, Y and Z
using Float32Triple = std::array<float, axes>;

/// A point stored twice: with Kadr's exact coordinates, and with Grbl's 32-bit values of these coordinates.
struct Float32Point {
  std::array<double, axes> exact{};
  Float32Triple single{};

  /// Copies Kadr's coordinates. If a set-up or a probe, not a word of a block, has changed a coordinate, the coordinate is rounded to 32
  /// bits for Grbl.
  void follow(const Axes& now);
  void take(std::size_t axis, double now, float by_words);
};

struct Float32State {
  Float32Point position, shift;           // position in machine coordinates, and the shift by G92
  std::array<Float32Point, 7> zeros;      // work offsets of G54 to G59, by number; index 0 is unused
  std::array<Float32Point, 3> reference;  // positions stored by G28.1 (index 1) and G30.1 (index 2)
  double exact_length = 0;
  float length = 0;  // tool length set by G43.1, mm
  /// The text of the last word of an axis in a series of plain motion blocks. The text is converted to a number when the number is needed.
  struct Unread {
    std::array<char, 15> text{};
    std::uint8_t size = 0;  // length of the text in characters; 0: no text is stored
  };
  std::array<Unread, axes> unread{};

  /// Copies the interpreter's position, offsets and tool length. Called before a block is executed.
  void follow(const BlockContext& m, double tool_length);
  /// Updates the 32-bit values after a block has been executed.
  void note(const BlockContext& m, const CheckedBlock& block, double tool_length);
  /// Records the end point of a block that has only axis words and a feed.
  void note_line(const BlockContext& m);
  void read_lines(std::size_t system);
  /// Returns the machine coordinate to which an axis moves, in mm. `word`: value of the axis word; `system`: index of the work offset in
  /// force.
  float target(std::size_t axis, float word, std::size_t system, bool absolute) const;
};

/// Returns a word's value as Grbl reads it: a 32-bit number in the unit of the block (mm or inch).
float single_of(const Block& block, const Word& word);

}  // namespace kadr::grbl
