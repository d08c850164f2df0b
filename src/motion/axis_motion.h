#pragma once
// AxisMotion: Actions → the axes' motion in time, by the Planner: what a motion's curve is in machine coordinates, where the axes
// stand still, what a pause lasts.

#include "config/machine_profile.h"
#include "config/setup.h"
#include "motion/estimate.h"
#include "motion/planner.h"

namespace kadr {

/// What the profile and the setup say; the setup goes before.
MotionLimits motion_limits(const MachineProfile& profile, const Setup& setup, const std::vector<std::string>& axes);

/// What a stretch of time is spent on, and for which line: the tag of a cell.
struct Spent {
  enum class On : std::uint8_t { cutting, rapid, dwell, tool_change };
  On on = On::cutting;
  std::uint32_t line = 0;
  std::uint16_t file = 0;  // Origin::file
  std::uint64_t tag() const { return std::uint64_t{line} << 32 | std::uint64_t{file} << 16 | static_cast<std::uint64_t>(on); }
  static Spent of(std::uint64_t tag) {
    return {static_cast<On>(tag & 0xFF), static_cast<std::uint32_t>(tag >> 32), static_cast<std::uint16_t>(tag >> 16 & 0xFFFF)};
  }
};

/// mm/s: the feed of a motion whose programmed time is unknown (override 0, the spindle stands).
inline constexpr double unlimited_feed = 1e6;

class AxisMotion {
 public:
  /// `tolerance`: mm, of corners for which the program states none.
  AxisMotion(const AxisRoles& roles, MotionLimits limits, double tolerance, const ToolPosition& start, Planner::Sink sink);

  /// Called for each motion before it is planned, with the way of all motions up to its end: mm of what the cells' lengths add up to.
  std::function<void(double way)> on_motion;

  /// An action, with its time by programmed feed: TimeEstimate or Statistics.
  void take(const Action& action, const MotionTime& programmed, double pause);
  /// The axes come to rest.
  void finish() { planner_.stop(); }

  std::size_t failures() const { return planner_.failures(); }

 private:
  void take(const Motion& motion, const MotionTime& programmed, const Origin& origin);
  void wait(double seconds, Spent spent);

  AxisRoles roles_;
  double tolerance_;
  ToolPosition position_;
  double way_ = 0;     // of all motions
  bool exact_ = true;  // the last motion ended exactly: no rounding behind it
  Planner::Sink sink_;
  Planner planner_;
};

}  // namespace kadr
