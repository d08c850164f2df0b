#pragma once
// Action: one elementary thing the machine is to do, fully resolved; a plain value (design.md 1).
// Lengths mm, angles degrees, times s. Axis values stand in the order of the control's axis names.

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
  std::optional<double> turn{};   // of `position`: degrees, signed
  std::optional<double> angle{};  // … and where it stands then
};
struct Speed {
  double value;  // a new speed: rev/min, or m/min at the surface (G96)
  bool surface;
  std::uint8_t number = 1;  // of the spindle
  std::uint8_t range = 0;   // gear range that follows from it; 0: none
  double rpm = 0;           // of a speed at the surface: what it makes where it is commanded
};
enum class Coolant : std::uint8_t { off, mist, flood };
struct CoolantSwitch {
  Coolant what;
};
/// Where a tool lies, for controls with a tool table (nct 12.3).
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
  bool there = false;  // nothing is changed: the program says which tool stands in the spindle (2С42 6.4.4)
};
/// M code for the machine.
struct MachineFunction {
  std::uint32_t code;
  std::optional<double> p{};  // words of a user macro (Mach3 M100 …)
  std::optional<double> q{};
  std::uint8_t spindle = 0;        // it acts on; 0: none
  std::optional<double> number{};  // of an output or input, and what it gets (spec/linuxcnc 8)
  std::optional<double> value{};
  bool by_control = false;  // the control carries it out itself, and the machine is told of it (nct 13.1: M2, M30, M98, M99)
};
/// A function on another address (nct 13.2).
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
  std::int32_t number = -1;  // -1: none
  bool asks = false;         // waits for an answer of the operator (#3107)
};
/// Channels have waited for each other; one for all of them (nct 14.5).
struct Sync {
  std::uint32_t code;
  std::vector<std::uint8_t> channels;  // in the order of arrival
  double at = 0;                       // s, time of release
};
/// Safety zones change (nct 22.2): G22 gives limits, G23 brings those of the parameters back.
struct ZoneChange {
  bool on = false;
  bool outside_forbidden = false;
  AxisMask axes = 0;           // with limits; the others are free
  Axes least{}, most{};        // of these, machine coordinates; infinite: no limit
  bool of_parameters = false;  // it is the zone of the parameters as they are now, in force or not; G23 brings it back
};
/// An electronic gearbox begins: the slave axis turns with a spindle and a third axis' travel beside its motions (nct 20.1).
struct Couple {
  std::string master, slave;      // spindle, axis
  double ratio = 1;               // revolutions of the slave for one of the master, signed
  double rpm = 0;                 // of the slave at the master's present speed, rev/min, signed
  bool feeds_by_slave = false;    // feed per revolution is that of the slave
  std::optional<double> phase{};  // of the slave at the zero pulse, degrees
  double helix = 0;               // degrees for a mm of `along`
  std::string along{};            // axis; empty: none
  int master_number = 0;          // of the spindle
};
struct Uncouple {
  std::string slave;
};
/// Round the corner at the tool's radius, about the programmed point (G39, nct 15.5.6).
struct ContourCorner {
  std::optional<Vec2> way{};  // I J K: the next motion goes that way; else as it does
};
/// How the compensated contour is checked from here on (nct 15.5.2, 15.5.7). Not a command to the machine.
struct ContourCheck {
  bool interference = false;  // N1403 #0 IEN
  bool always_alarm = false;  // #1 AAL: no correction is tried
  std::uint8_t further = 0;   // N1404: 0…8 blocks over and above three
  double least_step = 0;      // N1405 DELTV, mm: shorter steps round a corner are left out
  friend bool operator==(const ContourCheck&, const ContourCheck&) = default;
};
/// Compensation is interrupted: the tool's centre stands on the programmed point (nct 15.5.2); `off`: it is over (G40, 15.5.3).
/// `here`: the program takes the place where the tool stands, beside the contour, for its point (G92 after G40, Mach3 10.7.27).
/// Of a queued contour (LinuxCNC): the motion held back ends beside its point, before M0 too.
struct ContourBreak {
  bool off = false;
  bool here = false;
};
/// The frame of what follows, no command to the machine: `work` are the tool's coordinates from now on (2С42: but for a new length).
struct FrameChange {
  Placement placement;
  Axes work;
  std::shared_ptr<const Axes> shifted{};  // by G52, G92 …: part of the placement's origin; nullptr: not at all, or in its shift alone
};

struct Action {
  Origin origin;
  std::variant<Motion, Dwell, Spindle, Speed, CoolantSwitch, ToolSelect, ToolChange, MachineFunction, AuxiliaryFunction, Stop, Message,
               FrameChange, SurfaceSpeed, Sync, ZoneChange, Couple, Uncouple, ContourBreak, ContourCorner, ContourCheck>
      what;
};

/// Actions are emitted in batches. Clearing keeps the elements, so that a long run builds none anew.
class ActionBatch {
 public:
  Action& add() {
    if (end_ == actions_.size()) [[unlikely]]
      grow();
    return actions_[end_++];
  }
  /// One more before the first: once, until the batch is cleared.
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
  std::size_t begin_ = 1, end_ = 1;  // the first place is kept free
};

/// An alarm with its place, as people and traces see it.
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
    std::string file{};  // that the line stands in, if that is not the program itself; Control::calls_of() alone tells
  };
  std::vector<Call> calls;  // outermost first
  struct Line {
    std::uint32_t number = 0;  // 0: none
    std::string file, text;
    Span where{};
  };
  Line other{};            // a second place that belongs to it: the contour that is cut
  std::string own_text{};  // words of the program itself (#3000 of nct), longer than an argument of the alarm may be
};

/// What a probe motion met: handed back to `control` before the next block (design.md 1, the only backward arrow).
struct ProbeAnswer {
  bool touched = false;
  Axes at{};        // work coordinates where the motion ended
  double part = 1;  // of the way that was made
};

/// What was in force when a block had been carried out.
struct BlockState {
  std::vector<std::string> modal;  // code words, with F, S, T, D, H
  std::uint32_t tool = 0;          // in the spindle
  Axes origin{};                   // of the work system, all shifts included, machine coordinates
  Axes length{};                   // of the tool, by axis
};

/// State after a run: the last line of a trace.
struct Ending {
  Axes position{};  // work
  Axes machine_position{};
  std::vector<std::pair<std::string, double>> variables;    // "#100", "R2": all that are set
  std::vector<std::pair<std::string, bool>> watched_unset;  // asked for, not set
  std::vector<std::string> modal;                           // code words in force
};

}  // namespace kadr
