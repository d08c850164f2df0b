#pragma once
// Course: what a program makes the machine do, in the order of time, in a form in which two programs can be compared: straight pieces of
// the axes' path with what is in force along them, and acts between them.

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

/// Runs a program alone in its channel, only as far as items are requested.
class Course {
 public:
  ///   frame  names of the axes of the positions; an axis that the control does not have stays at 0
  ///   chord  mm by which a piece may differ from a curved path
  Course(std::unique_ptr<Session> session, const std::vector<std::string>& frame, double chord, const StopToken& stop);

  /// Leaves out messages to the operator.
  void pass_messages() { messages_ = false; }
  /// Adds this shift to its positions, mm by axis of the frame: where the operator has set the origin. Call it before the first item.
  void shift(const Axes& by);
  /// Does without times, which nobody needs. Call it before the first item.
  void pass_times() { session_->outlets().clock = nullptr; }
  /// The exact stops that look_at() excludes.
  std::size_t passed_exact_stops() const { return passed_exact_stops_; }
  std::size_t passed_messages() const { return passed_messages_; }
  /// Treats a tool change as a stop, whichever tool it is: the tool is changed by hand.
  void change_tools_by_hand() { tools_by_hand_ = true; }
  /// Sets which modes of corners and exact stops are compared.
  void look_at(const PathModes& modes) { modes_ = modes; }
  /// What an M function of the machine means on the other control, by the tables of both (config/machine_codes).
  struct CodeMeaning {
    std::optional<Coolant> coolant{};  // it switches the coolant; else
    std::uint32_t code = 0;            // it is the function with this number
  };
  void read_codes(std::map<std::uint32_t, CodeMeaning> codes) { codes_ = std::move(codes); }
  /// What was in force before the last block so far.
  const CourseState& before_last_block() const { return before_block_; }
  /// Position of the axes before the first item.
  const Axes& start() const { return start_; }
  /// Adds the next items, one or more; adds nothing after the end.
  void more(ItemRing& to);
  Session& session() { return *session_; }
  /// Origin of the work system of the first cut so far, in machine coordinates.
  const std::optional<Vec3>& zero() const { return zero_; }
  /// The alarm that stopped the program.
  const std::optional<AlarmReport>& stopped() const { return stopped_; }

 private:
  void take(const Step& step);
  void take_motion(const Step& step, const Motion& motion);
  void take_act(const Step& step, CourseAct::Kind kind, double value, std::string text = {});
  void take_switch(const Step& step);
  void take_function(const Step& step, std::uint32_t code);
  void stop_exactly(const Step& next);
  bool stands(const Step& step, const Motion& motion) const;
  void put_in_frame(Axes& to, const Axes& machine) const;

  std::unique_ptr<Session> session_;
  std::vector<int> axis_of_;  // axis of the frame → axis of the control; -1: it has none
  double chord_;
  StopToken stop_;
  Chain chain_;
  std::unique_ptr<TimeEstimate> clock_;
  Vec3 frame_zero_;
  std::optional<Vec3> zero_;
  ItemRing* ahead_ = nullptr;  // receives the items while they are requested
  CourseState state_, before_block_;
  PathModes modes_;
  std::map<std::uint32_t, CodeMeaning> codes_;
  std::optional<Origin> exact_end_;  // of the motion that the axes have just stopped after
  double rpm_ = 0;
  bool surface_ = false;
  Axes start_{}, shift_{};
  CourseItem end_;
  std::optional<AlarmReport> stopped_;
  bool over_ = false;
  bool messages_ = true, tools_by_hand_ = false;
  std::size_t passed_messages_ = 0, passed_exact_stops_ = 0;
};

}  // namespace kadr
