#pragma once
// What only the NCT control remembers (spec/nct): macro levels, parameters, tools, spindles, modal calls. One object a channel.

#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "action/action.h"
#include "config/setup.h"
#include "control/dialect.h"
#include "control/macro_variables.h"
#include "control/nct/changes.h"
#include "control/nct/coupling.h"
#include "control/nct/drilling.h"
#include "control/nct/endless.h"
#include "control/nct/measuring.h"
#include "control/nct/output_file.h"
#include "control/nct/parameters.h"
#include "control/nct/programs.h"
#include "control/nct/settings.h"
#include "control/nct/tools.h"
#include "control/nct/turning.h"
#include "control/state.h"

namespace kadr {
class Interpreter;
struct Call;
struct CallFrame;
}  // namespace kadr

namespace kadr::nct {

/// A modal macro call in force (23.3.2, 23.3.3).
struct ModalCall {
  std::uint16_t reader = 0;
  Position start;
  std::uint32_t times = 1;
  std::uint32_t name = 0;
  bool each_block = false;  // G66.1
  char called_by = 'G';
  std::int32_t called_code = -1;
  Locals arguments;
};

struct SpindleState {
  bool known = false;  // the set-up has it
  int channel = 1;
  double rpm = 0;  // within the limits of the range
  SpindleDir dir = SpindleDir::stop;
  bool loop_closed = false;
  bool referenced = false;  // oriented since the loop was closed
  double angle = 0;         // degrees, while the loop is closed
  int range = 0;            // selected by M11 … M18; 0: none
  int master = 0;           // it is synchronised to; 0: none
};

/// The electronic gearbox (20.1).
struct Gear {
  bool on = false;
  double ratio = 0;  // revolutions of the table for one of the spindle
  double teeth = 0;
};

/// Words of the last block and the like, for #4101 … (23.1.14).
struct ModalWords {
  std::array<double, 3> aux{};
  double d = 0, e = 0, f = 0, h = 0, m = 0, n = 0, o = 0, s = 0, t = 0;
  double extended_zero = 0;
};

/// What a run remembers beside Modal; an alarm takes it back.
struct Volatile {
  std::array<SpindleState, most_spindles + 1> spindles;
  int current_spindle = 1;  // referred to last (11.2)
  int main_spindle = 1;
  double surface_speed = 0;  // m/min
  int css_axis = 0;          // control-wide number
  double css_most = 0;       // G92 S, rev/min; 0: none
  ModalWords words;
  DrillingMemory drilling;
  TurningMemory turning;
  Gear gear;
  double tool_radius = 0;               // of D when it was programmed last (15.1)
  SideStep side_step = SideStep::none;  // what the next motion in the plane does
  std::optional<Vec2> way;              // I J K of G41, G42, G40 in this block
  bool compensates = false;             // a motion has been made with compensation since G41, G42
  ContourCheck contour_check;           // as `path` knows it
};

inline constexpr std::string_view interrupt_signal = "CP_MINT";
inline constexpr std::size_t basic_systems = 6, extended_systems = 99;  // G54 … G59, G54.1 P1 … P99
inline constexpr std::size_t all_systems = 1 + basic_systems + extended_systems;

enum class DataMode : std::uint8_t { none, parameters, tools };

/// What a word block may change here, as it was before: an alarm takes it back.
struct Before {
  // of every block
  ModalWords words;
  bool in_thread = false;
  double thread_lead = 0, surface_angle = 0;
  AxisMask smoothed = 0;
  SideStep side_step = SideStep::none;
  bool compensates = false;
  std::vector<std::pair<int, double>> commons;  // #191 … #199, set by bound letters
  // of a block that does more than move, or call
  bool all = false;
  Volatile state;
  std::vector<ModalCall> modal_calls;
  std::uint8_t active_modal_calls = 0;
  std::size_t levels = 1, repeated_arguments = 0;
  DataMode data_mode = DataMode::none;
  std::optional<ProgramPlace> interrupt_program;
  double parts_done = 0;
  std::vector<std::pair<double*, double>> cells;  // of the tables of zeros
};

/// A word that calls a subprogram behind its block: T, S, A, B, C, M or an ASCII letter (23.3.6–23.3.8).
struct PendingCall {
  int program = 0;
  char letter = 0;
  std::int32_t code = -1;
  Span where;
};

/// Modal state kept for the end of an interrupt macro (23.4).
struct Interrupted {
  bool active = false;
  Modal modal;
  ModalWords words;
  Transform transform;
};

/// The same of what the codes in force repeat: the data of cycles, the macros of G66.
struct InterruptedCycles {
  DrillingMemory drilling;
  TurningMemory turning;
  std::vector<ModalCall> modal_calls;
  std::uint8_t active_modal_calls = 0;
};

class Nct : public Dialect, public MachineSide {
 public:
  Nct(Interpreter& m, const Setup& setup, const RunLimits& limits, std::shared_ptr<Commons> commons);
  ~Nct() override;

