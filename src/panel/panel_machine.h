#pragma once
// PanelMachine: a machine with its control, as an operator uses it: it runs a program, section by section, in real time. It has its own
// thread and runs with or without clients; operator requests may come from any thread.
//
//   ask(PanelCommand) ──▶ its thread: Stepping, Session ──cells──▶ Playback ──▶ ServoClock ──▶ state(): a sample of the clock,
//                                                                                              and the block it belongs to
//
// A stretch starts where the axes are at rest and ends at their next rest: at the end of the program, before a block that holds, or after
// an entered line. The plan is that of the selected machine: the same code could drive another one.

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
#include "panel/panel_lane.h"
#include "panel/panel_opens.h"
#include "panel/panel_search.h"
#include "panel/panel_sheet.h"
#include "session/stepping.h"

namespace kadr {

enum class PanelMode : std::uint8_t {
  standing,  // before a block, or after an entered line
  running,
  held,       // by a feed hold: slowing down, or at rest
  ended,      // the program is over
  alarm,      // stopped by an alarm
  emergency,  // emergency stop; reset() ends it
};

/// One of several channels.
struct PanelChannel {
  int number = 1;
  std::vector<std::string> axes;
  ServoSample sample;
  PanelBlock block;                   // that it is on, or was on last
  AlarmReport::Line line;             // of that block
  std::optional<PanelMeeting> waits;  // set once its axes have arrived
};

/// Everything that an operator sees.
struct PanelState {
  PanelMode mode = PanelMode::standing;
  ServoSample sample;
  PanelShares shares;      // as set by the operator
  PanelBlock block;        // that the machine is on, or was on last
  AlarmReport::Line line;  // while the program runs, of that block; else of the next one
  bool entered = false;    // a line of the operator is being executed
  bool single = false, optional_stop = false;
  std::set<int> skip;
  std::map<std::size_t, StopPoint> stops;
  std::size_t hit = 0;        // the stop point that holds it; 0: none
  std::string told;           // a message of the program
  std::string why;            // the reason for a stop: "M0", "M1", "restart"; empty: another reason
  bool asks = false;          // it waits for answer()
  bool takes_tables = false;  // edited tables are being applied
  std::string not_kept;       // why events are not being saved; empty: they are
  bool goes_there = false;    // it moves to the block where the program is to continue
  std::optional<AlarmReport> alarm;
  std::size_t can_undo = 0;            // number of entered lines
  std::optional<PanelLimit> limit;     // what limits the speed now
  std::uint64_t blocks = 0;            // executed by the control, ahead of the machine
  std::vector<PanelChannel> channels;  // all, if there are several; the members above are of the program's own
};

/// Location of a machine in its program.
struct PanelSpot {
  PanelMode mode = PanelMode::standing;
  Axes machine{};
  std::uint32_t number = 0;  // PanelBlock::number of the current block, or of the next one; 0: none
  std::uint32_t line = 0;
  std::string file{};          // file of the line; empty: the program itself
  std::string text{};          // of the line
  std::vector<Axes> stands{};  // position of each channel, by index, if there are several
};

/// Saves events of the machine. Called in the machine's thread.
struct PanelKeeper {
  /// Called at each block.
  ///   returns  an error sentence if the location cannot be saved
  std::function<std::string(const PanelSpot&)> spot;
  /// For the log of the shift: "run" "hold" "reset" "emergency" "override" "line" "restart" "stopped" "ended".
  std::function<void(const char* kind, const std::string& text, std::uint32_t line)> event;
  std::function<void(const AlarmReport&)> alarm;
  /// A line of the operator has changed tables of the control: later sessions must start with the changed tables.
  ///   returns  an error sentence if they cannot be saved
  std::function<std::string(const Setup& before, const Setup& after)> tables;
  /// The program is about to start again. From now until the next call the program is the text that is on the disk now, whatever is saved
  /// meanwhile.
  std::function<void()> begins;
};

/// A variable with a value.
struct PanelVariable {
  std::string name;
  double value = 0;
  std::uint32_t line = 0;  // program line that set it last; 0: the set-up, or a line of the operator
};

/// The present tables of the control.
struct PanelTables {
  std::optional<RunState> state;  // nullopt: the control does not show them
  std::vector<PanelVariable> variables;
};

/// A watched expression and its present value.
struct PanelWatch {
  std::string text;
  std::optional<double> value;  // nullopt: not understood, or vacant
};

/// Motion from one rest of the axes to the next.
struct PanelStretch {
  enum class Of : std::uint8_t { program, line, hand };
  Of of = Of::program;
  std::size_t channel = 0;           // for a line: the index of its channel
  std::unique_ptr<Planned> by_hand;  // for motion by hand
  bool planned_all = false;
  Session::State came_to = Session::State::running;
};

/// The path of one channel.
struct PanelWay {
  std::size_t channel = 0;  // its index
  std::vector<WayPoint> way;
};

/// State while the machine moves to the block where the program is to continue.
struct PanelGoing {
  struct Line {
    std::size_t channel;
    std::string text;
  };
  std::shared_ptr<const PanelPlace> place;
  std::deque<Line> before;    // to be executed before the paths
  std::deque<PanelWay> ways;  // to be travelled one after the other
  std::deque<Line> after;     // to be executed after the paths
  bool is_there = false;
};

class PanelMachine {
 public:
  static constexpr double rate = 1000;  // Hz, of the servo clock
  static constexpr std::size_t most_entered = 1000, most_undone = 50, most_stops = 100;

