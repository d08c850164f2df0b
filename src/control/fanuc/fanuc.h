#pragma once
// Fanuc: the dialect class that Fanuc, Haas and NCT share (spec/fanuc, spec/nct); it is derived from the class of macros, MacroB. The class
// Fanuc adds drilling and turning cycles, reference return, frames, five axes, spindles and measuring. There is one object per channel. The
// memory of an object is a plain value (memory.h). `settings` and `state` belong to this class; the macro level has its own,
// macro_b_of(m).settings and macro_b_of(m).state. Virtual functions of the class stand for the behaviour that only the NCT has.

#include <memory>
#include <string>

#include "control/fanuc/state/memory.h"
#include "control/macro_b/macro_b.h"

namespace kadr::fanuc {

using namespace macro_b;  // the class Fanuc is derived from MacroB: its code uses the names of macro_b unqualified

class Fanuc : public MacroB, public fanuc::Memory {
 public:
  using fanuc::Memory::settings;
  using fanuc::Memory::state;

  Fanuc(BlockContext& m, const Setup& setup, const RunLimits& limits, std::shared_ptr<Commons> commons);
  ~Fanuc() override;

  // ---- start and end

  /// Sets the power-on state, then the state that the set-up describes.
  bool start(Interpreter& m, const Setup& setup) override;
  /// Reads variables, plane and diameter programming from the set-up, after the set-up's modal codes have been executed.
  void take_setup(Emitter& m, const Setup& setup) override;
  bool end_program(Interpreter& m) override;
  bool lose_power(Interpreter& m) override;
  /// Returns the whole state in the form of a set-up, for the last line of a trace.
  RunState run_state(const Emitter& m) const override;

  // ---- undoing a faulty block
  void begin_block(Emitter& m) override;
  void keep_all() override;
  void undo_block(BlockContext& m) override;

  // ---- snapshot
  std::shared_ptr<const DialectState> snapshot() const override;
  Status restore(BlockContext& m, const DialectState& from) override;

  // ---- spindles
  SpindleState& spindle(int number) { return state.spindles[static_cast<std::size_t>(number)]; }
  const SpindleState& spindle(int number) const { return state.spindles[static_cast<std::size_t>(number)]; }
  /// Returns the present speed of the main spindle, rev/min; 0 if the spindle does not turn.
  double spindle_rpm(const Emitter& m) const;
  /// Returns the rule by which G96 and G97 determine the speed of the main spindle (11.5). emit_surface_speed() emits this rule whenever
  /// the rule changes.
  SurfaceSpeed surface_speed(const BlockContext& m) const override;
  void emit_surface_speed(Emitter& m) const;
  double css_rpm(const Emitter& m) const;

  // ---- reports of the machine
  void synchronise(int slave, int master) override;
  bool rolls_over(std::size_t axis) const override { return settings.axes[axis].rolls; }
  void convert_spindle(int number, bool to_axis) override;
  SearchRules search_rules() const override;

  // ---- functions that the interpreter calls in a dialect (dialect.cpp); a function of the same name in this folder implements each
  bool has_unfinished() const override { return !finishing.empty(); }
  Result<bool> finish(Interpreter& m) override;
  void note_skip_mark(Emitter& m) override;
  Result<bool> takes_block(Interpreter& m) override;
  std::int16_t motion_row(const BlockContext& m) const override;
  BlockChanges changes_of(const BlockContext& m, const Plan& plan) const override;
  void before_function(Emitter& m, Function function) override;
  void after_code(Interpreter& m, const CodeRow& row, std::int32_t code) override;
  Status after_block(Interpreter& m) override;
  Status target(const BlockContext& m, Axes& to, AxisMask& named) const override;
  bool shapes_lines(const BlockContext& m) const override;
  Status straight(Emitter& m, const Call& call, MotionKind kind) override;
  bool only_shifts(const BlockContext& m) const override;
  Status arc(Emitter& m, const Call& call, Turn turn) override;
  Status surface_line(Emitter& m, MotionKind kind, const Axes& programmed, AxisMask named) override;
  bool lines_follow(const BlockContext& m) const override;
  /// The compensation of this family is not in Modal::contour but in `state`.
  bool contour_follows(const BlockContext&) const override { return state.compensates && !uncompensated; }
  AxisMask rolling_axes(const BlockContext& m) const override;
  ArcRule arc_rule(const BlockContext& m) const override;
  Result<PlaneArc> arc_of_radius(Emitter& m, const ArcRule& rule, const ArcEnds& ends, double radius) const override;
  void count_words(BlockContext& m) const override;
  void note_line(BlockContext& m) override;
  void note_motion(Emitter& m, Motion& motion) override;
  double inch_feed(const BlockContext& m, const Motion& motion, const Axes& from) const override;
  void note_feed(BlockContext&) override { state.thread_lead = 0; }
  bool keeps_both_feeds() const override { return true; }  // NCT 6.2.1: G94 and G95 each have their own F
  void refresh_frames(Emitter& m) override;
  Axes shift_of_origin(const BlockContext& m) const override;
  bool zero_may_move() const override { return true; }
  void roll(const BlockContext& m, Axes& positions) const override;
  Status accept_answer(Emitter& m, const ProbeAnswer& at) override;
  Status machine_code(Interpreter& m, const Call& call) override;
  /// Executes an M code of a spindle (indexing, closing the position loop); passes any other code to the machine's logic.
  Status spindle_machine_code(Emitter& m, int code, Span where);