  // ---- parameters and what follows from them
  /// Parameters have changed: what follows from them is worked out anew.
  void refresh_settings(const Interpreter& m);
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
  void keep_all(const Interpreter& m);
  /// A number of a table is about to be written.
  void keep_cell(double& cell) { before_.cells.emplace_back(&cell, cell); }
  void keep_common(int n) { before_.commons.emplace_back(n, variables.common(n)); }
  void take_back(Interpreter& m) override;

  // ---- tools
  Result<std::uint32_t> offset_of_tool(char letter) const;
  Status open_tool_data(Interpreter& m, std::uint32_t l, double p, Span where);
  Status tool_line(Interpreter& m);
  void close_data() { data_mode = DataMode::none; }

  // ---- spindles
  SpindleState& spindle(int number) { return state.spindles[static_cast<std::size_t>(number)]; }
  const SpindleState& spindle(int number) const { return state.spindles[static_cast<std::size_t>(number)]; }
  /// Speed of the main spindle now, rev/min; 0 if it stands.
  double spindle_rpm(const Interpreter& m) const;
  /// What G96, G97 make of the main spindle's speed (11.5); said where anything of it changes.
  SurfaceSpeed surface_speed(const Interpreter& m) const override;
  void tell_surface_speed(Interpreter& m) const;
  double css_rpm(const Interpreter& m) const;

  /// Tool lengths by axis before the block.
  const Axes& lengths_before() const { return lengths_before_; }
  /// The modal state of the interrupted block comes back (23.4). `restore`: plain M99.
  void end_interrupt(Interpreter& m, bool restore);

  // ---- what the machine tells (machine_side.cpp)
  MachineSide* machine_side() override { return this; }
  void set_signal(const std::string& name, double value) override;
  void set_answer(double to) override { answer = to; }
  void synchronise(int slave, int master) override;
  void couple_axis(Interpreter& m, const std::string& name, bool on) override;
  void convert_spindle(int number, bool to_axis) override;
  void set_time(double at_ms, double cut_ms) override;
  const WrittenFiles& files_written() const override { return output.files(); }
  bool waiting_suspended() const override;

  // ---- what the interpreter asks (dialect.cpp): each is a function of this folder
  bool starts_code_by_code() const override { return true; }
  void started(Interpreter& m) override;
  bool end_program(Interpreter& m) override;
  bool lose_power(Interpreter& m) override;
  void add_variables(Interpreter& m, Ending& ending, const std::vector<std::string>& watch) override;
  StateChanges take_changes(Interpreter& m) override;
  bool has_unfinished() const override { return !finishing.empty(); }
  Result<bool> finish(Interpreter& m) override;
  bool reads_clock(const Block& block) const override;
  void note_skip_mark(Interpreter& m) override;
  bool watches_blocks() const override { return interrupt_program.has_value(); }
  bool in_interrupt() const override { return interrupted.active; }
  Result<bool> interrupt(Interpreter& m, BlockMoment moment) override;
  bool takes_data() const override { return data_mode != DataMode::none; }
  Status statement(Interpreter& m) override;
  Result<bool> takes_block(Interpreter& m) override;
  std::int16_t motion_row(const Interpreter& m) const override;
  BlockChanges changes_of(const Interpreter& m, const Plan& plan) const override;
  void before_function(Interpreter& m, Function function) override;
  void after_code(Interpreter& m, const CodeRow& row, std::int32_t code) override;
  Status after_block(Interpreter& m) override;
  void keep(Interpreter& m) override { keep_all(m); }
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
  Status may_move(const Interpreter& m, AxisMask named) const override;
  void note_motion(Interpreter& m, Motion& motion) override;
  double inch_feed(const Interpreter& m, const Motion& motion, const Axes& from) const override;
  void note_feed(Interpreter&) override { thread_lead = 0; }
  bool keeps_both_feeds() const override { return true; }  // 6.2.1
  void refresh_frames(Interpreter& m) override;
  bool zero_may_move() const override { return true; }
  void roll(const Interpreter& m, Axes& positions) const override;
  Status take_answer(Interpreter& m, const ProbeAnswer& at) override;
  Status machine_code(Interpreter& m, const Call& call) override;
  Result<double> read_variable(Interpreter& m, double number, Span where) const override;
  Result<double> number_of_element(const Interpreter& m, double symbol, double index, Span where) const override;
  Result<double> control_value(Interpreter& m, double number, double bit, double index, Span where) const override;

