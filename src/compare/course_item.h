#pragma once
// CourseItem: one element of a course (compare/course): a straight segment of the path with the state in force along it, or an act
// (dwell, stop …).

#include <cstdint>
#include <memory>
#include <optional>
#include <string>

#include "action/action.h"

namespace kadr {

enum class CourseMove : std::uint8_t { rapid, feed, thread, probe };

/// The modes and values in force while the machine moves or acts.
struct CourseState {
  CourseMove move = CourseMove::rapid;
  FeedUnit unit = FeedUnit::mm_per_min;
  double feed = 0;  // commanded feed in `unit`; 0 for a rapid
  double lead = 0;  // thread lead, mm
  std::uint32_t tool = 0;
  SpindleDir spindle = SpindleDir::stop;
  bool surface = false;  // true if constant surface speed is in force: `speed` is then in m/min
  double speed = 0;      // speed of the rotating spindle, rev/min; m/min if `surface`
  double most_rpm = 0;   // highest spindle speed, rev/min, if `surface`; 0: no limit
  Coolant coolant = Coolant::off;
  double tolerance = 0;  // greatest rounding of corners, mm (G64 P)
  CornerSpeed corners = CornerSpeed::limited;
  std::uint8_t smoothing = 0;  // smoothing mode: the word Q of G5.1
  bool taps = false;           // true: a tapping cycle cuts a thread; not compared
  friend bool operator==(const CourseState&, const CourseState&) = default;
};

/// CourseEvent::text of an act that makes a tool ready for the next tool change.
inline constexpr const char* selected_tool = "T";

/// An act while the axes are at rest. The modes that the act puts in force are in CourseState.
struct CourseEvent {
  enum class Kind : std::uint8_t { tool, dwell, stop, optional_stop, message, function, exact_stop, other };
  Kind kind = Kind::other;
  double value = 0;  // number whose meaning depends on the kind of act: tool number; dwell time in s; number of the message or function
  std::string text;  // text of a message; for an act of the kind `other`, the name of the act
  friend bool operator==(const CourseEvent&, const CourseEvent&) = default;
};

struct CourseItem {
  enum class Kind : std::uint8_t { move, act, end };
  Kind kind = Kind::end;
  Axes to{};  // position at the end of the item, machine coordinates, in the order of the frame's axes
  CourseState state;
  Vec3 zero;                               // origin of the work system in machine coordinates, without G52, G92 and the tool length
  AxisMask named = 0;                      // axes whose position the block states; bits in the order of the control's axes
  bool by_work = true;                     // false: the end is a position of the machine (G53, G28); only for motions
  std::shared_ptr<const CourseEvent> act;  // the act; nullptr if the item is a motion or the end
  Origin origin;
  double begins = 0, ends = 0;   // programmed times of the item's start and end, s since the start of the run
  std::optional<AlarmId> fault;  // alarm that stopped the program; only in the item for the end of the course
};

}  // namespace kadr
