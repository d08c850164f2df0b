#pragma once
// Control: the interpreter. Block → Action, with everything a control remembers. The door of this room.

#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "action/action.h"
#include "action/in_force.h"
#include "action/tool_position.h"
#include "base/file_id.h"
#include "base/stop.h"
#include "config/control_def.h"
#include "config/setup.h"
#include "config/setup_file.h"
#include "config/state_file.h"
#include "control/state/far_axis.h"
#include "control/state/run_limits.h"
#include "control/state/search_rules.h"
#include "control/state/snapshot.h"
#include "control/state/usage.h"
#include "control/state/waiting.h"
#include "lang/block/block_reader.h"

namespace kadr {

/// Files that a program writes (nct 23.2.13): path from the folder of the program memory, bytes.
using WrittenFiles = std::map<std::string, std::uint64_t>;

class Interpreter;   // control/interpreter.h
class LineMarks;     // control/state/line_marks.h
class MachineSide;   // control/dialect.h
class SharedMemory;  // control/shared_memory.h

class Control {
 public:
  /// `def` must outlive the control. `shared`: what the channels of one machine have in common (nct 1.2), or nullptr.
  Control(const ControlDef& def, const Setup& setup, Program program, const RunLimits& limits,
          std::shared_ptr<SharedMemory> shared = nullptr);
  ~Control();

  enum class State : std::uint8_t { running, needs_probe, waiting, held, stopped, ended };

  /// Carries out blocks until `batch` (cleared first) is full or something must be answered.
  ///   needs_probe  the last action is a probe motion: call answer() with what it met, then go on
  ///   waiting      at a waiting code (nct 14.5), after meet_channels(): meeting() tells; call release(), then go on
  ///   held         holds_before() asked for it
  ///   stopped      by an alarm: report() tells; go_on() takes the next block (checking), nothing of the faulty one has been done
  ///   ended        the program is at its end
  State run(ActionBatch& batch);

  /// Asked before each block that has been read; true: it is not carried out now, and read once more by the next run(). The control may
  /// be asked for anything meanwhile, but for what it is asked about in the middle of a block.
  std::function<bool(const Origin&)> holds_before;
  /// From now on the lines that blocks are carried out of are noted there, while the control stands still (RunAhead::settle) to be looked
  /// at; after so many of them without actions run() returns. nullptr: no more.
  void note_lines(LineMarks* marks, std::uint64_t most);
  /// A block has been begun and is not over: a cycle goes on, something waits for its end.
  bool in_block() const;
  /// The operator enters a line (MDI): it is carried out next, in the present state; after it the program goes on where it stood.
  ///   pre  !in_block()
  void enter(const std::string& line);
  /// It is not over.
  bool in_entered() const;
  /// The axes have been moved by hand: they stand there now.
  ///   pre  !in_block()
  void stand_at(const Axes& machine);
  /// The value of an expression, written as a program would write it, now: `#100+1`, `R2`.
  ///   alarms  expression_syntax and what else an expression may be refused for
  Result<double> evaluate(std::string_view expression) const;
  /// Calls and repetitions that are open, the outermost first.
  std::vector<AlarmReport::Call> calls() const;
  /// Of the block that is under way, or was carried out last.
  const Origin& origin() const;
  /// mm: of lengths in the machine's own tables.
  double machine_unit() const;
  /// Axis of the normal of the plane in force.
  std::size_t plane_normal() const;
  /// What is in force, all blocks so far carried out.
  BlockState state_now() const;
  std::vector<InForce> in_force() const;

  /// All that decides how the run goes on; nothing while a probe is waited for. What the program has read from standard input or written
  /// into files is not in it, nor what refused() brings back.
  std::optional<Snapshot> snapshot() const;
  /// Goes on from a snapshot of a control of the same file, set-up and program: the actions, alarms and notes that follow are those that
  /// followed there. The tables shared by channels get the values of this channel.
  ///   alarms  file_missing, file_write: a file that the program had called or was writing is not there as it was
  Status restore(const Snapshot& from);

