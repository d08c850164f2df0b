#pragma once
// What a control remembers, grouped by purpose: modal state, position, frames, tables.

#include <array>
#include <cstdint>
#include <memory>
#include <vector>

#include "action/action.h"
#include "base/vec.h"
#include "config/control/function.h"
#include "config/setup/setup.h"

namespace kadr {

enum class Plane : std::uint8_t { xy, zx, yz };  // G17, G18, G19

/// The axes of a plane, by index. A counter-clockwise rotation turns the first axis towards the second; the third is normal to the plane.
struct PlaneAxes {
  std::size_t first = 0, second = 1, normal = 2;
  friend bool operator==(const PlaneAxes&, const PlaneAxes&) = default;
};
inline PlaneAxes axes_of(Plane plane) {
  switch (plane) {
    case Plane::zx: return {2, 0, 1};
    case Plane::yz: return {1, 2, 0};
    default: return {0, 1, 2};
  }
}

/// The progress of cutter compensation, from G41, G42 to the motion that leaves the contour (2С42 6.4.7, Mach3 10.7.13).
enum class CompensationPhase : std::uint8_t {
  off,
  on,          // G41 or G42 has been executed; no motion in the plane has followed yet
  approached,  // the first motion in the plane, the approach to the contour, has followed G41 or G42
  following,   // further motions in the plane have followed the approach to the contour
  leaving,     // G40 has been executed; the tool remains offset from the contour until the next motion in the plane
};

enum class MotionMode : std::uint8_t { none, rapid, linear, arc_cw, arc_ccw, cycle };
enum class FeedMode : std::uint8_t { per_minute, per_revolution, inverse_time };

inline constexpr std::uint8_t feed_permission = 1;  // bit of Modal::override_permission that lets the operator change the feed

/// The modes that a block with only motions and feeds may change.
struct MotionModal {
  // for each modal group, the index in ControlDef::codes of the code in force; -1: no code is in force
  std::array<std::int16_t, most_groups> rows;
  std::int16_t motion_row = -1;
  MotionMode motion = MotionMode::none;
  bool feed_known = false;
  double feed = 0;  // feed in force in mm/min, mm/rev or 1/min, as Modal::feed_mode selects
  friend bool operator==(const MotionModal&, const MotionModal&) = default;
};

/// The modes that stay in force from block to block. `rows` has the code in force of each group; the other members have what these codes
/// mean.
struct Modal : MotionModal {
  Plane plane = Plane::xy;
  PlaneAxes axes;  // axes of the selected plane
  FeedMode feed_mode = FeedMode::per_minute;
  SpindleDir spindle = SpindleDir::stop;
  std::int8_t radius_side = 0;  // side of the contour on which the tool is: -1 left (G41), +1 right (G42), 0 no cutter compensation
  std::int8_t length_sign = 0;  // sign of the tool length: +1 for G43, -1 for G44, 0 without length compensation
  // +1 or -1: an axis corrector acts with its absolute value and this sign; 0: the corrector acts with the sign of its own value
  std::int8_t corrector_sign = 0;
  bool absolute = true;
  bool centers_absolute = false;
  bool inch = false;
  bool exact = false;           // exact stop mode is on: each motion ends with an exact stop
  bool retract_initial = true;  // G98: canned cycles return to the initial level; false (G99): to the R level
  bool polar = false;
  bool surface_speed = false;  // G96 (constant surface speed) is in force, so `rpm` is a surface speed in m/min
  bool mist = false;
  bool flood = false;
  bool override_enabled = true;
  std::uint8_t override_permission = 3;  // overrides that the operator may change, as bits: feed_permission for the feed, 2 for the spindle
  std::uint16_t work_zero = 0;           // number of the work offset; 0: none
  std::uint32_t fixture = 1;
  std::uint32_t offset_number = 0;  // number of the offset that word D has put into force
  std::uint32_t length_number = 0;  // number of the length offset by word H, on controls that have a separate word for the length
  std::uint32_t tool_selected = 0;
  std::uint32_t corrector = 0;  // number of the corrector in force: the last two digits of T0404
  std::uint32_t tool = 0;       // number of the tool in the spindle
  double radius_by_word = -1;   // tool radius in mm that word P of G41 or G42 gives; -1: the offset table gives the radius
  std::uint8_t nose = 0;        // imaginary tip of a turning tool (Motion::nose), used only with radius_by_word
  double blend_tolerance = 0;   // path tolerance in mm that word P of G64 gives
  double rpm = 0;
  double rpm_waiting = -1;     // spindle speed S in rev/min that applies from the next M3 or M4 on (2С42 6.4.3); -1: no speed is waiting
  Axes axis_feed{};            // by axis: the feed of this axis alone (GOST 20999-83), for the axes in feeds_of_axes
  AxisMask feeds_of_axes = 0;  // axes that have a feed of their own
  Vec2 pole;                   // pole of polar coordinates, in programmed coordinates, mm
  double polar_radius = 0;
  double polar_angle = 0;
  std::array<double, 3> pole_of{};  // coordinates X, Y, Z of the pole by G10 of GOST, mm
  Plane pole_plane = Plane::xy;     // plane in which the pole and the polar angle are given
  Plane pole_under = Plane::xy;     // plane in force when the program gave the pole
  CompensationPhase contour = CompensationPhase::off;
  // side (Motion::side) of the last motion with cutter compensation; 0 if no motion was compensated
  std::int8_t compensation_side = 0;
  CornerJoin corner_join = CornerJoin::arc;  // G36 or G37: how the path passes round the corners of a compensated contour
  Vec2 compensation_start;                   // end of the first motion of the compensated contour, programmed coordinates
  PlaneAxes compensation_axes;               // plane of the contour
  // vector in work coordinates from the contour's last point to the tool centre, as if the contour ended at that point
  Vec2 compensation_vector;
  bool off_contour_reported = false;  // the warning beside_contour has been reported since the last G41 or G42
  // nct
  std::uint8_t main_spindle = 1;  // number of the spindle that feed per revolution and threads follow (nct 11.4)
  bool turning_lengths = false;   // G43.7: length offsets of turning tools are in force
  double other_feed = 0;          // last feed with the unit that is not in force: that of G94 while G95 is in force, or of G95 while G94 is
  bool other_feed_known = false;
  bool polar_data = false;          // G16: polar coordinates are on
  bool polar_radius_given = false;  // a polar radius has been given since G16, or on GOST since the first G10
  // the polar radius was given as an absolute value, so the radius counts from the origin, not from the tool's position
  bool polar_radius_absolute = true;
  bool polar_angle_given = false;
  std::uint8_t smoothing = 0;                // smoothing mode: word Q of G5.1, 2 or 3
  PathSurface surface = PathSurface::plane;  // G12.1, G7.1
  double surface_radius = 0;                 // radius in mm of the cylinder of G7.1
  double surface_side = 1;                   // G12.1: +1 or -1, the sign of the linear axis's position when G12.1 was executed
  AxisMask diameter = 0;                     // axes in diameter programming, whose words give diameters
  Axes new_system{};                         // shift of the work system by G92 in each axis, mm or degrees
  Axes local{};                              // shift of the local system by G52 in each axis, mm or degrees
  Axes lengths{};                            // length offset that G43 or G44 has put into force on each axis, with its sign, mm
  friend bool operator==(const Modal&, const Modal&) = default;
};

/// Conversion from programmed to work coordinates. A point is scaled, then rotated (or rotated, then scaled), then mirrored, and then
/// shifted by the values of axis correctors. Each axis is converted separately, except the two axes of the plane that G68 rotates. The
/// transformation that was switched on first is the outermost (nct 16.0).
///   law  to_programmed(to_work(p)) == p, within the numerical tolerance
struct Transform {
  bool identity = true;
  Axes scale;        // scale factor of each axis; negative if the axis is mirrored
  Axes scale_shift;  // shift of each axis in mm that scaling causes: scaling centre · (1 - scale)
  // for each axis, shift in mm by axis correctors, or twice the coordinate of a mirror line (nct 16.3)
  Axes added;
  double rotation = 0;                 // angle of the rotation in degrees; positive from the first axis towards the second
  Vec2 rotation_center;                // centre of the rotation, mm
  std::uint8_t first = 0, second = 1;  // indices of the two axes of the plane that G68 rotates
  // order of the transformations: true: a point is scaled, then rotated; false: rotated, then scaled
  bool turned_last = true;
  bool scaling = false, turning = false;     // on the NCT, G51 or G68 is in force, even if the code changes no coordinate
  std::array<std::int8_t, max_axes> mirror;  // for each axis: -1 if the axis is mirrored, otherwise +1

