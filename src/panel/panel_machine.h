#pragma once
// PanelMachine is a machine with its control, as an operator uses it. It executes a program in real time, one run of motion after another.
// PanelMachine has its own thread and continues whether or not a page is connected. Requests of the operator may come from any thread.
//
//   ask(PanelCommand) ──▶ its thread: Stepping, Session ──cells──▶ Playback ──▶ ServoClock ──▶ state(): a sample of the clock,
//                                                                                              and the block it belongs to
//
// A run of motion (PanelRun) is the motion from one position at which the axes are at rest to the next such position. The axes stop at the
// end of the program, before a block at which the program is held, or after a line that the operator entered. A run of motion is planned
// with the limits of the selected machine.

#include <chrono>
#include <condition_variable>
#include <deque>
#include <functional>
#include <future>
#include <memory>
#include <mutex>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "base/thread.h"
#include "panel/panel_state.h"
#include "panel/session_opener.h"

namespace kadr {

class PanelMachine {
 public:
  static constexpr double rate = 1000;  // rate of the servo clock, Hz
  static constexpr std::size_t max_entered = 1000, most_undone = 50, max_stops = 100;

  /// Switches on a machine. The program is at its beginning.
  ///   opens    the function that opens sessions of the program
  ///   start    start position of the axes in machine coordinates; nullopt: the start position is in the set-up
  ///   stands   the start positions of several channels, by index; empty: the start positions are in the set-up
  ///   axes     makes the axes of a real machine; empty: they are virtual
  ///   returns  the machine, or an error sentence
  static tl::expected<std::unique_ptr<PanelMachine>, std::string> make(SessionOpener opens, PanelRecorder keeper = {},
                                                                       const std::optional<Axes>& start = {}, std::vector<Axes> stands = {},
                                                                       AxesMaker axes = {});
  ~PanelMachine();
  PanelMachine(const PanelMachine&) = delete;
  PanelMachine& operator=(const PanelMachine&) = delete;

  /// Stops the axes. From this call on nothing is saved or reported, and all requests are refused.
  void switch_off();

  /// What has become of a request that is not refused: it is done, or it has begun and is completed later.
  enum class Outcome : std::uint8_t { done, queued };
  // The outcome of a request, or an error sentence that states why the request was refused. A refused request is never executed later.
  using Answer = tl::expected<Outcome, std::string>;
  /// Continues the program from the block at which it is held, or resumes after a feed hold.
  ///   how  how far the program runs; nullopt: one block if the single block switch is on, otherwise to the next stop
  Answer run(std::optional<Stepping::How> how = {});
  /// Feed hold: the axes slow down and stop on their path.
  Answer hold();
  /// Returns the program to its beginning without moving the axes. The call ends an alarm and an emergency stop.
  Answer reset();
  /// Emergency stop: the axes stop within one instant of the servo clock, even in the middle of a motion.
  void stop_at_once();
  /// Sets the single block switch. While it is on, each run() executes one block.
  Answer set_single(bool on);
  /// Sets the optional stop switch. While it is on, M1 holds the program.
  Answer set_optional_stop(bool on);
  Answer set_skip(int number, bool on);
  Answer set_overrides(const PanelOverrides& shares);
  /// Answers a question of the program (#3107 of the NCT): 0 cancel, 1 OK, 2 yes, 3 no. The program then continues.
  Answer answer(double answer);
  /// Executes a line of the operator (MDI) at once.
  Answer enter(const std::string& line);
  /// Restores the control and the virtual machine to their state before the last entered line. A real machine refuses this.
  Answer undo();
  /// Homes the axes of a real machine, or unlocks its controller after an alarm.
  Answer home();
  Answer unlock();
  /// Moves an axis of a real machine until its probe touches, then to the point where it has touched. Without a touch that is an alarm.
  ///   distance  at most, signed, mm; `feed` mm/min
  Answer probe(const std::string& axis, double distance, double feed);
  /// The page that has the controls is alive. A real machine is held if it runs and has not been kept alive for `lease`.
  void keep_alive() { alive_at_ = std::chrono::steady_clock::now().time_since_epoch().count(); }
  static constexpr std::chrono::milliseconds lease{3000};
  /// Moves an axis by hand.
  ///   distance  distance in machine coordinates, mm or degrees
  ///   feed     mm/min or degrees/min; 0: the highest speed of the axis
  ///   channel  number of the channel that has the axis; 0: the program's own channel
  Answer jog(const std::string& axis, double distance, double feed, int channel = 0);
  /// Moves an axis by hand as long as keep_jogging(true) is called at least every `most_silence`. Then it slows down and stops, as it does
  /// at the end of its travel.
  ///   sign     direction, positive or negative
  ///   feed, channel  as in jog()
  Answer jog_while_held(const std::string& axis, double sign, double feed, int channel = 0);
  /// Lets an axis that jog_while_held() moves go on, or slow down and stop. Returns false if no axis is moved so.
  bool keep_jogging(bool on);
  static constexpr std::chrono::milliseconds most_silence{300};
  /// Moves the axes of the program's own channel by hand along the path `points`.
  Answer move_along_path(const std::vector<WayPoint>& points);
  /// Adds a stop point, at which the program will be held. Returns its number.
  tl::expected<std::size_t, std::string> add_stop(StopPoint point);
  Answer remove_stop(std::size_t number);

