#pragma once
// Session: a program being run, or those of all channels of a machine. The one door for whoever runs programs: cli, page, debugger,
// library (design.md 9).
//
//   auto session = Session::open({control, machine, setup, program, limits});
//   (*session)->outlets().step = [](const Step& step) { … };                    // who looks
//   while ((*session)->go_on() == Session::State::running) {}
//
//   program ─▶ ChannelRun (control → path → machine) ─▶ Steps ─▶ outlets ─▶ LookAhead ─▶ outlets, in the machine's time
//                                                            └─▶ Planned: axes in time, samples
//
// All that decides how it goes on is a value: snapshot(), restore().

#include <memory>
#include <optional>
#include <vector>

#include "config/machine_profile.h"
#include "config/setup.h"
#include "control/control.h"
#include "session/channels.h"
#include "session/planned.h"

namespace kadr {

/// What is run, and on what.
struct SessionSpec {
  std::shared_ptr<const ControlDef> control;
  MachineProfile machine;
  Setup setup;
  Program program;
  RunLimits limits{};  // its `stop` ends a run
};

/// Copies share what they hold.
class SessionSnapshot {
 public:
  struct Content;
  explicit SessionSnapshot(std::shared_ptr<const Content> content) : content_(std::move(content)) {}
  const Content& content() const { return *content_; }

 private:
  std::shared_ptr<const Content> content_;
};

class Session {
 public:
  /// A key of the set-up that the control has not: told.
  static tl::expected<std::unique_ptr<Session>, ChannelsFault> open(SessionSpec spec);
  ~Session();
  Session(const Session&) = delete;  // its rooms point to each other
  Session& operator=(const Session&) = delete;

  // ---- what it is made of
  const ControlDef& def() const { return *spec_.control; }
  const MachineProfile& machine() const { return spec_.machine; }
  const Setup& setup() const { return spec_.setup; }
  /// All channels, in the order of their numbers.
  std::vector<Channel>& channels() { return channels_; }
  const std::vector<Channel>& channels() const { return channels_; }
  /// The program's own channel.
  std::size_t own() const { return own_; }
  Control& control() { return *channels_[own_].control; }
  const Control& control() const { return *channels_[own_].control; }
  /// The same to be asked by an outlet in the middle of a step: the control may be ahead in a thread of its own, and stands still now.
  Control& settled_control();

  // ---- who looks: before the first go_on()
  Outlets& outlets(std::size_t channel) { return outlets_.own[channel]; }
  Outlets& outlets() { return outlets(own_); }
  ChannelOutlets& together() { return outlets_; }
  /// The steps get the time that the machine takes, where something limits the speed: Outlets::timed. Of a channel alone.
  ///   returns  the rules; nothing: the programmed times hold
  std::optional<SpeedRules> look_ahead();
  /// The axes in time by the planner of least time.
  Planned& plan(std::size_t channel, const StopToken& stop = {});
  Planned* planned(std::size_t channel) { return planned_[channel].get(); }
  /// Of several channels: this step is shown when its time has come.
  void show(std::size_t channel, const Step& step) { channels_run_->show(channel, step); }

  // ---- going on
  enum class State : std::uint8_t {
    running,
    held,     // before a block, by Control::holds_before
    stopped,  // by an alarm: stopped() tells
    ended,
  };
  /// Carries out as much as is handed over at once: some dozen actions of the only channel, a block of the one whose time is lowest.
  State go_on();
  /// Until it stands.
  State run();
  /// Nothing more is to come: what the rooms hold back to see ahead is let out, as if the program ended here. Of a channel alone.
  State stop_here();
  /// The alarm that stopped it is answered for: it goes on with the next block, as after a reset of the control.
  void acknowledge() { acknowledge(own_); }
  void acknowledge(std::size_t channel);
  /// The operator enters a line (MDI): it is carried out next, also after the program's end or an alarm; then the program goes on.
  ///   pre  held, stopped or ended; no block is open (Control::in_block)
  void enter(const std::string& line) { enter(line, own_); }
  void enter(const std::string& line, std::size_t channel);
  /// Of several channels this one alone goes on, until it stands the next time. enter() calls it for the program's own.
  void alone(std::size_t channel);
  /// Of several channels each stays where it is held, by its Control::holds_before, until all are held, wait or have ended.
  void hold_each(bool on) {
    if (channels_run_) channels_run_->hold_each(on);
  }
  /// Where the machine stands.
  ToolPosition stand(std::size_t channel) const;
  ToolPosition stand() const { return stand(own_); }
  /// The axes of a channel have been moved by hand: they stand there now, machine coordinates.
  ///   pre  no block of it is open
  void stand_at(const Axes& machine) { stand_at(own_, machine); }
  void stand_at(std::size_t channel, const Axes& machine);
  /// Who looks has changed in mid program: the outlets' clock counts from here, plan() and look_ahead() begin here.
  void change_outlets();
  /// Blocks that the control of a channel alone has carried out, as far as the rooms after it have come.
  std::uint64_t blocks() const { return alone_ ? alone_->blocks() : control().blocks(); }
  /// How a channel came to its end.
  const Stopped& stopped(std::size_t channel) const;
  const Stopped& stopped() const { return stopped(own_); }
  /// s in which a channel has waited for others.
  double waited(std::size_t channel) const;

  // ---- snapshot
  /// All that decides how it goes on, between two calls of go_on(); not what the outlets have made of it, but for the planner's.
  /// Nothing while a probe is waited for.
  std::optional<SessionSnapshot> snapshot();
  /// Goes on from there; `from` may be of another session of the same program, control, machine, set-up and outlets.
  ///   alarms  those of Control::restore()
  Status restore(const SessionSnapshot& from);

 private:
  explicit Session(SessionSpec spec);
  void begin();
  void attach_planners();
  State end(ChannelRun::State state);
  State together(ChannelRun::State state);
  std::optional<State> begin_by_search();

  SessionSpec spec_;
  std::vector<Channel> channels_;
  std::size_t own_ = 0;
  ChannelOutlets outlets_;
  std::vector<std::unique_ptr<Planned>> planned_;
  std::optional<SpeedRules> rules_;
  bool begun_ = false;
  bool searched_ = false;       // as the set-up's `search` asks for
  std::vector<bool> attached_;  // Session::planned_ gets the steps
  // one channel alone, or …
  std::optional<Logic> logic_;
  std::unique_ptr<ChannelRun> alone_;
  // … several
  std::unique_ptr<Channels> channels_run_;
  State state_ = State::running;
};

}  // namespace kadr
