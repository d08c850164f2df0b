#pragma once
// The inside of Control: state, and what the functions of a control's table share. Only src/control includes it.

#include <initializer_list>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "action/in_force.h"
#include "base/units.h"
#include "config/setup_file.h"
#include "control/block/motion_run.h"
#include "control/block/plan.h"
#include "control/block/shapes.h"
#include "control/control.h"
#include "control/cycles/cycle_run.h"
#include "control/cycles/ellipse_run.h"
#include "control/dialect.h"
#include "control/flow/call_tree.h"
#include "control/flow/flow.h"
#include "control/state/block_states.h"
#include "control/state/journal.h"
#include "control/state/line_marks.h"
#include "control/state/run_memory.h"
#include "control/state/snapshot.h"
#include "control/state/state.h"
#include "control/state/usage.h"
#include "control/state/waiting.h"
#include "control/variables/macro_variables.h"
#include "control/variables/variables.h"

namespace kadr {

class Interpreter;
struct Call;
struct BlockMemory;  // control/snapshot_content.h

inline constexpr double farthest = 1e7;        // mm, degrees: a coordinate beyond ten kilometres is a mistake
inline constexpr std::size_t batch_size = 64;  // actions emitted at a time

/// What goes on after its block, some actions at a time, so that a cycle of any length runs in constant memory.
class Running {
 public:
  virtual ~Running() = default;
  /// A copy that goes on from here, in a control restored from a snapshot.
  virtual std::unique_ptr<Running> clone() const = 0;
  /// Emits the next actions, at most a few; false: it is over.
  virtual Result<bool> next(Interpreter& m) = 0;
  /// The other functions of its block act before it goes on (drilling, nct 18.0); else those after the motion wait for its end.
  virtual bool functions_first() const { return false; }
};

/// A cycle that is a plain value: `class Pocket final : public RunningValue<Pocket>`.
template <class Cycle>
class RunningValue : public Running {
 public:
  std::unique_ptr<Running> clone() const final { return std::make_unique<Cycle>(static_cast<const Cycle&>(*this)); }
};

/// The state is its base: `m.modal` is that of the block being carried out.
class Interpreter : public ControlState, public RunMemory {
 public:
  /// `own`: the control's definition made fit for this machine, or nullptr (then `control` is used as it is).
  Interpreter(const ControlDef& control, std::unique_ptr<ControlDef> own, const Setup& setup, Program program, const RunLimits& limits,
              std::shared_ptr<Commons> commons);
  ~Interpreter();

  Control::State run(ActionBatch& batch);
  /// Nothing while a probe is waited for. `cutting_seen_ms` goes along for Control.
  std::optional<Snapshot> snapshot(double cutting_seen_ms) const;
  Status restore(const Snapshot& from);
  void answer(const ProbeAnswer& answer);
  void go_on();
  void refused();
  void power_cycle();
  bool is_stopped() const { return stopped_; }
  void check_uncalled(const std::function<void(const AlarmReport&)>& on_fault);
  Ending ending();
  /// From now on the states of blocks are kept: state_of() tells them.
  void watch_states();
  std::optional<BlockState> state_of(const Origin& at) const;
  Alarm with_names(Alarm alarm) const;
  void decode_arguments(Alarm& alarm) const;
  /// Without the control's own words for it.
  AlarmReport plain_report_of(const Alarm& alarm, const Origin& origin, std::string_view line_text) const;
  AlarmReport report_of(const Alarm& alarm, const Origin& origin, std::string_view line_text) const;

  // ---- words of the block being carried out

