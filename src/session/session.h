#pragma once
// Session: one run of a program, or of the programs of all channels of a machine. All code that runs programs uses this interface: the
// commands, the page, the debugger, the library.
//
//   auto session = Session::open({control, machine, setup, program, limits});
//   (*session)->outlets().step = [](const Step& step) { … };                    // observes the run
//   while ((*session)->go_on() == Session::State::running) {}
//
//   program ─▶ ChannelRun (control → path → machine) ─▶ Steps ─▶ outlets ─▶ LookAhead ─▶ outlets, with the time the machine takes
//                                                            └─▶ Planned: axes in time, samples
//
// The whole state that determines how the run continues can be copied and restored: snapshot(), restore().

#include <memory>
#include <optional>
#include <vector>

#include "config/machine/machine_profile.h"
#include "config/setup/setup.h"
#include "control/control.h"
#include "session/channels.h"
#include "session/planned.h"

namespace kadr {

/// The program to run, and the control, machine and set-up for it.
struct SessionSpec {
  std::shared_ptr<const ControlDef> control;
  MachineProfile machine;
  Setup setup;
  Program program;
  RunLimits limits{};  // RunLimits::stop ends a run early
};

/// A stored state of a session. It is cheap to copy, since copies share the content.
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
  /// Opens a session. Returns an error if the set-up has a key that the control does not support.
  static tl::expected<std::unique_ptr<Session>, ChannelsFault> open(SessionSpec spec);
  ~Session();
  Session(const Session&) = delete;  // the members of a session point to each other
  Session& operator=(const Session&) = delete;

  // ---- the parts of a session
  const ControlDef& def() const { return *spec_.control; }
  const MachineProfile& machine() const { return spec_.machine; }
  const Setup& setup() const { return spec_.setup; }
  /// All channels, sorted by channel number.
  std::vector<Channel>& channels() { return channels_; }
  const std::vector<Channel>& channels() const { return channels_; }
  /// Index of the channel that runs the program itself. The other channels run the programs that the set-up assigns to them.
  std::size_t own() const { return own_; }
  Control& control() { return *channels_[own_].control; }
  const Control& control() const { return *channels_[own_].control; }
  /// The control, for an outlet that queries it in the middle of a step. The control may run ahead in its own thread; this call waits
  /// until that thread has stopped.
  Control& settled_control();

  // ---- the observers; they must be set before the first go_on()
  Outlets& outlets(std::size_t channel) { return outlets_.own[channel]; }
  Outlets& outlets() { return outlets(own_); }
  ChannelOutlets& together() { return outlets_; }
  /// Makes Outlets::timed receive the steps with the time that the machine really takes, if something limits the speed. For a single
  /// channel only.
  ///   returns  the rules that limit the speed; nullopt if there are none, so that the programmed times are valid
  std::optional<SpeedRules> look_ahead();
  /// Creates a planner that plans the axes of a channel in time (least time).
  Planned& plan(std::size_t channel, const StopToken& stop = {});
  Planned* planned(std::size_t channel) { return planned_[channel].get(); }
  /// With several channels: passes this step on as soon as the virtual time of all channels has reached it.
  void show(std::size_t channel, const Step& step) { channels_run_->show(channel, step); }

  // ---- running the session
  enum class State : std::uint8_t {
    running,
    held,     // the session is held before a block, by Control::holds_before
    stopped,  // an alarm has stopped the session, see stopped()
    ended,
  };
  /// Executes the next actions that the control passes together: some dozen actions of a single channel, or one block of the channel with
  /// the lowest virtual time.
  State go_on();
  /// Calls go_on() until it returns a state other than running.
  State run();
  /// Declares that no step follows: steps that are kept back for look-ahead are passed on as if the program ended here. For a single
  /// channel only.
  State stop_here();
  /// Acknowledges the alarm that stopped the run. The run continues with the next block, as after a reset of the control.
  void acknowledge() { acknowledge(own_); }
  void acknowledge(std::size_t channel);
  /// Enters a line of the operator (MDI). It is executed next, even after the end of the program or an alarm; then the program continues.
  ///   pre  the session is held, stopped or ended, and not in the middle of a block (Control::in_block)
  void enter(const std::string& line) { enter(line, own_); }
  void enter(const std::string& line, std::size_t channel);
  /// With several channels: only this channel continues, until it stops or is held next. enter() calls this function for the program's
  /// own channel.
  void alone(std::size_t channel);
  /// With several channels: each channel stays at the block where Control::holds_before holds it, until all are held, waiting or ended.
  void hold_each(bool on) {
    if (channels_run_) channels_run_->hold_each(on);
  }
  /// The machine position of a channel.
  ToolPosition stand(std::size_t channel) const;
  ToolPosition stand() const { return stand(own_); }
  /// Declares that the axes of a channel have been moved by hand and are now at this position, in machine coordinates.
  ///   pre  the channel is not in the middle of a block
  void stand_at(const Axes& machine) { stand_at(own_, machine); }
  void stand_at(std::size_t channel, const Axes& machine);
  /// Call after the observers were changed in mid program. The clock of the outlets counts from now on; plan() and look_ahead() start
  /// from here.
  void change_outlets();
  /// Number of blocks that the control of a single channel has executed and the later rooms (path, machine) have processed.
  std::uint64_t blocks() const { return alone_ ? alone_->blocks() : control().blocks(); }
  /// How a channel ended.
  const Stopped& stopped(std::size_t channel) const;
  const Stopped& stopped() const { return stopped(own_); }
  /// Time that a channel has waited for others, s.
  double waited(std::size_t channel) const;

  // ---- storing and restoring the state
  /// Returns everything that determines how the run continues, between two calls of go_on(). The state of the planners is included; other
  /// data computed by outlets are not. Returns nullopt while the control waits for a probe.
  std::optional<SessionSnapshot> snapshot();
  /// Restores the snapshot; the run continues from there. The snapshot may come from another session with the same program, control,
  /// machine, set-up and outlets.
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
  bool searched_ = false;       // the block search that the key `search` of the set-up requests has been done
  std::vector<bool> attached_;  // by channel: the planner in planned_ receives the steps
  // used with a single channel:
  std::optional<Logic> logic_;
  std::unique_ptr<ChannelRun> alone_;
  // used with several channels:
  std::unique_ptr<Channels> channels_run_;
  State state_ = State::running;
};

}  // namespace kadr
