#pragma once
// Straight motions one after another, as CAM systems write them: `X1.5 Z-2`, `G1 X1.6 Z-2.1`, thousands of lines long. Where a block has
// gone the general way and only such lines follow, all that it has looked up holds for them: codes, feed, frames; the end point alone is
// new. What a line does is the same either way (tests/run_plain.py, tests/control/straight_run_test.cpp).

#include <array>
#include <cstdint>

#include "action/action.h"
#include "base/vec.h"
#include "lang/block/block.h"

namespace kadr {

class Interpreter;

class StraightRun {
 public:
  bool is_on() const { return on_; }
  void end() { on_ = false; }
  /// A block has gone the general way: it may be the first of a run.
  void begin(const Interpreter& m);
  /// Carries the block in hand out, if it goes on the run.
  ///   returns  false: it must go the general way; nothing has changed
  bool take(Interpreter& m);

 private:
  static constexpr std::size_t most_words = 8;
  static constexpr std::size_t forms = 16;

  /// An axis word of a line.
  struct Slot {
    std::uint8_t word = 0;  // index in Block::words
    std::uint8_t axis = 0;
    bool adds = false;  // an increment
    double scale = 1, least = 0, most = 0;
  };
  /// Lines of one shape.
  struct Form {
    BlockShape shape;
    bool fits = false;
    bool coded = false;  // the motion code stands in it
    std::uint8_t count = 0;
    AxisMask named = 0;
    std::array<Slot, most_words> slots;
  };
  const Form& form_of(const Interpreter& m, const Block& block);
  bool make(const Interpreter& m, const Block& block, Form& form) const;

  bool on_ = false;
  bool absolute_ = true;
  bool code_in_force_ = true;                         // its group says so too
  AxisMask rolling_ = 0;                              // axes with a way of their own
  std::int16_t row_ = -1;                             // of the motion code in force
  std::uint32_t number_least_ = 0, number_most_ = 0;  // of N
  MotionModes modes_;
  std::array<Form, forms> forms_;
};

}  // namespace kadr
