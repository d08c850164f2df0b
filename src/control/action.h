#pragma once
// Action: one elementary thing the machine is to do, fully resolved; a plain value (design.md 1).
// Lengths mm, angles degrees, times s. Axis values stand in the order of the control's axis names.

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "base/alarm.h"
#include "base/span.h"
#include "base/vec.h"

namespace kadr {

/// Where an action comes from: the innermost block of the user's program.
struct Origin {
  std::uint32_t line = 0;
  std::uint32_t column = 0;  // counted from 1, in characters
  std::uint32_t block = 0;   // N…
  bool has_block = false;
  bool main_block = false;        // ':' instead of N
  std::uint8_t block_digits = 0;  // as written, zeros included
  std::uint8_t depth = 0;         // calls around it
};

enum class Plane : std::uint8_t { xy, zx, yz };  // G17, G18, G19
enum class FeedUnit : std::uint8_t { mm_per_min, mm_per_rev, per_min };
enum class MotionKind : std::uint8_t { rapid, feed, arc_cw, arc_ccw, probe, home };

/// A motion along a line, an arc or a helix, of the tool point.
struct Motion {
  MotionKind kind = MotionKind::rapid;
  Plane plane = Plane::xy;  // of arcs; directions as seen from the positive end of its normal
  FeedUnit unit = FeedUnit::mm_per_min;
  bool exact = false;    // exact stop at its end
  AxisMask named = 0;    // axes whose position it gives anew
  Axes to;               // work coordinates at its end
  Axes machine;          // machine coordinates at its end
  Vec3 center;           // of an arc, work coordinates
  double turns = 0;      // swept angle / 360, positive
  double feed = 0;       // as commanded, in `unit`
  double tolerance = 0;  // mm; how far the path may be rounded in constant-velocity mode; 0: not stated
};

struct Dwell {
  double seconds;
};
enum class SpindleDir : std::uint8_t { stop, cw, ccw, orient };
struct Spindle {
  SpindleDir dir;
  double rpm;
};  // rev/min
struct Speed {
  double value;
  bool surface;
};  // a new speed: rev/min, or m/min at the surface (G96)
enum class Coolant : std::uint8_t { off, mist, flood };
struct CoolantSwitch {
  Coolant what;
};
struct ToolSelect {
  std::uint32_t tool;
  std::uint32_t corrector;
};
struct ToolChange {
  std::uint32_t tool;
};
struct MachineFunction {
  std::uint32_t code;         // M code for the machine
  std::optional<double> p{};  // words of a user macro (Mach3 M100 …)
  std::optional<double> q{};
};  // M code for the machine
struct Stop {
  bool optional;
};
struct Message {
  std::string text;
};
/// The frame of what follows: machine = work + origin + length. Not a command to the machine: the tool stands, `work` are
/// its coordinates from now on (a length that is taken out by the next motion only, 2С42, leaves them as they were).
struct FrameChange {
  Axes origin;
  Axes length;
  Axes work;
};

struct Action {
  Origin origin;
  std::variant<Motion, Dwell, Spindle, Speed, CoolantSwitch, ToolSelect, ToolChange, MachineFunction, Stop, Message, FrameChange> what;
};

/// Actions are handed on in batches. Clearing keeps the elements, so that a long run builds none anew.
class ActionBatch {
 public:
  Action& add() {
    if (size_ == actions_.size()) actions_.emplace_back();
    return actions_[size_++];
  }
  void clear() { size_ = 0; }
  void cut(std::size_t size) { size_ = size; }
  std::size_t size() const { return size_; }
  bool empty() const { return size_ == 0; }
  Action& operator[](std::size_t i) { return actions_[i]; }
  Action& back() { return actions_[size_ - 1]; }
  Action* begin() { return actions_.data(); }
  Action* end() { return actions_.data() + size_; }
  const Action* begin() const { return actions_.data(); }
  const Action* end() const { return actions_.data() + size_; }

 private:
  std::vector<Action> actions_;
  std::size_t size_ = 0;
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
  };
  std::vector<Call> calls;  // outermost first
};

/// What a probe motion met: handed back to `control` before the next block (design.md 1, the only backward arrow).
struct ProbeAnswer {
  bool touched = false;
  Axes at{};  // work coordinates where the motion ended
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
