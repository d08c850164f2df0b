#pragma once
// BlockDialect: what a control makes of a block before and after its words are executed. One of the interfaces of a Dialect
// (control/dialect.h).

#include <cstdint>

#include "base/result.h"
#include "config/control_def.h"
#include "control/control.h"
#include "lang/block/block.h"

namespace kadr {

class BlockContext;
class Emitter;
class Interpreter;
struct Call;
struct Plan;

/// When the machine's logic and an interrupt macro are looked at.
enum class BlockMoment : std::uint8_t { start, end };

/// What a block may change, and so what is kept of the state before it: an alarm takes the block back.
enum class BlockChanges : std::uint8_t {
  position,  // nothing else: the motion either fails before, or is made
  little,    // motion code and feed
  cycle,     // those, and the words of a drilling cycle
  anything,
};

class BlockDialect {
 public:
  virtual ~BlockDialect() = default;

  /// Something is to be finished before the next block is read.
  virtual bool has_unfinished() const { return false; }
  /// Does a part of it. true: the next block must wait.
  virtual Result<bool> finish(Interpreter& m);
  /// The block's expressions ask the time: it must be that of the moment.
  virtual bool reads_clock(const Block& block) const;
  /// A block with `/`, whether it is skipped or not.
  virtual void note_skip_mark(Emitter& m);
  /// A block that is skipped is not read: what is wrong in it does not count.
  virtual bool skips_unread() const { return false; }
  /// Blocks are looked at one by one: an interrupt macro may come.
  virtual bool watches_blocks() const { return false; }
  virtual bool in_interrupt() const { return false; }
  /// Calls the interrupt macro where it is asked for. true: it was called.
  virtual Result<bool> interrupt(Interpreter& m, BlockMoment moment);
  /// Numbered lines are data (of a G10), not blocks.
  virtual bool takes_data() const { return false; }
  /// IF, WHILE, GOTO, #1=…: a block that is no words. false: IF … THEN holds, and the words behind it are to be carried out.
  virtual Result<bool> statement(Interpreter& m);
  virtual void begin_block(Emitter& m);
  /// The words have their values. true: the block is done with that (its words were arguments of a macro, data …).
  virtual Result<bool> takes_block(Interpreter& m);
  /// Row of the motion code that axis words alone would carry out; -1: none.
  virtual std::int16_t motion_row(const BlockContext& m) const;
  virtual BlockChanges changes_of(const BlockContext& m, const Plan& plan) const;
  /// Before and after each function of the block; `code` is the tenth of the word's number, -1: none.
  virtual void before_function(Emitter& m, Function function);
  virtual void after_code(Interpreter& m, const CodeRow& row, std::int32_t code);
  /// M codes of the machine.
  virtual Status machine_code(Interpreter& m, const Call& call);
  virtual Status after_block(Interpreter& m);
  /// The block may change anything: what of it is kept here.
  virtual void keep(BlockContext& m);
  /// The block was faulty: what it had changed here, as it was; then, when all the rest is as it was before.
  virtual void take_back(BlockContext& m);
  virtual void taken_back(Emitter& m);
  /// Comments that do something, before the block's words.
  virtual Status comments(Emitter& m);
  /// A subprogram of the program has the number of a cycle, which is called instead. `where`: the call, or its first block.
  virtual void note_shadowed(Emitter& m, std::uint32_t number, Span where);
};

}  // namespace kadr
