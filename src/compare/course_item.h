#pragma once
// CourseItem: a straight piece of the axes' way with what is in force along it, or an act. Of compare/course.

#include <cstdint>
#include <memory>
#include <optional>
#include <string>

#include "action/action.h"

namespace kadr {

enum class CourseMove : std::uint8_t { rapid, feed, thread, probe };

/// In force while the machine moves or acts.
struct CourseState {
  CourseMove move = CourseMove::rapid;
  FeedUnit unit = FeedUnit::mm_per_min;
  double feed = 0;  // in that unit, as commanded; 0 at rapid
  double lead = 0;  // of a thread, mm
  std::uint32_t tool = 0;
  SpindleDir spindle = SpindleDir::stop;
  bool surface = false;  // the speed is m/min
  double speed = 0;      // of a spindle that turns
  Coolant coolant = Coolant::off;
  double tolerance = 0;  // mm that corners may be rounded by (G64 P)
  CornerSpeed corners = CornerSpeed::limited;
  std::uint8_t smoothing = 0;  // Q of G5.1
  friend bool operator==(const CourseState&, const CourseState&) = default;
};

/// What happens while the axes stand, but for what is in force afterwards.
struct CourseAct {
  enum class Kind : std::uint8_t { tool, dwell, stop, optional_stop, message, function, exact_stop, other };
  Kind kind = Kind::other;
  double value = 0;  // tool; s; number of a message or function
  std::string text;  // of a message; which other
  friend bool operator==(const CourseAct&, const CourseAct&) = default;
};

struct CourseItem {
  enum class Kind : std::uint8_t { move, act, end };
  Kind kind = Kind::end;
  Axes to{};  // machine coordinates at its end, in the order of the frame's axes
  CourseState state;
  std::shared_ptr<const CourseAct> act;  // of an act
  Origin origin;
  double begins = 0, ends = 0;   // s since the start, as programmed
  std::optional<AlarmId> fault;  // of an end: the alarm that it came by
};

}  // namespace kadr
