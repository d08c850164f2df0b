#pragma once
// Plain motions one after another, as CAM systems write them: `G1 X1.5 Z-2 F300`, `G17 G3 X2 Y0 I1 J0`, thousands of lines long. Where a
// block has gone the general way and only such blocks follow, all that it has looked up holds for them: frames, modes, and for each motion
// code met so far what a motion takes from them; the end point, the centre, the feed and which of the codes it is are new. Loops and calls
// of macros between them change nothing of that. What a block does is the same either way (tests/run_plain.py,
// tests/control/motion_run_test.cpp).

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
  /// The interpreter's block has gone the general way: it may be the first of a run, or the first of its motion code in one; or leave the
  /// run as it is; or end it.
  void note(const Emitter& m);
  /// Carries the interpreter's block out, if it goes on the run.
  ///   returns  false: it must go the general way; nothing has changed
  bool take(Interpreter& m);

 private:
  /// What take() answers of a block that ends the run.
  bool refused() {
    end();
    return false;
  }
  static constexpr std::size_t most_words = 8, forms = 16, most_codes = 4;
  /// The motion codes, as an index.
  enum Kind : std::uint8_t { rapid, linear, arc_cw, arc_ccw, kinds };

  /// A word of a line that says where it goes.
  struct Slot {
    std::uint8_t word = no_word;  // index in Block::words
    std::uint8_t axis = 0;
    bool adds = false;  // an increment
    double scale = 1, least = 0, most = 0;
  };
  /// Blocks of one shape; or one that loops carry out again.
  struct Form {
    BlockShape shape;
    const Block* kept = nullptr;
    std::uint64_t letters = 0;                      // of `kept`: some may be vacant
    bool fits = false;                              // a plain motion
    bool calls = false;                             // calls or returns, and nothing else
    std::uint8_t call = no_word;                    // the word that does, where it can be carried out alone
    std::int16_t row = -1;                          // of its motion code; -1: none, that in force
    std::uint8_t axes = 0, codes = 0;               // how many
    std::array<std::int16_t, most_codes> steady{};  // rows of codes that do nothing if they are in force
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
  std::uint8_t known_ = 0;     // motion codes met in this run, a bit a Kind
  std::uint8_t old_feed_ = 0;  // of these, those whose `modes_` have a feed that is no longer in force
  double feed_ = 0;            // Modal::feed of the last line
  bool absolute_ = true;
  AxisMask rolling_ = 0;                              // axes with a way of their own
  std::uint32_t number_least_ = 0, number_most_ = 0;  // of N
  ArcRule arcs_;
  std::array<std::int16_t, kinds> rows_{};
  std::array<MotionModes, kinds> modes_;
  std::array<Form, forms> forms_;
};

}  // namespace kadr
