#pragma once
// MotionForm: what the words of a plain motion block mean, for all blocks of one shape (same addresses and codes). The form of a shape is
// computed once, so that the fast path (control/block/motion_run) reads only the numbers of a block.

#include <array>
#include <cstdint>

#include "base/vec.h"
#include "control/block/plan.h"
#include "lang/block/block.h"

namespace kadr {

class BlockContext;

/// One word of a motion block and its meaning: the end coordinate of an axis, a coordinate of the arc centre, or the feed.
struct MotionSlot {
  std::uint8_t word = no_word;  // index in Block::words
  std::uint8_t axis = 0;
  bool adds = false;  // the word has an incremental address (U, W), so its value is added to the start coordinate
  double scale = 1, least = 0, most = 0;
};
/// The facts about all blocks of one shape (same addresses and codes), or about the one block `repeated`, which a loop executes again.
struct MotionForm {
  static constexpr std::size_t max_words = 8, most_codes = 4;
  BlockShape shape;
  const Block* repeated = nullptr;
  std::uint64_t letters = 0;  // letters of those words of the block `repeated` that have a value (not vacant)
  bool fits = false;          // true: blocks of this shape are plain motions, which the fast path executes
  // true: a block of this shape does nothing but call a subprogram or return from one, so that the run of plain motions may go on after
  // it
  bool calls = false;
  // Index of the word that calls, if a block of this shape can be executed without a plan (see quick_call); no_word for other
  // blocks.
  std::uint8_t call = no_word;
  // Row, in ControlDef::codes, of the motion code of the block; -1: the block has no motion code, and the motion code in force applies.
  std::int16_t row = -1;
  std::uint8_t axes = 0, codes = 0;  // `axes`: number of elements in use in `slots`; `codes`: number of elements in use in `steady`
  // Rows, in the control's table, of those codes of the block that are not motion codes. The fast path covers the block only while these
  // codes are in force already, so that they have no effect.
  std::array<std::int16_t, most_codes> steady{};
  AxisMask named = 0;
  bool centered = false;  // the block has a word of an arc centre
  MotionSlot feed;
  MotionSlot radius;                 // word R of an arc
  std::array<MotionSlot, 3> center;  // words of the arc centre, by axis of the plane
  std::array<MotionSlot, max_words> slots;
  bool gives_arc() const { return centered || radius.word != no_word; }
};
/// The forms of the latest blocks.
class MotionForms {
 public:
  const MotionForm& of(const BlockContext& m, const Block& block);

 private:
  static constexpr std::size_t kept = 64;
  static bool make(const BlockContext& m, const Block& block, MotionForm& form);
  static bool add_code(const BlockContext& m, const Word& word, MotionForm& form);
  std::array<MotionForm, kept> forms_;
};

}  // namespace kadr