  /// Evaluates expressions written in the syntax of the program.
  tl::expected<std::vector<PanelWatch>, std::string> watch_values(const std::vector<std::string>& expressions);
  tl::expected<PanelTables, std::string> tables();
  /// Checks whether take_tables() can apply tables at present. The machine must be at rest at a suitable block.
  Answer may_apply_tables();
  /// Applies edited tables at the present block. The SessionOpener must already open sessions with these tables.
  Answer take_tables();

  /// Searches for a block at which the program could continue. Returns what the search has found so far.
  PanelSearch::Answer find(const PanelSearch::SearchRequest& request) {
    // While edited tables are applied, the machine uses the search itself: it searches for its own location in a run with the new tables.
    // The caller's request must therefore wait.
    if (state().takes_tables) return {};
    return search_->find(request);
  }
  /// Returns what must be done to bring the machine from its present state to the state at the restart position.
  ///   returns  the sheet of the program's own channel, followed by one sheet per channel of RestartPoint::other_channels, in the same
  ///   order
  tl::expected<std::vector<PanelSheet>, std::string> sheets(const std::shared_ptr<const RestartPoint>& place, const WayRules& rules);
  /// Moves the machine to the restart position and holds the program before the block at this position, as if the program had been executed
  /// up to this block.
  ///   left  keys (see key_of()) of the items that keep their present value; a key of another channel begins with the channel number:
  ///         "2/tool:"
  ///   paths  the paths to move along, one after another: the paths of the sheets, or other paths that end at the same positions. A channel
  ///         without a path must already be at its position
  Answer go_there(std::shared_ptr<const RestartPoint> place, const std::set<std::string>& left, std::vector<PanelPath> paths);

  /// Sets an observer. The machine's thread calls it with each step that the control executes (program, entered lines, motion by hand), in
  /// their order and ahead of the machine. Call watch() before the first run().
  void watch(std::function<void(const Step&)> look) { looks_on_ = std::move(look); }

  PanelState state();
  const std::vector<std::string>& axes() const { return lane_->axes; }
  /// The names of the axes of the channel with this index. The reference is valid while the machine is on.
  const std::vector<std::string>& axes(std::size_t channel) const { return lanes_[channel]->axes; }
  std::size_t channel_count() const { return lanes_.size(); }
  int number_of(std::size_t channel) const { return lanes_[channel]->number; }
  /// Index of the program's own channel.
  std::size_t own() const { return own_; }

 private:
  using Run = PanelRun;
  /// The state before a line of the operator; undo() restores this state.
  struct Before {
    Stepping::Memory stepping;
    Axes machine;
    Placement placement;
    std::uint64_t entered;
  };
  struct Request {
    std::function<Answer()> what;
    std::promise<Answer> answer;
    std::uint64_t number = 0;
    // true if the caller has the answer that the request is queued; lock_ protects the value
    std::shared_ptr<bool> is_queued = std::make_shared<bool>(false);
  };
  enum class Wait : std::uint8_t { for_start, for_end };

