#pragma once
// Session: one run of a program, or of the programs of all channels of a machine. Everything that runs programs uses this interface: cli,
// page, debugger, library.
//
//   auto session = Session::open({control, machine, setup, program, limits});
//   (*session)->outlets().step = [](const Step& step) { … };                    // observes the run
//   while ((*session)->go_on() == Session::State::running) {}
//
//   program ─▶ ChannelRun (control → path → machine) ─▶ Steps ─▶ outlets ─▶ LookAhead ─▶ outlets, with the time the machine takes
//                                                            └─▶ Planned: axes in time, samples
//
// The whole state that determines how the run continues is a value: snapshot(), restore().

#include <memory>
#include <optional>
#include <vector>

#include "config/machine_profile.h"
#include "config/setup.h"
#include "control/control.h"
#include "session/channels.h"
#include "session/planned.h"

namespace kadr {

/// What to run, and with which control, machine and set-up.
struct SessionSpec {
  std::shared_ptr<const ControlDef> control;
  MachineProfile machine;
  Setup setup;
  Program program;
  RunLimits limits{};  // its `stop` ends a run early
};

/// Cheap to copy: copies share the content.
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
  /// Returns an error if the set-up has a key that the control does not support.
  static tl::expected<std::unique_ptr<Session>, ChannelsFault> open(SessionSpec spec);
  ~Session();
  Session(const Session&) = delete;  // its members point to each other
  Session& operator=(const Session&) = delete;

  // ---- its parts
  const ControlDef& def() const { return *spec_.control; }
  const MachineProfile& machine() const { return spec_.machine; }
  const Setup& setup() const { return spec_.setup; }
  /// All channels, sorted by their numbers.
  std::vector<Channel>& channels() { return channels_; }
  const std::vector<Channel>& channels() const { return channels_; }
  /// Index of the channel that runs the program itself (the others run programs of the set-up's channels).
  std::size_t own() const { return own_; }
  Control& control() { return *channels_[own_].control; }
  const Control& control() const { return *channels_[own_].control; }
  /// The control, for an outlet that queries it in the middle of a step: the control may run ahead in its own thread, and this call makes
  /// that thread stop first.
  Control& settled_control();

  // ---- observers: set them before the first go_on()
  Outlets& outlets(std::size_t channel) { return outlets_.own[channel]; }
  Outlets& outlets() { return outlets(own_); }
  ChannelOutlets& together() { return outlets_; }
  /// Gives the steps the time that the machine takes, through Outlets::timed, if something limits the speed. For a single channel only.
  ///   returns  the rules in force; nullopt if nothing limits the speed and the programmed times are kept
  std::optional<SpeedRules> look_ahead();
  /// Plans the axes in time with the least-time planner.
  Planned& plan(std::size_t channel, const StopToken& stop = {});
  Planned* planned(std::size_t channel) { return planned_[channel].get(); }
  /// With several channels: shows this step as soon as the virtual time has reached it.
  void show(std::size_t channel, const Step& step) { channels_run_->show(channel, step); }

  // ---- running
  enum class State : std::uint8_t {
    running,
    held,     // before a block, by Control::holds_before
    stopped,  // by an alarm, see stopped()
    ended,
  };
  /// Executes what the control passes on at once: some dozen actions of a single channel, or one block of the channel with the lowest time.
  State go_on();
  /// Calls go_on() until the session no longer runs.
  State run();
  /// States that nothing follows: steps that are kept back for look-ahead are emitted as if the program ended here. For a single channel
  /// only.
  State stop_here();
  /// Acknowledges the alarm that stopped the run: it continues with the next block, as after a reset of the control.
  void acknowledge() { acknowledge(own_); }
  void acknowledge(std::size_t channel);
  /// The operator enters a line (MDI): it is executed next, even after the end of the program or an alarm; then the program continues.
  ///   pre  held, stopped or ended; no block is open (Control::in_block)
  void enter(const std::string& line) { enter(line, own_); }
  void enter(const std::string& line, std::size_t channel);
  /// Of several channels, only this one continues, until it next stops or is held. enter() calls it for the program's own channel.
  void alone(std::size_t channel);
  /// Of several channels, each stays where its Control::holds_before holds it, until all are held, waiting or ended.
  void hold_each(bool on) {
    if (channels_run_) channels_run_->hold_each(on);
  }
  /// The position of the machine.
  ToolPosition stand(std::size_t channel) const;
  ToolPosition stand() const { return stand(own_); }
  /// States that the axes of a channel have been moved by hand and are now at this position, in machine coordinates.
  ///   pre  no block of the channel is open
  void stand_at(const Axes& machine) { stand_at(own_, machine); }
  void stand_at(std::size_t channel, const Axes& machine);
  /// States that the observers have changed in mid program: the clock of the outlets counts from here, plan() and look_ahead() start here.
  void change_outlets();
  /// Number of blocks that the control of a single channel has executed, as far as the rooms after the control have processed them.
  std::uint64_t blocks() const { return alone_ ? alone_->blocks() : control().blocks(); }
  /// How a channel ended.
  const Stopped& stopped(std::size_t channel) const;
  const Stopped& stopped() const { return stopped(own_); }
  /// Time that a channel has waited for others, s.
  double waited(std::size_t channel) const;

  // ---- snapshot
  /// Everything that determines how the run continues, taken between two calls of go_on(). It includes the state of the planners, but
  /// nothing else that outlets have computed. Returns nullopt while the control waits for a probe.
  std::optional<SessionSnapshot> snapshot();
  /// Continues from the snapshot, which may come from another session with the same program, control, machine, set-up and outlets.
  ///   alarms  as Control::restore()
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
  bool searched_ = false;       // the block search that the set-up's `search` requests is done
  std::vector<bool> attached_;  // Session::planned_ receives the steps
  // either a single channel …
  std::optional<Logic> logic_;
  std::unique_ptr<ChannelRun> alone_;
  // … or several
  std::unique_ptr<Channels> channels_run_;
  State state_ = State::running;
};

}  // namespace kadr
