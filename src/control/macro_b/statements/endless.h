#pragma once
// Finds loops that never end (a GOTO backwards, or END back to its DO; spec/nct/23 23.2.8, 23.2.11) without running them for long.
//
// A pass is one execution of the blocks of a loop. It depends on the position in the program, the variables, the open calls and, if the
// pass reads a system variable, on the values of system variables. If the same jump back is made twice and all of these are equal, the loop
// never ends. A snapshot of these values is taken at passes 1, 2, 4, 8 …. Only the few passes after a snapshot are compared with it, so the
// check of a loop of a million passes costs almost nothing.
// `kadr check` continues after a fault. Two loops are then left early, so that one fault gives one alarm: a loop with a faulty block that
// would have written a variable or jumped is left after one pass; so is a loop that an earlier fault keeps from ending.

#include <array>
#include <cstdint>
#include <memory>
#include <vector>

#include "base/vec.h"
#include "lang/block/block_reader.h"

namespace kadr {
class BlockContext;
class Emitter;
}  // namespace kadr

namespace kadr::macro_b {

struct Moment;  // the values on which a pass of a loop depends, at one time

class Endless {
 public:
  enum class Verdict : std::uint8_t {
    go,       // the program makes the jump back, because nothing shows that the loop never ends
    endless,  // the loop would never end, so the run stops with an alarm
    leave,    // the program continues after the loop, because a fault keeps the loop from ending
  };
  /// Decides before a jump back to `target` whether the loop that this jump closes would never end. `reader`: number of the file; `blocks`:
  /// number of blocks executed so far.
  Verdict look(const Emitter& m, Position target, std::uint16_t reader, std::uint64_t blocks) {
    Watch& w = watches_[(target.offset ^ reader * 17u) % watches_.size()];
    if (w.target != target.offset || w.reader != reader) [[unlikely]]
      start(w, target, reader);
    w.arrived = blocks;
    if (++w.passes < w.next_look) [[likely]]
      return Verdict::go;
    return look_closely(m, w);
  }

  /// Records that a system variable has been read. From now on passes are compared by the values of system variables too.
  void note_reading() { ++readings_; }
  /// Records that the program has changed a value that it can read only by system variables.
  void note_change() { ++changes_; }
  /// Records that the current block was faulty and that the run continues. `may_steer`: without the fault, the block would have written a
  /// variable, called a program or jumped.
  void note_fault(const BlockContext& m, bool may_steer);
  /// Clears all records of loops, because the whole program starts again.
  void forget();

  std::uint64_t readings() const { return readings_; }
  std::uint64_t changes() const { return changes_; }

 private:
  /// The record of one jump back.
  struct Watch {
    std::uint64_t target = ~std::uint64_t{0};
    std::uint64_t from = 0;  // offset in the file of the block that jumps back
    std::uint64_t passes = 0, next_look = 1;
    std::uint64_t arrived = 0;  // number of blocks that had been executed at the last jump
    std::uint64_t seen = 0;     // number of the pass at which the snapshot was taken
    std::size_t depth = 0;      // number of open calls at the jump back
    std::uint16_t reader = 0;
    std::shared_ptr<const Moment> snapshot;
  };
  struct Fault {
    std::uint64_t offset = 0;
    std::uint64_t blocks = 0;  // number of blocks that had been executed when the fault was found
    std::uint16_t reader = 0;
  };
  void start(Watch& w, Position target, std::uint16_t reader);
  Verdict look_closely(const Emitter& m, Watch& w);
  bool is_inside_another(const Watch& w) const;
  bool took_too_long(const BlockContext& m, const Watch& w);
  bool holds_fault(const Watch& w) const;

  std::array<Watch, 64> watches_;
  std::vector<Fault> faults_;  // faulty blocks that would have written a variable, called a program or jumped
  bool any_fault_ = false;
  // Counts after a fault: the jumps examined; the blocks executed in successive passes of one loop; the blocks executed up to the jump that
  // was examined last.
  std::uint64_t looks_ = 0, looped_ = 0, looked_at_ = 0;
  std::size_t looked_ = ~std::size_t{0};  // index in watches_ of the jump back that was examined last
  std::uint64_t readings_ = 0, changes_ = 0;
};

}  // namespace kadr::macro_b
