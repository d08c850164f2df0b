#pragma once
// PanelMachine: a machine with its control, as an operator has it before him: a program, stretch by stretch, in true time. It lives in a
// thread of its own and goes on whoever looks at it; what an operator asks comes from any thread.
//
//   ask(PanelCommand) ──▶ its thread: Stepping, Session ──cells──▶ Playback ──▶ ServoClock ──▶ state(): a sample of the clock, and the
//   block
//                                                                                              that it belongs to
//
// A stretch begins where the axes stand and ends where they stand again: at the end of the program, before a block that it is held before,
// after a line that was entered. What it plans is of the machine that it is: the same code would drive another one.

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
  standing,  // before a block, or after a line that was entered
  running,
  held,       // by a feed hold: on its way, or standing
  ended,      // the program is over
  alarm,      // an alarm stopped it
  emergency,  // stop; reset() leaves it
};

/// One of several channels.
struct PanelChannel {
  int number = 1;
  std::vector<std::string> axes;
  ServoSample sample;
  PanelBlock block;                   // that it is on, or was on last
  AlarmReport::Line line;             // of it
  std::optional<PanelMeeting> waits;  // with its axes there
};

/// What an operator sees.
struct PanelState {
  PanelMode mode = PanelMode::standing;
  ServoSample sample;
  PanelShares shares;      // as they are set
  PanelBlock block;        // that the machine is on, or was on last
  AlarmReport::Line line;  // of it while it runs, else of the one that comes next
  bool entered = false;    // a line of the operator is carried out
  bool single = false, optional_stop = false;
  std::set<int> skip;
  std::map<std::size_t, StopPoint> stops;
  std::size_t hit = 0;        // the stop point that it is held by; 0: none
  std::string told;           // a message of the program
  std::string why;            // it stands by "M0", "M1", "restart"; empty: by something else
  bool asks = false;          // it waits for answer()
  bool takes_tables = false;  // tables that were edited are being taken over
  std::string not_kept;       // why what happens is not kept; empty: it is
  bool goes_there = false;    // it is led to where the program is to go on
  std::optional<AlarmReport> alarm;
  std::size_t can_undo = 0;            // lines that were entered
  std::optional<PanelLimit> limit;     // that acts
  std::uint64_t blocks = 0;            // carried out by the control, ahead of the machine
  std::vector<PanelChannel> channels;  // all, where there are several; what stands above is of the program's own
};

/// Where a machine is in its program.
struct PanelSpot {
  PanelMode mode = PanelMode::standing;
  Axes machine{};
  std::uint32_t number = 0;  // PanelBlock::number of the block that it is on, or stands before; 0: of none
  std::uint32_t line = 0;
  std::string file{};          // that the line stands in; empty: the program itself
  std::string text{};          // of the line
  std::vector<Axes> stands{};  // of each channel, by its index, where there are several
};

/// Who keeps what happens. Called in the machine's thread.
struct PanelKeeper {
  /// At each block.
  ///   returns  an error sentence: it is not kept
  std::function<std::string(const PanelSpot&)> spot;
  /// For the log of the shift: "run" "hold" "reset" "emergency" "override" "line" "restart" "stopped" "ended".
  std::function<void(const char* kind, const std::string& text, std::uint32_t line)> event;
  std::function<void(const AlarmReport&)> alarm;
  /// A line of the operator has changed tables of the control: from the next session on they must be so from the start.
  ///   returns  an error sentence: they are not kept
  std::function<std::string(const Setup& before, const Setup& after)> tables;
  /// The program is about to begin anew: it is the text that lies on the disk now, and stays so until this is called again, whatever is
  /// saved meanwhile.
  std::function<void()> begins;
};

/// A variable that is set.
struct PanelVariable {
  std::string name;
  double value = 0;
  std::uint32_t line = 0;  // of the program that set it last; 0: the set-up, or a line of the operator
};

/// Tables as the control has them now.
struct PanelTables {
  std::optional<RunState> state;  // nothing: the control does not show them
  std::vector<PanelVariable> variables;
};

/// An expression that is watched, and its value now.
struct PanelWatch {
  std::string text;
  std::optional<double> value;  // nothing: it cannot be understood, or is vacant
};

/// From where the axes stand to where they stand again.
struct PanelStretch {
  enum class Of : std::uint8_t { program, line, hand };
  Of of = Of::program;
  std::size_t channel = 0;           // of a line: its index
  std::unique_ptr<Planned> by_hand;  // of axes by hand
  bool planned_all = false;
  Session::State came_to = Session::State::running;
};

/// The way of one channel.
struct PanelWay {
  std::size_t channel = 0;  // its index
  std::vector<WayPoint> way;
};

/// On its way to where the program is to go on.
struct PanelGoing {
  struct Line {
    std::size_t channel;
    std::string text;
  };
  std::shared_ptr<const PanelPlace> place;
  std::deque<Line> before;    // to be carried out here
  std::deque<PanelWay> ways;  // one after the other
  std::deque<Line> after;     // to be carried out there
  bool is_there = false;
};

class PanelMachine {
 public:
  static constexpr double rate = 1000;  // Hz, of the servo clock
  static constexpr std::size_t most_entered = 1000, most_undone = 50, most_stops = 100;

  ///   returns  an error sentence
  ///   start    machine coordinates where the axes stand; nothing: where the set-up says
  ///   stands   those of each of several channels; empty: where the set-up says
  static tl::expected<std::unique_ptr<PanelMachine>, std::string> make(PanelOpens opens, PanelKeeper keeper = {},
                                                                       const std::optional<Axes>& start = {},
                                                                       std::vector<Axes> stands = {});
  ~PanelMachine();
  PanelMachine(const PanelMachine&) = delete;
  PanelMachine& operator=(const PanelMachine&) = delete;

