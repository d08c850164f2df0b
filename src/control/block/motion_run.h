#pragma once
// MotionRun: the fast path for a run, which here is a sequence of plain motions as CAM systems write them: `G1 X1.5 Z-2 F300`, `G17 G3 X2
// Y0 I1 J0`, thousands of blocks long. The first block of a run is executed the general way, through evaluation, planning and execution
// (Interpreter::execute_block). The results for this block remain valid for the whole run: the frames, the modes, and the motion modes of
// each motion code that has occurred. Only the end point, the arc centre, the feed and the choice among the motion codes are new in each
// block. Loops and macro calls between the blocks do not end a run. A run of holes consists of blocks that only state the position of the
// next hole of a drilling cycle: `G81 X1 Y1 Z-5 R2 F100`, `X2`, `X3`. The fast path and the general way emit the same actions
// (tests/run_plain.py, tests/control/motion_run_test.cpp).

#include <array>
#include <cstdint>

#include "action/action.h"
#include "base/vec.h"
#include "control/block/arc.h"
#include "control/block/motion_form.h"
#include "control/state/control_state.h"
#include "lang/block/block.h"

namespace kadr {

class BlockContext;
class Emitter;
class Interpreter;

class MotionRun {
 public:
  bool is_on() const { return on_; }
  void end() { on_ = holes_ = false, known_ = old_feed_ = 0; }
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
  using Form = MotionForm;
  /// The motion codes of a run of plain motions; the values are indices of rows_ and modes_.
  enum Kind : std::uint8_t { rapid, linear, arc_cw, arc_ccw, kinds };

  void begin(const Emitter& m, const Form& form);
  void begin_loop(const Emitter& m);
  void begin_holes(const Emitter& m, const Form& form);
  bool take_hole(Interpreter& m, const Form& form);
  void note_modes(const Emitter& m);
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
  static bool is_hole(const BlockContext& m, const Form& form);
  bool find_end(const BlockContext& m, const Form& form, Axes& to) const;
  bool find_arc(Emitter& m, const Form& form, Kind kind, const Axes& to, PlaneArc& arc) const;
  bool find_center(const BlockContext& m, const Form& form, Vec2& center) const;

  bool on_ = false;
  bool by_steps_ = false;  // the cycle of a run of holes is a SteppedCycle, not a CannedCycleRun
  bool holes_ = false;     // the run is not one of motions but of holes of one drilling cycle (take_hole())
  // motion codes that have occurred in this run of plain motions; bit i stands for the code with the value i of Kind
  std::uint8_t known_ = 0;
  // motion codes whose stored modes still have an earlier feed; bit i stands for the code with the value i of Kind
  std::uint8_t old_feed_ = 0;
  double feed_ = 0;  // feed in force after the last block (Modal::feed), to detect a change by other blocks
  bool absolute_ = true;
  bool contour_ = false;  // the motions follow a contour with cutter compensation
  // the axes that roll over, from Dialect::rolling_axes(); a block that has a word of one of them is executed the general way
  AxisMask rolling_ = 0;
  std::uint32_t number_least_ = 0, number_most_ = 0;  // least and greatest allowed block number N
  ArcRule arcs_;
  std::array<std::int16_t, kinds> rows_{};
  std::array<MotionModes, kinds> modes_;
  MotionForms forms_;
};

}  // namespace kadr
