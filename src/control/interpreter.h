#pragma once
// Interpreter: runs a program block by block. It reads the next block, plans and executes it, undoes a faulty one, and decides where
// the program continues. Its functions read the state as a BlockContext and emit actions through an Emitter; only functions that change
// the program flow receive the Interpreter itself. Only src/control includes this file.

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "action/in_force.h"
#include "config/setup/setup_file.h"
#include "control/block/motion_run.h"
#include "control/block/plan.h"
#include "control/control.h"
#include "control/emitter.h"
#include "control/flow/call_tree.h"
#include "control/state/block_states.h"
#include "control/state/line_marks.h"
#include "control/state/snapshot.h"

namespace kadr {

struct BlockMemory;  // control/snapshot_content.h

class Interpreter final : public Emitter {
 public:
  /// `own`: the control's definition, adapted to this machine; nullptr if `control` is used without changes.
  Interpreter(const ControlDef& control, std::unique_ptr<ControlDef> own, const Setup& setup, Program program, const RunLimits& limits,
              std::shared_ptr<Commons> commons);
  ~Interpreter();

  Control::State run(ActionBatch& batch);
  /// Returns the state of the run as a snapshot; nullopt while the control waits for the result of a probe motion. `cutting_seen_ms`: a
  /// time in ms that the Control needs after a restore; the interpreter only stores it.
  std::optional<Snapshot> snapshot(double cutting_seen_ms) const;
  Status restore(const Snapshot& from);
  void answer(const ProbeAnswer& answer);
  void go_on();
  void refused();
  void power_cycle();
  bool is_stopped() const { return phase_ == RunPhase::stopped; }
  void check_uncalled(const std::function<void(const AlarmReport&)>& on_fault);
  FinalState ending();
  /// Starts recording the state after each block. state_of() returns the recorded states.
  void watch_states();
  std::optional<BlockState> state_of(const Origin& at) const;
  Alarm with_names(Alarm alarm) const;
  void decode_arguments(Alarm& alarm) const;
  /// Returns the report that report_of() returns, but without the control's own wording of the message.
  AlarmReport plain_report_of(const Alarm& alarm, const Origin& origin, std::string_view line_text) const;
  AlarmReport report_of(const Alarm& alarm, const Origin& origin, std::string_view line_text) const;

  // ---- words of the block being executed

  /// Evaluates the words written as expressions and checks the ranges of all words.
  Status evaluate_words();
  /// Returns true while a block is not finished: its canned cycle is being executed, or functions of the block wait for the end of the
  /// cycle.
  bool in_block() const { return cycling() || waiting_count_ != 0 || phase_ == RunPhase::end_of_block || phase_ == RunPhase::same_block; }
  /// Returns the open calls and repetitions, outermost first.
  std::vector<AlarmReport::Call> calls() const;
  /// Starts recording the chain of calls of each block. calls_of() returns the recorded chains.
  void watch_calls() { call_tree_ = std::make_unique<CallTree>(); }
  bool watches_calls() const { return call_tree_ != nullptr; }
  std::vector<AlarmReport::Call> calls_of(const Origin& at) const;
  BlockState state_now() const;
  std::vector<InForce> in_force();
  LatheModes lathe_modes() const;
  /// Returns the set-up of the run, for a copy of the interpreter (control/outline_run.h); nullptr if the dialect makes no copies.
  const Setup* kept_setup() const { return kept_setup_.get(); }
  /// Makes kept_setup() return nullptr, so that a copy makes no copies: a contour whose cycle needs the same contour would never end.
  void make_no_copies() { kept_setup_.reset(); }
  /// Copies the data that the channels of a machine share from the interpreter of another channel.
  void take_common(const Interpreter& from);

  /// Executes codes that a canned cycle sets by itself, so that their modes come into force.
  void run_modes(std::initializer_list<Function> functions);
  void warn(const Alarm& alarm) override;
  /// M99, M47 of a main program: starts another pass, from the first block or from `from`. The run ends with a note, which is not a fault,
  /// if all further passes would be like this pass, or after RunLimits::restarts passes (control/functions/continuation.cpp).
  Status begin_again(Span where, Position from = {});

