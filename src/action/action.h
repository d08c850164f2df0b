#pragma once
// Action: one elementary thing that the machine has to do, fully resolved; a plain value. Lengths are in mm, angles in
// degrees, times in s. Axis values are in the order of the control's axis names.

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
  std::optional<double> turn{};   // only for `position`: signed rotation, degrees
  std::optional<double> angle{};  // only for `position`: the resulting angle of the spindle, degrees
};
struct Speed {
  double value;  // the new speed: rev/min, or surface speed in m/min (G96)
  bool surface;
  std::uint8_t number = 1;  // number of the spindle
  std::uint8_t range = 0;   // gear range that the speed selects; 0: the speed selects no range
  double rpm = 0;           // rev/min that the surface speed gives at the position where it is commanded
};
enum class Coolant : std::uint8_t { off, mist, flood };
struct CoolantSwitch {
  Coolant what;
};
/// The location of a tool, for controls with a tool table (nct 12.3).
struct ToolPlace {
  std::uint32_t data = 0;  // row of the tool table; 0: none
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
  bool there = false;  // no tool is changed: the program states which tool is in the spindle (2С42 6.4.4)
};
/// An M code that goes to the machine.
struct MachineFunction {
  std::uint32_t code;
  std::optional<double> p{};  // P and Q, words of a user macro (Mach3 M100 …)
  std::optional<double> q{};
  std::uint8_t spindle = 0;        // the spindle that the M code acts on; 0: none
  std::optional<double> number{};  // number of an output or input of the machine; `value` is what it is set to (spec/linuxcnc 8)
  std::optional<double> value{};
  bool by_control = false;  // the control executes the M code itself and only reports it to the machine (nct 13.1: M2, M30, M98, M99)
};
/// An auxiliary function on another address than M (nct 13.2).
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
  std::int32_t number = -1;  // number of the message; -1: none
  bool asks = false;         // the program waits for the operator's answer (#3107)
};
/// Several channels have waited for each other and now continue together. One Sync stands for all of them (nct 14.5).
struct Sync {
  std::uint32_t code;
  std::vector<std::uint8_t> channels;  // numbers of the channels, in their order of arrival
  double at = 0;                       // s, time at which the channels continue
};
/// Changes the safety zones (nct 22.2): G22 sets limits, G23 restores the limits of the parameters.
struct ZoneChange {
  bool on = false;
  bool outside_forbidden = false;
  AxisMask axes = 0;           // axes with limits; the others are unlimited
  Axes least{}, most{};        // limits of the axes in `axes`, machine coordinates; an infinite value is no limit
  bool of_parameters = false;  // the change concerns the zone that the parameters define now, active or not; G23 restores this zone
};
/// Switches an electronic gearbox on: in addition to its own motions, the slave axis follows a spindle and the travel of a third axis
/// (nct 20.1).
struct Couple {
  std::string master, slave;      // names of the master spindle and of the slave axis
  double ratio = 1;               // revolutions of the slave per revolution of the master, signed
  double rpm = 0;                 // speed of the slave at the master's present speed, rev/min, signed
  bool feeds_by_slave = false;    // a feed per revolution refers to the slave's revolutions, not to the master's
  std::optional<double> phase{};  // angle of the slave at the spindle's zero pulse, degrees
  double helix = 0;               // rotation of the slave in degrees per mm of travel of the axis `along`
  std::string along{};            // name of the third axis; empty: none
  int master_number = 0;          // number of the master spindle
};
struct Uncouple {
  std::string slave;
};
/// Rounds the corner: the tool's centre moves on an arc of the tool's radius around the programmed point (G39, nct 15.5.6).
struct CompensationCorner {
  std::optional<Vec2> way{};  // I J K: direction that the corner leads to; without it, the direction of the next motion
};
/// How the compensated path is checked from here on (nct 15.5.2, 15.5.7). This is not a command to the machine.
struct CompensationCheck {
  bool interference = false;  // N1403 #0 IEN: interference is checked
  bool always_alarm = false;  // N1403 #1 AAL: interference is an alarm at once; the control does not try to correct the path
  std::uint8_t further = 0;   // N1404: number of blocks that are checked in addition to three, 0…8
  double least_step = 0;      // N1405 DELTV, mm: shorter steps around a corner are omitted
  friend bool operator==(const CompensationCheck&, const CompensationCheck&) = default;
};
/// Interrupts cutter compensation: the tool's centre is on the programmed point (nct 15.5.2). With `off`, compensation has ended (G40,
/// 15.5.3). With `here`, the program takes the tool's actual position, off the contour, as the programmed point (G92 after G40, Mach3
/// 10.7.27). LinuxCNC holds back one compensated motion: at a CompensationBreak, also before M0, that motion ends one tool radius off its
/// programmed point.
struct CompensationBreak {
  bool off = false;
  bool here = false;
};
/// Changes the frame of all actions that follow; not a command to the machine. `work`: the tool's work coordinates from now on (on the
/// 2С42, a tool length that was newly selected does not count in them yet).
struct FrameChange {
  Placement placement;
  Axes work;
  // The part of placement.origin that comes from G52, G92 …; nullptr: there is no such part, or placement.shift holds it
  std::shared_ptr<const Axes> shifted{};
};

