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

#include "action/end_given.h"
#include "action/origin.h"
#include "action/placement.h"
#include "action/surface_speed.h"
#include "base/alarm.h"
#include "base/span.h"
#include "base/vec.h"

namespace kadr {

enum class FeedUnit : std::uint8_t { mm_per_min, mm_per_rev, per_min };
enum class MotionKind : std::uint8_t { rapid, feed, arc_cw, arc_ccw, probe, home, thread, spline };
inline bool is_arc(MotionKind kind) { return kind == MotionKind::arc_cw || kind == MotionKind::arc_ccw; }

/// What the commanded feed is measured along.
enum class FeedAlong : std::uint8_t {
  path,      // the linear axes; where only rotary axes move, their way (NIST 2.1.2.5)
  turn,      // of an arc whose radius changes: its angle goes evenly, at its start with the feed (nct 4.3)
  arc,       // of a helix: the arc in its plane, the other axes keep pace (nct 4.3.2, HEF=0)
  all_axes,  // millimetres and degrees alike (nct 4.2)
  xyz,       // X, Y, Z where they move, else the other linear axes, else the rotary ones (spec/linuxcnc 7.2)
};

/// Where the programmed plane lies when it is not a plane of the axes (nct 4.5, 4.6).
enum class PathSurface : std::uint8_t { plane, polar, cylinder };

/// What a motion in the plane does to cutter radius compensation (nct 15.5.1, 15.5.3).
enum class SideStep : std::uint8_t {
  none,
  begins,  // G41, G42 in its block
  begun,   // in a block before, that did not move in the plane
  ends,    // G40 in its block
  holds,   // G38: it ends with the vector that it begins with
};

/// How the offset path goes round an outside corner.
enum class CornerJoin : std::uint8_t {
  extended,  // straight lines, a sharp corner cut off (nct 15.5.2)
  arc,       // about the programmed point (2С42 G36, Mach3)
  straight,  // up to the intersection of the lines (2С42 G37)
};

/// How the speed is controlled where motions meet (nct 6.3).
enum class CornerSpeed : std::uint8_t {
  limited,       // as the control's limits say (G64, G61)
  inner_slower,  // and slower near inner corners (G62)
  kept,          // not slowed down (G63)
};

/// Where the first compensated motion ends.
enum class ContourEntry : std::uint8_t {
  by_corner,  // as the corner to the next one says (nct 15.5.1)
  normal,     // on the normal to the next element (2С42 6.4.7)
  tangent,    // the tool touches the line to the programmed point all along its way (Mach3, RS274/NGC)
};

/// An axis that copies another's way (nct 20.2).
struct Follower {
  std::uint8_t axis = 0;
  std::uint8_t master = 0;
  double sign = 1;  // -1: the other way round
};

/// What a motion in the plane lies on, where its start or end is to be calculated (nct 17.3).
enum class SupportingCurve : std::uint8_t {
  none,    // its ends say it
  way,     // a line from its start: only its direction is known, its end is where the next motion begins
  line,    // over-determined: the line through its end; it begins where that meets the motion before
  circle,  // over-determined: the circle about its centre; the same
};

/// How a motion meets its neighbours in the plane (nct 17); path/contour/contour_corners uses it up.
struct ContourData {
  double chamfer = 0;   // leg of the chamfer at its end, mm; 0: none
  double rounding = 0;  // radius of the rounding there, mm; 0: none
  SupportingCurve on = SupportingCurve::none;
  Vec2 direction;         // of `way` and `line`: unit vector
  double radius = 0;      // of `circle`, mm
  bool farther = false;   // of two intersections the second (Q above 0)
  bool mirrored = false;  // the programmed plane is: its clockwise is counter-clockwise here
};

/// Where the tool is along a motion that leads its tip, where that is not what the motion's curve and the rotary axes' even way say: tool
/// posture control, cutting point control (nct 25.15 to 25.17). kinematics/tip_ways has them.
class TipWay {
 public:
  virtual ~TipWay() = default;
  /// Work coordinates of tip and rotary axes at the part where the curve is at `on_curve`.
  virtual Axes at(double part, const Axes& on_curve) const = 0;
  /// Of the surface at the cutting point, in the work system; {}: there is none.
  virtual Vec3 normal(double /*part*/) const { return {}; }
};

class PlaneSpline;

/// What of a curve in the motion's plane (work coordinates) the motion goes along: between two parts of its length.
struct SplinePart {
  std::shared_ptr<const PlaneSpline> curve;
  double from = 0, to = 1;
};

/// What only few motions have.
struct MotionDetail {
  AxisMask rolled = 0;  // rotary axes that roll over: `travel` is their signed way, degrees (nct 5.6)
  Axes travel{};
  PathSurface surface = PathSurface::plane;
  Vec2 flat_from;          // polar: the programmed plane, mm; cylinder: the unrolled surface, mm
  Vec2 flat_to;            // (the arc's centre and turns stand in it too)
  double radius = 0;       // of the cylinder, mm
  double side = 1;         // polar: sign of the linear axis at G12.1
  double offset = 0;       // polar: perpendicular offset of the rotation centre, mm
  double rotary_most = 0;  // polar: degrees/min, 0: no limit
  Axes programmed{};       // end point as the program's words mean it
  bool has_programmed = false;
  std::optional<double> lead;         // of a thread, mm
  std::optional<double> start_angle;  // of the spindle at its start, degrees
  std::optional<double> turn;         // degrees the spindle turns with it, signed
  std::optional<double> torque;       // limit of a probe motion, %
  int input = 0;                      // of a probe motion: 1 to 8; 98: torque; 0: any
  std::optional<Vec2> way;            // I J K of G41, G42, G40: direction of the way in or out
  std::vector<Follower> followers;    // each after its master; their way is no part of the path
  std::shared_ptr<const TipWay> tip_way;
  AxisMask parked = 0;  // axes that stand, as the machine's logic has parked them: only calculated (nct 20.2)
  bool evenly = false;  // the axes go evenly, although the tip is led by other motions (G53, nct 25.2)
  std::optional<ContourData> contour;
  SplinePart spline;  // of MotionKind::spline
};

/// What a drilling cycle does beside cutting while it carries a motion out.
enum class HoleWork : std::uint8_t {
  none,
  taps,        // the spindle turns either way, as the thread wants it
  stands_off,  // the spindle is oriented, its one edge away from the wall (fine boring, back boring)
};

/// The form of a motion: what of its path is not its end.
struct MotionPath {
  MotionKind kind = MotionKind::rapid;
  std::uint8_t first = 0;   // axes of an arc's plane, by index: counter-clockwise turns the first towards the second
  std::uint8_t second = 1;  //
  EndGiven end_given = EndGiven::by_work;
  AxisMask named = 0;          // axes whose position it gives
  Vec2 center;                 // of an arc: of its first and second axis, work coordinates
  double turns = 0;            // swept angle / 360, positive; the radius changes linearly with the angle
  bool as_programmed = false;  // its end is what the program's words say: reported where frames in space may be (nct 25)
  bool inch = false;           // its block was read in inches
};

/// How fast a motion goes, and how exactly.
struct MotionFeed {
  double feed = 0;       // as commanded, in `unit`
  double tolerance = 0;  // mm; how far the path may be rounded in constant-velocity mode; 0: not stated
  double join = 0;       // mm; straight motions no longer than this in any axis are made as one (nct 4.7, N3103)
  FeedUnit unit = FeedUnit::mm_per_min;
  FeedAlong along = FeedAlong::path;
  CornerSpeed corner_speed = CornerSpeed::limited;
  std::uint8_t spindle = 1;    // whose turns a feed per revolution and a thread count
  std::uint8_t smoothing = 0;  // Q of G5.1 in force for it: 2 smooth, 3 fine (nct 4.7); 0: none
  bool exact = false;          // exact stop at its end
  bool own_override = false;   // feed and spindle override count as 100 % (tapping, threads, G23, M49)
  bool no_hold = false;        // nor does the operator's feed stop act (nct 6.3.4)
  bool in_position = false;    // at its end the axes must come into position (nct 4.1.1, 6.3)
};

/// On which side of the programmed path the tool goes, and how it comes there.
struct MotionCompensation {
  double tool_radius = 0;           // mm, at its end
  std::uint16_t radius_offset = 0;  // row of the offset table, where the tool is on a side of the path; 0: none
  std::int8_t side = 0;             // of the path that the tool is on: +1 left, -1 right; 0: no compensation
  std::uint8_t nose = 0;            // orientation of a turning tool: whose tip is led, spec/linuxcnc 9; 0, 9: its centre is
  SideStep side_step = SideStep::none;
  CornerJoin join_corner = CornerJoin::extended;  // with the next motion
  ContourEntry entry = ContourEntry::by_corner;   // where it begins compensation
};

/// What a motion belongs to: work system, tool length, drilling cycle.
struct MotionContext {
  std::uint16_t system = 0;         // work system in force: row of the table of zeros or fixtures, config/setup_names; 0: none
  std::uint16_t length_offset = 0;  // row of the offset table whose length is in force; 0: none
  HoleWork in_hole = HoleWork::none;
  bool of_cycle = false;  // a drilling cycle has made it
};

/// What of a motion its block's modes and words say, but for where it goes. `MotionModes{}` is a rapid motion in which nothing is in force.
struct MotionModes : MotionPath, MotionContext, MotionFeed, MotionCompensation {};

/// A motion along a line, an arc, a spiral or a helix, of the tool point.
struct Motion : MotionModes {
  std::shared_ptr<const MotionDetail> detail;  // mostly nullptr
  Axes to{};                                   // work coordinates at its end
  Axes machine{};                              // machine coordinates at its end
};

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
