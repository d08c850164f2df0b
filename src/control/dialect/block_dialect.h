#pragma once
// BlockDialect: what a control does with a block before and after its words
// are executed. One of the interfaces of a Dialect (control/dialect.h).

#include <cstdint>

#include "base/result.h"
#include "config/control/control_def.h"
#include "control/control.h"
#include "lang/block/block.h"

namespace kadr {

class BlockContext;
class Emitter;
class Interpreter;
struct Call;
struct Plan;

/// The moments of a block at which the machine's logic and an interrupt macro may act.
enum class BlockMoment : std::uint8_t { start, end };

/// What a block may change; it decides how much of the state is saved before it, because an alarm restores the state before the block.
enum class BlockChanges : std::uint8_t {
  position,  // nothing but the position: the motion either fails before it starts, or is executed
  little,    // motion code and feed
  cycle,     // motion code, feed, and the words of a drilling cycle
  anything,
};

class BlockDialect {
 public:
  virtual ~BlockDialect() = default;

  /// Returns true if the dialect must finish something before the next block is read.
  virtual bool has_unfinished() const { return false; }
  /// Executes one step of what the dialect must finish. Returns true if the next block must still wait.
  virtual Result<bool> finish(Interpreter& m);
  /// Returns true if the block's expressions read a clock: it must then be executed at its real time.
  virtual bool reads_clock(const Block& block) const;
  /// Called for each block with `/`, whether it is skipped or not.
  virtual void note_skip_mark(Emitter& m);
  /// True if a skipped block is not even read, so that faults in it do not matter.
  virtual bool skips_unread() const { return false; }
  /// True if the dialect observes the blocks one by one, because an interrupt macro may be requested.
  virtual bool watches_blocks() const { return false; }
  virtual bool in_interrupt() const { return false; }
  /// Calls the interrupt macro if it has been requested. Returns true if it was called.
  virtual Result<bool> interrupt(Interpreter& m, BlockMoment moment);
  /// True if blocks with a number are data lines (of a G10), not blocks to execute.
  virtual bool takes_data() const { return false; }
  /// Executes a block that is a statement: IF, WHILE, GOTO, #1=…. Returns
  /// false if an IF … THEN is true and the words after it must be executed.
  virtual Result<bool> statement(Interpreter& m);
  virtual void begin_block(Emitter& m);
  /// Called when the words have their values. Returns true if nothing of the block remains to be executed (its words were arguments of a
  /// macro, data …).
  virtual Result<bool> takes_block(Interpreter& m);
  /// Returns the row of the motion code that a block with axis words only executes; -1 if there is none.
  virtual std::int16_t motion_row(const BlockContext& m) const;
  virtual BlockChanges changes_of(const BlockContext& m, const Plan& plan) const;
  /// Called before and after each function of the block; `code` is the word's number in tenths, -1 if there is no word.
  virtual void before_function(Emitter& m, Function function);
  virtual void after_code(Interpreter& m, const CodeRow& row, std::int32_t code);
  /// Executes an M code of the machine.
  virtual Status machine_code(Interpreter& m, const Call& call);
  virtual Status after_block(Interpreter& m);
  /// Saves the dialect's own data before a block that may change anything.
  virtual void keep(BlockContext& m);
  /// undo_block() restores the dialect's own data after a faulty block; block_undone() follows when everything else is restored too.
  virtual void undo_block(BlockContext& m);
  virtual void block_undone(Emitter& m);
  /// Executes comments that have an effect, before the block's words.
  virtual Status comments(Emitter& m);
  /// Called if a subprogram of the program has the number of a called canned cycle,
  /// which is called instead. `where`: the call, or the first block of the subprogram.
  virtual void note_shadowed(Emitter& m, std::uint32_t number, Span where);
};

}  // namespace kadr
