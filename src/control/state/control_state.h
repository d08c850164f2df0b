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
  on,          // after G41, G42: no motion in the plane has followed
  approached,  // after the first motion in the plane
  following,   // after further motions in the plane
  leaving,     // after G40: the tool is still offset from the contour, until the next motion in the plane
};

enum class MotionMode : std::uint8_t { none, rapid, linear, arc_cw, arc_ccw, cycle };
enum class FeedMode : std::uint8_t { per_minute, per_revolution, inverse_time };

inline constexpr std::uint8_t feed_permission = 1;  // bit of Modal::override_permission that lets the operator change the feed

/// The modes that a block with only motions and feeds may change.
struct MotionModal {
  std::array<std::int16_t, most_groups> rows;  // by modal group: index in ControlDef::codes of the code in force; -1: none
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
  std::int8_t radius_side = 0;  // side of the tool: -1 left (G41), +1 right (G42), 0 no compensation
  std::int8_t length_sign = 0;  // +1 G43, -1 G44, 0 no length compensation
  // +1 or -1: an axis corrector acts with its absolute value and this sign; 0: the corrector acts with its own sign
  std::int8_t corrector_sign = 0;
  bool absolute = true;
  bool centers_absolute = false;
  bool inch = false;
  bool exact = false;           // exact stop mode
  bool retract_initial = true;  // G98: canned cycles return to the initial level
  bool polar = false;
  bool surface_speed = false;  // G96 is in force (constant surface speed): `rpm` is in m/min
  bool mist = false;
  bool flood = false;
  bool override_enabled = true;
  std::uint8_t override_permission = 3;  // overrides that the operator may change, as bits: feed_permission for the feed, 2 for the spindle
  std::uint16_t work_zero = 0;           // number of the work offset; 0: none
  std::uint32_t fixture = 1;
  std::uint32_t offset_number = 0;  // D: number of the offset in force
  std::uint32_t length_number = 0;  // H: number of the length offset, on controls that have a separate word for it
  std::uint32_t tool_selected = 0;
  std::uint32_t corrector = 0;  // number of the corrector in force: the last two digits of T0404
  std::uint32_t tool = 0;       // number of the tool in the spindle
  double radius_by_word = -1;   // tool radius in mm by P of G41, G42; -1: the tool radius is in the table
  std::uint8_t nose = 0;        // orientation of a turning tool, used only with radius_by_word (spec/linuxcnc 9)
  double blend_tolerance = 0;   // path tolerance in mm by P of G64
  double rpm = 0;
  double rpm_waiting = -1;     // spindle speed S that applies from the next M3 or M4 on (2С42 6.4.3); -1: none
  Axes axis_feed{};            // by axis: the feed of this axis alone (GOST 20999-83), for the axes in feeds_of_axes
  AxisMask feeds_of_axes = 0;  // axes that have a feed of their own
  Vec2 pole;                   // pole of polar coordinates, in programmed coordinates, mm
  double polar_radius = 0;
  double polar_angle = 0;
  std::array<double, 3> pole_of{};  // G10 of GOST: coordinates X, Y, Z of the pole, mm
  Plane pole_plane = Plane::xy;     // plane in which the pole and the polar angle are given
  Plane pole_under = Plane::xy;     // plane in force when the program gave the pole
  CompensationPhase contour = CompensationPhase::off;
  std::int8_t compensation_side = 0;         // Motion::side of the last compensated motion; 0 if no motion was compensated
  CornerJoin corner_join = CornerJoin::arc;  // type of corner of a compensated contour: G36, G37
  Vec2 compensation_start;                   // end of the first motion of the compensated contour, programmed coordinates
  PlaneAxes compensation_axes;               // plane of the contour
  Vec2 compensation_vector;           // vector in work coordinates from the contour's last point to the tool, as if the contour ended there
  bool off_contour_reported = false;  // the warning beside_contour has been reported for this contour
  // nct
  std::uint8_t main_spindle = 1;  // nct 11.4: number of the spindle for feed per revolution and for threads
  bool turning_lengths = false;   // G43.7: length offsets of turning tools are in force
  double other_feed = 0;          // last feed of the unit that is not in force: of G94 while G95 is in force, and vice versa
  bool other_feed_known = false;
  bool polar_data = false;            // G16: polar coordinates are on
  bool polar_radius_given = false;    // a radius was given since G16; on GOST, since the first G10
  bool polar_radius_absolute = true;  // the polar radius was given as an absolute value
  bool polar_angle_given = false;
  std::uint8_t smoothing = 0;                // Q of G5.1: 2 or 3
  PathSurface surface = PathSurface::plane;  // G12.1, G7.1
  double surface_radius = 0;                 // radius in mm of the cylinder of G7.1
  double surface_side = 1;                   // G12.1: +1 or -1, the sign of the linear axis's position when G12.1 was executed
  AxisMask diameter = 0;                     // axes whose words give diameters
  Axes new_system{};                         // shift by G92, mm or degrees
  Axes local{};                              // shift by G52, mm or degrees
  Axes lengths{};                            // length offsets by G43, G44 on each axis, with their sign
  friend bool operator==(const Modal&, const Modal&) = default;
};

