#pragma once
// What a PanelMachine shows and saves, as values: the state of the machine for the operator, its location in the program, its tables, and
// what a run of motion is.

#include <deque>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "panel/channel_axes.h"
#include "panel/panel_search.h"
#include "panel/panel_sheet.h"
#include "session/stepping.h"

namespace kadr {

enum class PanelMode : std::uint8_t {
  standing,  // the axes are at rest before a block, or after a line of the operator
  running,
  held,       // feed hold: the axes are slowing down or at rest
  ended,      // the program has ended
  alarm,      // an alarm has stopped the program; reset() ends this mode
  emergency,  // emergency stop; only reset() ends this mode
};

/// The state of one channel on a machine with several channels.
struct PanelChannel {
  int number = 1;
  std::vector<std::string> axes;
  ServoSample sample;
  PanelBlock block;                   // the block that the channel's axes are executing, or executed last
  AlarmReport::Line line;             // text and location of the block in the program
  std::optional<PanelMeeting> waits;  // The waiting code at which this channel waits. It is set when the axes of the channel have stopped.
};

/// The state of the machine that the panel displays to the operator.
struct PanelState {
  PanelMode mode = PanelMode::standing;
  ServoSample sample;
  PanelOverrides shares;   // the overrides that the operator has set
  PanelBlock block;        // the block that the machine is executing, or executed last
  AlarmReport::Line line;  // Text and location of this block while the program runs; otherwise of the next block.
  bool entered = false;    // true while a line of the operator is being executed
  bool single = false, optional_stop = false;
  std::set<int> skip;
  std::map<std::size_t, StopPoint> stops;
  std::size_t hit = 0;        // number of the stop point that holds the program; 0: no stop point holds it
  std::string message;        // the message that the program displays
  std::string why;            // reason for the stop: "M0", "M1", "restart", and on a real machine "M6", "M21" …; empty: another reason
  AlarmReport::Line stop;     // the line with M0 or M1, if this is the reason for the stop
  bool asks = false;          // True if the program waits for the operator's answer() to the question in `message`.
  bool takes_tables = false;  // true while edited tables are being applied
  std::string save_fault;     // An error sentence that states why the machine's data cannot be saved; empty: the data are saved.
  // True while a restart in mid-program is in progress: the axes move to the block at which the program continues.
  bool goes_there = false;
  std::optional<RealMachine> real;  // what a real machine reports; nullopt: the machine is virtual
  std::optional<AlarmReport> alarm;
  std::size_t can_undo = 0;         // number of entered lines that undo() can revert
  std::optional<PanelLimit> limit;  // the limit that determines the speed at present
  std::uint64_t blocks = 0;         // Number of blocks that the control has executed. The control is ahead of the machine.
  // All channels, if the machine has several channels. The members above describe the program's own channel.
  std::vector<PanelChannel> channels;
};

/// The location of a machine in its program.
struct PanelLocation {
  PanelMode mode = PanelMode::standing;
  Axes machine{};
  std::uint32_t number = 0;  // PanelBlock::number of the current block or the next block; 0: no block of the program
  std::uint32_t line = 0;
  std::string file{};          // the file that contains `line`; empty: the main program
  std::string text{};          // text of the line
  std::vector<Axes> stands{};  // The machine position of each channel, by index; empty if the machine has only one channel.
};

/// Functions of the client with which a PanelMachine saves its data for a later start of the server. The machine's thread calls them.
struct PanelRecorder {
  /// A function of the client that saves the program line and the axis positions, for a restart after power-off. PanelMachine calls it at
  /// each block.
  ///   returns  an error sentence if the location cannot be saved
  std::function<std::string(const PanelLocation&)> spot;
  /// A function of the client that adds an entry to the log of the operator's actions. The kinds of entries are "run" "hold" "reset"
  /// "emergency" "override" "line" "restart" "stopped" "ended".
  std::function<void(const char* kind, const std::string& text, std::uint32_t line)> event;
  std::function<void(const AlarmReport&)> alarm;
  /// A function of the client that saves table changes which a line of the operator has made, so that later sessions start with the changed
  /// tables. PanelMachine calls it after such a line.
  ///   returns  an error sentence if the changes cannot be saved
  std::function<std::string(const Setup& before, const Setup& after)> tables;
  /// A function of the client that reads the program file from the disk. PanelMachine calls it before the program starts from its
  /// beginning. Later changes of the file have no effect until the next call.
  std::function<void()> begins;
};

/// A variable of the program and its value.
struct PanelVariable {
  std::string name;
  double value = 0;
  std::uint32_t line = 0;  // program line that set the variable last; 0: the set-up, or a line of the operator
};

/// The present tables of the control.
struct PanelTables {
  std::optional<RunState> state;  // the tables; nullopt: the tables of this control cannot be displayed
  std::vector<PanelVariable> variables;
};

/// An expression that the operator watches, with its present value.
struct PanelWatch {
  std::string text;
  std::optional<double> value;  // the value; nullopt: the expression is invalid, or its value is vacant
};

/// A run of motion: the motion from one position at which the axes are at rest to the next such position.
struct PanelRun {
  enum class Of : std::uint8_t { program, line, hand };
  Of of = Of::program;
  std::size_t channel = 0;  // index of the channel in which an entered line is executed; only for Of::line
  bool planned_all = false;
  Session::State came_to = Session::State::running;
};

/// A path along which one channel moves to its restart position.
struct PanelPath {
  std::size_t channel = 0;  // index of the channel
  std::vector<WayPoint> points;
};

/// The state of a restart while the machine moves to the block at which the program continues.
struct PanelApproach {
  struct Line {
    std::size_t channel;
    std::string text;
  };
  std::shared_ptr<const RestartPoint> place;
  std::deque<Line> before;      // lines of the program's language that the control executes before the axes move to the restart position
  std::deque<PanelPath> paths;  // paths along which the channels move to the restart position, one path after another
  std::deque<Line> after;       // lines that the control executes after the axes have moved along these paths
  bool is_there = false;
};

}  // namespace kadr
