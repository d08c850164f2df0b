#pragma once
// Control: the interpreter. It turns blocks into actions and holds everything that a control remembers. The entrance to this room.

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
#include "base/stop_token.h"
#include "config/control/control_def.h"
#include "config/setup/setup.h"
#include "config/setup/setup_file.h"
#include "config/state/state_file.h"
#include "control/state/cross_channel_axis.h"
#include "control/state/run_limits.h"
#include "control/state/search_rules.h"
#include "control/state/snapshot.h"
#include "control/state/usage.h"
#include "control/state/waiting_codes.h"
#include "lang/block/block_reader.h"

namespace kadr {

/// Files that a program writes (nct 23.2.13): path from the folder of the program memory, bytes.
using WrittenFiles = std::map<std::string, std::uint64_t>;

class Interpreter;       // control/interpreter.h
class LineMarks;         // control/state/line_marks.h
class MachineInterface;  // control/dialect.h
class SharedMemory;      // control/shared_memory.h

class Control {
 public:
  /// `def` must outlive the control. `shared`: the memory that the channels of one machine share (nct 1.2), or nullptr.
  Control(const ControlDef& def, const Setup& setup, Program program, const RunLimits& limits,
          std::shared_ptr<SharedMemory> shared = nullptr);
  ~Control();

  enum class State : std::uint8_t { running, needs_probe, waiting, held, stopped, ended };

  /// Executes blocks until `batch` (cleared first) is full or the caller must react.
  ///   needs_probe  the last action is a probe motion: call answer() with the contact, then continue
  ///   waiting      at a waiting code (nct 14.5) after Waiting::meet: see meeting(); call release(), then continue
  ///   held         holds_before() has returned true: the next block has not been executed
  ///   stopped      by an alarm, see report(); go_on() continues with the next block (for a check); the faulty block has no effect
  ///   ended        the program is at its end
  State run(ActionBatch& batch);

  /// Called before each block that has been read. If it returns true, the block is not executed now and the next run() reads it again.
  /// In the meantime the control answers every query, except those that need the middle of a block.
  std::function<bool(const Origin&)> holds_before;
  /// From now on records in `marks` the lines whose blocks are executed; run() returns after `most` blocks at the latest. Read
  /// `marks` only while the control is at rest (RunAhead::settle). nullptr ends the recording.
  void note_lines(LineMarks* marks, std::uint64_t most);
  /// Returns true if a block is not finished: its canned cycle still has motions to emit, or functions of the block wait for the end of
  /// the cycle.
  bool in_block() const;
  /// Enters a line of the operator (MDI). It is executed next, in the present state; then the program continues where it was.
  ///   pre  !in_block()
  void enter(const std::string& line);
  /// Returns true while an entered line is not finished.
  bool in_entered() const;
  /// Sets the machine position after the axes have been moved by hand.
  ///   pre  !in_block()
  void stand_at(const Axes& machine);
  /// Returns the present value of an expression in the program's notation: `#100+1`, `R2`.
  ///   alarms  expression_syntax and every other alarm of an expression
  Result<double> evaluate(std::string_view expression) const;
  /// Open calls and repetitions, outermost first.
  std::vector<AlarmReport::Call> calls() const;
  /// Location of the block that is being executed, or was executed last.
  const Origin& origin() const;
  /// mm per unit of the lengths in the machine's own tables.
  double machine_unit() const;
  /// Index of the axis normal to the selected plane.
  std::size_t plane_normal() const;
  /// Returns the modes and offsets in force after all blocks executed so far.
  BlockState state_now() const;
  std::vector<InForce> in_force() const;

  /// Returns everything that decides how the run continues; nullopt while the control waits for a probe. Not included: what the program
  /// has read from standard input or written into files, and the state before the last block, which refused() would restore.
  std::optional<Snapshot> snapshot() const;
  /// Continues from a snapshot of a control with the same file, set-up and program: the actions, alarms and notes that follow are those
  /// that followed in that control. Tables shared by channels get the values of this channel.
  ///   alarms  file_missing, file_write: a file that the program had called or was writing is missing or has changed
  Status restore(const Snapshot& from);