  PanelMachine(SessionOpener opens, PanelRecorder keeper, std::vector<Axes> stands, AxesMaker axes)
      : opens_(std::move(opens)), keeper_(std::move(keeper)), makes_axes_(std::move(axes)), stands_(std::move(stands)) {}
  // in panel_machine.cpp: the machine's thread and the operator's requests
  Answer ask(std::function<Answer()> what, Wait wait = Wait::for_start);
  void live();
  bool look_round();
  void execute_requests();
  void give_answer(Request& request, const Answer& answer);
  void watch_run();
  /// True if an emergency stop was requested and the machine's thread has not handled this request yet.
  bool must_stop() const { return lane_->was_stopped() && panel_state_.mode != PanelMode::emergency; }
  void stand_still();
  Answer may_begin() const;
  void apply_overrides();
  void show_channels(PanelState& now) const;
  bool is_alone() const { return lanes_.size() == 1; }
  void show();
  // The functions below are in panel_opening.cpp.
  Answer may_have_axes() const;
  Answer make_lanes();
  Answer begin_session(const std::optional<Axes>& start);
  void obey_switches();
  Answer open(const std::optional<Axes>& start);
  Answer start_over();
  void begin_search();
  void stand_here();
  // The functions below are in panel_keeping.cpp.
  void save_location(const PanelState& now);
  void notify(const char* kind, const std::string& text = {}, std::uint32_t line = 0) const;
  void note_variables(std::uint32_t line);
  void apply_edited_tables();
  void keep_tables(const Setup& before);
  bool is_in_contour() const;
  Answer may_apply_tables_now() const;
  AlarmReport::Line line_of(const ServoSample& sample) const;
  // The functions below are in panel_run.cpp.
  void look(ChannelAxes& lane, Control& control, const Step& step);
  void note_motion(ChannelAxes& lane, Control& control, const Step& step);
  void begin_leg(std::size_t channel);
  void watch_channels();
  void begin(Run::Of of, std::size_t channel);
  void begin_line(const std::string& line, std::size_t channel);
  void end_line();
  void provide();
  void play();
  void go_on();
  bool is_over() const;
  void end_run();
  void show_what_is_in_force();
  void drop_run();
  ToolPosition standing_plainly(std::size_t channel) const;
  void begin_by_hand(ChannelAxes& lane, const std::vector<Motion>& motions);
  double factor_of(const Motion& motion) const;
  double way_while_held(std::size_t channel, const std::string& axis, double sign, double feed) const;
  // The functions below are in panel_by_hand.cpp.
  tl::expected<std::size_t, std::string> channel_of(int number) const;
  void let_go();
  Answer move_by_hand(std::size_t channel, const std::string& axis, double distance, double feed);
  // The functions below are in panel_real.cpp.
  bool is_real() const { return lane_->is_real(); }
  void watch_machine();
  void follow_machine();
  void go_to_touch();
  void begin_really();
  bool jog_really(std::size_t channel, const std::string& axis, double distance, double feed);
  // The functions below are in panel_restart.cpp.
  Answer may_go_there() const;
  tl::expected<Axes, std::string> end_of(const PanelPath& path) const;
  Answer check_paths(const std::vector<PanelPath>& paths, const RestartPoint& place) const;
  tl::expected<PanelSheet, std::string> sheet_of_channel(std::size_t channel, const Restart& restart, bool in_block,
                                                         const WayRules& rules) const;
  Answer prepare(PanelApproach& going, std::size_t channel, const Restart& restart, bool in_block, const std::set<std::string>& left) const;
  void match_paths(const PanelPath& path);
  Answer go_on_there();
  void execute(std::deque<PanelApproach::Line>& lines);
  Answer arrive(const RestartPoint& place);
  Answer resume_from(const RestartPoint& place);
  void set_other_channel(const OtherChannelState& channel);
  bool stand_as_in(const RestartPoint& place) const;

  const SessionOpener opens_;
  const PanelRecorder keeper_;
  const AxesMaker makes_axes_;
  std::function<void(const Step&)> looks_on_;
  std::unique_ptr<PanelSearch> search_;
  std::vector<std::unique_ptr<ChannelAxes>> lanes_;  // One object per channel; the objects are never replaced.
  ChannelAxes* lane_ = nullptr;                      // The object of the program's own channel. Only the machine's thread uses it.
  std::size_t own_ = 0;

  // Only the machine's thread uses the members below, except stops_.
  std::atomic<bool> stops_{false};  // A flag that stops the session while it is set. Any thread may set the flag.
  std::optional<Axes> start_;       // machine coordinates at the start of the run: PanelStart::axes
  std::vector<Axes> stands_;        // start position of each channel in machine coordinates: PanelStart::stands
  std::unique_ptr<Session> session_;
  std::unique_ptr<Stepping> stepping_;
  std::optional<Run> running_;
  std::optional<Stepping::How> how_;  // how far the run of motion goes; nullopt: the single block switch decides
  bool holds_ = false;                // true while a feed hold is active
  bool lets_go_ = false;              // True if the axis that a held key moves must stop.
  std::optional<std::chrono::steady_clock::time_point> held_until_;  // until then an axis moves by a held key; nullopt: none does
  bool resets_ = false;      // True if a reset was requested. The reset is executed when the axes are at rest.
  bool goes_on_ = false;     // True if the program has not ended: one of its channels is held before a block.
  Control* asks_ = nullptr;  // the control whose program waits for an answer to a question
  std::vector<Before> before_;
  std::optional<PanelApproach> going_;
  // Numbers of executed blocks: `entered_` in all lines of the operator, `entering_from_` before the line of the operator that is being
  // executed.
  std::uint64_t entered_ = 0, entering_from_ = 0;
  // While edited tables are applied: the search for the present location in a run with these tables; otherwise nullopt.
  std::optional<PanelSearch::SearchRequest> retables_;
  std::optional<Setup> tables_before_;  // the tables before the line of the operator that is being executed
  PanelLocation saved_location_;
  std::optional<std::size_t> probed_axis_;  // the axis that a probe motion by hand moves
  bool has_moved_ = false;                  // false until a motion starts after the machine was switched on
  std::map<std::string, double> variables_;
  std::map<std::string, std::uint32_t> set_by_;  // The program line that set each variable last. The key is the name of the variable.
  std::uint32_t last_line_ = 0;                  // number of the program line of the present block
  // The part of the displayed state that the machine's thread sets directly (switches, stop points, message); show() computes the rest.
  PanelState panel_state_;

  // Several threads use the members below; the mutex lock_ protects these members.
  std::mutex lock_;
  std::condition_variable wakes_;
  std::deque<Request> requests_;
  std::uint64_t request_count_ = 0;
  std::atomic<bool> ends_{false};
  std::atomic<std::chrono::steady_clock::rep> alive_at_{0};  // of the steady clock; 0: nobody has to keep the machine alive
  std::mutex off_lock_;
  PanelState shown_;
  Thread thread_;
};

}  // namespace kadr