struct Action {
  Origin origin;
  std::variant<Motion, Dwell, Spindle, Speed, CoolantSwitch, ToolSelect, ToolChange, MachineFunction, AuxiliaryFunction, Stop, Message,
               FrameChange, SurfaceSpeed, Sync, ZoneChange, Couple, Uncouple, CompensationBreak, CompensationCorner, CompensationCheck>
      what;
};

/// A batch of emitted actions. clear() keeps the elements in memory, so that a long run does not allocate them again.
class ActionBatch {
 public:
  Action& add() {
    if (end_ == actions_.size()) [[unlikely]]
      grow();
    return actions_[end_++];
  }
  /// Inserts an action before the first; at most once until the batch is cleared.
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

/// An alarm with its location, as it is printed for people and in traces.
struct AlarmReport {
  Alarm alarm;
  std::string file;
  std::string line_text;  // UTF-8
  Origin origin;
  struct Call {
    std::string what;  // "L02", "P100", "M20"
    std::uint32_t line;
    std::uint32_t block;
    bool has_block;
    std::string file{};  // the file that the line is in, if it is not the program itself; set only by Control::calls_of()
  };
  std::vector<Call> calls;  // outermost first
  struct Line {
    std::uint32_t number = 0;  // line number; 0: there is no second line
    std::string file, text;
    Span where{};
  };
  Line other{};            // a second line that the alarm is about, such as the line of the contour that is cut
  std::string own_text{};  // the program's own message (#3000 of nct), which may be longer than an AlarmArg
};

/// The result of a probe motion, passed back to `control` before the next block (docs/architecture.md, the only backward arrow).
struct ProbeAnswer {
  bool touched = false;
  Axes at{};        // work coordinates where the motion ended
  double part = 1;  // executed part of the motion's path, 0..1
};

/// What was in force after a block was executed.
struct BlockState {
  std::vector<std::string> modal;  // code words in force, and the words F, S, T, D, H
  std::uint32_t tool = 0;          // number of the tool in the spindle
  Axes origin{};                   // origin of the work system in machine coordinates, including all shifts
  Axes length{};                   // tool length, by axis
};

/// The state after a run: the last line of a trace.
struct FinalState {
  Axes position{};  // work coordinates
  Axes machine_position{};
  std::vector<std::pair<std::string, double>> variables;    // every variable that has a value: "#100", "R2"
  std::vector<std::pair<std::string, bool>> watched_unset;  // variables whose values were requested, but that have none
  std::vector<std::string> modal;                           // code words in force
};

}  // namespace kadr
