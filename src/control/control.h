#pragma once
// Control: one numerical control with its interpreter. It turns blocks into actions and stores everything that a control remembers. All
// other rooms use the room control through this file.

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
#include "control/lathe_modes.h"
#include "control/state/cross_channel_axis.h"
#include "control/state/run_limits.h"
#include "control/state/search_rules.h"
#include "control/state/snapshot.h"
#include "control/state/usage.h"
#include "control/state/waiting_codes.h"
#include "lang/block/block_reader.h"

namespace kadr {

/// The files that a program writes (nct 23.2.13). The key is the path, relative to the folder of the program memory; the value is the
/// number of bytes.
using WrittenFiles = std::map<std::string, std::uint64_t>;

class Interpreter;       // control/interpreter.h
class LineMarks;         // control/state/line_marks.h
class MachineInterface;  // control/dialect/machine_interface.h
class SharedMemory;      // control/shared_memory.h

class Control {
 public:
  /// `def` must outlive the control. `shared`: the memory that the channels of one machine share (nct 1.2), or nullptr.
  Control(const ControlDef& def, const Setup& setup, Program program, const RunLimits& limits,
          std::shared_ptr<SharedMemory> shared = nullptr);
  ~Control();

  enum class State : std::uint8_t { running, needs_probe, waiting, held, stopped, ended };

  /// Executes blocks until `batch` (cleared first) is full or the caller must react. The result means:
  ///   needs_probe  the last action is a probe motion: call answer() with the contact, then run() again
  ///   waiting      this channel is at a waiting code (nct 14.5) while the mode is Waiting::meet: meeting() describes the code; call
  ///                release() when all channels have arrived, then run() again
  ///   held         holds_before() has returned true: the next block has not been executed
  ///   stopped      an alarm has stopped the run: report() describes the alarm; the faulty block has no effect. go_on() continues with the
  ///                next block (for a check)
  ///   ended        the program is at its end
  State run(ActionBatch& batch);

  /// A function of the client that decides whether the run pauses; the control calls it before each block that has been read. If the result
  /// is true, the block is not executed now, and the next run() reads the block again. In the meantime the control answers every query,
  /// except queries about a block that is being executed.
  std::function<bool(const Origin&)> holds_before;
  /// Starts recording in `marks` the lines whose blocks are executed; nullptr ends the recording. From then on run() returns after `most`
  /// blocks at the latest, so that the caller can read the marks. The caller must read `marks` only while run() is not being executed
  /// (RunAhead::settle).
  void note_lines(LineMarks* marks, std::uint64_t most);
  /// Returns true if a block is not finished, either because its canned cycle has more motions to emit, or because functions of the block
  /// wait for the end of the cycle.
  bool in_block() const;
  /// Enters a line of the operator (MDI). The line is executed next, with the modes in force; then the program continues at its next block.
  ///   pre  !in_block()
  void enter(const std::string& line);
  /// Returns true while an entered line is not finished.
  bool in_entered() const;
  /// Sets the machine position after the operator has moved the axes by hand.
  ///   pre  !in_block()
  void stand_at(const Axes& machine);
  /// Returns the present value of an expression in the program's notation: `#100+1`, `R2`.
  ///   alarms  expression_syntax and every other alarm of an expression
  Result<double> evaluate(std::string_view expression) const;
  /// Open calls and repetitions, outermost first.
  std::vector<AlarmReport::Call> calls() const;
  /// Returns the location of the block that is being executed, or was executed last.
  const Origin& origin() const;
  /// Returns the unit of the lengths in the machine's own tables, in mm.
  double machine_unit() const;
  /// Returns the index of the axis that is normal to the selected plane.
  std::size_t plane_normal() const;
  /// Returns the modes and offsets in force after all blocks executed so far.
  BlockState state_now() const;
  std::vector<InForce> in_force() const;
  /// Returns what the panel of a lathe shows besides in_force(), after all blocks executed so far.
  LatheModes lathe_modes() const;

  /// Returns everything that decides how the run continues; nullopt while the control waits for the result of a probe motion. Three things
  /// are not included: the text that the program has read from standard input, the contents of the files that it has written, and the state
  /// before the last block, which refused() would restore.
  std::optional<Snapshot> snapshot() const;
  /// Restores a snapshot that was made with the same control file, set-up and program. The actions, alarms and notes that follow are the
  /// same as in the control that made the snapshot. Tables that channels share get the values that this channel had.
  ///   alarms  file_missing, file_write: a file that the program had called or was writing is missing or has changed
  Status restore(const Snapshot& from);

