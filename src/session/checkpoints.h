#pragma once
// Checkpoints: takes a snapshot of a run every so many blocks, so that any line of a long program can be reached without running everything
// before it. Block search, restart in mid program, and a slider over the program are built on it.
//
//   first pass   ●────────●────────●────────●──        a snapshot, then a segment with the marks of its lines
//   a line       the first segment that may contain it: from its snapshot on, block by block
//
// Memory is constant: when there are too many snapshots, every second one is dropped.

#include <cstdint>
#include <vector>

#include "control/state/line_marks.h"
#include "session/stepping.h"

namespace kadr {

class Checkpoints {
 public:
  /// For a session that has not started and that outlives this object. With several channels, lines and blocks are those of the program's
  /// own.
  ///   each  blocks between two snapshots at first
  ///   most  number of snapshots; each takes more than some 100 KB (Session::snapshot)
  explicit Checkpoints(Session& session, std::uint64_t each = 8192, std::size_t most = 128);
  ~Checkpoints();
  Checkpoints(const Checkpoints&) = delete;  // the control notes its lines here
  Checkpoints& operator=(const Checkpoints&) = delete;

  /// The first pass: runs the session until it stops.
  Session::State run();

  /// After run(): goes to the first block that matches the target, whose `pass` counts from the beginning of the program, and is held
  /// before it.
  ///   pre      `stepping` belongs to the same session
  ///   returns  held; or the state of the session if no block matches
  ///   alarms   as Session::restore()
  Result<Session::State> reach(Stepping& stepping, const StopPoint& target);

  std::size_t count() const { return all_.size(); }

 private:
  struct Checkpoint {
    SessionSnapshot snapshot;
    LineMarks marks;           // lines of the segment that follows
    std::uint64_t blocks = 0;  // that the control had executed by then
  };
  void keep();
  void thin_out();
  bool may_hold(const LineMarks& marks, const StopPoint& target) const;

  Session& session_;
  std::uint64_t each_;
  std::size_t most_;
  LineMarks marks_;  // lines of the segment in progress
  std::vector<Checkpoint> all_;
};

}  // namespace kadr
