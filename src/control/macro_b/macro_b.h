#pragma once
// Custom macros B, as Fanuc, Haas and NCT have them (spec/nct/23, spec/fanuc 5, 9): calls, variables, statements, output. One object a
// channel; its memory is a value (memory.h). What stands on it, cycles, frames, tools, it asks by the virtual functions below.

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "config/setup.h"
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

class MacroB : public Dialect, public MachineSide, public Memory {
 public:
  MacroB(BlockContext& m, const Setup& setup, const RunLimits& limits, std::shared_ptr<Commons> commons);
  ~MacroB() override;

  // ---- parameters and what follows from them
  /// Parameters have changed: what follows from them is worked out anew.
  void refresh_settings(BlockContext& m);
  Status parameter_line(BlockContext& m);
  void close_data() { state.data_mode = DataMode::none; }

  /// The modal state of the interrupted block comes back (23.4). `restore`: plain M99.
  void end_interrupt(Emitter& m, bool restore);

  // ---- what an alarm takes back
  void begin_block(Emitter& m) override;
  /// The block may change more than where the tool is.
  virtual void keep_all();
  void keep(BlockContext&) override { keep_all(); }
  void take_back(BlockContext& m) override;
  void taken_back(Emitter& m) override;

  // ---- snapshot
  std::shared_ptr<const DialectState> snapshot() const override;
  Status restore(BlockContext& m, const DialectState& from) override;

  // ---- what the machine tells
  MachineSide* machine_side() override { return this; }
  void set_signal(const std::string& name, double value) override;
  void set_answer(double to) override { answer = to; }
  void set_time(double at_ms, double cut_ms) override;
  const WrittenFiles& files_written() const override { return output.files(); }

  // ---- what the interpreter asks
  bool starts_code_by_code() const override { return true; }
  bool start(Interpreter& m, const Setup& setup) override;
  /// Variables of the set-up.
  void take_setup(Emitter& m, const Setup& setup) override;
  bool lose_power(Interpreter& m) override;
  void add_variables(Emitter& m, Ending& ending, const std::vector<std::string>& watch) override;
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

  // ---- what stands on it
  /// Where the tool stands after the transformations: work coordinates, in polar interpolation the virtual ones.
  virtual Axes before_transform(const BlockContext& m) const = 0;
  /// Data of cycles in force: kept for the end of an interrupt macro, as they were then.
  virtual void keep_cycles() = 0;
  virtual void bring_cycles_back() = 0;
  /// Contours of the program that cycles are carrying out.
  virtual std::size_t open_contours() const = 0;
  /// Has a table been written to since the last question?
  virtual bool take_touched_tables() = 0;
  /// A system variable that is no macro's: positions, offsets, zeros, tools. Nothing: it is none of these.
  virtual std::optional<double> table_value(Emitter& m, const FoundVariable& variable) const = 0;
  /// true: it was one, and is written. alarms value_limit, magazine_number
  virtual Result<bool> write_table(Emitter& m, const FoundVariable& variable, double value, Span where) = 0;

  MacroVariables variables;
  ParameterStore parameters;
  OutputFile output;

 protected:
  /// The parameters have changed, and the settings follow.
  virtual void read_parameters(BlockContext& m);
  /// What the program has set is as at power-on (3.4).
  void reset_macros();
  /// Words of a block like the one before are read by no macro: Dialect::lines_follow.
  bool words_follow() const {
    return !settings.binds_codes && pending.empty() && state.data_mode == DataMode::none && state.active_modal_calls == 0 &&
           !single_block && !watches_blocks() && !interrupted.active;
  }
  /// Nothing of this block has been kept yet.
  bool keeps_nothing() const { return !before_.all; }

 private:
  /// What keep_all() has kept; tables and variables stand in the interpreter's journal.
  struct Before {
    bool all = false;
    Volatile state;
    std::size_t levels = 1, repeated_arguments = 0;
  };

  Before before_;
  std::vector<double> clocks_;  // numbers of the clock variables
};

/// Its part of a snapshot.
struct MacroState : DialectState {
  explicit MacroState(const MacroB& of);

  Memory memory;
  ParameterStore::Memory parameters;
  MacroVariables::Memory variables;
  OutputFile::Memory output;
};

}  // namespace kadr::macro_b

namespace kadr {

/// The object of an interpreter whose control has custom macros B.
macro_b::MacroB& macro_b_of(const BlockContext& m);

}  // namespace kadr
