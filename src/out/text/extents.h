#pragma once
// Extents of a run: how far it cuts and how far it moves at all, in each work system that it uses. The summary tells them, and the picture.

#include <algorithm>
#include <string>
#include <vector>

#include "action/curve.h"
#include "action/tool_position.h"
#include "base/units.h"
#include "config/alarm_texts.h"

namespace kadr {

/// Box of the X, Y, Z that occurred.
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

/// Cutting: at feed, along arcs, threads. A probe looks for the part, it does not cut it.
inline bool cuts(const Motion& motion) {
  return motion.kind == MotionKind::feed || motion.kind == MotionKind::thread || motion.kind == MotionKind::spline || is_arc(motion.kind);
}

/// The unit that lengths are told in: that of the blocks that cut; of a program without any, of its motions.
enum class LengthUnit : std::uint8_t { mm, inch, mixed };  // mixed: both; told in mm
/// mm of it.
inline double mm_of(LengthUnit unit) { return unit == LengthUnit::inch ? mm_per_inch : 1; }
/// "mm", "in"; «мм», «дюймы».
const char* unit_name(LengthUnit unit, Lang lang);
/// "mm/min", "in/min".
const char* speed_unit_name(LengthUnit unit, Lang lang);
/// A length in its unit: to 0.001 mm, 0.0001 in.
std::string length_text(double mm, LengthUnit unit);

/// Which unit the motions of a run are programmed in.
class MotionUnits {
 public:
  void take(const Motion& motion) {
    if (cuts(motion)) (motion.inch ? cut_in_inches_ : cut_in_mm_) = true;
    moved_ = true, moved_in_inches_ = motion.inch;
  }
  /// Nothing has moved.
  bool empty() const { return !moved_; }
  LengthUnit unit() const;

 private:
  bool cut_in_mm_ = false, cut_in_inches_ = false, moved_in_inches_ = false, moved_ = false;
};

/// What motions of one kind reach: X, Y, Z in mm, rotary axes in degrees.
struct Reach {
  Box box;
  Axes least{}, most{};  // of rotary axes, once the box is not empty
  void take(const AxisRoles& roles, const Axes& at);
  void take(const Reach& other);
};

/// Of one work system, in its coordinates.
struct SystemExtents {
  std::uint16_t system = 0;  // Motion::system
  Reach cutting, other;
  Reach all() const;
};

/// Takes the motions of a run; its memory grows with the work systems that are used.
class RunExtents {
 public:
  RunExtents(const std::vector<std::string>& axes, const AxisRoles& roles) : roles_(roles), axes_(axes) {}

  ///   from   where the tool stood, in work coordinates
  void take(const Motion& motion, const ToolPosition& from, const Curve& curve);
  /// The next motion does not begin where the last one ended: the frame has changed.
  void lift() { stands_in_ = nowhere; }

  const std::vector<SystemExtents>& systems() const { return systems_; }
  const MotionUnits& units() const { return units_; }
  LengthUnit unit() const { return units_.unit(); }
  Box cutting_box() const;
  Box box() const;

  /// Which extents.
  enum class Of : std::uint8_t { cutting, all };
  /// Of an axis: X, Y, Z and rotary axes that have moved; mm or degrees.
  struct AxisRange {
    std::string name;
    double least, most;
    bool rotary;
  };
  /// Of a work system.
  struct Row {
    std::string system;  // its name, where several are used; else empty
    std::vector<AxisRange> axes;
  };
  /// One for each work system that has some. `names`: of the systems, by number.
  std::vector<Row> rows(Of of, const std::vector<std::string>& names) const;
  /// "X 0 … 20   Y … Z …   C 0 … 90°", one for each work system that has some; of several "G54  X …". `names`: of the systems, by number.
  std::vector<std::string> texts(Of of, const std::vector<std::string>& names) const;

 private:
  void enter(std::uint16_t system);
  static constexpr std::size_t nowhere = ~std::size_t{0};

  AxisRoles roles_;
  std::vector<std::string> axes_;
  std::vector<SystemExtents> systems_;
  std::size_t now_ = 0;              // index of the system in force
  std::size_t stands_in_ = nowhere;  // the reach that has taken the place where the tool stands: twice the system's index, 1 more: cutting
  AxisMask turned_ = 0;              // rotary axes that have moved
  MotionUnits units_;
};

}  // namespace kadr
