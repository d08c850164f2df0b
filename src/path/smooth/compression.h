#pragma once
// Compression: joins short straight feed motions into one (nct 4.7, N3103 Accuracy). Motion::join states which motions are joined, and up
// to which travel.
//
//   travel since the last emitted point, in every axis at most `join`:   ·──·─·──·         stored as one motion to the last end
//   the next motion that goes further in any axis:                      ·─────────────▸·   emitted as one line to its end
//
// Any other action emits the held motion first. At most one motion and the single-block stop after the motion are stored, so memory is
// bounded.

#include <optional>

#include "action/action.h"

namespace kadr {

class Compression {
 public:
  /// Joins the motions of a batch, in place.
  ///   from   position of the tool after all actions emitted so far, work coordinates
  ///   last   true: no batch follows, so no motion is held back
  ///   returns  how many actions at the start of the resulting batch come from earlier batches
  ///   law    motions whose `join` is 0 are emitted unchanged
  ///   manual NCT 4.7; INFERRED: the travel counts from the last emitted point, a motion with exact stop ends at its programmed end,
  ///          feed and origin of the result are those of the last motion joined
  std::size_t take(ActionBatch& batch, const Axes& from, bool last);

  /// Discards the stored motion and stop, because their block was withdrawn.
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
  Axes from_{};  // the last emitted point
  std::optional<Action> held_;
  std::optional<Action> stop_;  // a single_block stop after the held motion (NCT 4.7: it stops after the joined block)
  bool held_before_ = false;    // true: the motion in `held_` belongs to an earlier batch
  std::size_t of_before_ = 0;
};

}  // namespace kadr