  /// The axes stand, nothing is kept or told any more; what is asked is refused.
  void switch_off();

  using Answer = tl::expected<void, std::string>;  // an error sentence: why not
  /// The program goes on from where it is held, or from a feed hold.
  ///   how  nothing: a block, or to the next stop, by the switch
  Answer run(std::optional<Stepping::How> how = {});
  /// Feed hold: the axes come to rest on their path.
  Answer hold();
  /// The program is at its beginning, the axes are where they stand. Ends an alarm and an emergency stop.
  Answer reset();
  /// The axes stand within one instant of the clock, wherever they are.
  void stop_at_once();
  /// One block with each run().
  Answer set_single(bool on);
  /// M1 holds.
  Answer set_optional_stop(bool on);
  Answer set_skip(int number, bool on);
  Answer set_shares(const PanelShares& shares);
  /// To a question of the program (#3107 of the NCT): 0 cancel, 1 OK, 2 yes, 3 no; it goes on.
  Answer answer(double answer);
  /// A line of the operator (MDI), carried out at once.
  Answer enter(const std::string& line);
  /// The control and the virtual machine are as they were before the last line that was entered: not for a machine of iron.
  Answer undo();
  /// Axes by hand, relative, in machine coordinates: `way` mm or degrees, `feed` mm/min or degrees/min; 0: as fast as they can.
  ///   channel  its number; 0: the program's own
  Answer jog(const std::string& axis, double way, double feed, int channel = 0);
  /// Axes by hand, motion by motion, of the program's own channel.
  Answer lead(const std::vector<WayPoint>& way);
  ///   returns  its number
  tl::expected<std::size_t, std::string> add_stop(StopPoint point);
  Answer remove_stop(std::size_t number);

  /// Values of expressions as the program would write them.
  tl::expected<std::vector<PanelWatch>, std::string> watch_values(const std::vector<std::string>& expressions);
  tl::expected<PanelTables, std::string> tables();
  /// It stands, so that take_tables() can be called.
  Answer may_take_tables();
  /// The set-up that PanelOpens gives is another one: it is in force from here on, wherever the program stands.
  Answer take_tables();

  /// A place where the program could go on, as far as it has been found.
  PanelSearch::Answer find(const PanelSearch::Wish& wish) {
    if (state().takes_tables) return {};  // it is being searched for that
    return search_->find(wish);
  }
  /// What leads there from where the machine stands.
  ///   returns  that of the program's own channel, then those of PanelPlace::beside, in their order
  tl::expected<std::vector<PanelSheet>, std::string> sheets(const std::shared_ptr<const PanelPlace>& place, const WayRules& rules);
  /// The machine is led there, then stands before the block as if the program had run.
  ///   left  keys (key_of; of other channels with their number before: "2/tool:") of what stays as it is now
  ///   ways  of the sheets, or others that end there, one after the other; a channel without one stands there
  Answer go_there(std::shared_ptr<const PanelPlace> place, const std::set<std::string>& left, std::vector<PanelWay> ways);

  /// Called in its thread with each step that the control carries out, of program, lines and axes by hand, in their order; ahead of the
  /// machine. Before the first run().
  void watch(std::function<void(const Step&)> look) { looks_on_ = std::move(look); }

  PanelState state();
  const std::vector<std::string>& axes() const { return lane_->axes; }
  /// Of the channel with this index, as long as it is on.
  const std::vector<std::string>& axes(std::size_t channel) const { return lanes_[channel]->axes; }
  std::size_t channel_count() const { return lanes_.size(); }
  int number_of(std::size_t channel) const { return lanes_[channel]->number; }
  /// The program's own.
  std::size_t own() const { return own_; }

 private:
  using Stretch = PanelStretch;
  /// A line was entered.
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
  // panel_machine.cpp: its thread, and what is asked of it
  Answer ask(std::function<Answer()> what);
  void live();
  bool look_round();
  void carry_out_asked();
  void look_after_stretch();
  /// An emergency stop that has not been seen to yet.
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
  std::vector<std::unique_ptr<PanelLane>> lanes_;  // of all channels, as long as it lives
  PanelLane* lane_ = nullptr;                      // of the program's own, by its index
  std::size_t own_ = 0;

  // of its thread
  std::atomic<bool> stops_{false};  // the session, from any thread
  std::optional<Axes> start_;       // of the run: PanelStart
  std::vector<Axes> stands_;        //
  std::unique_ptr<Session> session_;
  std::unique_ptr<Stepping> stepping_;
  std::optional<Stretch> stretch_;
  std::optional<Stepping::How> how_;  // of the stretch that run() begins; nothing: by the switch
  bool holds_ = false;                // by a feed hold
  bool resets_ = false;               // as soon as the axes stand
  bool goes_on_ = false;              // the program is not over: held before a block of one of its channels
  Control* asks_ = nullptr;           // whose program asks
  std::vector<Before> before_;
  std::optional<PanelGoing> going_;
  std::uint64_t entered_ = 0, entering_from_ = 0;  // blocks of lines of the operator; carried out before the one under way
  std::optional<PanelSearch::Wish> retables_;      // where it stands, with other tables
  std::optional<Setup> tables_before_;             // of the line of the operator under way
  PanelSpot kept_spot_;
  bool has_moved_ = false;  // else what is kept is where it stood when it was switched on
  std::map<std::string, double> variables_;
  std::map<std::string, std::uint32_t> set_by_;  // line; of those that the program has set
  std::uint32_t last_line_ = 0;                  // of the block under way
  PanelState kept_;                              // what of the state lasts: switches, stop points, what was told

  // between threads
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