  ///   returns  an error sentence
  ///   start    machine coordinates of the axes; nullopt: from the set-up
  ///   stands   the same for each of several channels; empty: from the set-up
  static tl::expected<std::unique_ptr<PanelMachine>, std::string> make(PanelOpens opens, PanelKeeper keeper = {},
                                                                       const std::optional<Axes>& start = {},
                                                                       std::vector<Axes> stands = {});
  ~PanelMachine();
  PanelMachine(const PanelMachine&) = delete;
  PanelMachine& operator=(const PanelMachine&) = delete;

  /// Stops the axes; nothing is saved or reported any more, and requests are refused.
  void switch_off();

  using Answer = tl::expected<void, std::string>;  // an error sentence: why not
  /// Continues the program from where it is held, or from a feed hold.
  ///   how  nullopt: one block, or up to the next stop, by the single block switch
  Answer run(std::optional<Stepping::How> how = {});
  /// Feed hold: the axes slow down and stop on their path.
  Answer hold();
  /// Returns the program to its beginning; the axes stay where they are. Ends an alarm and an emergency stop.
  Answer reset();
  /// Emergency stop: the axes stop within one instant of the clock, wherever they are.
  void stop_at_once();
  /// Single block: each run() executes one block.
  Answer set_single(bool on);
  /// Optional stop: M1 holds.
  Answer set_optional_stop(bool on);
  Answer set_skip(int number, bool on);
  Answer set_shares(const PanelShares& shares);
  /// Answers a question of the program (#3107 of the NCT): 0 cancel, 1 OK, 2 yes, 3 no; the program continues.
  Answer answer(double answer);
  /// Executes a line of the operator (MDI) at once.
  Answer enter(const std::string& line);
  /// Restores control and virtual machine to the state before the last entered line: not possible on a real machine.
  Answer undo();
  /// Moves an axis by hand, relative, in machine coordinates: `way` in mm or degrees, `feed` in mm/min or degrees/min; 0: as fast as
  /// possible.
  ///   channel  its number; 0: the program's own
  Answer jog(const std::string& axis, double way, double feed, int channel = 0);
  /// Moves the axes of the program's own channel by hand, motion by motion.
  Answer lead(const std::vector<WayPoint>& way);
  ///   returns  the number of the stop point
  tl::expected<std::size_t, std::string> add_stop(StopPoint point);
  Answer remove_stop(std::size_t number);