/// Conversion from programmed to work coordinates. A point is scaled, then rotated (or rotated, then scaled), then mirrored, and then
/// shifted by the values of axis correctors. Each axis is converted separately, except the two axes of a rotation. The transformation that
/// was switched on first is the outermost (nct 16.0).
///   law  to_programmed(to_work(p)) == p, within the numerical tolerance
struct Transform {
  bool identity = true;
  Axes scale;                                // scale factor of each axis; negative if the axis is mirrored
  Axes scale_shift;                          // shift of each axis by scaling, mm: scaling centre · (1 - scale)
  Axes added;                                // shift in mm by axis correctors, or twice the coordinate of a mirror line (nct 16.3)
  double rotation = 0;                       // angle in degrees; positive from the first axis towards the second
  Vec2 rotation_center;                      // centre of the rotation, mm
  std::uint8_t first = 0, second = 1;        // indices of the axes of the rotation
  bool turned_last = true;                   // true: a point is scaled, then rotated; false: rotated, then scaled
  bool scaling = false, turning = false;     // nct: G51 or G68 is in force, even if it changes no coordinate
  std::array<std::int8_t, max_axes> mirror;  // by axis: +1, or -1 if mirrored

  Transform();
  void refresh();  // sets `identity` and the rotation's sine and cosine
  Axes to_work(const Axes& programmed) const;
  Axes to_programmed(const Axes& work) const;
  /// Returns the axes that move if the named axes move: of the two axes of a rotation, both move if one is named.
  AxisMask moved_with(AxisMask named) const;

  // ---- effect in a plane

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
  Axes programmed{};  // the position in programmed coordinates
  Axes work{};        // the position in coordinates of the work system in force
  Axes machine{};
};

/// The tables that a program reads and, by G10, writes.
struct Tables {
  std::vector<ToolOffset> offsets;                  // tool offsets by number; [0] is unused
  std::vector<Axes> zeros = std::vector<Axes>(10);  // work offsets by number from 1 on; [0] is unused
  std::vector<Vec3> rotations;                      // basic rotations of the work offsets: angles in G17, G18, G19 (nct 10.2.3)
  Axes common{};                                    // common work offset
  std::vector<double> correctors;
  std::array<Axes, 5> reference{};  // reference points 1…4, machine coordinates
  friend bool operator==(const Tables&, const Tables&) = default;
};

/// The words of a drilling cycle that remain valid while blocks of the same cycle follow ("sticky", spec/mach3 4).
struct CycleMemory {
  std::int16_t row = -1;         // row of the cycle in ControlDef::codes; -1: none
  std::uint64_t known = 0;       // letters of the words that have a value, one bit per letter
  double bottom = 0, level = 0;  // Z (bottom) and R (level) as programmed, mm
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
  Axes set_position{};               // mm; shift of the work system by G92 or G52 (Mach3)
  bool set_position_by_g52 = false;  // set_position was set by G52
  Axes zero_shift{};                 // additional temporary shift of the work system (G92 of the 2С42 and GOST)
};

}  // namespace kadr
