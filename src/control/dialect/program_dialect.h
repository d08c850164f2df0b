#pragma once
// ProgramDialect: how a control starts and ends a program, and which data it stores after the program's end. One of the interfaces of a
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
#include "control/local_variables.h"

namespace kadr {

class BlockContext;
class Emitter;
class Interpreter;
class Dialect;
struct CallFrame;

/// The part of a snapshot that belongs to a dialect: the data that the dialect stores between two blocks.
struct DialectState {
  virtual ~DialectState() = default;
  /// Returns the variables of the main program and of each call, outermost first; empty if the control has no local variables.
  virtual std::vector<LocalVariables> local_variables(const std::vector<CallFrame>& calls, const ControlDef& def) const;
};

class ProgramDialect {
 public:
  virtual ~ProgramDialect() = default;

  /// Returns all data that the dialect stores between two blocks; nullptr if it stores none.
  virtual std::shared_ptr<const DialectState> snapshot() const { return nullptr; }
  /// Restores the data from a snapshot of the same dialect, after the interpreter has been restored.
  ///   alarms  file_write: a file that the program was writing cannot be continued
  virtual Status restore(BlockContext& m, const DialectState& from);
  /// Returns the functions for the machine; nullptr if the control models no machine with logic, operator and parameters.
  virtual MachineInterface* machine_interface() { return nullptr; }
  /// Returns the files that the program has written: for each path, the size in bytes.
  virtual const WrittenFiles& files_written() const;
  /// Starts the dialect at power-on. Returns true if the dialect has set the initial modes itself, in place of the power-on codes in the
  /// control's file.
  virtual bool start(Interpreter& m, const Setup& setup);
  /// Returns true if the modal codes of a set-up are executed one by one, each as its own block. If false, all codes together form one
  /// block.
  virtual bool starts_code_by_code() const { return false; }
  /// Reads the rest of the set-up, after the interpreter has executed the modal codes of the set-up.
  virtual void take_setup(Emitter& m, const Setup& setup);
  /// Returns code words to be executed after the power-on codes and before the modal codes of the set-up.
  virtual std::string start_words() const { return {}; }
  /// Ends the start-up of the dialect. At this moment the tool is at the start position of the set-up.
  virtual void started(Emitter& m);
  /// Returns true if cycles of the dialect read contours from subprograms (control/outline_run.h), for which the set-up is kept.
  virtual bool reads_outlines() const { return false; }
  /// Returns the limits of an axis from a file of the machine, in machine coordinates (mm, degrees); ±1e300 if the file gives none. Limits
  /// in the set-up and in a machine description have priority.
  virtual std::pair<double, double> limits_by_file(std::size_t axis) const;
  /// Ends the program at M2 or M30. Returns true if the dialect has ended the program itself, so that the end codes in the control's file
  /// are not executed.
  virtual bool end_program(Interpreter& m);
  /// A function of the dialect for an alarm that has stopped the run; the interpreter calls it after the state before the faulty block is
  /// restored.
  virtual void failed(Emitter&) {}
  /// Clears the data that are lost without power, because the power goes off and on. Returns false if the control does not model this loss.
  virtual bool lose_power(Interpreter& m);
  /// Adds the tables of the dialect to a set-up (control/tables_now). Returns false if the caller must add the interpreter's own tables.
  virtual bool add_tables(const BlockContext&, Setup&) const { return false; }
  /// Returns the data that the block has changed and that survive power-off.
  virtual StateChanges take_changes(Interpreter& m);
  /// Returns the version of the data that the channels of a machine share, other than the common variables (Commons). The version rises
  /// with each change.
  virtual std::uint64_t common_version() const { return 0; }
  /// Copies the data that channels share from another channel, whose dialect is of the same type. The interpreter calls this function only
  /// between two blocks.
  virtual void take_common(BlockContext&, const Dialect&) {}
  /// Handles a line that consists of `%` (Grammar::percent_encloses). Returns true if the interpreter has nothing more to do for the line.
  virtual Result<bool> sign_of_file(Interpreter& m);
  /// Handles the end of the program's file if no code has ended the program. Returns true if the interpreter has nothing more to do at this
  /// end.
  virtual Result<bool> end_of_file(BlockContext& m);
  virtual void note_fault(Interpreter& m, bool may_have_steered);
  /// Discards the data that were recorded during the last pass of the main program, because the main program starts again.
  virtual void begin_again() {}
  /// Leaves the innermost call if the end of its subprogram is missing. Returns true if the dialect has left the call, false if the
  /// interpreter must do so.
  virtual bool leave_call(Interpreter& m);
  /// Replaces the text of a report by the control's own text. Needed if no row of [alarms] in the control's file can give this text.
  virtual void reword(const BlockContext& m, AlarmReport& report) const;
};

}  // namespace kadr
