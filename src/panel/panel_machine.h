#pragma once
// PanelMachine: a machine with its control, as an operator has it before him: a program, stretch by stretch, in true time. It lives in a
// thread of its own and goes on whoever looks at it; what an operator asks comes from any thread.
//
//   ask(PanelCommand) ──▶ its thread: Stepping, Session ──cells──▶ Playback ──▶ ServoClock ──▶ state(): a sample of the clock, and the block
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
#include <thread>
#include <vector>

#include "panel/panel_blocks.h"
#include "panel/servo_clock.h"
#include "session/planned.h"
#include "session/stepping.h"

namespace kadr {

enum class PanelMode : std::uint8_t {
  standing,   // before a block, or after a line that was entered
  running,
  held,       // by a feed hold: on its way, or standing
  ended,      // the program is over
  alarm,      // an alarm stopped it
  emergency,  // stop; reset() leaves it
};

/// What an operator sees.
struct PanelState {
  PanelMode mode = PanelMode::standing;
  ServoSample sample;
  double override_share = 1;  // as it is set
  PanelBlock block;           // that the machine is on, or was on last
  AlarmReport::Line line;     // of it while it runs, else of the one that comes next
  bool entered = false;       // a line of the operator is carried out
  bool single = false, optional_stop = false;
  std::set<int> skip;
  std::map<std::size_t, StopPoint> stops;
  std::size_t hit = 0;        // the stop point that it is held by; 0: none
  std::string told;           // a message of the program
  std::string why;            // it stands by "M0", "M1"; empty: by something else
  std::optional<AlarmReport> alarm;
  std::size_t can_undo = 0;   // lines that were entered
  std::uint64_t blocks = 0;   // carried out by the control, ahead of the machine
};

/// From where the axes stand to where they stand again.
struct PanelStretch {
  enum class Of : std::uint8_t { program, line, hand };
  Of of = Of::program;
  Planned* planned = nullptr;        // of the session, or …
  std::unique_ptr<Planned> by_hand;  // … of axes by hand
  std::unique_ptr<Playback> playback;
  std::deque<TimedCells> to_come;    // planned and not offered yet, but for
  std::size_t offered = 0;           // so many of the first
  bool planned_all = false;
  Session::State came_to = Session::State::running;
};

class PanelMachine {
 public:
  static constexpr double rate = 1000;  // Hz, of the servo clock
  static constexpr std::size_t most_entered = 1000, most_undone = 50, most_stops = 100;

  /// `spec`: makes a session of the program from its beginning, with `start` as machine coordinates where the axes stand (nothing: those of
  /// the set-up).
  using Opens = std::function<tl::expected<std::unique_ptr<Session>, std::string>(const std::optional<Axes>& start, const StopToken& stop)>;
  ///   returns  an error sentence
  static tl::expected<std::unique_ptr<PanelMachine>, std::string> make(Opens opens);
  ~PanelMachine();
  PanelMachine(const PanelMachine&) = delete;
  PanelMachine& operator=(const PanelMachine&) = delete;

  using Answer = tl::expected<void, std::string>;  // an error sentence: why not
  /// The program goes on from where it is held, or from a feed hold.
  Answer run();
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
  /// 0 … 1 of the planned speed.
  Answer override_to(double share);
  /// A line of the operator (MDI), carried out at once.
  Answer enter(const std::string& line);
  /// The control and the virtual machine are as they were before the last line that was entered: not for a machine of iron.
  Answer undo();
  /// Axes by hand, relative, in machine coordinates: `way` mm or degrees, `feed` mm/min or degrees/min; 0: as fast as they can.
  Answer jog(const std::string& axis, double way, double feed);
  ///   returns  its number
  tl::expected<std::size_t, std::string> add_stop(StopPoint point);
  Answer remove_stop(std::size_t number);

  PanelState state();
  const std::vector<std::string>& axes() const { return axes_; }

 private:
  using Stretch = PanelStretch;
  /// A line was entered.
  struct Before {
    Stepping::Memory stepping;
    Axes machine;
    Placement placement;
  };
  struct Asked {
    std::function<Answer()> what;
    std::promise<Answer> answer;
  };

  explicit PanelMachine(Opens opens) : opens_(std::move(opens)) {}
  // panel_machine.cpp: its thread, and what is asked of it
  Answer ask(std::function<Answer()> what);
  void live();
  void carry_out_asked();
  void look_after_stretch();
  /// An emergency stop that has not been seen to yet.
  bool must_stop() const { return clock_->was_stopped() && kept_.mode != PanelMode::emergency; }
  void stand_still();
  Answer open(const std::optional<Axes>& start);
  Answer may_begin() const;
  void set_share();
  void show();
  AlarmReport::Line line_of(const ServoSample& sample) const;
  // panel_stretch.cpp
  void look(const Step& step);
  void begin(Stretch::Of of);
  void set_up(Stretch& stretch);
  void provide();
  bool offer();
  void go_on();
  void end_stretch();
  void drop_stretch();
  Answer move_by_hand(const std::string& axis, double way, double feed);

  const Opens opens_;
  std::vector<std::string> axes_;
  AxisRoles roles_;

  // of its thread
  std::atomic<bool> stops_{false};  // the session, from any thread
  std::unique_ptr<Session> session_;
  std::unique_ptr<Stepping> stepping_;
  std::unique_ptr<ServoClock> clock_;
  std::optional<Stretch> stretch_;
  bool holds_ = false;   // by a feed hold
  bool resets_ = false;  // as soon as the axes stand
  PanelBlocks blocks_;
  PanelBlock pending_;   // the motion that is being planned
  PanelBlock on_;        // that the machine is on, or was on last
  Placement placement_;
  std::uint32_t modes_of_ = 0;  // Origin::number of pending_.modes
  std::vector<Before> before_;
  PanelState kept_;      // what of the state lasts: switches, stop points, what was told

  // between threads
  std::mutex lock_;
  std::condition_variable wakes_;
  std::deque<Asked> asked_;
  bool ends_ = false;
  PanelState shown_;
  std::thread thread_;
};

}  // namespace kadr
