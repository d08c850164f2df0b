#pragma once
// Checkpoints: stores snapshots of a run at regular numbers of blocks, so that any line of a long program can be reached without running
// all blocks before it. Block search, restart in mid program, and the slider over the program use it.
//
//   first run    ●────────●────────●────────●──        ● a snapshot; ── the segment up to the next one, with marks of its lines
//   a line       starts at the snapshot of the first segment that may contain the line, and runs block by block from there
//
// The memory is limited: when there are too many snapshots, every second one is dropped.

#include <cstdint>
#include <vector>

#include "control/state/line_marks.h"
#include "session/stepping.h"

namespace kadr {

class Checkpoints {
 public:
  /// The session must not have started and must outlive this object. If it has several channels, lines and blocks are those of the
  /// program's own channel.
  ///   each  number of blocks between two snapshots at first
  ///   most  maximum number of snapshots; each takes at least some 100 KB (Session::snapshot)
  explicit Checkpoints(Session& session, std::uint64_t each = 8192, std::size_t most = 128);
  ~Checkpoints();
  Checkpoints(const Checkpoints&) = delete;  // the control writes line marks into this object
  Checkpoints& operator=(const Checkpoints&) = delete;

  /// The first run through the program: runs the session until it stops.
  Session::State run();

  /// Call after run(). Goes to the first block that matches the target and is held before it. StopPoint::pass counts from the beginning
  /// of the program.
  ///   pre      `stepping` belongs to the same session
  ///   returns  held; or the state in which the session stopped, if no block matches
  ///   alarms   as Session::restore()
  Result<Session::State> reach(Stepping& stepping, const StopPoint& target);

  std::size_t count() const { return all_.size(); }

 private:
  struct Checkpoint {
    SessionSnapshot snapshot;
    LineMarks marks;           // marks of the lines in the segment that follows the snapshot
    std::uint64_t blocks = 0;  // number of blocks that the control had executed at the snapshot
  };
  void keep();
  void thin_out();
  bool may_hold(const LineMarks& marks, const StopPoint& target) const;

  Session& session_;
  std::uint64_t each_;
  std::size_t most_;
  LineMarks marks_;  // marks of the lines in the current segment
  std::vector<Checkpoint> all_;
};

}  // namespace kadr