  void answer(const ProbeAnswer& answer);
  /// From now on run() returns the actions of each block separately, so that the machine can refuse a block.
  void return_each_block();
  /// Returns true if run() returns the actions of each block separately. This is so either from the start of the run, or from the block on
  /// in which the program has reached a safety zone or has read a clock.
  bool returns_each_block() const;
  /// Cancels the last block because the machine has refused one of its actions. Afterwards the block has no effect, as if it had raised an
  /// alarm.
  void refused();
  using Waiting = WaitingMode;
  void set_waiting(Waiting waiting);
  using Meeting = ChannelMeeting;
  /// Returns the waiting code at which this channel waits; nullopt if it does not wait. While the signal CP_NOWT is on, no channel waits.
  const std::optional<Meeting>& meeting() const;
  void release();

  /// Returns true if an alarm has stopped the run: an alarm of a block, or of the answer to a probe motion (no contact).
  bool is_stopped() const;
  void go_on();

  /// Returns the report of the alarm that has stopped the run.
  const AlarmReport& report() const;
  /// Returns the report of an alarm that a later room (path, motion, machine …) has raised. `origin`: the location of the action that
  /// caused the alarm.
  AlarmReport report_for(const Alarm& alarm, const Origin& origin) const;
  /// Returns the line that an action comes from, for display; its text is empty if the line is in no file.
  AlarmReport::Line line_at(const Origin& origin) const;

  /// A function of the client that lets the machine's logic act (Control::set_signal, …); the control calls it before and after each
  /// executed block. The call after a block follows when run() has returned the actions of the block; there is no such call if the block
  /// failed.
  std::function<void(const Origin&, bool at_end)> on_block;
  /// A function of the client that receives each signal which the machine's logic sets by set_signal(); the control calls it.
  std::function<void(const std::string& name, bool on)> on_signal;
  /// These functions are the inputs from the machine's logic and from the operator (nct): a signal, a skip switch, the switch for the
  /// optional stop, the answer to a message box (#3107).
  void set_signal(const std::string& name, double value);
  void set_skip(int number, bool on);
  void set_optional_stop(bool on);
  void set_answer(double answer);
  /// Makes spindle `slave` follow spindle `master` (nct 11.7.4). If `master` is 0, `slave` stops following; if `slave` is 0, all spindles
  /// are meant.
  void synchronise(int slave, int master);
  /// Returns the version of the data that the channels of a machine share, other than variables (nct 12.3, 24.1). The version rises with
  /// each change.
  std::uint64_t common_version() const;
  /// Copies the data that the channels of a machine share from the control of another channel. Allowed only between two blocks.
  void take_common(const Control& from);
  /// Couples each of the axes to the master axis that its parameter N2101 names, or ends this coupling (nct 20.2).
  void couple_axes(const std::vector<std::string>& axes, AxisLink link, bool on);
  /// Returns the axes of this channel that are coupled to axes of other channels at present, or exchanged with them (nct 20.2, 20.3).
  const std::vector<CrossChannelAxis>& cross_channel_axes() const;
  /// A function of the client that reads cross_channel_axes() again; the control calls it when the machine's logic may have changed these
  /// axes. At this moment the axes of both channels do not move.
  std::function<void()> on_cross_channel_axes;
  /// Ends a coupling or exchange of axes that is impossible. The axis becomes independent again, and a warning is reported.
  void drop_cross_channel(const CrossChannelAxis& axis);
  /// Moves an axis of this channel to a machine coordinate in mm or degrees, because the axis follows an axis of another channel that has
  /// moved. Axes of this channel that follow `axis` move too.
  void move_linked_axis(std::size_t axis, double machine);
  /// Returns true if the axis of this channel may be exchanged with a linear axis.
  bool may_exchange(std::size_t axis) const;
  /// Starts or ends the exchange of an axis of this channel with an axis of another channel, at the next block. During the exchange the
  /// words of `axis` drive the other axis, whose machine coordinate is `machine`.
  void exchange_cross_channel(std::size_t axis, double machine, bool on);
  bool is_parked(std::size_t axis) const;
  bool rolls_over(std::size_t axis) const;
  /// Returns the number of an axis; the numbers are unique across the channels (nct 1.2).
  int axis_number(std::size_t axis) const;
  /// Records that the machine has converted a spindle into an axis (nct 11.8), or back into a spindle. As an axis the spindle does not
  /// turn, and its position is controlled.
  void convert_spindle(int number, bool to_axis);
  /// Switches the power off and on: the program ends, and data that need power are cleared (nct 23.1.4, 23.5).
  void power_cycle();
  /// Sets the times that a program reads from its clocks (nct 23.1.9).
  ///   now_ms      virtual time since the start of the run, ms
  ///   cutting_ms  total time of the motions at feed, ms
  void set_time(double now_ms, double cutting_ms);
  /// Returns true from the first block on that may read a clock. From then on set_time() has an effect, and run() returns the actions of
  /// each block separately.
  bool reads_clock() const;
  /// Returns true if programs of this control can read a clock, so that the virtual time may influence the run.
  bool may_read_clock() const;
  /// Returns the tables and switches after the run, in the form of a set-up; nullopt if the control has no tables that are stored after a
  /// run.
  std::optional<RunState> run_state() const;