  /// Values of the words written as expressions, ranges of all.
  Status evaluate_words();
  const Word* word(char letter) const { return block->find(letter); }
  bool has(char letter) const { return block->has(letter); }
  /// Value of a word with the scale of its address; 0 if it is not there.
  double value(char letter) const;
  /// The same as a length: mm.
  double length_value(char letter) const { return value(letter) * unit_scale(); }
  double unit_scale() const { return modal.inch ? mm_per_inch : 1.0; }
  /// A whole number between the two.
  ///   alarms  word_not_integer, value_out_of_range
  Result<std::uint32_t> whole(char letter, double least, double most) const;
  Span where(char letter) const;
  /// The block holds a code of one of these functions.
  bool has_code(std::initializer_list<Function> functions) const;
  /// What is known of blocks like this one; nullptr: it is no plain block, or words were taken away from it.
  ShapeFacts* shape() const { return block->altered ? nullptr : shape_; }
  /// A block has been begun and is not over: its cycle is being carried out, or what waits for the cycle's end.
  bool in_block() const { return cycling() || waiting_count_ != 0 || block_open || again_; }
  /// The value of an expression as the program would write it, now.
  ///   alarms  those of compile_value and of its evaluation; expression_syntax: something follows it
  Result<double> value_of(std::string_view expression);
  /// Calls and repetitions that are open, the outermost first.
  std::vector<AlarmReport::Call> calls() const;
  /// From now on ways of calls are kept: calls_of() tells them.
  void watch_calls() { call_tree_ = std::make_unique<CallTree>(); }
  bool watches_calls() const { return call_tree_ != nullptr; }
  std::vector<AlarmReport::Call> calls_of(const Origin& at) const;
  BlockState state_now() const;
  std::vector<InForce> in_force();
  /// A cycle of the block is being carried out.
  bool cycling() const { return cycle_run.active() || ellipse_run.active() || running != nullptr; }
  /// Every value within the limits of its address.
  ///   alarms  value_out_of_range, word_not_integer
  Status check_ranges() const;
  bool has_axis_words() const { return (block->letters & letters.axes) != 0; }
  /// What the channels have in common, of another one.
  void take_common(const Interpreter& from);

  // ---- motion

  /// End point by the block's axis words, programmed coordinates; `named`: axes that have a word.
  Status target(Axes& to, AxisMask& named) const;
  /// One axis word as a programmed end coordinate.
  double axis_target(const Word& w, std::size_t axis) const;
  /// Emits a straight motion to a programmed point.
  Status straight(MotionKind kind, const Axes& programmed, AxisMask named);
  /// A point that a transformation has led to. alarms position_out_of_range
  Status within_reach(const Axes& work) const;
  /// A straight motion to a machine position on the named axes.
  Status to_machine(MotionKind kind, const Axes& machine, AxisMask named, double feed, EndGiven end = EndGiven::by_machine);
  /// The axes have been moved by hand.
  void stand_at(const Axes& machine);
  /// The tool stands where `position.programmed` says, on these axes, where work coordinates are the programmed ones and the frame is not
  /// turned.
  void place_plainly(AxisMask named) {
    for (; named != 0; named &= named - 1) {
      const auto a = static_cast<std::size_t>(__builtin_ctz(named));
      position.work[a] = position.programmed[a];
      position.machine[a] = position.work[a] + frames.origin[a] + frames.length[a];
    }
  }
  /// Position after a motion; the axes not named stay where they are.
  void move_to(const Axes& programmed, const Axes& work, AxisMask named);
  Motion& add_motion(MotionKind kind, AxisMask named);
  /// The row of the offset table whose length is in force; 0: none.
  std::uint16_t length_row() const;
  /// The same where the modes are known: to where the tool is to stand now.
  Motion& add_motion_as(const MotionModes& modes, AxisMask named);
  Status feed_known(Span where);
  /// The motion's feed, unit, exact stop from the modal state.
  void set_feed(Motion& motion);
  double feed_limited(double feed) const;
  double feed_by_axes(const Motion& motion) const;
  bool axes_have_feeds() const;

  template <class What>
  void emit(What&& what) {
    Action& action = batch->add();
    action.origin = origin;
    action.what = std::forward<What>(what);
  }

  // ---- frames

  /// Origin and length worked out anew from the tables and the modal state.
  void refresh_frames();
  /// The same, and the tool's coordinates in the new frame (the machine stands).
  void change_frames();
  FrameChange frame_change() const;
  /// What G96, G97 make of the speed of the main spindle (nct 11.5); of controls but NCT by X as a radius (spec/gost 4; INFERRED: X).
  SurfaceSpeed surface_speed() const;
  double radius_in_force() const;
  ArcRule arc_rule() const { return dialect->arc_rule(*this); }
  /// Modes that a cycle sets by itself.
  void run_modes(std::initializer_list<Function> functions);
  /// The mirrored axes of the panel that are in force in the plane (2С42 6.8).
  void apply_mirror();
  void warn(const Alarm& alarm);
  /// M99, M47 of a main program: another pass, from its first block or from `from`. Where nothing on the way could change the next
  /// pass, or RunLimits::restarts passes are done, the run is over, with a note: that is no fault (control/functions/again.cpp).
  Status begin_again(Span where, Position from = {});
  /// The addresses of the block, anew: words were taken away (address 0) or given back.
  void note_addresses();

