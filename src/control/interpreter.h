#pragma once
// Interpreter: runs a program block by block. It reads the next block, plans and executes it, takes a faulty one back, and knows where the
// program goes on. What its functions read is a BlockContext, what they emit goes through an Emitter; only what changes the course of the
// program takes the Interpreter itself. Only src/control includes it.

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "action/in_force.h"
#include "config/setup_file.h"
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
  bool is_stopped() const { return phase_ == RunPhase::stopped; }
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
  /// A block has been begun and is not over: its cycle is being carried out, or what waits for the cycle's end.
  bool in_block() const { return cycling() || waiting_count_ != 0 || phase_ == RunPhase::end_of_block || phase_ == RunPhase::same_block; }
  /// Calls and repetitions that are open, the outermost first.
  std::vector<AlarmReport::Call> calls() const;
  /// From now on ways of calls are kept: calls_of() tells them.
  void watch_calls() { call_tree_ = std::make_unique<CallTree>(); }
  bool watches_calls() const { return call_tree_ != nullptr; }
  std::vector<AlarmReport::Call> calls_of(const Origin& at) const;
  BlockState state_now() const;
  std::vector<InForce> in_force();
  /// What the channels have in common, of another one.
  void take_common(const Interpreter& from);

  /// Modes that a cycle sets by itself.
  void run_modes(std::initializer_list<Function> functions);
  void warn(const Alarm& alarm) override;
  /// M99, M47 of a main program: another pass, from its first block or from `from`. Where nothing on the way could change the next
  /// pass, or RunLimits::restarts passes are done, the run is over, with a note: that is no fault (control/functions/again.cpp).
  Status begin_again(Span where, Position from = {});

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
  /// A block does not begin again, a cycle does not go on: the program is over.
  void stop_cycles();

  // ---- what the file alone says (a dialect may say otherwise)

  /// The words' ranges, and assignments that act with them.
  Status take_words();

  // ---- what the functions work on

  using BlockContext::flow;  // where the program is, and goes on

  Block first_block;  // before the first one is read, and in the middle of which a snapshot was taken
  std::function<void(const AlarmReport&)>* on_warning = nullptr;
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

  /// The end of a watched block will not come.
  void close_block() {
    if (phase_ == RunPhase::end_of_block) phase_ = RunPhase::next_block;
  }

  RunPhase phase_ = RunPhase::next_block;
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
  std::array<std::uint8_t, limits::block_words> waiting_{};  // items of plan_ that stop or end the program after the block's cycle
  std::size_t waiting_count_ = 0;
  mutable std::shared_ptr<const Tables> last_tables_;  // of the last snapshot
  mutable std::shared_ptr<const Variables::Values> last_variables_;
  std::unique_ptr<BlockStates> block_states_;  // nullptr: nobody asks
  std::unique_ptr<CallTree> call_tree_;        // the same
  std::string first_text_;                     // of first_block
  std::vector<double> assigned_;
  StopToken stop_;
  std::vector<std::string> watch_;
};

/// `#1=…` alone, of variables that neither modes nor tables are made of.
bool sets_variables_only(const Block& block);

/// What a row's function does (control/functions/functions.cpp).
using Handler = Status (*)(Interpreter&, const Call&);
Handler handler_of(Function function);

}  // namespace kadr
