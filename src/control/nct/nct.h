#pragma once
// The dialect of the NCT control (spec/nct): what it does that no row can say. One object a channel; its memory is a value (memory.h).

#include <memory>
#include <string>
#include <vector>

#include "config/setup.h"
#include "control/dialect.h"
#include "control/macro_b/output/output_file.h"
#include "control/macro_b/variables/parameters.h"
#include "control/nct/memory.h"
#include "control/variables/macro_variables.h"

namespace kadr {
class Interpreter;
struct Call;
struct CallFrame;
}  // namespace kadr

namespace kadr::nct {

class Nct : public Dialect, public MachineSide, public Memory {
 public:
  Nct(Interpreter& m, const Setup& setup, const RunLimits& limits, std::shared_ptr<Commons> commons);
  ~Nct() override;

  // ---- parameters and what follows from them
  /// Parameters have changed: what follows from them is worked out anew.
  void refresh_settings(Interpreter& m);
  Status parameter_line(Interpreter& m);

  // ---- start and end
  /// Power-on state, then what the set-up says.
  bool start(Interpreter& m, const Setup& setup) override;
  /// Variables, plane, diameter of the set-up, after its modal codes.
  void take_setup(Interpreter& m, const Setup& setup) override;
  /// What the program has set is as at power-on (3.4).
  void reset_program(Interpreter& m);
  /// Whole state for the last line of a trace, in the form of a set-up.
  RunState run_state(const Interpreter& m) const override;

  // ---- what an alarm takes back
  /// A word block begins.
  void begin_block(Interpreter& m) override;
  /// It may change more than where the tool is.
  void keep_all();
  void take_back(Interpreter& m) override;

  // ---- snapshot
  std::shared_ptr<const DialectState> snapshot() const override;
  Status restore(Interpreter& m, const DialectState& from) override;

  // ---- tools
  Result<std::uint32_t> offset_of_tool(char letter) const;
  Status open_tool_data(Interpreter& m, std::uint32_t l, double p, Span where);
  Status tool_line(Interpreter& m);
  void close_data() { state.data_mode = DataMode::none; }

  // ---- spindles
  SpindleState& spindle(int number) { return state.spindles[static_cast<std::size_t>(number)]; }
  const SpindleState& spindle(int number) const { return state.spindles[static_cast<std::size_t>(number)]; }
  /// Speed of the main spindle now, rev/min; 0 if it stands.
  double spindle_rpm(const Interpreter& m) const;
  /// What G96, G97 make of the main spindle's speed (11.5); said where anything of it changes.
  SurfaceSpeed surface_speed(const Interpreter& m) const override;
  void tell_surface_speed(Interpreter& m) const;
  double css_rpm(const Interpreter& m) const;

  /// The modal state of the interrupted block comes back (23.4). `restore`: plain M99.
  void end_interrupt(Interpreter& m, bool restore);

  // ---- what the machine tells (machine_side.cpp)
  MachineSide* machine_side() override { return this; }
  void set_signal(const std::string& name, double value) override;
  void set_answer(double to) override { answer = to; }
  void synchronise(int slave, int master) override;
  void couple_axis(Interpreter& m, const std::string& name, AxisLink link, bool on) override;
  const std::vector<FarAxis>& far_axes() const override { return couplings.far; }
  void drop_far(Interpreter& m, const FarAxis& axis) override;
  void lead_axis(Interpreter& m, std::size_t axis, double machine) override;
  bool may_exchange(const Interpreter& m, std::size_t axis) const override;
  void exchange_far(std::size_t axis, double machine, bool on) override;
  bool is_parked(std::size_t axis) const override { return (drives.parked >> axis & 1U) != 0; }
  bool rolls_over(std::size_t axis) const override { return settings.axes[axis].rolls; }
  void convert_spindle(int number, bool to_axis) override;
  void set_time(double at_ms, double cut_ms) override;
  const WrittenFiles& files_written() const override { return output.files(); }
  bool waiting_suspended() const override;
  SearchRules search_rules() const override;

