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

/// The two moments of a block at which the machine's logic and an interrupt macro may act.
enum class BlockMoment : std::uint8_t { start, end };

/// The state that a block may change. Only this state is saved before the block, so that an alarm can restore it.
enum class BlockChanges : std::uint8_t {
  position,  // the block changes only the position: its motion either fails before it starts, or is executed
  little,    // the block changes the position, the motion code and the feed
  cycle,     // the block changes the position, the motion code, the feed, and the stored words of a drilling cycle
  anything,
};

class BlockDialect {
 public:
  virtual ~BlockDialect() = default;

  /// Returns true if the dialect has work from earlier blocks to finish before the next block is read.
  virtual bool has_unfinished() const { return false; }
  /// Executes one step of the work that has_unfinished() reports. Returns true if the next block must still wait.
  virtual Result<bool> finish(Interpreter& m);
  /// Returns true if the block's expressions read a clock. The block must then be executed only when the machine reaches it, so that the
  /// clock has the right time.
  virtual bool reads_clock(const Block& block) const;
  /// A function of the dialect for a block with a skip mark `/`; the interpreter calls it whether the block is skipped or not.
  virtual void note_skip_mark(Emitter& m);
  /// Returns true if a skipped block is not even read, so that a fault in it is not reported.
  virtual bool skips_unread() const { return false; }
  /// Returns true if an interrupt macro may be requested: the interpreter then calls interrupt() at the start and end of each block.
  virtual bool watches_blocks() const { return false; }
  virtual bool in_interrupt() const { return false; }
  /// Calls the interrupt macro if it has been requested. Returns true if it was called.
  virtual Result<bool> interrupt(Interpreter& m, BlockMoment moment);
  /// Returns true while blocks with a block number are data lines of a G10: they are stored, not executed.
  virtual bool takes_data() const { return false; }
  /// Executes a block that is a statement: IF, WHILE, GOTO, #1=…. Returns false if the words of the block must still be executed: those
  /// after THEN if the condition of an IF … THEN is true.
  virtual Result<bool> statement(Interpreter& m);
  virtual void begin_block(Emitter& m);
  /// Receives the block when its words have their values. Returns true if the interpreter must execute nothing else of the block, because
  /// the words were data or the arguments of a macro.
  virtual Result<bool> takes_block(Interpreter& m);
  /// Returns the row of the motion code for a block that has only axis words; -1 if no motion code is in force.
  virtual std::int16_t motion_row(const BlockContext& m) const;
  virtual BlockChanges changes_of(const BlockContext& m, const Plan& plan) const;
  /// The interpreter calls before_function() before it executes each function of the block, and after_code() after each code. `code` is the
  /// number of the code's word in tenths; -1 if there is no word.
  virtual void before_function(Emitter& m, Function function);
  virtual void after_code(Interpreter& m, const CodeRow& row, std::int32_t code);
  /// Executes an M code that the control passes to the machine.
  virtual Status machine_code(Interpreter& m, const Call& call);
  virtual Status after_block(Interpreter& m);
  /// Saves the dialect's own data before a block that may change anything.
  virtual void keep(BlockContext& m);
  /// Restores the dialect's own data after a faulty block. The interpreter calls block_undone() later, when its own data are restored too.
  virtual void undo_block(BlockContext& m);
  virtual void block_undone(Emitter& m);
  /// Executes those comments of the block that have an effect, such as (MSG, …), before the words of the block.
  virtual Status comments(Emitter& m);
  /// A function of the dialect for a program in which a subprogram has the number of a canned cycle: a call of this number executes the
  /// cycle, not the subprogram. `where`: location of the call, or of the first block of the subprogram.
  virtual void note_shadowed(Emitter& m, std::uint32_t number, Span where);
};

}  // namespace kadr
