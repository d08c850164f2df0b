#pragma once
// Compression joins short straight feed motions into one motion (nct 4.7, N3103 Accuracy). Motion::join states which motions are joined,
// and the greatest travel of a joined motion.
//
//   travel since the last emitted point, in every axis at most `join`:   ·──·─·──·         stored as one motion to the last end
//   the next motion that goes further in any axis:                      ·─────────────▸·   emitted as one line to its end
//
// Before any other action the stored motion is emitted. At most one motion and the single-block stop after this motion are stored, so
// memory is bounded.

#include <optional>

#include "action/action.h"

namespace kadr {

class Compression {
 public:
  /// Joins the motions of a batch and replaces the batch by the result.
  ///   from   position of the tool after all actions emitted so far, work coordinates
  ///   last   true: no batch follows, so the stored motion is emitted too
  ///   returns  how many actions at the start of the resulting batch come from earlier batches
  ///   law    motions whose `join` is 0 are emitted unchanged
  ///   manual NCT 4.7; INFERRED: the travel counts from the last emitted point, a motion with exact stop ends at its programmed end,
  ///          feed and origin of the result are those of the last motion joined
  std::size_t take(ActionBatch& batch, const Axes& from, bool last);

  /// Discards the stored motion and the stored stop. Call it when the block of these actions was withdrawn.
  void drop() { held_.reset(), stop_.reset(); }

  struct Memory {
    std::optional<Action> held, stop;
  };
  Memory memory() const { return {held_, stop_}; }
  void resume_from(const Memory& memory) { held_ = memory.held, stop_ = memory.stop; }

 private:
  void join(Action& action);
  void let_out();

  ActionBatch out_;
  Axes from_{};  // position that the last emitted motion reached, work coordinates
  std::optional<Action> held_;
  std::optional<Action> stop_;  // A single-block stop after the stored motion. NCT 4.7: this stop occurs after the joined block.
  bool held_before_ = false;    // True if the motion in `held_` belongs to an earlier batch.
  std::size_t of_before_ = 0;
};

}  // namespace kadr