  void answer(const ProbeAnswer& answer);
  /// From now on returns the actions of each block separately, so that the machine may refuse a block.
  void return_each_block();
  /// Returns true if the actions of each block are returned separately: from the start, or since the program has reached a safety zone or
  /// a clock.
  bool returns_each_block() const;
  /// Cancels the last block because the machine has refused one of its actions; the block has no effect, as after an alarm of its own.
  void refused();
  using Waiting = WaitingMode;
  void set_waiting(Waiting waiting);
  using Meeting = ChannelMeeting;
  /// The waiting code that this channel is at; nullopt if it does not wait (the signal CP_NOWT switches waiting off).
  const std::optional<Meeting>& meeting() const;
  void release();

  /// Returns true if an alarm of a block, or of an answer (no contact), has stopped the run.
  bool is_stopped() const;
  void go_on();

  /// The alarm that stopped the run.
  const AlarmReport& report() const;
  /// Returns the report of an alarm that a later room (path, motion, machine …) raised, with the location of the action that caused it.
  AlarmReport report_for(const Alarm& alarm, const Origin& origin) const;
  /// Returns the line that an action comes from, for display; its text is empty if it is in no file.
  AlarmReport::Line line_at(const Origin& origin) const;

  /// Called before and after each executed block, so that the machine's logic can act (Control::set_signal, …). The call after a block
  /// comes once its actions have been passed on, and not if the block failed.
  std::function<void(const Origin&, bool at_end)> on_block;
  /// Called for each signal that the machine's logic sets.
  std::function<void(const std::string& name, bool on)> on_signal;
  /// Input of the machine's logic and its operator (nct): a signal, a skip switch, the answer to a message box (#3107).
  void set_signal(const std::string& name, double value);
  void set_skip(int number, bool on);
  void set_optional_stop(bool on);
  void set_answer(double answer);
  /// Makes spindle `slave` follow `master` (nct 11.7.4). `master` 0 ends it; `slave` 0 means all spindles.
  void synchronise(int slave, int master);
  /// Version of what the channels of a machine share besides the variables (nct 12.3, 24.1); it rises with each change.
  std::uint64_t common_version() const;
  /// Copies the shared data from another channel of the same machine, between two blocks.
  void take_common(const Control& from);
  /// Makes the axes follow the master axes that parameter N2101 names, or ends this coupling (nct 20.2).
  void couple_axes(const std::vector<std::string>& axes, AxisLink link, bool on);
  /// Axes of this channel that are coupled to, or exchanged with, axes of other channels at present (nct 20.2, 20.3).
  const std::vector<CrossChannelAxis>& cross_channel_axes() const;
  /// Called when the machine's logic may have changed cross_channel_axes(); the axes of both channels are at rest.
  std::function<void()> on_cross_channel_axes;
  /// Ends a coupling or exchange that is impossible: the axis is independent again, with a warning.
  void drop_cross_channel(const CrossChannelAxis& axis);
  /// Moves an axis to a machine coordinate because the axis of another channel that it follows has moved. Axes of this channel that
  /// follow this axis move too.
  void lead_axis(std::size_t axis, double machine);
  /// Returns true if the axis may be exchanged with a linear one.
  bool may_exchange(std::size_t axis) const;
  /// From the next block on, lets the axis drive the axis of another channel that it is exchanged with, which is at `machine`; or ends
  /// this.
  void exchange_cross_channel(std::size_t axis, double machine, bool on);
  bool is_parked(std::size_t axis) const;
  bool rolls_over(std::size_t axis) const;
  /// Number of an axis; the numbers are unique across the channels (nct 1.2).
  int axis_number(std::size_t axis) const;
  /// Records that the machine has converted the spindle into an axis (nct 11.8), at rest with its loop closed, or back into a spindle.
  void convert_spindle(int number, bool to_axis);
  /// Switches the power off and on: the program is over, and what is lost without power is lost (nct 23.1.4, 23.5).
  void power_cycle();
  /// Sets the virtual time since the start of the run and the time at feed, for the clocks that a program reads (nct 23.1.9).
  void set_time(double now_ms, double cutting_ms);
  /// Returns true once the program may read a clock: from then on set_time() has an effect, and the actions of each block are returned
  /// separately.
  bool reads_clock() const;
  /// Returns true if programs of this control can read a clock, so that the time since the start may matter.
  bool may_read_clock() const;
  /// Returns the tables and switches after the run, in the form of a set-up; nullopt if the control has no such tables.
  std::optional<RunState> run_state() const;