  /// Returns the present contents of the tables that a program can write (control/tables_now).
  Setup tables_now() const;

  /// Returns the rules of the control's own block search (session/block_search); nullopt if the control has no block search.
  std::optional<SearchRules> search_rules() const;

  /// A function of the client that receives the data that survive power-off (nct); the control calls it after each executed block that has
  /// changed such data.
  std::function<void(const StateChanges&)> on_changes;

  /// A function of the client that computes the corners of a contour (chamfers, roundings, calculated end points) in the room path, which
  /// control does not include. If the first motion starts cutter compensation (SideStep::begins), the function also replaces the motions by
  /// the compensated ones, which begin at the uncompensated start and end square to the last motion (fanuc-t 9.11). The control calls it
  /// before it executes a contour that is read ahead (nct 19.A 5). `from`: start of the contour, work coordinates.
  std::function<std::optional<Alarm>(ActionBatch& contour, const Axes& from)> find_corners;

  /// A function of the client that receives every warning, for example that a letter looks like another letter; the control calls it.
  std::function<void(const AlarmReport&)> on_warning;

  /// Returns which data of a set-up the program has used. Variables and lines are included if watch_use() was called before the run.
  const ProgramUse& use() const;
  void watch_use();

  /// Checks, after the run, the subprograms that were never called. Their blocks are read without being executed, and `on_fault` is called
  /// for each fault.
  void check_uncalled(const std::function<void(const AlarmReport&)>& on_fault);

  /// Returns lines of a file in UTF-8, by line number; lines that cannot be read are omitted. `file`: the number of the program or of a
  /// called file, as in Origin::file. To be called after the run, because the function reads through the file once.
  std::map<std::uint32_t, std::string> texts_of(const std::set<std::uint32_t>& lines, std::uint16_t file) const;
  /// Returns the bytes of the file with the number `file` (0: the program), as they were when the file was opened; nullopt if no file has
  /// this number.
  std::shared_ptr<ByteSource> source_of(std::uint32_t file) const;
  /// Returns the path of the file with the number `file` (0: the program).
  const std::string& file_name(std::uint16_t file) const;
  /// Returns the paths of all files that have been read: the program and the files that it called.
  std::vector<std::string> files_read() const;
  /// Returns the numbers of the files that the program has called, for file_name(), source_of() and Origin::file. The numbers are not
  /// consecutive.
  std::vector<std::uint16_t> called_files() const;
  /// Returns the files that the program has written, or would have written if RunLimits::writes_files were set.
  const WrittenFiles& files_written() const;

  FinalState ending() const;
  /// Returns the tool position after all blocks executed so far. Its coordinates are in the frame that the first action sets.
  ToolPosition tool_position() const;
  /// Returns the placement of the work coordinates on the machine, after all blocks executed so far.
  const Placement& placement() const;
  /// Starts recording states for state_of(). This costs a comparison per block, and a copy of the state per block that changes a mode.
  void watch_states();
  /// Returns the modes and offsets that were in force after the block that an action comes from. The control may have read far beyond that
  /// block. The result is nullopt if the modes have changed some thousand times since, or if watch_states() was not called.
  std::optional<BlockState> state_of(const Origin& origin) const;
  /// Starts recording calls for calls_of(). The results of report_for() then include the calls that were open at the location of the alarm.
  void watch_calls();
  /// Returns the calls and repetitions through which the program reached the block of an action, outermost first. The control may have read
  /// far beyond that block. Snapshots do not include these calls, so the list is empty for actions that were emitted before restore().
  std::vector<AlarmReport::Call> calls_of(const Origin& origin) const;
  std::uint64_t blocks() const;      // number of blocks executed
  std::uint64_t bytes_read() const;  // bytes of the program read so far, for a display of progress
  std::uint64_t bytes() const;
  Encoding encoding() const;
  bool encoding_was_guessed() const;
  const std::vector<std::string>& axes() const;
  /// Returns the fault that the set-up names an axis or table row which this control lacks; empty if there is no such fault. The check of
  /// the table of keys (config/setup/setup_check) does not find this fault.
  const SetupFault& setup_fault() const;
  /// Returns true if parameters of the control describe the machine (nct 24).
  bool has_machine_parameters() const;
  /// Returns true if path/compensation/queued_compensation computes the cutter compensation of this control.
  bool queues_compensation() const;
  std::uint32_t rotary() const;
  /// Returns the least and the greatest machine coordinate of an axis that a file of the machine allows: see Dialect::limits_by_file().
  std::pair<double, double> limits_by_file(std::size_t axis) const;

 private:
  /// Returns the part of the dialect that serves the machine; nullptr if the dialect has no such part.
  MachineInterface* machine_interface() const;

  std::unique_ptr<Interpreter> interpreter_;
  std::shared_ptr<SharedMemory> shared_;
  double cutting_seen_ms_ = 0;
};

}  // namespace kadr