  /// The state is kept: an alarm later in the block brings it back.
  void keep_state();
  /// The block is a statement, and nobody watches: carried out, or an alarm.
  void carry_out_statement();
  /// A block that only sets variables (sets_variables_only()); false: it is faulty, and nothing of it is done.
  bool assign_again();
  /// What is in force has been changed by other means than a block's words.
  void modes_changed() { motion_run_.end(); }
  /// The block is a call of a macro or a return alone (its `word`), and nobody watches.
  ///   returns  false: it must go the general way; nothing has changed
  bool carry_out_call(std::uint8_t word);
  /// The same of where the program goes on.
  void keep_flow_place() { flow_before_ = flow.place(); }
  bool keeps_flow_place() const { return flow_before_.has_value(); }
  /// As the block found it, where keep_state() has been called.
  const ControlState& state_before() const { return before_; }
  bool keeps_state() const { return state_kept_; }
  /// A block does not begin again, a cycle does not go on: the program is over.
  void stop_cycles();

  // ---- what the file alone says (a dialect may say otherwise)

  /// (MSG, …) of the block's comments.
  void show_messages();
  /// The words' ranges, and assignments that act with them.
  Status take_words();
  Status axis_words(Axes& to, AxisMask& named) const;
  void frames_by_tables();
  /// What of their origin is a shift of the work system: G92 and what acts like it.
  Axes shift_by_tables() const;
  SurfaceSpeed speed_by_x() const;
  Status note_answer(const ProbeAnswer& answer);
  Status emit_machine_function(const Call& call);
  /// The machine's logic gets the code, which the control carries out itself (nct 13.1).
  ///   code  in tenths
  void tell_machine(std::int32_t code);
  Status plain_arc(Turn turn, Span where);
  ArcRule plain_arc_rule() const;
  BlockChanges changes_of_block(const Plan& plan) const;

  // ---- what the functions work on

  const std::unique_ptr<ControlDef> own_def;
  const ControlDef& def;
  const LetterSets letters;
  Journal journal;
  Tables tables;
  Variables variables;
  Flow flow;
  CycleRun cycle_run;
  EllipseRun ellipse_run;
  std::unique_ptr<Running> running;                       // a cycle of the dialect
  std::unique_ptr<Dialect> dialect = make_iso_dialect();  // never nullptr
  MacroVariables* macro_variables = nullptr;              // those of the dialect, where it has levels of locals
  bool has_fixtures = false;                              // its work systems are Modal::fixture, else Modal::work_zero
  bool block_axes_taken = false;           // a code of this block has its axis words: a motion code beside it only sets the mode
  bool block_exact = false;                // G9 in this block
  bool block_machine_coordinates = false;  // G53 with a motion (Mach3)
  bool needs_probe = false;
  bool probe_stated = false;  // the set-up says what a probe meets
  Span probe_where;
  bool each_block = false;  // hand over after each block
  bool block_open = false;  // a watched block has been carried out, its end is to come

  Block first_block;            // before the first one is read, and in the middle of which a snapshot was taken
  Block* block = &first_block;  // being carried out
  ActionBatch* batch = nullptr;
  std::vector<std::string> axis_names;
  std::size_t axis_count = 3;
  std::function<void(const AlarmReport&)>* on_warning = nullptr;
  std::function<void(const Origin&, bool)>* on_block = nullptr;
  const std::function<bool(const Origin&)>* holds_before = nullptr;
  LineMarks* line_marks = nullptr;
  std::uint64_t most_unseen = 0;  // blocks that run() carries out without being looked at, where lines are noted
  std::function<void(const StateChanges&)>* on_changes = nullptr;
  const std::function<std::optional<Alarm>(ActionBatch&, const Axes&)>* find_corners = nullptr;

