#pragma once
// MotionRun: the fast path for a run, which here is a sequence of plain motions as CAM systems write them: `G1 X1.5 Z-2 F300`, `G17 G3 X2
// Y0 I1 J0`, thousands of blocks long. The first block of a run is executed the general way, through evaluation, planning and execution
// (Interpreter::execute_block). The results for this block remain valid for the whole run: the frames, the modes, and the motion modes of
// each motion code that has occurred. Only the end point, the arc centre, the feed and the choice among the motion codes are new in each
// block. Loops and macro calls between the blocks do not end a run. The fast path and the general way emit the same actions
// (tests/run_plain.py, tests/control/motion_run_test.cpp).

#include <array>
#include <cstdint>

#include "action/action.h"
#include "base/vec.h"
#include "control/block/arc.h"
#include "control/block/plan.h"
#include "control/state/control_state.h"
#include "lang/block/block.h"

namespace kadr {

class BlockContext;
class Emitter;
class Interpreter;

class MotionRun {
 public:
  bool is_on() const { return on_; }
  void end() { on_ = false, known_ = old_feed_ = 0; }
  /// Called after the interpreter has executed a block the general way. The block may start a run of plain motions, add its motion code to
  /// the run, leave the run unchanged, or end the run.
  void note(const Emitter& m);
  /// Executes the interpreter's current block on the fast path if the run of plain motions covers such a block.
  ///   returns  false if the block must be executed the general way; then nothing has changed
  bool take(Interpreter& m);

 private:
  /// Ends the run of plain motions, because it does not cover the current block. Returns false, which take() then returns too.
  bool refused() {
    end();
    return false;
  }
  static constexpr std::size_t max_words = 8, forms = 16, most_codes = 4;
  /// The motion codes of a run of plain motions; the values are indices of rows_ and modes_.
  enum Kind : std::uint8_t { rapid, linear, arc_cw, arc_ccw, kinds };

  /// One word of a motion block and its meaning: the end coordinate of an axis, a coordinate of the arc centre, or the feed.
  struct Slot {
    std::uint8_t word = no_word;  // index in Block::words
    std::uint8_t axis = 0;
    bool adds = false;  // the word has an incremental address (U, W), so its value is added to the start coordinate
    double scale = 1, least = 0, most = 0;
  };
  /// The facts about all blocks of one shape (same addresses and codes), or about the one block `repeated`, which a loop executes again.
  struct Form {
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
    bool centered = false;
    Slot feed;
    std::array<Slot, 3> center;  // words of the arc centre, by axis of the plane
    std::array<Slot, max_words> slots;
  };
  void begin(const Emitter& m, const Form& form);
  const Form& form_of(const BlockContext& m, const Block& block);
  bool make(const BlockContext& m, const Block& block, Form& form) const;
  bool add_code(const BlockContext& m, const Word& word, Form& form) const;
  bool number_fits(const Block& block) const {
    return !block.has_number || (block.number >= number_least_ && block.number <= number_most_);
  }
  bool holds(const BlockContext& m, const Form& form) const;
  static bool changes_radius(const BlockContext& m, const Axes& to, Vec2 center);
  void take_feed(BlockContext& m, double feed);
  void note_feed(double feed) {
    feed_ = feed;
    old_feed_ = static_cast<std::uint8_t>(known_ & ~(1u << rapid));
  }
  bool find_arc(const BlockContext& m, const Form& form, Kind kind, const Axes& to, PlaneArc& arc) const;

  bool on_ = false;
  // motion codes that have occurred in this run of plain motions; bit i stands for the code with the value i of Kind
  std::uint8_t known_ = 0;
  // motion codes whose stored modes still have an earlier feed; bit i stands for the code with the value i of Kind
  std::uint8_t old_feed_ = 0;
  double feed_ = 0;  // feed in force after the last block (Modal::feed), to detect a change by other blocks
  bool absolute_ = true;
  // the axes that roll over, from Dialect::rolling_axes(); a block that has a word of one of them is executed the general way
  AxisMask rolling_ = 0;
  std::uint32_t number_least_ = 0, number_most_ = 0;  // least and greatest allowed block number N
  ArcRule arcs_;
  std::array<std::int16_t, kinds> rows_{};
  std::array<MotionModes, kinds> modes_;
  std::array<Form, forms> forms_;
};

}  // namespace kadr