  MacroVariables variables;
  ParameterStore parameters;
  Settings settings;
  Volatile state;
  ToolManagement tools;
  DataInput data_input;
  OutputFile output;
  Programs programs;
  std::map<int, std::vector<std::pair<double, double>>> ranges;  // of spindles, rev/min
  std::map<int, std::string> spindle_names;
  std::vector<std::pair<std::size_t, Locals>> repeated_arguments;  // by depth of the call
  std::vector<ModalCall> modal_calls;
  std::uint8_t active_modal_calls = 0;  // how many of them act on the blocks being carried out
  std::vector<Finishing> finishing;     // contours that G70.7 is in
  DataMode data_mode = DataMode::none;
  Interrupted interrupted;
  std::optional<ProgramPlace> interrupt_program;      // M96
  bool signal_rose = false;                           // CP_MINT, since it was looked at last
  std::map<std::string, double> signals;              // of the machine's logic
  Couplings couplings;                                // axes that follow others
  bool single_block = false;                          // the operator's switch
  std::uint8_t drilling_group = 0, motion_group = 0;  // of G80 and G0
  std::uint8_t stop_group = 0;                        // of G61 … G64
  std::int16_t inhibiting = -1;                       // row of G63
  std::int16_t slowing = -1;                          // row of G62
  // of the block being carried out
  bool was_hidden = false;     // the block stands in a program that is not listed (23.3.9)
  bool moved = false;          // it held a movement command
  bool holds_vector = false;   // G38
  bool uncompensated = false;  // its motions are: G53, G28, G30
  bool stops_reading = false;  // it empties the buffer
  bool in_thread = false;      // the motion before was a thread too
  double thread_lead = 0;      // mm
  AxisMask smoothed = 0;       // axes that G5.1 has named; 0: all linear ones
  std::vector<PendingCall> pending;
  int spindle_by_p = 0;          // S1500 P2: number of the spindle; 0: none
  bool absolute_block = false;   // its axis words are absolute even with G91 (17.3)
  bool cartesian_block = false;  // its axis words are Cartesian even with G16 (5.4)
  AxisMask rolled = 0;           // rotary axes of the block that roll over, and their way
  Axes travel{};
  double surface_angle = 0;  // of the rotary axis in G12.1, unwound
  AxisMask plane_axes = 0;   // axes whose letter stands in the block, with or without a number
  // of the machine and its operator
  std::array<double, 32> plc_in{}, plc_out{};
  std::array<double, 4> plc_in_word{}, plc_out_word{};
  std::uint32_t control_1 = 0, control_2 = 0;  // #3003, #3004
  double answer = 0;                           // #3107
  double parts_done = 0, parts_required = 0;
  double cutting_ms = 0, clock_offset_ms = 0;
  bool counts_time = false;               // of tools, since set_time came last
  double now_ms = 0;                      // virtual time since power-on
  double tool_magazine = 10;              // #8400
  Axes probe_position{}, probe_length{};  // work coordinates; tool length then
  Measurement measurement;                // of the probe motion under way
  std::string clock;                      // "2014-05-18T15:32:41"
  // for the state file
  Changes changes;
  bool tables_changed = false;
  std::vector<std::uint32_t> changed_offsets;

 private:
  std::uint64_t parameters_seen_ = 0;
  Axes lengths_before_{};
  Before before_;
  std::vector<double> clocks_;  // numbers of the clock variables

 public:
  InterruptedCycles interrupted_cycles;
  std::vector<std::pair<std::size_t, int>> spindle_axes;  // axis, spindle that it is made of (11.8)
  Endless endless;
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
/// M codes for the machine: indexing, closing the loop, optional spindle codes, all others (11, 13.1).
Status machine_code(Interpreter& m, const Call& call);
/// The gearbox, if it is on, stops (20.1).
void disengage(Interpreter& m);
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
