#pragma once
// ProgramDialect: how a control starts and ends a program, and what it remembers after the program's end. One of the interfaces of a
// Dialect (control/dialect.h).

#include <cstdint>
#include <memory>
#include <string>
#include <utility>

#include "base/result.h"
#include "base/vec.h"
#include "config/setup/setup.h"
#include "config/setup/setup_file.h"
#include "config/state/state_file.h"
#include "control/control.h"
#include "control/dialect/machine_interface.h"

namespace kadr {

class BlockContext;
class Emitter;
class Interpreter;
class Dialect;

/// The data that a dialect remembers, as part of a snapshot.
struct DialectState {
  virtual ~DialectState() = default;
};

class ProgramDialect {
 public:
  virtual ~ProgramDialect() = default;

  /// Returns everything that the dialect remembers between two blocks; nullptr if it remembers nothing.
  virtual std::shared_ptr<const DialectState> snapshot() const { return nullptr; }
  /// Restores the data from a snapshot of the same dialect, after the interpreter has been restored.
  ///   alarms  file_write: a file that the program was writing cannot be continued
  virtual Status restore(BlockContext& m, const DialectState& from);
  /// The interface for the machine; nullptr if the control models no machine with logic, operator or parameters.
  virtual MachineInterface* machine_interface() { return nullptr; }
  /// The files that the program has written: path, size in bytes.
  virtual const WrittenFiles& files_written() const;
  /// Called at power-on. Returns true if the dialect has set the initial modes itself, in place of the power-on codes in the control's
  /// file.
  virtual bool start(Interpreter& m, const Setup& setup);
  /// True if the modal codes of a set-up are executed one after another, each as a block, not all as one block.
  virtual bool starts_code_by_code() const { return false; }
  /// Reads the set-up, after its modal codes.
  virtual void take_setup(Emitter& m, const Setup& setup);
  /// Returns the text of words to be executed after the power-on codes and before the words of the set-up.
  virtual std::string start_words() const { return {}; }
  /// Called when the tool is at the start position of the set-up.
  virtual void started(Emitter& m);
  /// Returns the limits of an axis from a file of the machine, in machine coordinates; ±1e300 if the file gives none. Limits of the
  /// set-up and of a machine description have priority.
  virtual std::pair<double, double> limits_by_file(std::size_t axis) const;
  /// Called at M2, M30. Returns true if the dialect's action replaces the effect of the end codes in the control's file.
  virtual bool end_program(Interpreter& m);
  /// Called when an alarm has stopped the run and everything that the block had changed is restored.
  virtual void failed(Emitter&) {}
  /// Called when the power goes off and on: discards what is lost without power. Returns false if the control does not model this.
  virtual bool lose_power(Interpreter& m);
  /// Adds tables in the form of a set-up (control/tables_now). Returns false if the interpreter's own tables are to be used.
  virtual bool add_tables(const BlockContext&, Setup&) const { return false; }
  /// Returns what the block changed among the data that survive power-off.
  virtual StateChanges take_changes(Interpreter& m);
  /// Version of the data that the channels of a machine share besides the common variables (Commons); it rises with each change.
  virtual std::uint64_t common_version() const { return 0; }
  /// Copies the shared data from another channel, whose dialect is of the same type; between two blocks.
  virtual void take_common(BlockContext&, const Dialect&) {}
  /// Handles a line with nothing but `%` (Grammar::percent_encloses). Returns true if no other handling is needed.
  virtual Result<bool> sign_of_file(Interpreter& m);
  /// Handles the end of the program's file without a code that ends it. Returns true if no other handling is needed.
  virtual Result<bool> end_of_file(BlockContext& m);
  virtual void note_fault(Interpreter& m, bool may_have_steered);
  /// Called when a main program starts again: discards what was recorded about its passes.
  virtual void begin_again() {}
  /// Leaves the innermost call although its end is missing. Returns true if done.
  virtual bool leave_call(Interpreter& m);
  /// Puts the control's own wording into a report where no row of [alarms] can give it.
  virtual void reword(const BlockContext& m, AlarmReport& report) const;
};

}  // namespace kadr
