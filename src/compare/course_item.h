#pragma once
// CourseItem: a straight piece of the axes' path with what is in force along it, or an act. Part of compare/course.

#include <cstdint>
#include <memory>
#include <optional>
#include <string>

#include "action/action.h"

namespace kadr {

enum class CourseMove : std::uint8_t { rapid, feed, thread, probe };

/// What is in force while the machine moves or acts.
struct CourseState {
  CourseMove move = CourseMove::rapid;
  FeedUnit unit = FeedUnit::mm_per_min;
  double feed = 0;  // in `unit`, as commanded; 0 at rapid
  double lead = 0;  // of a thread, mm
  std::uint32_t tool = 0;
  SpindleDir spindle = SpindleDir::stop;
  bool surface = false;  // constant surface speed: `speed` is m/min
  double speed = 0;      // of a rotating spindle
  Coolant coolant = Coolant::off;
  double tolerance = 0;  // mm by which corners may be rounded (G64 P)
  CornerSpeed corners = CornerSpeed::limited;
  std::uint8_t smoothing = 0;  // Q of G5.1
  friend bool operator==(const CourseState&, const CourseState&) = default;
};

/// What happens while the axes are at rest, apart from what it leaves in force.
struct CourseAct {
  enum class Kind : std::uint8_t { tool, dwell, stop, optional_stop, message, function, exact_stop, other };
  Kind kind = Kind::other;
  double value = 0;  // the tool; s; number of a message or function
  std::string text;  // of a message; for `other`, which act
  friend bool operator==(const CourseAct&, const CourseAct&) = default;
};

struct CourseItem {
  enum class Kind : std::uint8_t { move, act, end };
  Kind kind = Kind::end;
  Axes to{};  // machine coordinates at its end, in the order of the frame's axes
  CourseState state;
  std::shared_ptr<const CourseAct> act;  // if it is an act
  Origin origin;
  double begins = 0, ends = 0;   // s since the start, as programmed
  std::optional<AlarmId> fault;  // if it is the end: the alarm that caused it
};

}  // namespace kadr