  void answer(const ProbeAnswer& answer);
  /// Hands actions over after each block, so that the machine may refuse one.
  void hand_over_each_block();
  /// It does: from the start, or since the program came to a safety zone or a clock.
  bool hands_over_each_block() const;
  /// The machine has refused an action of the last block: nothing of the block is done, as with an alarm of its own.
  void refused();
  using Waiting = WaitingMode;
  void set_waiting(Waiting waiting);
  using Meeting = ChannelMeeting;
  /// What this channel waits for; nothing: it goes on (the signal CP_NOWT takes the waiting away).
  const std::optional<Meeting>& meeting() const;
  void release();

  /// Stopped by an alarm, of a block or of an answer (no contact).
  bool is_stopped() const;
  void go_on();

  /// The alarm that stopped the run.
  const AlarmReport& report() const;
  /// An alarm of a later room, with the place of the action that caused it.
  AlarmReport report_for(const Alarm& alarm, const Origin& origin) const;
  /// The line that an action comes from, as it is shown; without text where it stands in no file.
  AlarmReport::Line line_at(const Origin& origin) const;

  /// Called before and after each block that is carried out, for what the machine's logic does then (Control::set_signal, …);
  /// after a block only when its actions have been handed over, and not if it failed.
  std::function<void(const Origin&, bool at_end)> on_block;
  /// Called for each signal that the machine's logic sets.
  std::function<void(const std::string& name, bool on)> on_signal;
  /// The machine's logic and its operator (nct): a signal, a skip switch, the answer to a message box (#3107).
  void set_signal(const std::string& name, double value);
  void set_skip(int number, bool on);
  void set_optional_stop(bool on);
  void set_answer(double answer);
  /// Spindle `slave` follows `master` (nct 11.7.4); 0: no more. `slave` 0: all spindles.
  void synchronise(int slave, int master);
  /// What the channels of a machine have in common besides the variables (nct 12.3, 24.1): goes up as it changes.
  std::uint64_t common_version() const;
  /// Of another channel of the same machine, between two blocks.
  void take_common(const Control& from);
  /// Axes follow the masters that N2101 names, or not any more (nct 20.2).
  void couple_axes(const std::vector<std::string>& axes, AxisLink link, bool on);
  /// Axes of this channel that hang on those of others now (nct 20.2, 20.3).
  const std::vector<FarAxis>& far_axes() const;
  /// Called when the machine's logic may have changed far_axes(); the axes of both channels stand.
  std::function<void()> on_far_axes;
  /// It cannot be: the axis is its own again, with a warning.
  void drop_far(const FarAxis& axis);
  /// The axis has been moved along with that of another channel; those that follow it in this channel go with it. Machine coordinate.
  void lead_axis(std::size_t axis, double machine);
  /// The axis may be exchanged with a linear one.
  bool may_exchange(std::size_t axis) const;
  /// From the next block on the axis drives that of another channel, which stands there, or is its own again.
  void exchange_far(std::size_t axis, double machine, bool on);
  bool is_parked(std::size_t axis) const;
  bool rolls_over(std::size_t axis) const;
  /// Number of an axis: these run on through the channels (nct 1.2).
  int axis_number(std::size_t axis) const;
  /// The machine has made an axis of the spindle (nct 11.8): it stands, its loop is closed; or a spindle of it again.
  void convert_spindle(int number, bool to_axis);
  /// Power off and on: the program is over, and what only the power kept is lost (nct 23.1.4, 23.5).
  void power_cycle();
  /// Virtual time since the start of the run and time at feed, for clocks the program reads (nct 23.1.9).
  void set_time(double now_ms, double cutting_ms);
  /// The program may read a clock: from here on set_time() counts, and each block is handed over.
  bool reads_clock() const;
  /// Programs of this control can read one: the time since the start may be asked for.
  bool may_read_clock() const;
  /// Tables and switches after the run, in the form of a set-up; nothing where the control has none to show.
  std::optional<RunState> run_state() const;

