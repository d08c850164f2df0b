#pragma once
// Loops that never end (GOTO back, END to its DO; spec/nct/23 23.2.8, 23.2.11), found without running them for long.
//
// A pass is decided by the place in the program, the variables, the open calls and, where the pass read one, what a system variable
// shows. If a jump back is made twice with all of these alike, it is made for ever. A snapshot is taken at passes 1, 2, 4, 8 … and
// the few passes after each are held against it, so that a loop of a million passes pays nothing.
//
// `kadr check` goes on after faults. A loop in which a faulty block would have written a variable or jumped, and one that a fault
// before it keeps from ending, is left after a pass: one fault is one alarm.

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

struct Moment;  // what decides a pass

class Endless {
 public:
  enum class Verdict : std::uint8_t {
    go,       // nothing is known against the jump
    endless,  // it would be made for ever
    leave,    // after a fault: the program goes on after the loop
  };
  /// A jump back to `target`, in the file being read, is about to be made.
  Verdict look(const Emitter& m, Position target, std::uint16_t reader, std::uint64_t blocks) {
    Watch& w = watches_[(target.offset ^ reader * 17u) % watches_.size()];
    if (w.target != target.offset || w.reader != reader) [[unlikely]]
      start(w, target, reader);
    w.arrived = blocks;
    if (++w.passes < w.next_look) [[likely]]
      return Verdict::go;
    return look_closely(m, w);
  }

  /// A system variable has been read: what it shows counts.
  void note_reading() { ++readings_; }
  /// Something that system variables show, and nothing else, has changed.
  void note_change() { ++changes_; }
  /// The current block was faulty, and the run goes on. `may_steer`: it would have written a variable, called or jumped.
  void note_fault(const BlockContext& m, bool may_steer);
  /// Another pass of the whole program: what was seen counts no more.
  void forget();

  std::uint64_t readings() const { return readings_; }
  std::uint64_t changes() const { return changes_; }

 private:
  struct Watch {
    std::uint64_t target = ~std::uint64_t{0};
    std::uint64_t from = 0;  // offset of the block that jumps
    std::uint64_t passes = 0, next_look = 1;
    std::uint64_t arrived = 0;  // blocks carried out when it was made last
    std::uint64_t seen = 0;     // passes when the snapshot was taken
    std::size_t depth = 0;      // calls open
    std::uint16_t reader = 0;
    std::shared_ptr<const Moment> snapshot;
  };
  struct Fault {
    std::uint64_t offset = 0;
    std::uint64_t blocks = 0;  // carried out then
    std::uint16_t reader = 0;
  };
  void start(Watch& w, Position target, std::uint16_t reader);
  Verdict look_closely(const Emitter& m, Watch& w);
  bool is_inside_another(const Watch& w) const;
  bool took_too_long(const BlockContext& m, const Watch& w);
  bool holds_fault(const Watch& w) const;

  std::array<Watch, 64> watches_;
  std::vector<Fault> faults_;  // that may steer
  bool any_fault_ = false;
  // … after one: jumps looked at, blocks of passes one after another, and where the last look was
  std::uint64_t looks_ = 0, looped_ = 0, looked_at_ = 0;
  std::size_t looked_ = ~std::size_t{0};  // by watches_
  std::uint64_t readings_ = 0, changes_ = 0;
};

}  // namespace kadr::macro_b
