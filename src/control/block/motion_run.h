#pragma once
// MotionRun: the fast path for a run, which here is a sequence of plain motions as CAM systems write them: `G1 X1.5 Z-2 F300`, `G17 G3 X2
// Y0 I1 J0`, thousands of blocks long. Once a block has been executed the general way and only such blocks follow, everything that was
// looked up for it remains valid: the frames, the modes, and the motion modes of each motion code that has occurred. Only the end point,
// the arc centre, the feed and the choice among these codes are new in each block. Loops and macro calls between the blocks do not end a
// run. The fast path and the general way give the same actions (tests/run_plain.py, tests/control/motion_run_test.cpp).

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
  /// Called after the interpreter has executed a block the general way. The block may start a run, add a motion code to it, leave it as it
  /// is, or end it.
  void note(const Emitter& m);
  /// Executes the interpreter's block on the fast path if the run covers such a block.
  ///   returns  false if the block must go the general way; nothing has changed then
  bool take(Interpreter& m);

 private:
  /// Ends the run and returns what take() returns for a block that the run does not cover.
  bool refused() {
    end();
    return false;
  }
  static constexpr std::size_t max_words = 8, forms = 16, most_codes = 4;
  /// The motion codes, as indices of rows_ and modes_.
  enum Kind : std::uint8_t { rapid, linear, arc_cw, arc_ccw, kinds };

  /// One word of a block: an axis, an arc centre or the feed.
  struct Slot {
    std::uint8_t word = no_word;  // index in Block::words
    std::uint8_t axis = 0;
    bool adds = false;  // an incremental word (U, W): its value is added to the start coordinate
    double scale = 1, least = 0, most = 0;
  };
  /// What is known about all blocks of one shape (same addresses and codes), or about one block that a loop executes again.
  struct Form {
    BlockShape shape;
    const Block* kept = nullptr;
    std::uint64_t letters = 0;    // letters of the words of `kept`, without words whose value is vacant
    bool fits = false;            // the blocks are plain motions, which the run can execute
    bool calls = false;           // the blocks only call a subprogram or return
    std::uint8_t call = no_word;  // the word that calls, if it can be executed without a plan
    std::int16_t row = -1;        // row of the motion code in ControlDef::codes; -1: the block has no motion code, the modal one applies
    std::uint8_t axes = 0, codes = 0;               // number of elements used in `slots` and in `steady`
    std::array<std::int16_t, most_codes> steady{};  // rows of codes that change nothing as long as they are already in force
    AxisMask named = 0;
    bool centered = false;
    Slot feed;
    std::array<Slot, 3> center;  // words of the arc centre, by axis
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
  std::uint8_t known_ = 0;     // motion codes met in this run, one bit per Kind
  std::uint8_t old_feed_ = 0;  // motion codes, one bit per Kind, whose modes_ hold a feed that is no longer in force
  double feed_ = 0;            // Modal::feed of the last block
  bool absolute_ = true;
  AxisMask rolling_ = 0;                              // axes that roll over: a block that names one is executed the general way
  std::uint32_t number_least_ = 0, number_most_ = 0;  // limits of the block number N
  ArcRule arcs_;
  std::array<std::int16_t, kinds> rows_{};
  std::array<MotionModes, kinds> modes_;
  std::array<Form, forms> forms_;
};

}  // namespace kadr