  /// Evaluates expressions as the program would write them.
  tl::expected<std::vector<PanelWatch>, std::string> watch_values(const std::vector<std::string>& expressions);
  tl::expected<PanelTables, std::string> tables();
  /// Succeeds if the machine is at rest, so that take_tables() can be called.
  Answer may_take_tables();
  /// PanelOpens returns a changed set-up: it applies from here on, wherever the program is.
  Answer take_tables();

  /// Searches for a block where the program could continue. Returns what is found so far.
  PanelSearch::Answer find(const PanelSearch::Wish& wish) {
    if (state().takes_tables) return {};  // a search for the tables is in progress
    return search_->find(wish);
  }
  /// What restores the state of that place, starting from the present state of the machine.
  ///   returns  the sheet of the program's own channel, then the sheets of the channels in PanelPlace::beside, in their order
  tl::expected<std::vector<PanelSheet>, std::string> sheets(const std::shared_ptr<const PanelPlace>& place, const WayRules& rules);
  /// Moves the machine to the place, and holds it before the block as if the program had run to there.
  ///   left  keys (key_of; for other channels with their number as a prefix: "2/tool:") of items that keep their present value
  ///   ways  of the sheets, or others with the same ends, one after the other; a channel without a path is in place already
  Answer go_there(std::shared_ptr<const PanelPlace> place, const std::set<std::string>& left, std::vector<PanelWay> ways);

  /// Called in the machine's thread with each step that the control executes, of program, lines and motion by hand, in order and ahead of
  /// the machine. Set it before the first run().
  void watch(std::function<void(const Step&)> look) { looks_on_ = std::move(look); }

  PanelState state();
  const std::vector<std::string>& axes() const { return lane_->axes; }
  /// Axes of the channel with this index; valid as long as the machine is on.
  const std::vector<std::string>& axes(std::size_t channel) const { return lanes_[channel]->axes; }
  std::size_t channel_count() const { return lanes_.size(); }
  int number_of(std::size_t channel) const { return lanes_[channel]->number; }
  /// Index of the program's own channel.
  std::size_t own() const { return own_; }

 private:
  using Stretch = PanelStretch;
  /// The state before a line was entered.
  struct Before {
    Stepping::Memory stepping;
    Axes machine;
    Placement placement;
    std::uint64_t entered;
  };
  struct Asked {
    std::function<Answer()> what;
    std::promise<Answer> answer;
    std::uint64_t number = 0;
  };

