#pragma once
// Extents of a run: the range of each axis while cutting, and over all motions, in each work system that the run uses. The summary and
// the picture show them.

#include <algorithm>
#include <string>
#include <vector>

#include "action/curve.h"
#include "action/tool_position.h"
#include "base/units.h"
#include "config/alarm_texts.h"

namespace kadr {

/// The bounding box of X, Y, Z; valid once a point was added.
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

/// True if the motion cuts: feed, arcs, threads. A probe motion touches the part but does not cut.
inline bool cuts(const Motion& motion) {
  return motion.kind == MotionKind::feed || motion.kind == MotionKind::thread || motion.kind == MotionKind::spline || is_arc(motion.kind);
}

/// The unit in which lengths are shown: that of the blocks that cut, or of the last motion if no block cuts.
enum class LengthUnit : std::uint8_t { mm, inch, mixed };  // mixed: both occur; shown in mm
/// Returns the number of mm in one unit.
inline double mm_of(LengthUnit unit) { return unit == LengthUnit::inch ? mm_per_inch : 1; }
/// "mm", "in".
const char* unit_name(LengthUnit unit, Lang lang);
/// "mm/min", "in/min".
const char* speed_unit_name(LengthUnit unit, Lang lang);
/// Returns a length in its unit, to 0.001 mm or 0.0001 in.
std::string length_text(double mm, LengthUnit unit);

/// Collects which unit the motions of a run are programmed in.
class MotionUnits {
 public:
  void take(const Motion& motion) {
    if (cuts(motion)) (motion.inch ? cut_in_inches_ : cut_in_mm_) = true;
    moved_ = true, moved_in_inches_ = motion.inch;
  }
  /// True if nothing has moved yet.
  bool empty() const { return !moved_; }
  LengthUnit unit() const;

 private:
  bool cut_in_mm_ = false, cut_in_inches_ = false, moved_in_inches_ = false, moved_ = false;
};

/// The range that a set of motions reaches: X, Y, Z in mm, rotary axes in degrees.
struct Reach {
  Box box;
  Axes least{}, most{};  // range of the rotary axes; valid once the box is not empty
  void take(const AxisRoles& roles, const Axes& at);
  void take(const Reach& other);
};

/// The extents in one work system, in its work coordinates.
struct SystemExtents {
  std::uint16_t system = 0;  // Motion::system
  Reach cutting, other;
  Reach all() const;
};

/// Collects the extents of the motions of a run; needs memory only for each work system used.
class RunExtents {
 public:
  RunExtents(const std::vector<std::string>& axes, const AxisRoles& roles) : roles_(roles), axes_(axes) {}

  ///   from  where the tool was before the motion, in work coordinates
  void take(const Motion& motion, const ToolPosition& from, const Curve& curve);
  /// Call it when the work frame has changed: the next motion does not begin at the work coordinates where the last one ended.
  void lift() { stands_in_ = nowhere; }

  const std::vector<SystemExtents>& systems() const { return systems_; }
  const MotionUnits& units() const { return units_; }
  LengthUnit unit() const { return units_.unit(); }
  Box cutting_box() const;
  Box box() const;

  /// Selects the extents: of cutting motions, or of all motions.
  enum class Of : std::uint8_t { cutting, all };
  /// The range of one axis, X, Y, Z or a rotary axis that has moved; mm or degrees.
  struct AxisRange {
    std::string name;
    double least, most;
    bool rotary;
  };
  /// The ranges in one work system.
  struct Row {
    std::string system;  // name of the work system if several are used, else empty
    std::vector<AxisRange> axes;
  };
  /// Returns one row for each work system in which such motions occurred. `names` are the names of the work systems, by number.
  std::vector<Row> rows(Of of, const std::vector<std::string>& names) const;
  /// Like rows(), but as texts: "X 0 … 20   Y … Z …   C 0 … 90°"; with several work systems "G54  X …".
  std::vector<std::string> texts(Of of, const std::vector<std::string>& names) const;

 private:
  void enter(std::uint16_t system);
  static constexpr std::size_t nowhere = ~std::size_t{0};

  AxisRoles roles_;
  std::vector<std::string> axes_;
  std::vector<SystemExtents> systems_;
  std::size_t now_ = 0;              // index of the work system in force
  std::size_t stands_in_ = nowhere;  // the reach that includes the tool's position: 2 × system index, + 1 if cutting
  AxisMask turned_ = 0;              // rotary axes that have moved
  MotionUnits units_;
};

}  // namespace kadr
