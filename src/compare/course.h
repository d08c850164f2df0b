#pragma once
// Course: what a program makes the machine do, in the order of time, such that two programs can be compared: straight pieces of the axes'
// way with what is in force along them, and acts between them.

#include <cstdint>
#include <deque>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "kinematics/chain.h"
#include "session/session.h"

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
  friend bool operator==(const CourseState&, const CourseState&) = default;
};

/// What happens while the axes stand, but for what is in force afterwards.
struct CourseAct {
  enum class Kind : std::uint8_t { tool, dwell, stop, optional_stop, message, function, other };
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
  CourseAct act;
  Origin origin;
  double begins = 0, ends = 0;   // s since the start, as programmed
  std::optional<AlarmId> fault;  // of an end: the alarm that it came by
};

/// Runs a program alone in its channel, as far as it is asked for.
class Course {
 public:
  ///   frame  names of the axes that positions are told in; what the control has not stays at 0
  ///   chord  mm that a piece may be off a way that is no line
  Course(std::unique_ptr<Session> session, const std::vector<std::string>& frame, double chord, const StopToken& stop);

  /// What is shown to the operator is passed over.
  void pass_messages() { messages_ = false; }
  std::size_t passed_messages() const { return passed_messages_; }
  /// A change of the tool is a stop, and which one it is does not count: it is changed by hand.
  void change_tools_by_hand() { tools_by_hand_ = true; }
  /// Where its axes stand before the first item.
  const Axes& start() const { return start_; }
  /// After an end it is the end again and again.
  CourseItem next();
  Session& session() { return *session_; }
  /// Zero of the work system of the first cut so far, machine coordinates.
  const std::optional<Vec3>& zero() const { return zero_; }
  /// The alarm that it has stopped by.
  const std::optional<AlarmReport>& stopped() const { return stopped_; }

 private:
  void take(const Step& step);
  void take_motion(const Step& step, const Motion& motion);
  void take_act(const Step& step, CourseAct::Kind kind, double value, std::string text = {});
  Axes in_frame(const Axes& machine) const;

  std::unique_ptr<Session> session_;
  std::vector<int> axis_of_;  // of the frame → of the control; -1: it has none
  double chord_;
  StopToken stop_;
  Chain chain_;
  std::unique_ptr<TimeEstimate> clock_;
  Vec3 frame_zero_;
  std::optional<Vec3> zero_;
  std::deque<CourseItem> ahead_;
  CourseState state_;
  double rpm_ = 0;
  bool surface_ = false;
  Axes start_{};
  CourseItem end_;
  std::optional<AlarmReport> stopped_;
  bool over_ = false;
  bool messages_ = true, tools_by_hand_ = false;
  std::size_t passed_messages_ = 0;
};

}  // namespace kadr