  /// Present contents of the tables that a program can write (control/tables_now).
  Setup tables_now() const;

  /// Rules of the control's own block search (session/block_search); nullopt if it has none.
  std::optional<SearchRules> search_rules() const;

  /// Called after each executed block that changed something that survives power-off (nct).
  std::function<void(const StateChanges&)> on_changes;

  /// Computes the corners of a contour that is read ahead before it is executed (nct 19.A 5): chamfers, roundings, calculated end
  /// points. The code is in the room path, which control does not include. `from`: start of the contour, work coordinates.
  std::function<std::optional<Alarm>(ActionBatch& contour, const Axes& from)> find_corners;

  /// Called for every warning (look-alike letters, …).
  std::function<void(const AlarmReport&)> on_warning;

  /// Returns which data of a set-up the program has used. Includes variables and lines if watch_use() was called before the run.
  const ProgramUse& use() const;
  void watch_use();

  /// After the run, for a check: reads the subprograms that were never
  /// called, without executing them, and passes their faults to `on_fault`.
  void check_uncalled(const std::function<void(const AlarmReport&)>& on_fault);

  /// Returns lines of the program, or of the called file with number Origin::file, in UTF-8 by line number; unreadable lines are
  /// missing. To be called after the run; reads through the file once.
  std::map<std::uint32_t, std::string> texts_of(const std::set<std::uint32_t>& lines, std::uint16_t file) const;
  /// Returns the bytes of the program or of another file, as they were when the file was opened; nullptr if no file has this number.
  std::shared_ptr<ByteSource> source_of(std::uint32_t file) const;
  /// Returns the path of the program or of another file, by number.
  const std::string& file_name(std::uint16_t file) const;
  /// Returns the paths of all files that have been read: the program and the files that it called.
  std::vector<std::string> files_read() const;
  /// Numbers of the files that the program has called, for file_name(), source_of(), Origin::file. The numbers are not consecutive.
  std::vector<std::uint16_t> called_files() const;
  /// The files that the program has written, or would have written (RunLimits::writes_files).
  const WrittenFiles& files_written() const;

  FinalState ending() const;
  /// Tool position after all blocks executed so far; its coordinates are in the frame that the first action sets.
  ToolPosition tool_position() const;
  /// Placement of the work coordinates on the machine, after all blocks executed so far.
  const Placement& placement() const;
  /// Starts recording states for state_of(). This costs a comparison per block, and a copy of the state per block that changes a mode.
  void watch_states();
  /// Returns what was in force after the block that an action comes from; the control may have read far beyond that block. Returns
  /// nullopt if the modes have changed some thousand times since, or without watch_states().
  std::optional<BlockState> state_of(const Origin& origin) const;
  /// Starts recording calls for calls_of(); reports of report_for() then include the calls that were open at the location of the alarm.
  void watch_calls();
  /// The calls and repetitions through which the program reached the block of an action, outermost first; the control may have read far
  /// beyond that block. Snapshots do not include these calls: for actions emitted before a restore the list is empty.
  std::vector<AlarmReport::Call> calls_of(const Origin& origin) const;
  std::uint64_t blocks() const;      // number of blocks executed
  std::uint64_t bytes_read() const;  // bytes of the program read so far, for progress
  std::uint64_t bytes() const;
  Encoding encoding() const;
  bool encoding_was_guessed() const;
  const std::vector<std::string>& axes() const;
  /// Something that the set-up names and this control does not have, beyond the
  /// checks of the table of keys (config/setup/setup_check); empty if there is none.
  const SetupFault& setup_fault() const;
  /// Returns true if the machine is described by parameters (nct 24).
  bool has_machine_parameters() const;
  /// Returns true if the cutter compensation of this control is computed by path/compensation/queued_compensation.
  bool queues_compensation() const;
  std::uint32_t rotary() const;
  /// See Dialect::limits_by_file().
  std::pair<double, double> limits_by_file(std::size_t axis) const;

 private:
  /// The part of the dialect that serves the machine; nullptr if the dialect has none.
  MachineInterface* machine_interface() const;

  std::unique_ptr<Interpreter> interpreter_;
  std::shared_ptr<SharedMemory> shared_;
  double cutting_seen_ms_ = 0;
};

}  // namespace kadr
