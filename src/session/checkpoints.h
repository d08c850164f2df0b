#pragma once
// Checkpoints: snapshots of a run every so many blocks, so that any line of a long program is reached without running all that comes
// before it. Block search, restart in mid program, a slider over the program stand on it.
//
//   first pass   ●────────●────────●────────●──        a snapshot, then a stretch with the marks of its lines
//   a line       the first stretch that may hold it: from its snapshot on, block by block
//
// Constant memory: where there are too many, every second one goes.

#include <cstdint>
#include <vector>

#include "control/state/line_marks.h"
#include "session/stepping.h"

namespace kadr {

class Checkpoints {
 public:
  /// Of a session that has not begun; it must outlive this. Of several channels lines and blocks are the program's own.
  ///   each  blocks between two at first
  ///   most  of them; each more than some 100 KB (Session::snapshot)
  explicit Checkpoints(Session& session, std::uint64_t each = 8192, std::size_t most = 128);
  ~Checkpoints();
  Checkpoints(const Checkpoints&) = delete;  // the control notes its lines here
  Checkpoints& operator=(const Checkpoints&) = delete;

  /// The first pass: until the session stands.
  Session::State run();

  /// After it: held before the first block for which it holds, its `pass` counted from the beginning of the program.
  ///   pre      `stepping` is of the same session
  ///   returns  held; or what the session is where nothing does
  ///   alarms   those of Session::restore()
  Result<Session::State> reach(Stepping& stepping, const StopPoint& target);

  std::size_t count() const { return all_.size(); }

 private:
  struct Checkpoint {
    SessionSnapshot snapshot;
    LineMarks marks;           // of the stretch that follows
    std::uint64_t blocks = 0;  // that the control has carried out before it
  };
  void keep();
  void thin_out();
  bool may_hold(const LineMarks& marks, const StopPoint& target) const;

  Session& session_;
  std::uint64_t each_;
  std::size_t most_;
  LineMarks marks_;  // of the stretch under way
  std::vector<Checkpoint> all_;
};

}  // namespace kadr
