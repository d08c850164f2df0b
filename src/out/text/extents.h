#pragma once
// Extents of a run: for each of the work coordinates in use, the range of each axis while cutting and over all motions. The summary and the
// picture show the extents.

#include <algorithm>
#include <string>
#include <vector>

#include "action/curve.h"
#include "action/tool_position.h"
#include "base/units.h"
#include "config/alarm_texts.h"

namespace kadr {

/// The bounding box of X, Y, Z, mm. It is valid after the first point has been added.
struct Box {
  Vec3 least;
  Vec3 most;
  bool empty = true;
  void take(Vec3 p) {
    if (empty) least = most = p;
    empty = false;
    least = {std::min(least.x, p.x), std::min(least.y, p.y), std::min(least.z, p.z)};
    most = {std::max(most.x, p.x), std::max(most.y, p.y), std::max(most.z, p.z)};
  }
  void take(const Box& box) {
    if (box.empty) return;
    take(box.least);
    take(box.most);
  }
};

/// True if the motion cuts: feed, arcs, threads. A probe motion does not cut, although it touches the part.
inline bool cuts(const Motion& motion) {
  return motion.kind == MotionKind::feed || motion.kind == MotionKind::thread || motion.kind == MotionKind::spline || is_arc(motion.kind);
}

/// The unit in which lengths are shown. It is the unit of the blocks that cut, or of the last motion if no block cuts.
enum class LengthUnit : std::uint8_t { mm, inch, mixed };  // mixed: cutting blocks have both units, so lengths are shown in mm
/// Returns the number of mm in one unit of length.
inline double mm_of(LengthUnit unit) { return unit == LengthUnit::inch ? mm_per_inch : 1; }
/// Returns the name of the unit: "mm", "in".
const char* unit_name(LengthUnit unit, Lang lang);
/// Returns the name of the unit of speed: "mm/min", "in/min".
const char* speed_unit_name(LengthUnit unit, Lang lang);
/// Formats a length in its unit, rounded to 0.001 mm or 0.0001 in.
std::string length_text(double mm, LengthUnit unit);

/// Finds the units in which the motions of a run are programmed, and which axes are programmed in diameters.
class MotionUnits {
 public:
  void take(const Motion& motion);
  /// True if the program has not moved yet.
  bool empty() const { return !moved_; }
  LengthUnit unit() const;
  /// Returns the axes that are in diameter programming in all blocks that cut, or in the last motion if no block cuts.
  AxisMask diameters() const { return cut_in_inches_ || cut_in_mm_ ? cut_in_diameters_ : moved_in_diameters_; }

 private:
  bool cut_in_mm_ = false, cut_in_inches_ = false, moved_in_inches_ = false, moved_ = false;
  AxisMask cut_in_diameters_ = ~AxisMask{0}, moved_in_diameters_ = 0;
};

/// The range of positions in a set of motions: X, Y, Z in mm, rotary axes in degrees.
struct Reach {
  Box box;
  Axes least{}, most{};  // range of the rotary axes, degrees; valid if the box is not empty
  void take(const AxisRoles& roles, const Axes& at);
  void take(const Reach& other);
};

/// The extents of the motions in the work coordinates of one work offset.
struct SystemExtents {
  std::uint16_t system = 0;  // number of the work offset: Motion::system
  Reach cutting, other;
  Reach all() const;
};

/// Collects the extents of the motions of a run. The memory depends only on the number of work offsets in use.
class RunExtents {
 public:
  RunExtents(const std::vector<std::string>& axes, const AxisRoles& roles) : roles_(roles), axes_(axes) {}

  ///   from  position of the tool before the motion, in work coordinates
  void take(const Motion& motion, const ToolPosition& from, const Curve& curve);
  /// Declares that the work coordinates have changed. Then the next motion does not begin at the coordinates where the last motion ended.
  void lift() { stands_in_ = nowhere; }

  const std::vector<SystemExtents>& systems() const { return systems_; }
  const MotionUnits& units() const { return units_; }
  LengthUnit unit() const { return units_.unit(); }
  /// True if X is programmed in diameters. The ranges of rows() and texts() are then diameters; the boxes are always true lengths.
  bool x_is_diameter() const { return roles_.xyz[0] >= 0 && (units_.diameters() >> roles_.xyz[0] & 1U) != 0; }
  Box cutting_box() const;
  Box box() const;

  /// Selects which extents are returned: of cutting motions or of all motions.
  enum class Of : std::uint8_t { cutting, all };
  /// The range of one axis: X, Y, Z as far as the channel has them, or a rotary axis that has moved; mm or degrees. X is a diameter if it
  /// is programmed so.
  struct AxisRange {
    std::string name;
    double least, most;
    bool rotary;
  };
  /// The ranges of all axes for one work offset.
  struct Row {
    std::string system;  // name of the work offset; empty if the program uses only one
    std::vector<AxisRange> axes;
  };
  /// Returns one row for each work offset with which the program has moved. `names`: the names of the work offsets, by number.
  std::vector<Row> rows(Of of, const std::vector<std::string>& names) const;
  /// Returns the rows as texts: "X 0 … 20   Y … Z …   C 0 … 90°". If there are several work offsets, their names come first: "G54  X …".
  std::vector<std::string> texts(Of of, const std::vector<std::string>& names) const;

 private:
  void enter(std::uint16_t system);
  static constexpr std::size_t nowhere = ~std::size_t{0};

  AxisRoles roles_;
  std::vector<std::string> axes_;
  std::vector<SystemExtents> systems_;
  std::size_t now_ = 0;  // index of the work offset in force
  // index of the extents that include the present position of the tool: 2 × index of the work offset, + 1 if the tool is cutting
  std::size_t stands_in_ = nowhere;
  AxisMask turned_ = 0;  // bit mask of the rotary axes that have moved
  MotionUnits units_;
};

}  // namespace kadr