  // ---- what the interpreter asks (dialect.cpp): each is a function of this folder
  bool starts_code_by_code() const override { return true; }
  void started(Interpreter& m) override;
  bool end_program(Interpreter& m) override;
  bool lose_power(Interpreter& m) override;
  void add_variables(Interpreter& m, Ending& ending, const std::vector<std::string>& watch) override;
  StateChanges take_changes(Interpreter& m) override;
  /// Of the channel's default spindle (N0604; 12.3.2): 10, 20, …
  int spindle_magazine() const { return ToolManagement::main_spindle * std::max(settings.default_spindle, 1); }
  std::uint64_t common_version() const override { return tools.tables_version() + parameters.version(); }
  void take_common(Interpreter& m, const Dialect& from) override;
  bool has_unfinished() const override { return !finishing.empty() || !drives.asked.empty(); }
  Result<bool> finish(Interpreter& m) override;
  bool reads_clock(const Block& block) const override;
  void note_skip_mark(Interpreter& m) override;
  bool watches_blocks() const override { return state.interrupt_program.has_value(); }
  bool in_interrupt() const override { return interrupted.active; }
  Result<bool> interrupt(Interpreter& m, BlockMoment moment) override;
  bool takes_data() const override { return state.data_mode != DataMode::none; }
  Result<bool> statement(Interpreter& m) override;
  Result<bool> takes_block(Interpreter& m) override;
  std::int16_t motion_row(const Interpreter& m) const override;
  BlockChanges changes_of(const Interpreter& m, const Plan& plan) const override;
  void before_function(Interpreter& m, Function function) override;
  void after_code(Interpreter& m, const CodeRow& row, std::int32_t code) override;
  Status after_block(Interpreter& m) override;
  void keep(Interpreter&) override { keep_all(); }
  void taken_back(Interpreter& m) override;
  void note_fault(Interpreter& m, bool may_have_steered) override { endless.note_fault(m, may_have_steered); }
  void begin_again() override { endless.forget(); }
  bool leave_call(Interpreter& m) override;
  Status target(const Interpreter& m, Axes& to, AxisMask& named) const override;
  bool shapes_lines(const Interpreter& m) const override;
  Status straight(Interpreter& m, const Call& call, MotionKind kind) override;
  bool only_shifts(const Interpreter& m) const override;
  Status arc(Interpreter& m, const Call& call, Turn turn) override;
  Status surface_line(Interpreter& m, MotionKind kind, const Axes& programmed, AxisMask named) override;
  bool lines_follow(const Interpreter& m) const override;
  AxisMask rolling_axes(const Interpreter& m) const override;
  ArcRule arc_rule(const Interpreter& m) const override;
  void note_line(Interpreter& m) override;
  Status may_move(const Interpreter& m, AxisMask named) const override;
  void note_motion(Interpreter& m, Motion& motion) override;
  double inch_feed(const Interpreter& m, const Motion& motion, const Axes& from) const override;
  void note_feed(Interpreter&) override { state.thread_lead = 0; }
  bool keeps_both_feeds() const override { return true; }  // 6.2.1
  void refresh_frames(Interpreter& m) override;
  Axes shift_of_origin(const Interpreter& m) const override;
  bool zero_may_move() const override { return true; }
  void roll(const Interpreter& m, Axes& positions) const override;
  Status take_answer(Interpreter& m, const ProbeAnswer& at) override;
  Status machine_code(Interpreter& m, const Call& call) override;
  Result<double> read_variable(Interpreter& m, double number, Span where) const override;
  Result<double> number_of_element(const Interpreter& m, double symbol, double index, Span where) const override;
  Result<double> control_value(Interpreter& m, double number, double bit, double index, Span where) const override;

  MacroVariables variables;
  ParameterStore parameters;
  OutputFile output;

 private:
  /// What keep_all() has kept; tables, variables and MotionMemory stand in the interpreter's journal.
  struct Before {
    bool all = false;
    Volatile state;
    std::size_t levels = 1, repeated_arguments = 0;
  };
  void take_reference_points(Interpreter& m);
  void mirror_by_settings(Interpreter& m) const;

  Before before_;
  std::array<Axes, 5> setup_reference_{};  // reference points that the set-up states by themselves
  std::vector<double> clocks_;             // numbers of the clock variables
};

/// Groups of the offset table: N1400, else what the variables have room for (15.1).
std::uint32_t most_offsets(const Interpreter& m);
/// Axes that the machine makes of spindles (11.8), as far as the set-up's events say that it does.
void find_spindle_axes(Interpreter& m, const Setup& setup);
/// A warning where one of these axes moves while it turns as a spindle.
void watch_spindle_axes(Interpreter& m, AxisMask named);
/// Lead of a thread by the block's E or F, or the last one, mm; 0: none (4.4).
double take_lead(Interpreter& m);
/// Dwell P in seconds (8). alarms value_out_of_range, spindle_not_turning
Result<double> dwell_seconds(Interpreter& m, double p, Span where);
/// P of a dwell by its digits: milliseconds; with a point seconds, or an alarm (spec/fanuc 4.1, spec/haas 4.1). alarms point_not_allowed
Result<double> dwell_by_digits(Interpreter& m);
/// M codes for the machine: indexing, closing the loop, optional spindle codes, all others (11, 13.1).
Status machine_code(Interpreter& m, const Call& call);
/// The gearbox, if it is on, stops (20.1).
void disengage(Interpreter& m);
/// The tool leaves the teeth (20.1.4), while the gearbox is on.
Status withdraw(Interpreter& m);
/// A tool's life may be counted in time (12.3.1).
void watch_tool_time(Interpreter& m);
/// The block has a word for a spindle.
bool has_spindle_word(const Interpreter& m);
/// Variables that hold something, and those that are asked for ("#5061", "#_ALM").
void add_variables(Interpreter& m, Ending& ending, const std::vector<std::string>& watch);
/// G10 L… (set_tables.cpp).
Status set_tables(Interpreter& m, const Call& call);

}  // namespace kadr::nct

namespace kadr {

/// The dialect of an interpreter that has this one.
nct::Nct& nct_of(const Interpreter& m);

}  // namespace kadr