  /// Tables that a program can write, as they are now (control/tables_now).
  Setup tables_now() const;

  /// Of its own block search (session/block_search); nothing: it has none.
  std::optional<SearchRules> search_rules() const;

  /// Called after each block that changed something that survives power-off (nct); the block is carried out.
  std::function<void(const StateChanges&)> on_changes;

  /// Finds the corners of a contour that is looked at before it is carried out (nct 19.A 5): chamfers, roundings, calculated ends. They
  /// are the room path's, which control does not know. `from`: where the contour begins, work coordinates.
  std::function<std::optional<Alarm>(ActionBatch& contour, const Axes& from)> find_corners;

  /// Called for every warning (look-alike letters, …).
  std::function<void(const AlarmReport&)> on_warning;

  /// What the program has used of a set-up. With watch_use(), before the run, variables and lines too.
  const ProgramUse& use() const;
  void watch_use();

  /// After the run, for people who check: the subprograms never called, read but not carried out; their faults go to `on_fault`.
  void check_uncalled(const std::function<void(const AlarmReport&)>& on_fault);

  /// Lines of the program or, by Origin::file, of another file that it called, UTF-8 by their numbers; those that cannot be read are
  /// missing. After the run; passes through the file once.
  std::map<std::uint32_t, std::string> texts_of(const std::set<std::uint32_t>& lines, std::uint16_t file) const;
  /// The bytes of the program or of another file, as it was when it was opened; nullptr: there is no file of that number.
  std::shared_ptr<ByteSource> source_of(std::uint32_t file) const;
  /// Path of the program or of another file.
  const std::string& file_name(std::uint16_t file) const;
  /// Paths of all files that have been read: the program, what it called.
  std::vector<std::string> files_read() const;
  /// Numbers of the files that the program has called: file_name(), source_of(), Origin::file. They do not follow each other.
  std::vector<std::uint16_t> called_files() const;
  /// What the program has written, or would have (RunLimits::writes_files).
  const WrittenFiles& files_written() const;

  Ending ending() const;
  /// Where the tool stands, all blocks carried out; its frame is the first of the actions.
  ToolPosition tool_position() const;
  /// How work coordinates lie on the machine, all blocks carried out.
  const Placement& placement() const;
  /// From now on state_of() can tell; a block costs a comparison, one that changes a mode a copy of the state.
  void watch_states();
  /// What was in force when the block that an action comes from had been carried out: the control may be far ahead. Nothing where
  /// more than some thousand changes of modes lie in between, or nobody watches.
  std::optional<BlockState> state_of(const Origin& origin) const;
  /// From now on calls_of() can tell, and reports of report_for() have the calls of their place.
  void watch_calls();
  /// By which calls and repetitions the block of an action came to be carried out, the outermost first; the control may be far ahead.
  /// Not in snapshots: of actions that a control before this one has made it knows none.
  std::vector<AlarmReport::Call> calls_of(const Origin& origin) const;
  std::uint64_t blocks() const;      // carried out
  std::uint64_t bytes_read() const;  // for progress
  std::uint64_t bytes() const;
  Encoding encoding() const;
  bool encoding_was_guessed() const;
  const std::vector<std::string>& axes() const;
  /// What the set-up names and this control has not, beyond what the table of keys says (config/setup_check); empty: all is well.
  const SetupFault& setup_fault() const;
  /// Its machine is described by parameters (nct 24).
  bool has_machine_parameters() const;
  /// Its contours are those of path/contour/queued_compensation.
  bool queues_contours() const;
  std::uint32_t rotary() const;
  /// Dialect::limits_by_file().
  std::pair<double, double> limits_by_file(std::size_t axis) const;

 private:
  /// What the machine may tell the control; nullptr: nothing.
  MachineSide* machine_side() const;

  std::unique_ptr<Interpreter> interpreter_;
  std::shared_ptr<SharedMemory> shared_;
  double cutting_seen_ms_ = 0;
};

}  // namespace kadr