  /// Saves the state, so that an alarm later in the block can restore it.
  void keep_state();
  /// Executes a block that is a statement (IF, GOTO, #1=…), while neither an interrupt macro nor the machine's logic observes the blocks. A
  /// faulty statement stops the run with an alarm.
  void execute_statement();
  /// Returns true if nobody looks at single blocks, so that blocks which emit no action may be executed without being read as blocks.
  bool runs_unseen() const;
  /// Executes again a block that only sets variables (sets_variables_only()). Returns false if the block is faulty; in this case no
  /// variable has changed.
  bool assign_again();
  /// To be called when anything except the words of a block has changed the modes or tables. Ends the fast path, whose copies of the modes
  /// are outdated.
  void modes_changed() { motion_run_.end(); }
  /// Executes a block that is only a macro call or a return, while neither an interrupt macro nor the machine's logic observes the blocks.
  ///   word     index of the word that calls or returns
  ///   returns  false if the block must be executed with a plan (execute_block()); in this case nothing has changed
  bool execute_call(std::uint8_t word);
  /// Saves the position in the program, so that an alarm later in the block can restore it.
  void keep_flow_place() { flow_before_ = flow.place(); }
  /// Ends the canned cycle or ellipse that is being executed, without its remaining motions.
  void stop_cycles();

  // ---- functions that a dialect may override; the versions here use only the control's file

  /// Checks the ranges of the words and executes the assignments among them.
  Status take_words();

  // ---- data that the functions of codes and addresses work on

  using BlockContext::flow;  // position in the program; public, because a function may change it

  Block first_block;  // block that serves as the current block before the first block is read, and after a restore in the middle of a block
  std::function<void(const AlarmReport&)>* on_warning = nullptr;
  const std::function<bool(const Origin&)>* holds_before = nullptr;
  LineMarks* line_marks = nullptr;
  // While `line_marks` is set, run() returns after this number of blocks, so that the caller can read the marks.
  std::uint64_t most_unseen = 0;
  std::function<void(const StateChanges&)>* on_changes = nullptr;
  const std::function<std::optional<Alarm>(ActionBatch&, const Axes&)>* find_corners = nullptr;

 private:
  void read_setup(const Setup& setup);
  void check_setup(const Setup& setup);
  void start_modal(const Setup& setup);
  bool starts(const std::string& text) const;
  bool note_unsupported();
  Status modes_served(const PlanItem& item) const;
  Status execute_block();
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
  Status execute(const Plan& plan);
  Status execute(const PlanItem& item);
  Status check_work_offset_kept() const;
  bool is_call(const PlanItem& item) const;
  bool waits_for(const SteppedCycle& cycle, const PlanItem& item) const;
  void keep_for_return(const PlanItem& item);
  Status end_possible(const PlanItem& item, std::size_t depth) const;
  const CodeRow* row_of(const PlanItem& item) const { return item.row >= 0 ? &def.codes[static_cast<std::size_t>(item.row)] : nullptr; }
  Phase phase_of(const PlanItem& item) const { return item.row >= 0 ? row_of(item)->phase : def.address(item.address).phase; }
  void begin_batch(ActionBatch& to);
  bool continues_last();
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
  void warn_passed_over(std::uint64_t letters_passed);
  void note_section();
  Span label_span() const;
  Status end_of_file();
  void keep_simple_state();
  void undo_block(std::size_t actions);
  Origin origin_of_block() const;
  void fail_with(const Alarm& alarm);
  bool follows_refused_motion(AlarmId id) const;
  void keep_from_faulty_block();
  void keep_modes_of_faulty_block();
  void assume_meant_position();
  void note_placed();
  std::shared_ptr<const BlockMemory> block_memory() const;
  void continue_in_block(const BlockMemory& then);

  /// Cancels the actions at the end of an observed block (RunPhase::end_of_block), because the run does not reach the end of the block.
  void close_block() {
    if (phase_ == RunPhase::end_of_block) phase_ = RunPhase::next_block;
  }

  std::unique_ptr<const Setup> kept_setup_;
  RunPhase phase_ = RunPhase::next_block;
  Plan plan_;
  /// The plan of a block that a loop executes again. The address of the block in memory identifies the plan.
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
  // Items of the plan, such as stops and ends, that wait for the end of the canned cycle.
  std::array<std::uint8_t, limits::block_words> waiting_{};
  std::size_t waiting_count_ = 0;
  // Tables of the last snapshot; the next snapshot shares these tables, instead of a copy, if they have not changed.
  mutable std::shared_ptr<const Tables> last_tables_;
  mutable std::shared_ptr<const Variables::Values> last_variables_;
  std::unique_ptr<BlockStates> block_states_;  // recorded states after blocks; nullptr: states are not recorded
  std::unique_ptr<CallTree> call_tree_;        // recorded chains of calls; nullptr: calls are not recorded
  std::string first_text_;                     // text of first_block
  std::vector<double> assigned_;
  StopToken stop_;
  std::vector<std::string> watch_;
};

/// Returns true if the block has only assignments such as `#1=…`, and no mode or table depends on the assigned variables.
bool sets_variables_only(const Block& block);

/// Returns the C++ function that executes the function named in a code row (control/functions/functions.cpp).
using Handler = Status (*)(Interpreter&, const Call&);
Handler handler_of(Function function);

}  // namespace kadr
