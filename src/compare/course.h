#pragma once
// Course: what a program makes the machine do, in order of time, in a form that can be compared with another program. It consists of
// straight segments of the path with the state in force along them, and of acts (dwell, stop, message …) between the segments.

#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "compare/item_ring.h"
#include "compare/path_modes.h"
#include "kinematics/chain.h"
#include "session/session.h"

namespace kadr {

/// Runs one program, without its other channels, only as far as items are requested.
class Course {
 public:
  ///   frame  axis names in the order in which the course's positions list them; an axis that the control does not have stays at 0
  ///   chord  mm; greatest deviation of the straight segments from a curved path
  Course(std::unique_ptr<Session> session, const std::vector<std::string>& frame, double chord, const StopToken& stop);

  /// Excludes messages to the operator from the course.
  void pass_messages() { messages_ = false; }
  /// Sets a function that takes all items of the first ring and appends what is to be compared instead to the second ring. It must pass
  /// the end on. An empty function changes nothing.
  void change_items(std::function<void(ItemRing& from, ItemRing& to)> change) { change_ = std::move(change); }
  /// Adds this vector, the origin that the operator has set, to all positions (mm, by axis of the frame). Call this function before the
  /// first item.
  void shift(const Axes& by);
  /// Switches off the computation of times. Call this function before the first item.
  void pass_times() { session_->outlets().clock = nullptr; }
  /// Returns the number of exact stops that were not added to the course because look_at() excludes them.
  std::size_t passed_exact_stops() const { return passed_exact_stops_; }
  std::size_t passed_messages() const { return passed_messages_; }
  /// Treats each tool change as a stop, independent of the selected tool: the operator changes the tool by hand.
  void change_tools_by_hand() { tools_by_hand_ = true; }
  /// Adds to the course what depends on the machine: which tool is made ready, and spindle and coolant at a tool change.
  void state_everything() { all_ = true; }
  /// Sets which exact stops and corner modes the course contains.
  void look_at(const PathModes& modes) { modes_ = modes; }
  /// The meaning of an M function of the machine on the other control, by the tables of both controls (config/machine/machine_codes).
  struct CodeMeaning {
    std::optional<Coolant> coolant{};  // the coolant that the function switches; nullopt: it switches no coolant
    std::uint32_t code = 0;            // number of the function on the other control, if `coolant` is nullopt
  };
  void read_codes(std::map<std::uint32_t, CodeMeaning> codes) { codes_ = std::move(codes); }
  /// Returns the state that was in force before the last block that has been read.
  const CourseState& before_last_block() const { return before_block_; }
  /// Returns the position of the axes before the first item, machine coordinates.
  const Axes& start() const { return start_; }
  /// Appends the next items (at least one) to the ring; after the end of the course, appends nothing.
  void more(ItemRing& to);
  Session& session() { return *session_; }
  /// Returns the origin of the work system in which the first cut was made, in machine coordinates; nullopt before this cut.
  const std::optional<Vec3>& zero() const { return zero_; }
  /// Returns the alarm that stopped the program; nullopt if no alarm stopped it.
  const std::optional<AlarmReport>& stopped() const { return stopped_; }

 private:
  void take(const Step& step);
  void take_motion(const Step& step, const Motion& motion);
  void take_event(const Step& step, CourseEvent::Kind kind, double value, std::string text = {});
  void take_switch(const Step& step);
  void note_frame(const FrameChange& frame);
  void take_function(const Step& step, std::uint32_t code);
  void stop_exactly(const Step& next);
  bool stands(const Step& step, const Motion& motion) const;
  void put_in_frame(Axes& to, const Axes& machine) const;

  std::unique_ptr<Session> session_;
  std::vector<int> axis_of_;  // by axis of the frame: index of the control's axis; -1: the control has no such axis
  double chord_;
  StopToken stop_;
  std::function<void(ItemRing& from, ItemRing& to)> change_;
  ItemRing unchanged_;  // items before change_ takes them
  Chain chain_;
  std::unique_ptr<TimeEstimate> clock_;
  Vec3 frame_zero_, system_zero_;  // system_zero_: as CourseItem::zero
  std::optional<Vec3> zero_;
  ItemRing* ahead_ = nullptr;  // the ring that receives the items during more()
  CourseState state_, before_block_;
  PathModes modes_;
  std::map<std::uint32_t, CodeMeaning> codes_;
  std::optional<Origin> exact_end_;  // origin of a motion with an exact stop that has just ended; nullopt: there is none
  double rpm_ = 0, most_rpm_ = 0;  // rpm_: speed commanded last, rev/min, or m/min if surface_ is true; most_rpm_: as CourseState::most_rpm
  bool surface_ = false;
  Axes start_{}, shift_{};
  CourseItem end_;
  std::optional<AlarmReport> stopped_;
  bool over_ = false;
  bool messages_ = true, tools_by_hand_ = false, all_ = false;
  std::size_t passed_messages_ = 0, passed_exact_stops_ = 0;
};

}  // namespace kadr
