#pragma once
// Motion: a line, an arc, a spiral or a helix of the tool point, fully resolved; a plain value (design.md 1). Units as in action/action.h.

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "action/end_given.h"
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

}  // namespace kadr