  // ---- functions that the macro level, MacroB, calls
  Axes before_transform(const BlockContext& m) const override;
  void keep_cycles() override { interrupted_cycles = {state.drilling, state.turning}; }
  void bring_cycles_back() override;
  std::size_t open_contours() const override { return finishing.size(); }
  bool consume_touched_tables() override;
  std::optional<double> table_value(Emitter& m, const FoundVariable& variable) const override;
  Result<bool> write_table(Emitter& m, const FoundVariable& variable, double value, Span where) override;

  // ---- behaviour that only the NCT has

  /// Returns the offset number that an H or D word means. One special number means the offset of the tool in the spindle (12.5.1).
  virtual Result<std::uint32_t> offset_meant(char letter, std::uint32_t number) const = 0;
  /// open_tool_data() opens the tool tables for G10 L75 to L77; tool_line() reads one of the data lines that follow (12.4).
  virtual Status open_tool_data(BlockContext& m, std::uint32_t l, double p, Span where) = 0;
  virtual Status tool_line(Emitter& m) = 0;

 protected:
  void read_parameters(BlockContext& m) override;
  /// Resets everything that the program has set to its power-on state (3.4).
  void reset_program(Interpreter& m);
  /// Ends the electronic gearbox (NCT 20.1) at a reset of the program, if the parameters request this.
  virtual void end_gear(Emitter& m) = 0;
  /// Returns true if a reset leaves the code of this group in force.
  virtual bool keeps_group(int group) const = 0;

 private:
  void take_reference_points(BlockContext& m);
  void mirror_by_settings(BlockContext& m) const;
  void reset_codes(Interpreter& m, bool keep);
  void stop_machine(Interpreter& m);

  UndoableState before_;                   // the state that keep_all() has saved, so that an alarm can restore it
  std::array<Axes, 5> setup_reference_{};  // reference points that keys of the set-up give; those that parameters give are not included
};

/// The part of a snapshot that belongs to the class Fanuc.
struct FanucState : MacroState {
  explicit FanucState(const Fanuc& of);

  fanuc::Memory cutting;
};

/// Returns the number of rows of the offset table, which N1400 gives. If N1400 is not set, returns the number of rows that variables can
/// address (15.1).
std::uint32_t max_offsets(const BlockContext& m);
/// Finds the axes into which the machine converts spindles (11.8), as events of the set-up command.
void find_spindle_axes(BlockContext& m, const Setup& setup);
/// Warns if a motion moves one of the named axes while the axis turns as a spindle.
void watch_spindle_axes(Emitter& m, AxisMask named);
/// Returns the thread lead in mm, from the block's E or F, or the last lead; 0 if there is no lead (4.4).
double take_lead(BlockContext& m);
/// Returns the duration in s of a dwell P (8). alarms value_out_of_range, spindle_not_turning
Result<double> dwell_seconds(Emitter& m, double p, Span where);
/// Returns the duration in s of a dwell P on a control where the decimal point decides the unit. Without a point P is in milliseconds. With
/// a point P is in seconds, or on some controls raises an alarm (spec/fanuc 4.1, spec/haas 4.1). alarms point_not_allowed
Result<double> dwell_by_digits(BlockContext& m);
/// Returns true if the block has a word that refers to a spindle.
bool has_spindle_word(const BlockContext& m);
/// Executes G10 L… (in tables/set_tables.cpp).
Status set_tables(Emitter& m, const Call& call);
/// Sets the common work offset by the axis words of the block: G10 P0 of lathes (in tables/set_tables.cpp, spec/fanuc-t 4.3).
Status set_work_shift(Emitter& m, const Call& call);

}  // namespace kadr::fanuc

namespace kadr {

/// Returns the dialect object of an interpreter whose control belongs to the Fanuc family.
fanuc::Fanuc& fanuc_of(const BlockContext& m);

}  // namespace kadr
