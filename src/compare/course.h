#pragma once
// Course: what a program makes the machine do, in the order of time, such that two programs can be compared: straight pieces of the axes'
// way with what is in force along them, and acts between them.

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

/// Runs a program alone in its channel, as far as it is asked for.
class Course {
 public:
  ///   frame  names of the axes that positions are told in; what the control has not stays at 0
  ///   chord  mm that a piece may be off a way that is no line
  Course(std::unique_ptr<Session> session, const std::vector<std::string>& frame, double chord, const StopToken& stop);

  /// What is shown to the operator is passed over.
  void pass_messages() { messages_ = false; }
  /// Its positions are told so much farther on, mm by axis of the frame: where the operator has set the zero. Before the first item.
  void shift(const Axes& by);
  /// When things are is not told: nobody counts it. Before the first item.
  void pass_times() { session_->outlets().clock = nullptr; }
  /// Exact stops that do not count by look_at().
  std::size_t passed_exact_stops() const { return passed_exact_stops_; }
  std::size_t passed_messages() const { return passed_messages_; }
  /// A change of the tool is a stop, and which one it is does not count: it is changed by hand.
  void change_tools_by_hand() { tools_by_hand_ = true; }
  /// These count of how corners are gone round.
  void look_at(const PathModes& modes) { modes_ = modes; }
  /// An M function of the machine by its number: what it is on the other control, by the tables of both (config/machine_codes).
  struct CodeMeaning {
    std::optional<Coolant> coolant{};  // it switches that; else …
    std::uint32_t code = 0;            // … it is the function of this number
  };
  void read_codes(std::map<std::uint32_t, CodeMeaning> codes) { codes_ = std::move(codes); }
  /// What was in force before the last block so far.
  const CourseState& before_last_block() const { return before_block_; }
  /// Where its axes stand before the first item.
  const Axes& start() const { return start_; }
  /// Adds what comes next, one or more; after its end nothing.
  void more(ItemRing& to);
  Session& session() { return *session_; }
  /// Zero of the work system of the first cut so far, machine coordinates.
  const std::optional<Vec3>& zero() const { return zero_; }
  /// The alarm that it has stopped by.
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
  std::vector<int> axis_of_;  // of the frame → of the control; -1: it has none
  double chord_;
  StopToken stop_;
  Chain chain_;
  std::unique_ptr<TimeEstimate> clock_;
  Vec3 frame_zero_;
  std::optional<Vec3> zero_;
  ItemRing* ahead_ = nullptr;  // where they are wanted
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