  Transform();
  void refresh();  // sets `identity` and the rotation's sine and cosine
  Axes to_work(const Axes& programmed) const;
  Axes to_programmed(const Axes& work) const;
  /// Returns the axes that move if the axes `named` are programmed. Under G68, both axes of the rotated plane move if one of them is
  /// programmed.
  AxisMask moved_with(AxisMask named) const;

  // ---- effect of the transformation in a plane

  /// Returns true if a rotation in another plane moves points of this plane out of it.
  bool leaves(PlaneAxes plane) const;
  /// Returns true if the transformation mirrors the plane, so that a contour is traversed in the opposite sense (negative determinant).
  bool reverses(PlaneAxes plane) const { return sign(plane.first) * sign(plane.second) < 0; }
  /// Returns true if the two axes of the plane have different scale factors: a circle then becomes an ellipse.
  bool distorts(PlaneAxes plane) const;
  /// Converts a point of the plane, in mm. The third coordinate is not needed if the transformation does not leave the plane.
  Vec2 to_work(Vec2 programmed, PlaneAxes plane) const;
  /// Converts a direction in the plane: mirrors and rotates it, without scaling (nct 15.5.6).
  Vec2 direction(Vec2 vector, PlaneAxes plane) const;
  /// Returns the factor for the size of a rounding or chamfer at a corner: the mean of the absolute scale factors of the two axes (nct
  /// 16.2).
  double corner_scale(PlaneAxes plane) const;
  /// Returns the factor for the radius of an arc: the absolute scale factor of the first axis of the plane (nct 16.2).
  double radius_scale(PlaneAxes plane) const;
  friend bool operator==(const Transform&, const Transform&) = default;

