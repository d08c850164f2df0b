#pragma once
// Checkpoints: stores snapshots of a run at regular numbers of blocks. Then any line of a long program is reached without running all
// blocks before it. Block search, restart in mid-program and the slider over the program use Checkpoints.
//
//   first run    ●────────●────────●────────●──        ●: a snapshot; ──: a segment up to the next snapshot, with marks of its lines
//   a line       the run restores the snapshot of the first segment that may contain the line, and continues block by block
//
// The memory is limited: when there are too many snapshots, every second snapshot is dropped.

#include <cstdint>
#include <vector>

#include "control/state/line_marks.h"
#include "session/stepping.h"

namespace kadr {

class Checkpoints {
 public:
  /// Prepares the recording of a session. The session must not have started and must outlive this object. If the session has several
  /// channels, lines and blocks are those of the program's own channel.
  ///   each  number of blocks between two snapshots at first
  ///   most  greatest number of snapshots; each snapshot needs at least some 100 KB (Session::snapshot)
  explicit Checkpoints(Session& session, std::uint64_t each = 8192, std::size_t most = 128);
  ~Checkpoints();
  Checkpoints(const Checkpoints&) = delete;  // not copyable: the control writes line marks into this object
  Checkpoints& operator=(const Checkpoints&) = delete;

  /// Runs the session from the beginning until it stops, and stores snapshots on the way.
  Session::State run();

  /// Goes to the first block that matches `target`, and is held before that block. StopPoint::pass counts from the beginning of the
  /// program. Call this function after run().
  ///   pre      `stepping` belongs to the same session
  ///   returns  held; if no block matches, the state in which the session stopped
  ///   alarms   as Session::restore()
  Result<Session::State> reach(Stepping& stepping, const StopPoint& target);

  std::size_t count() const { return all_.size(); }

 private:
  struct Checkpoint {
    SessionSnapshot snapshot;
    LineMarks marks;           // marks of the lines that the run executes after this snapshot and before the next one
    std::uint64_t blocks = 0;  // number of blocks that the control had executed when the snapshot was stored
  };
  void keep();
  void thin_out();
  bool may_hold(const LineMarks& marks, const StopPoint& target) const;

  Session& session_;
  std::uint64_t each_;
  std::size_t most_;
  LineMarks marks_;  // marks of the lines that the run has executed since the last snapshot
  std::vector<Checkpoint> all_;
};

}  // namespace kadr
