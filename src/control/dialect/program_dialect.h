#pragma once
// ProgramDialect: how a control begins and ends a program, and what it remembers beyond it. One of the interfaces of a Dialect
// (control/dialect.h).

#include <cstdint>
#include <memory>
#include <string>
#include <utility>

#include "base/result.h"
#include "base/vec.h"
#include "config/setup.h"
#include "config/setup_file.h"
#include "config/state_file.h"
#include "control/control.h"
#include "control/dialect/machine_side.h"

namespace kadr {

class BlockContext;
class Emitter;
class Interpreter;
class Dialect;

/// What a dialect remembers, in a snapshot.
struct DialectState {
  virtual ~DialectState() = default;
};

class ProgramDialect {
 public:
  virtual ~ProgramDialect() = default;

  /// All that it remembers, between two blocks.
  virtual std::shared_ptr<const DialectState> snapshot() const { return nullptr; }
  /// Goes on from a snapshot of its like; the interpreter has been restored.
  ///   alarms  file_write: a file that the program was writing cannot be gone on with
  virtual Status restore(BlockContext& m, const DialectState& from);
  /// nullptr: there is no machine whose logic, operator or parameters are known.
  virtual MachineSide* machine_side() { return nullptr; }
  /// What the program has written: path, bytes.
  virtual const WrittenFiles& files_written() const;
  /// Power-on, instead of the codes that the file's groups begin with. true: done.
  virtual bool start(Interpreter& m, const Setup& setup);
  /// The modal codes of a set-up are carried out one by one, not as one block.
  virtual bool starts_code_by_code() const { return false; }
  /// What the set-up says, after its modal codes.
  virtual void take_setup(Emitter& m, const Setup& setup);
  /// Words carried out behind the power-on codes, before those of the set-up.
  virtual std::string start_words() const { return {}; }
  /// The tool stands where the set-up says.
  virtual void started(Emitter& m);
  /// Limits of an axis that a file of the machine says, machine coordinates; ±1e300: none. Those of the set-up and of a machine file
  /// count before them.
  virtual std::pair<double, double> limits_by_file(std::size_t axis) const;
  /// M2, M30, instead of the file's end codes. true: done.
  virtual bool end_program(Interpreter& m);
  /// The run has stopped with an alarm; all that the block had changed is as it was.
  virtual void failed(Emitter&) {}
  /// Power off and on: what only the power kept is lost. false: nothing is known of that.
  virtual bool lose_power(Interpreter& m);
  /// Tables as a set-up would give them (control/tables_now). false: they are those of the interpreter.
  virtual bool add_tables(const BlockContext&, Setup&) const { return false; }
  /// What the block changed of the things that survive power-off.
  virtual StateChanges take_changes(Interpreter& m);
  /// What the channels of a machine have in common besides Commons: goes up as it changes.
  virtual std::uint64_t common_version() const { return 0; }
  /// Of another channel, a dialect of the same kind; between two blocks.
  virtual void take_common(BlockContext&, const Dialect&) {}
  /// A line of nothing but `%` (Grammar::percent_encloses). true: dealt with.
  virtual Result<bool> sign_of_file(Interpreter& m);
  /// The program's file is over, without a code that ends it. true: dealt with.
  virtual Result<bool> end_of_file(BlockContext& m);
  virtual void note_fault(Interpreter& m, bool may_have_steered);
  /// A main program begins again: what was noted of its passes is forgotten.
  virtual void begin_again() {}
  /// The innermost call is left although its end is missing. true: done.
  virtual bool leave_call(Interpreter& m);
  /// The control's own words for what is reported, where no row of [alarms] can have them.
  virtual void reword(const BlockContext& m, AlarmReport& report) const;
};

}  // namespace kadr
