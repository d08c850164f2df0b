#pragma once
// Custom macros B of Fanuc, Haas and NCT (spec/nct/23, spec/fanuc 5, 9): calls, variables, statements, output. There is one MacroB object
// per channel; the state of an object is a plain value (memory.h). The dialects derived from MacroB provide canned cycles, frames and tools
// through virtual functions, which are at the end of the public part.

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "config/setup/setup.h"
#include "control/dialect.h"
#include "control/macro_b/memory.h"
#include "control/macro_b/output/output_file.h"
#include "control/macro_b/variables/parameters.h"
#include "control/macro_b/variables/system_variables.h"
#include "control/variables/macro_variables.h"

namespace kadr {
class BlockContext;
class Emitter;
class Interpreter;
struct Call;
struct CallFrame;
}  // namespace kadr

namespace kadr::macro_b {

class MacroB : public Dialect, public MachineInterface, public Memory {
 public:
  MacroB(BlockContext& m, const Setup& setup, const RunLimits& limits, std::shared_ptr<Commons> commons);
  ~MacroB() override;

  // ---- parameters and the settings derived from them

  /// Derives the macro settings from the parameters again if a parameter has changed.
  void refresh_settings(BlockContext& m);
  Status parameter_line(BlockContext& m);
  void close_data() { state.data_mode = DataMode::none; }

  /// Ends an interrupt macro (23.4).
  ///   restore  true for M99 without P: the modal state of the interrupted block is restored
  void end_interrupt(Emitter& m, bool restore);

  // ---- state that an alarm restores
  void begin_block(Emitter& m) override;
  /// Saves the macro state, so that an alarm in the block can restore it. Must be called before a block changes more than the position.
  virtual void keep_all();
  void keep(BlockContext&) override { keep_all(); }
  void undo_block(BlockContext& m) override;
  void block_undone(Emitter& m) override;

  // ---- snapshot
  std::shared_ptr<const DialectState> snapshot() const override;
  Status restore(BlockContext& m, const DialectState& from) override;

  // ---- reports of the machine
  MachineInterface* machine_interface() override { return this; }
  void set_signal(const std::string& name, double value) override;
  void set_answer(double to) override { answer = to; }
  void set_time(double at_ms, double cut_ms) override;
  const WrittenFiles& files_written() const override { return output.files(); }

  // ---- functions that the interpreter calls
  bool starts_code_by_code() const override { return true; }
  bool start(Interpreter& m, const Setup& setup) override;
  /// Assigns the values that the set-up gives to variables.
  void take_setup(Emitter& m, const Setup& setup) override;
  bool lose_power(Interpreter& m) override;
  void add_variables(Emitter& m, FinalState& ending, const std::vector<std::string>& watch) override;
  StateChanges take_changes(Interpreter& m) override;
  std::uint64_t common_version() const override { return parameters.version(); }
  void take_common(BlockContext& m, const Dialect& from) override;
  bool reads_clock(const Block& block) const override;
  bool watches_blocks() const override { return state.interrupt_program.has_value(); }
  bool in_interrupt() const override { return interrupted.active; }
  Result<bool> interrupt(Interpreter& m, BlockMoment moment) override;
  bool takes_data() const override { return state.data_mode != DataMode::none; }
  Result<bool> statement(Interpreter& m) override;
  void note_fault(Interpreter& m, bool may_have_steered) override;
  void begin_again() override { endless.forget(); }
  bool leave_call(Interpreter& m) override;
  Result<double> read_variable(Emitter& m, double number, Span where) const override;
  Result<double> number_of_element(const BlockContext& m, double symbol, double index, Span where) const override;
  Result<double> control_value(BlockContext& m, double number, double bit, double index, Span where) const override;

  // ---- functions that the derived dialects provide

  /// Returns the tool's position after mirroring, scaling and rotation, in work coordinates. In polar interpolation, returns coordinates of
  /// the virtual plane.
  virtual Axes before_transform(const BlockContext& m) const = 0;
  /// Saves the data of the canned cycles in force when an interrupt macro starts; bring_cycles_back() restores these data at the end of the
  /// macro.
  virtual void keep_cycles() = 0;
  virtual void bring_cycles_back() = 0;
  /// Returns the number of contours (blocks of the program) that canned cycles are executing at present. The contours are nested, one
  /// within the other.
  virtual std::size_t open_contours() const = 0;
  /// Returns true if a table has been written since the last call.
  virtual bool consume_touched_tables() = 0;
  /// Returns the value of a system variable of a table or position: positions, tool offsets, work offsets, tools. Returns nullopt for any
  /// other variable.
  virtual std::optional<double> table_value(Emitter& m, const FoundVariable& variable) const = 0;
  /// Writes a variable that table_value() reads. Returns false for any other variable. alarms value_limit, magazine_number
  virtual Result<bool> write_table(Emitter& m, const FoundVariable& variable, double value, Span where) = 0;

  MacroVariables variables;
  ParameterStore parameters;
  OutputFile output;

 protected:
  /// Derives the settings from the parameters.
  virtual void read_parameters(BlockContext& m);
  /// Resets everything that the program has set to its state at power-on (3.4).
  void reset_macros();
  /// Returns true if macros do not act on a block that has only an end point, an arc centre and a feed. Such a block may be executed
  /// without the checks that other blocks need (MotionDialect::lines_follow).
  bool words_follow() const {
    return !settings.binds_codes && pending.empty() && state.data_mode == DataMode::none && state.active_modal_calls == 0 &&
           !single_block && !watches_blocks() && !interrupted.active;
  }
  /// Returns true if keep_all() has not been called in this block. Then keep_all() must save the state, and an alarm has no saved state to
  /// restore.
  bool keeps_nothing() const { return !before_.all; }

 private:
  /// The state that keep_all() saves. The interpreter's journal saves the old values of tables and variables.
  struct Before {
    bool all = false;
    UndoableState state;
    std::size_t levels = 1, repeated_arguments = 0;
  };

  Before before_;
  std::vector<double> clocks_;  // numbers of the system variables that show the time
};

/// The part of a snapshot that belongs to custom macros.
struct MacroState : DialectState {
  explicit MacroState(const MacroB& of);
  std::vector<LocalVariables> local_variables(const std::vector<CallFrame>& calls, const ControlDef& def) const override;

  Memory memory;
  ParameterStore::Memory parameters;
  MacroVariables::Memory variables;
  OutputFile::Memory output;
};

}  // namespace kadr::macro_b

namespace kadr {

/// Returns the dialect object of an interpreter whose control has custom macros B.
macro_b::MacroB& macro_b_of(const BlockContext& m);

}  // namespace kadr
