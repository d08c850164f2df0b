#pragma once
// MotionRun: the fast path for plain motions one after another, as CAM systems write them: `G1 X1.5 Z-2 F300`, `G17 G3 X2 Y0 I1 J0`,
// thousands of lines long. Once a block has been executed the general way and only such blocks follow, everything it looked up remains
// valid: the frames, the modes, and for each motion code met so far the modes of its motion. Only the end point, the arc centre, the feed
// and the choice among these codes are new. Loops and macro calls between the blocks do not end a run. The fast path and the general way do
// the same (tests/run_plain.py, tests/control/motion_run_test.cpp).

#include <array>
#include <cstdint>

#include "action/action.h"
#include "base/vec.h"
#include "control/block/arc.h"
#include "control/block/plan.h"
#include "control/state/state.h"
#include "lang/block/block.h"

namespace kadr {

class BlockContext;
class Emitter;
class Interpreter;

class MotionRun {
 public:
  bool is_on() const { return on_; }
  void end() { on_ = false, known_ = old_feed_ = 0; }
  /// Called after the interpreter has executed a block the general way. The block may start a run, add a motion code to it, leave it as it
  /// is, or end it.
  void note(const Emitter& m);
  /// Executes the interpreter's block if the run applies to it.
  ///   returns  false if the block must go the general way; nothing has changed then
  bool take(Interpreter& m);

 private:
  /// Ends the run. The result is that of take() for such a block.
  bool refused() {
    end();
    return false;
  }
  static constexpr std::size_t most_words = 8, forms = 16, most_codes = 4;
  /// The motion codes, as indices of rows_ and modes_.
  enum Kind : std::uint8_t { rapid, linear, arc_cw, arc_ccw, kinds };

  /// One word of a block: an axis, an arc centre or the feed.
  struct Slot {
    std::uint8_t word = no_word;  // index in Block::words
    std::uint8_t axis = 0;
    bool adds = false;  // an incremental word (U, W)
    double scale = 1, least = 0, most = 0;
  };
  /// What is known of all blocks of one shape, or of one block that a loop executes again.
  struct Form {
    BlockShape shape;
    const Block* kept = nullptr;
    std::uint64_t letters = 0;                      // of `kept`: words with a vacant value are not there
    bool fits = false;                              // the blocks are plain motions
    bool calls = false;                             // the blocks only call a subprogram or return
    std::uint8_t call = no_word;                    // the word that calls, if it can be executed without a plan
    std::int16_t row = -1;                          // row of the motion code; -1: no code, the one in force applies
    std::uint8_t axes = 0, codes = 0;               // used elements of slots and steady
    std::array<std::int16_t, most_codes> steady{};  // rows of codes that change nothing while they are in force
    AxisMask named = 0;
    bool centered = false;
    Slot feed;
    std::array<Slot, 3> center;  // by axis
    std::array<Slot, most_words> slots;
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
  std::uint8_t known_ = 0;     // motion codes met in this run, one bit per Kind
  std::uint8_t old_feed_ = 0;  // those of them whose modes_ hold a feed that is no longer in force
  double feed_ = 0;            // Modal::feed of the last line
  bool absolute_ = true;
  AxisMask rolling_ = 0;                              // axes that roll over: their blocks go the general way
  std::uint32_t number_least_ = 0, number_most_ = 0;  // limits of the block number N
  ArcRule arcs_;
  std::array<std::int16_t, kinds> rows_{};
  std::array<MotionModes, kinds> modes_;
  std::array<Form, forms> forms_;
};

}  // namespace kadr
