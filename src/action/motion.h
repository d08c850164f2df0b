#pragma once
// Motion: a line, an arc, a spiral, a helix or a spline of the tool point, fully resolved; a plain value. The units are those of
// action/action.h.

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "action/end_reference.h"
#include "base/vec.h"

namespace kadr {

enum class FeedUnit : std::uint8_t { mm_per_min, mm_per_rev, per_min };
enum class MotionKind : std::uint8_t { rapid, feed, arc_cw, arc_ccw, probe, home, thread, spline };
inline bool is_arc(MotionKind kind) { return kind == MotionKind::arc_cw || kind == MotionKind::arc_ccw; }

/// The length along which the commanded feed is measured.
enum class FeedAlong : std::uint8_t {
  path,  // the travel of the linear axes; if only rotary axes move, their travel (NIST 2.1.2.5)
  turn,  // the angle of a spiral in the plane: the angle advances evenly, at the rate that the feed gives at the spiral's start (nct 4.3)
  arc,   // length of the arc in its plane, without the travel of a helix along its axis (nct 4.3.2, HEF=0)
  all_axes,  // travel of all axes; a millimetre and a degree count alike (nct 4.2)
  xyz,       // travel of X, Y, Z; if they do not move, of the other linear axes; else of the rotary axes (spec/linuxcnc 7.2)
};

/// The surface of the programmed path: a plane of two axes, or the plane of polar interpolation, or a cylinder (nct 4.5, 4.6).
enum class PathSurface : std::uint8_t { plane, polar, cylinder };

/// What a motion in the plane changes in cutter compensation (nct 15.5.1, 15.5.3).
enum class SideStep : std::uint8_t {
  none,
  begins,  // compensation starts: G41 or G42 is in the motion's block
  begun,   // compensation starts with this motion, because the earlier block with G41 or G42 did not move in the plane
  ends,    // compensation ends: G40 is in the motion's block
  holds,   // G38: the offset vector at the motion's end is the same as at the motion's start
};

/// The path around an outside corner under cutter compensation.
enum class CornerJoin : std::uint8_t {
  extended,  // the path follows the tangents of both path elements at the corner; it cuts off the tip of a sharp corner (nct 15.5.2)
  arc,       // the path is an arc about the programmed point (2С42 G36, Mach3)
  straight,  // the path follows both offset lines to their intersection (2С42 G37)
  open,      // both path elements are followed to their ends, inside corners too, with a straight move between them (spec/heidenhain 7.6)
};

/// The speed control where two motions meet (nct 6.3).
enum class CornerSpeed : std::uint8_t {
  limited,       // the control's usual speed limits apply at the corner (G64, G61)
  inner_slower,  // the usual speed limits apply, and motions are also slower near inside corners (G62)
  kept,          // the speed is not reduced at the corner (G63)
};

/// The point at which the first compensated motion ends.
enum class CompensationApproach : std::uint8_t {
  by_corner,  // the point from which the tool passes the corner to the next motion (nct 15.5.1)
  normal,     // a point on the normal to the next path element, through the programmed point (2С42 6.4.7)
  tangent,    // a point such that the tool touches the line to the programmed point over its whole length (Mach3, RS274/NGC)
  // the point of `normal`; all other rules are those of `by_corner`, except that the last compensated motion ends on the normal to its own
  // end (type A, fanuc-t 7.3)
  square,
  around,  // as `normal`, but from a point behind the contour the tool moves around the contour's first corner (KONT, spec/sinumerik 13.2)
};

/// An axis that copies the travel of another axis, its master (nct 20.2).
struct Follower {
  std::uint8_t axis = 0;
  std::uint8_t master = 0;
  double sign = 1;  // factor for the travel; -1: the follower moves in the opposite direction
};

/// The line or circle that a motion in the plane lies on. It is needed if the start or end of the motion has to be calculated (nct 17.3).
enum class SupportingCurve : std::uint8_t {
  none,    // no line or circle is needed: the ends of the motion are given, and nothing is calculated
  ray,     // a line with a known start and direction; the line ends where the next motion starts
  line,    // a line with a known end and direction; the line starts at its intersection with the previous motion
  circle,  // an arc with a known end and centre; the arc starts at its intersection with the previous motion
};

/// The chamfer, rounding or intersection at the ends of a motion in the plane (nct 17). path/compensation/corner_resolver computes the
/// corners from these data.
struct CornerData {
  double chamfer = 0;   // leg of the chamfer at the motion's end, mm; 0: there is no chamfer
  double rounding = 0;  // radius of the rounding at the motion's end, mm; 0: there is no rounding
  SupportingCurve on = SupportingCurve::none;
  Vec2 direction;        // unit vector in the direction of a line whose start or end has to be calculated (SupportingCurve::ray, line)
  double radius = 0;     // radius of an arc whose start has to be calculated (SupportingCurve::circle), mm
  bool farther = false;  // true: if the two path elements have two intersections, the second one is used (Q above 0)
  // true: the programmed plane is mirrored, so an arc that is clockwise in the program is executed counter-clockwise
  bool mirrored = false;
  bool optional = false;  // true: modal, so the corner stays as programmed where no motion of the plane follows (spec/sinumerik 12.4)
  bool square = false;    // the next motion must be a line at a right angle to this one (spec/fanuc-t 3.4)
  double feed = 0;        // feed of the chamfer or rounding, in the unit of the motion's feed; 0: that of the motion
};

/// Computes the positions of the tool tip and of the rotary axes along a motion with tool centre point control. It is needed only for modes
/// in which the motion's curve, with an even travel of the rotary axes, does not determine these positions: tool posture control and
/// cutting point control (nct 25.15 to 25.17). Implemented in kinematics/five_axis_tip_path.
class TipPath {
 public:
  virtual ~TipPath() = default;
  /// Returns the work coordinates of the tip and the positions of the rotary axes at `part`. `on_curve` is the point of the motion's curve
  /// at `part`.
  virtual Axes at(double part, const Axes& on_curve) const = 0;
  /// Returns the surface normal at the cutting point, in the work system; the zero vector if the mode has no cutting point.
  virtual Vec3 normal(double /*part*/) const { return {}; }
};

class PlaneSpline;

/// The segment of a spline that the motion follows: the curve in the motion's plane (work coordinates), and the two fractions (0 to 1) of
/// the curve's length between which the segment lies.
struct SplinePart {
  std::shared_ptr<const PlaneSpline> curve;
  double from = 0, to = 1;
};

/// Data that only few motions have, so that a Motion stays small.
struct MotionDetail {
  AxisMask rolled = 0;  // rotary axes that roll over at 360°; `travel` is their signed travel, degrees (nct 5.6)
  Axes travel{};
  PathSurface surface = PathSurface::plane;
  Vec2 flat_from;               // start point, mm: in the programmed plane (polar interpolation) or on the unrolled surface (cylinder)
  Vec2 flat_to;                 // end point, mm, in the same plane or on the same surface as flat_from
  double radius = 0;            // radius of the cylinder, mm
  double side = 1;              // only for polar interpolation: sign of the position that the linear axis had at G12.1
  double offset = 0;            // only for polar interpolation: perpendicular offset of the rotation centre from the linear axis, mm
  double max_rotary_speed = 0;  // only for polar interpolation: greatest speed of the rotary axis, degrees/min; 0: no limit
  Axes programmed{};            // end point of the motion in the coordinates that the program's words have
  bool has_programmed = false;
  std::optional<double> lead;         // lead of a thread: travel per revolution, mm
  std::optional<double> start_angle;  // angle of the spindle at the start of the thread, degrees
  std::optional<double> turn;         // rotation of the spindle during the motion, degrees, signed
  std::optional<double> torque;       // torque limit of a probe motion, %
  int input = 0;  // number of the signal that ends a probe motion: 1 to 8 a probe input, 98 the torque limit, 0 any input
  std::optional<Vec2> direction_vector;  // I J K of G41, G42, G40: direction of the approach to the contour, or of the departure
  // Axes that copy the travel of another axis, each listed after its master; the path's length does not include their travel
  std::vector<Follower> followers;
  std::shared_ptr<const TipPath> tip_path;
  AxisMask parked = 0;  // axes that the machine's logic has parked: these axes do not move, only their positions are calculated (nct 20.2)
  bool evenly = false;  // all axes move evenly in this motion, although tool centre point control is in force (G53, nct 25.2)
  std::optional<CornerData> contour;
  SplinePart spline;  // only for MotionKind::spline
};

/// What a drilling cycle does during a motion, in addition to cutting.
enum class HoleWork : std::uint8_t {
  none,
  taps,           // tapping: the spindle rotates in the direction that the thread requires
  clear_of_wall,  // the spindle is oriented, and its single cutting edge does not touch the wall (fine boring, back boring)
};

/// Everything about the path of a motion except its end point.
struct MotionPath {
  MotionKind kind = MotionKind::rapid;
  std::uint8_t first = 0;   // index of the first axis of an arc's plane; counter-clockwise means from the first axis towards the second
  std::uint8_t second = 1;  //
  EndReference end_reference = EndReference::by_work;
  AxisMask named = 0;  // axes whose position the block states
  Vec2 center;         // centre of an arc, in the two axes of its plane, work coordinates
  double turns = 0;    // swept angle / 360°, positive; the radius changes linearly with the angle
  // true: the end point equals the coordinates that the program states; set only on controls with rotated frames (nct 25)
  bool as_programmed = false;
  bool inch = false;       // the lengths of the block were stated in inches
  AxisMask diameters = 0;  // axes whose words state diameters
};

/// The feed of a motion, and how exactly the motion follows its path.
struct MotionFeed {
  double feed = 0;       // commanded feed, in `unit`
  double tolerance = 0;  // deviation from the path, mm, that constant-velocity mode permits at corners; 0: the program does not state it
  double join = 0;       // straight motions whose travel is no longer than this in any axis (mm) are joined into one (nct 4.7, N3103)
  FeedUnit unit = FeedUnit::mm_per_min;
  FeedAlong along = FeedAlong::path;
  CornerSpeed corner_speed = CornerSpeed::limited;
  std::uint8_t spindle = 1;    // number of the spindle whose revolutions a feed per revolution or a thread counts
  std::uint8_t smoothing = 0;  // smoothing mode in force, Q of G5.1: 2 smooth, 3 fine (nct 4.7); 0: no smoothing
  bool exact = false;          // the axes stop exactly at the end of the motion
  bool own_override = false;   // the overrides of feed and spindle act as 100 % (tapping, threads, G23, M49)
  bool no_hold = false;        // the operator's feed hold does not stop the motion either (nct 6.3.4)
  bool in_position = false;    // the axes must be within the in-position window at the end of the motion (nct 4.1.1, 6.3)
};

/// The side of the programmed path on which the tool is, and how the tool reaches this side.
struct MotionCompensation {
  double tool_radius = 0;           // radius of the tool at the end of the motion, mm
  std::uint16_t radius_offset = 0;  // row of the offset table that gives the radius while compensation is on; 0: no row
  std::int8_t side = 0;             // +1: the tool is left of the path, -1: right, 0: no compensation
  // Number of the imaginary tip of a turning tool (spec/fanuc-t 7.1). The motion is the path of this tip. With 0 or 9, it is the path of
  // the nose centre (path/compensation/nose_tip.h).
  std::uint8_t nose = 0;
  SideStep side_step = SideStep::none;
  CornerJoin join_corner = CornerJoin::extended;  // shape of the corner between this motion and the next motion
  bool corner_first = false;  // actions between this motion and the next motion of the contour come after the way around their corner
  // first compensated position; only for a motion with which compensation starts
  CompensationApproach entry = CompensationApproach::by_corner;
};

/// The work offset, tool length and drilling cycle that a motion belongs to.
struct MotionContext {
  std::uint16_t system = 0;         // row in force of the table of work offsets or fixtures (config/setup/setup_names); 0: no row
  std::uint16_t length_offset = 0;  // row of the offset table that gives the tool length in force; 0: no row
  HoleWork in_hole = HoleWork::none;
  bool of_cycle = false;  // a canned cycle created the motion
};

/// All that the modes and words of a block determine about its motion, except the end point. `MotionModes{}` is a rapid without any mode in
/// force.
struct MotionModes : MotionPath, MotionContext, MotionFeed, MotionCompensation {};

/// A motion of the tool point along a line, an arc, a spiral, a helix or a spline.
struct Motion : MotionModes {
  std::shared_ptr<const MotionDetail> detail;  // nullptr for most motions
  Axes to{};                                   // end point, work coordinates
  Axes machine{};                              // end point, machine coordinates
};

}  // namespace kadr
