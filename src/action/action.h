#pragma once
// Action: one elementary thing that the machine has to do, fully resolved; a plain value. Lengths are in mm, angles in degrees, times in s.
// An Axes value lists its numbers in the order of the control's axis names.

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "action/motion.h"
#include "action/origin.h"
#include "action/placement.h"
#include "action/surface_speed.h"
#include "base/alarm.h"
#include "base/span.h"
#include "base/vec.h"

namespace kadr {

struct Dwell {
  double seconds;
};
enum class SpindleDir : std::uint8_t { stop, cw, ccw, orient, position };
struct Spindle {
  SpindleDir dir;
  double rpm;  // rev/min
  std::uint8_t number = 1;
  std::optional<double> turn{};   // for an orientation of the spindle (`position`): signed rotation of the spindle, degrees
  std::optional<double> angle{};  // for an orientation of the spindle (`position`): angle of the spindle after the rotation, degrees
};
struct Speed {
  double value;  // the new value: spindle speed, rev/min, or surface speed, m/min (G96)
  bool surface;
  std::uint8_t number = 1;  // number of the spindle
  std::uint8_t range = 0;   // gear range that the speed selects; 0: the speed selects no range
  double rpm = 0;           // spindle speed, rev/min, that the surface speed gives at the position of the block
};
enum class Coolant : std::uint8_t { off, mist, flood };
struct CoolantSwitch {
  Coolant what;
};
/// The row of a tool in the tool table, and its pocket in the magazine; for controls with a tool table (nct 12.3).
struct ToolPlace {
  std::uint32_t data = 0;  // row of the tool table; 0: the tool has no row
  std::uint32_t magazine = 0;
  std::uint32_t pocket = 0;
};
struct ToolSelect {
  std::uint32_t tool;
  std::uint32_t corrector;
  ToolPlace place{};
};
struct ToolChange {
  std::uint32_t tool;
  ToolPlace place{};
  bool there = false;  // the tool is in the spindle already: the program only states its number (2С42 6.4.4)
};
/// An M code that the control passes to the machine.
struct MachineFunction {
  std::uint32_t code;
  std::optional<double> p{};  // values of the words P and Q of a user macro (Mach3 M100 …)
  std::optional<double> q{};
  std::uint8_t spindle = 0;  // number of the spindle that the M code acts on; 0: no spindle
  // number of the machine's output that the code switches, or of its input that the code waits for (spec/linuxcnc 8); `value` is the
  // output's new value
  std::optional<double> number{};
  std::optional<double> value{};
  bool by_control = false;  // the control executes the M code itself and only reports it to the machine (nct 13.1: M2, M30, M98, M99)
};
/// An auxiliary function: a code with another address letter than M (nct 13.2).
struct AuxiliaryFunction {
  char address;
  double value;
};
enum class StopReason : std::uint8_t { program, optional, single_block, message };
struct Stop {
  bool optional;
  StopReason reason = StopReason::program;
};
struct Message {
  std::string text;
  std::int32_t number = -1;  // number of the message; -1: the message has no number
  bool asks = false;         // the program waits until the operator answers the message (#3107)
};
/// Reports that several channels have waited for each other and now continue together. One Sync stands for all these channels (nct 14.5).
struct Sync {
  std::uint32_t code;
  std::vector<std::uint8_t> channels;  // numbers of the channels that waited, in their order of arrival
  double at = 0;                       // time at which the channels continue, s
};
/// Changes the safety zones (nct 22.2): G22 sets limits, G23 restores the limits of the parameters.
struct ZoneChange {
  bool on = false;
  bool outside_forbidden = false;
  AxisMask axes = 0;     // axes with limits; the others are unlimited
  Axes least{}, most{};  // limits of the axes in `axes`, machine coordinates; an infinite value means that there is no limit
  // true: the change sets the parameters of zone 2, and a later G23 restores the zone that these parameters define
  bool of_parameters = false;
};
/// Switches an electronic gearbox on. In addition to its own motions, the slave axis then follows a spindle and the travel of a third axis
/// (nct 20.1).
struct Couple {
  std::string master, slave;      // names of the master spindle and of the slave axis
  double ratio = 1;               // gear ratio: revolutions of the slave axis per revolution of the master spindle, signed
  double rpm = 0;                 // speed of the slave axis at the master spindle's present speed, rev/min, signed
  bool feeds_by_slave = false;    // true: a feed per revolution counts revolutions of the slave axis; false: those of the master spindle
  std::optional<double> phase{};  // angle of the slave axis at the master spindle's zero pulse, degrees
  double helix = 0;               // additional rotation of the slave axis, in degrees per mm of travel of the axis `along`
  std::string along{};            // name of the axis whose travel also turns the slave axis; empty: no axis
  int master_number = 0;          // number of the master spindle
};
struct Uncouple {
  std::string slave;
};
/// Makes the tool's centre round the corner: it moves on an arc of the tool's radius around the programmed point (G39, nct 15.5.6).
struct CompensationCorner {
  std::optional<Vec2>
      direction_vector{};  // I J K: direction in which the path leaves the corner; nullopt: the direction of the next motion
};
/// Selects how the control checks the compensated path from this action on (nct 15.5.2, 15.5.7). This action does not command the machine.
struct CompensationCheck {
  bool interference = false;  // true: the path is checked for interference (parameter N1403 #0 IEN)
  // true: interference raises an alarm at once, and the control does not try to correct the path (parameter N1403 #1 AAL)
  bool always_alarm = false;
  // number of blocks, 0…8, that the check for interference includes in addition to the usual three (parameter N1404)
  std::uint8_t further = 0;
  double least_step = 0;  // length in mm; shorter segments of the path around a corner are omitted (parameter N1405 DELTV)
  friend bool operator==(const CompensationCheck&, const CompensationCheck&) = default;
};
/// Interrupts cutter compensation: the tool's centre is on the programmed point (nct 15.5.2). If `off` is true, compensation ends (G40,
/// 15.5.3). If `here` is true, the tool's actual position, which is off the contour, becomes the programmed point (G92 after G40, Mach3
/// 10.7.27). LinuxCNC executes a compensated motion only when it has read the next one. At a CompensationBreak, also before M0, the motion
/// that waits ends one tool radius off its programmed point.
struct CompensationBreak {
  bool off = false;
  bool here = false;
};
/// Changes the frame (work coordinates to machine coordinates) of all actions that follow; it does not command the machine. `work` holds
/// the tool's work coordinates in the new frame. On the 2С42, they do not include yet a tool length that was newly selected.
struct FrameChange {
  Placement placement;
  Axes work;
  // The part of the origin of work coordinates that comes from G52, G92 …; nullptr: there is no such part, or placement.shift contains it.
  std::shared_ptr<const Axes> shifted{};
};

/// Its copies and moves are compiled once, in action.cpp: an instance for twenty alternatives in each file costs the compiler seconds.
struct Action {
  using What =
      std::variant<Motion, Dwell, Spindle, Speed, CoolantSwitch, ToolSelect, ToolChange, MachineFunction, AuxiliaryFunction, Stop, Message,
                   FrameChange, SurfaceSpeed, Sync, ZoneChange, Couple, Uncouple, CompensationBreak, CompensationCorner, CompensationCheck>;

