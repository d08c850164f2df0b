#pragma once
// What Grbl keeps in 32 bits: where it stands, its zeros and shifts, each beside the figure of Kadr (spec/grbl 1.3). Only arcs ask.

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

/// Three figures of Kadr and what Grbl has of them.
struct SinglePoint {
  std::array<double, axes> exact{};
  Single3 single{};

  /// Kadr's are these now; where they have changed by other means than a block's words (a set-up, a probe) they are rounded.
  void follow(const Axes& now);
  void take(std::size_t axis, double now, float by_words);
};

struct Singles {
  SinglePoint position, shift;           // machine coordinates; G92
  std::array<SinglePoint, 7> zeros;      // G54 to G59 from 1 on
  std::array<SinglePoint, 3> reference;  // G28.1, G30.1: 1, 2
  double exact_length = 0;
  float length = 0;  // G43.1
  /// The last words of lines that nobody has asked about: they are read when somebody does.
  struct Unread {
    std::array<char, 15> text{};
    std::uint8_t size = 0;  // 0: none
  };
  std::array<Unread, axes> unread{};

  /// As the interpreter has them before a block.
  void follow(const BlockContext& m, double tool_length);
  /// What a block has changed, which is carried out.
  void note(const BlockContext& m, const CheckedBlock& block, double tool_length);
  /// A motion whose words are all that it is, in mm.
  void note_line(const BlockContext& m);
  void read_lines(std::size_t system);
  /// Where words lead to, axis by axis.
  float target(std::size_t axis, float word, std::size_t system, bool absolute) const;
};

/// A word as Grbl reads it, in the unit of the block.
float single_of(const Block& block, const Word& word);

}  // namespace kadr::grbl