 private:
  void read_setup(const Setup& setup);
  void check_setup(const Setup& setup);
  void start_modal(const Setup& setup);
  bool starts(const std::string& text) const;
  bool note_unserved();
  Motion& next_motion();
  Status modes_served(const PlanItem& item) const;
  Status execute();
  void take_block();
  bool returns_from_entered() const;
  void watch_block();
  bool is_watched() const;
  bool asks_to_skip();
  bool is_skipped() const;
  void end_block();
  void report_changes();
  std::vector<std::string> codes_in_force(const Modal& of) const;
  Status attempt();
  Status check_numbers();
  Status words();
  Status carry_out(const Plan& plan);
  Status carry_out(const PlanItem& item);
  Status check_zero_kept() const;
  bool is_call(const PlanItem& item) const;
  bool waits_for(const Running& cycle, const PlanItem& item) const;
  void keep_for_return(const PlanItem& item);
  Status end_possible(const PlanItem& item, std::size_t depth) const;
  const CodeRow* row_of(const PlanItem& item) const { return item.row >= 0 ? &def.codes[static_cast<std::size_t>(item.row)] : nullptr; }
  Phase phase_of(const PlanItem& item) const { return item.row >= 0 ? row_of(item)->phase : def.address(item.address).phase; }
  void begin_batch(ActionBatch& to);
  bool goes_on_with_last();
  bool waits_for_dialect();
  std::optional<Control::State> close_file(Block* last);
  std::optional<Control::State> take_read(const Result<BlockReader::Got>& got);
  Status after_cycle();
  Status next_of_cycle();
  Status evaluate_word(Word& w);
  bool reads_variables() const;
  bool may_have_steered() const;
  Status find_axis(Word& w);
  Status assign();
  Status assign_alone();
  Status plan();
  Status check_place() const;
  Status structure();
  Status next_program();
  void tell_passed_over(std::uint64_t letters_passed);
  void note_section();
  Span label_place() const;
  Status end_of_file();
  void keep_little();
  void take_back(std::size_t actions);
  Origin origin_of_block() const;
  void fail_with(const Alarm& alarm);
  bool follows_refused_motion(AlarmId id) const;
  void keep_from_faulty_block();
  void keep_modes_of_faulty_block();
  void stand_where_meant();
  void note_placed();
  std::shared_ptr<const BlockMemory> block_memory() const;
  void go_on_in_block(const BlockMemory& then);

  Plan plan_;
  /// Plans of blocks that loops carry out again, found by the block's place in memory.
  struct KeptPlan {
    const Block* block = nullptr;
    std::uint64_t letters = 0;
    std::int16_t motion_row = -1;
    Plan plan;
  };
  static constexpr std::size_t kept_plans = 64;
  std::vector<KeptPlan> plans_;
  Plan* plan_now_ = &plan_;
  Shapes shapes_;
  MotionRun motion_run_;
  ShapeFacts* shape_ = nullptr;                              // of the current block
  std::array<std::uint8_t, limits::block_words> waiting_{};  // items of plan_ that stop or end the program after the block's cycle
  std::size_t waiting_count_ = 0;
  std::optional<Flow::Place> flow_before_;             // kept where a block has more than one item that jumps
  mutable std::shared_ptr<const Tables> last_tables_;  // of the last snapshot
  mutable std::shared_ptr<const Variables::Values> last_variables_;
  std::unique_ptr<BlockStates> block_states_;  // nullptr: nobody asks
  std::unique_ptr<CallTree> call_tree_;        // the same
  ControlState before_;
  bool state_kept_ = false;
  std::string first_text_;  // of first_block
  std::vector<double> assigned_;
  StopToken stop_;
  bool stopped_ = false;
  // of a block that the machine's logic watches (nct 23.4)
  bool again_ = false;  // the current block comes once more
  std::vector<std::string> watch_;

 public:
  SetupFault start_fault;  // what the set-up names and the control has not
};

/// `#1=…` alone, of variables that neither modes nor tables are made of.
bool sets_variables_only(const Block& block);

/// What a row's function does (control/functions/functions.cpp).
struct Call {
  const CodeRow* row = nullptr;  // nullptr: an address that acts by itself
  const Word* word = nullptr;    // nullptr: the motion in force
  Span where;
};
using Handler = Status (*)(Interpreter&, const Call&);
Handler handler_of(Function function);

}  // namespace kadr