  PanelMachine(PanelOpens opens, PanelKeeper keeper, std::vector<Axes> stands)
      : opens_(std::move(opens)), keeper_(std::move(keeper)), stands_(std::move(stands)) {}
  // panel_machine.cpp: its thread, and the requests
  Answer ask(std::function<Answer()> what);
  void live();
  bool look_round();
  void carry_out_asked();
  void look_after_stretch();
  /// True after an emergency stop that the machine's thread has not handled yet.
  bool must_stop() const { return lane_->clock.was_stopped() && kept_.mode != PanelMode::emergency; }
  void stand_still();
  Answer may_begin() const;
  void set_share();
  void show_channels(PanelState& now) const;
  bool is_alone() const { return lanes_.size() == 1; }
  void show();
  // panel_opening.cpp
  Answer make_lanes();
  Answer begin_session(const std::optional<Axes>& start);
  void obey_switches();
  Answer open(const std::optional<Axes>& start);
  Answer start_over();
  void begin_search();
  void stand_here();
  // panel_keeping.cpp
  void keep_spot(const PanelState& now);
  void tell(const char* kind, const std::string& text = {}, std::uint32_t line = 0) const;
  void note_variables(std::uint32_t line);
  void look_after_tables();
  void keep_tables(const Setup& before);
  bool is_in_contour() const;
  Answer may_take_tables_now() const;
  AlarmReport::Line line_of(const ServoSample& sample) const;
  // panel_stretch.cpp
  void look(PanelLane& lane, Control& control, const Step& step);
  void begin_leg(std::size_t channel);
  void watch_channels();
  void begin(Stretch::Of of, std::size_t channel);
  void begin_line(const std::string& line, std::size_t channel);
  void end_line();
  void provide();
  void play();
  void go_on();
  bool is_over() const;
  void end_stretch();
  void show_what_is_in_force();
  void drop_stretch();
  ToolPosition standing_plainly(std::size_t channel) const;
  void begin_by_hand(PanelLane& lane, const std::vector<Motion>& motions);
  Answer move_by_hand(std::size_t channel, const std::string& axis, double way, double feed);
  // panel_restart.cpp
  Answer may_go_there() const;
  tl::expected<Axes, std::string> end_of(const PanelWay& way) const;
  Answer lead_to(const std::vector<PanelWay>& ways, const PanelPlace& place) const;
  tl::expected<PanelSheet, std::string> sheet_of_channel(std::size_t channel, const Restart& restart, bool in_block,
                                                         const WayRules& rules) const;
  Answer prepare(PanelGoing& going, std::size_t channel, const Restart& restart, bool in_block, const std::set<std::string>& left) const;
  void go_along(const PanelWay& way);
  Answer go_on_there();
  void carry_out(std::deque<PanelGoing::Line>& lines);
  Answer arrive(const PanelPlace& place);
  Answer remember(const PanelPlace& place);
  void stand_beside(const PanelBeside& channel);
  bool stand_as_in(const PanelPlace& place) const;

  const PanelOpens opens_;
  const PanelKeeper keeper_;
  std::function<void(const Step&)> looks_on_;
  std::unique_ptr<PanelSearch> search_;
  std::vector<std::unique_ptr<PanelLane>> lanes_;  // of all channels; never replaced
  PanelLane* lane_ = nullptr;                      // of the program's own channel, for use by its thread
  std::size_t own_ = 0;

  // used by its thread only, except for stops_
  std::atomic<bool> stops_{false};  // stops the session; set by any thread
  std::optional<Axes> start_;       // of the run: PanelStart
  std::vector<Axes> stands_;        // likewise
  std::unique_ptr<Session> session_;
  std::unique_ptr<Stepping> stepping_;
  std::optional<Stretch> stretch_;
  std::optional<Stepping::How> how_;  // for the stretch that run() starts; nullopt: by the switch
  bool holds_ = false;                // by a feed hold
  bool resets_ = false;               // reset as soon as the axes are at rest
  bool goes_on_ = false;              // the program has not ended: a block of one of its channels is held
  Control* asks_ = nullptr;           // the control whose program asks a question
  std::vector<Before> before_;
  std::optional<PanelGoing> going_;
  std::uint64_t entered_ = 0, entering_from_ = 0;  // blocks in lines of the operator; blocks executed before the current line
  std::optional<PanelSearch::Wish> retables_;      // the present location, searched again with other tables
  std::optional<Setup> tables_before_;             // before the line of the operator that is being executed
  PanelSpot kept_spot_;
  bool has_moved_ = false;  // false: the saved location is that of switching on
  std::map<std::string, double> variables_;
  std::map<std::string, std::uint32_t> set_by_;  // by variable: the program line that set it last
  std::uint32_t last_line_ = 0;                  // of the current block
  PanelState kept_;                              // the lasting part of the state: switches, stop points, message

  // shared between threads
  std::mutex lock_;
  std::condition_variable wakes_;
  std::deque<Asked> asked_;
  std::uint64_t asked_count_ = 0;
  std::atomic<bool> ends_{false};
  std::mutex off_lock_;
  PanelState shown_;
  Thread thread_;
};

}  // namespace kadr