 private:
  int sign(std::size_t axis) const { return scale[axis] * mirror[axis] < 0 ? -1 : 1; }
  void turn(Axes& at, SinCos by) const;
  SinCos turn_;
};

struct ProgramPosition {
  Axes programmed{};  // the tool's position in programmed coordinates
  Axes work{};        // the tool's position in coordinates of the work system in force
  Axes machine{};
};

/// The tables that a program reads and, by G10, writes.
struct Tables {
  std::vector<ToolOffset> offsets;                  // tool offsets by number; [0] is unused
  std::vector<Axes> zeros = std::vector<Axes>(10);  // work offsets by number from 1 on; [0] is unused
  // for each work offset, the angles in degrees of its basic rotation in G17, G18, G19 (nct 10.2.3)
  std::vector<Vec3> rotations;
  Axes common{};  // common work offset
  std::vector<double> correctors;
  std::array<Axes, 5> reference{};  // reference points 1…4, machine coordinates
  friend bool operator==(const Tables&, const Tables&) = default;
};

/// The words of a drilling cycle that remain valid while blocks of the same cycle follow ("sticky", spec/mach3 4).
struct CycleMemory {
  std::int16_t row = -1;         // row of the drilling cycle in ControlDef::codes; -1: no cycle is in force
  std::uint64_t known = 0;       // letters of the cycle's words that have a value, one bit per letter
  double bottom = 0, level = 0;  // words Z (bottom of the hole) and R (level) as programmed, mm
  double peck = 0, dwell = 0;
  double i = 0, j = 0, k = 0;
};

/// The state that a block changes and that an alarm in the block restores, as one value. ControlState is a base class of Interpreter. Other
/// data that a block writes are recorded in its Journal.
struct ControlState {
  Modal modal;
  Transform transform;
  ProgramPosition position;
  Placement frames;
  CycleMemory cycle_memory;
  Axes set_position{};               // shift of the work system by G92 or G52 on Mach3, mm
  bool set_position_by_g52 = false;  // true: G52 has set the shift set_position; false: G92 has set it
  Axes zero_shift{};                 // additional temporary shift of the work system (G92 of the 2С42 and GOST)
};

}  // namespace kadr