  Action();
  Action(Origin by, What that);
  Action(const Action&);
  Action(Action&&) noexcept;
  Action& operator=(const Action&);
  Action& operator=(Action&&) noexcept;
  ~Action();

  Origin origin;
  What what;
};

/// A batch of emitted actions. clear() keeps the elements in memory, so that a long run does not allocate them again.
class ActionBatch {
 public:
  Action& add() {
    if (end_ == actions_.size()) [[unlikely]]
      grow();
    return actions_[end_++];
  }
  /// Inserts an action before the first action; allowed once until the batch is cleared.
  Action& add_front() { return actions_[begin_ = 0]; }
  void clear() { begin_ = end_ = 1; }
  void cut(std::size_t size) { end_ = begin_ + size; }
  std::size_t size() const { return end_ - begin_; }
  bool empty() const { return end_ == begin_; }
  Action& operator[](std::size_t i) { return actions_[begin_ + i]; }
  Action& back() { return actions_[end_ - 1]; }
  Action* begin() { return actions_.data() + begin_; }
  Action* end() { return actions_.data() + end_; }
  const Action* begin() const { return actions_.data() + begin_; }
  const Action* end() const { return actions_.data() + end_; }

 private:
  [[gnu::noinline]] void grow() { actions_.emplace_back(); }

  std::vector<Action> actions_ = std::vector<Action>(1);
  std::size_t begin_ = 1, end_ = 1;  // actions_[0] is reserved for add_front(): the batch starts at index 1
};

/// An alarm with its location, for messages to people and for traces.
struct AlarmReport {
  Alarm alarm;
  std::string file;
  std::string line_text;  // the text of the line, UTF-8
  Origin origin;
  struct Call {
    std::string what;  // the word that made the call: "L02", "P100", "M20"
    std::uint32_t line;
    std::uint32_t block;
    bool has_block;
    std::string file{};  // name of the file that contains the line; empty: the program itself; set only by Control::calls_of()
  };
  std::vector<Call> calls;  // the calls that led to the line, outermost first
  struct Line {
    std::uint32_t number = 0;  // line number in the program; 0: the alarm refers to one line only
    std::string file, text;
    Span where{};
  };
  Line other{};            // a second line that the alarm refers to, for example the line of the contour that would be cut
  std::string own_text{};  // the text of the program's own alarm (#3000 of nct), which may be too long for an AlarmArg
};

/// The result of a probe motion. The session passes it back to `control` before the next block (docs/architecture.md, the only backward
/// arrow).
struct ProbeAnswer {
  bool touched = false;
  Axes at{};        // work coordinates at which the motion ended
  double part = 1;  // executed fraction of the motion's path, 0 to 1
};

/// The state of the control after a block: position, modes, tool and offsets.
struct BlockState {
  std::vector<std::string> modal;  // code words in force, and the words F, S, T, D, H in force
  std::uint32_t tool = 0;          // number of the tool in the spindle
  Axes origin{};                   // origin of the work system in machine coordinates, with all shifts included
  Axes length{};                   // tool length in mm, by axis
};

/// The state after a run, which the last line of a trace contains.
struct FinalState {
  Axes position{};  // work coordinates
  Axes machine_position{};
  std::vector<std::pair<std::string, double>> variables;    // every variable that has a value: "#100", "R2"
  std::vector<std::pair<std::string, bool>> watched_unset;  // names of the variables that a user asked for, but that have no value
  std::vector<std::string> modal;                           // code words in force
};

}  // namespace kadr
