#pragma once
// Compression: short straight feed motions made as one (nct 4.7, N3103 Accuracy; Motion::join says which and how long).
//
//   way since the last point let out, in every axis at most `join`:   ·──·─·──·      held back, only its end is kept
//   the next motion that goes further in some axis:                   ·─────────────▸·   let out, from there straight to its end
//
// Whatever else comes lets the rest out first. At most one motion, and the single-block stop after it, is held: constant memory.

#include <optional>

#include "action/action.h"

namespace kadr {

class Compression {
 public:
  /// Joins the motions of a batch, in place.
  ///   from   where the tool stands before it (after all that was let out), work coordinates
  ///   last   nothing follows: nothing is held back
  ///   returns  how many of its first actions belong to batches before
  ///   law    motions whose `join` is 0 come out as they went in
  ///   manual NCT 4.7; INFERRED: the way counts from the last point let out, a motion with exact stop ends where it should,
  ///          feed and origin are those of the last motion joined
  std::size_t take(ActionBatch& batch, const Axes& from, bool last);

  /// What is held back is not carried out: its block was taken back.
  void drop() { held_.reset(), stop_.reset(); }

  struct Memory {
    std::optional<Action> held, stop;
  };
  Memory memory() const { return {held_, stop_}; }
  void remember(const Memory& memory) { held_ = memory.held, stop_ = memory.stop; }

 private:
  void join(Action& action);
  void let_out();

  ActionBatch out_;
  Axes from_{};  // the last point let out
  std::optional<Action> held_;
  std::optional<Action> stop_;  // single_block, after the held one (4.7: it stops after the joined block)
  bool held_before_ = false;    // `held_` is of a batch before
  std::size_t of_before_ = 0;
};

}  // namespace kadr
