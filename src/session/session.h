#pragma once
// Session: one run of a program, or of the programs of all channels of a machine. All code that runs programs uses this interface: the
// commands, the page, the debugger, the library.
//
//   auto session = Session::open({control, machine, setup, program, limits});
//   (*session)->outlets().step = [](const Step& step) { … };                    // observes the run
//   while ((*session)->go_on() == Session::State::running) {}
//
//   program ─▶ ChannelRun (control → path → machine) ─▶ Steps ─▶ outlets ─▶ LookAhead ─▶ outlets, with the time the machine takes
//                                                           └─▶ Planned: axes in time, samples
//
// The whole state that determines how the run continues can be stored and restored: snapshot(), restore().

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
  RunLimits limits{};  // limits of the run; RunLimits::stop can end the run early
};

/// A stored state of a session. A copy needs little time and memory, since all copies share the same content.
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
  Session(const Session&) = delete;  // not copyable: the members of a session contain pointers to each other
  Session& operator=(const Session&) = delete;

  // ---- the parts of a session
  const ControlDef& def() const { return *spec_.control; }
  const MachineProfile& machine() const { return spec_.machine; }
  const Setup& setup() const { return spec_.setup; }
  /// All channels, sorted by channel number.
  std::vector<Channel>& channels() { return channels_; }
  const std::vector<Channel>& channels() const { return channels_; }
  /// Index of the channel that runs the program itself. Each other channel runs a program that the set-up assigns to it.
  std::size_t own() const { return own_; }
  Control& control() { return *channels_[own_].control; }
  const Control& control() const { return *channels_[own_].control; }
  /// Returns the control, for an outlet that queries it in the middle of a step. The control may run in its own thread, so the function
  /// first waits until that thread has stopped.
  Control& settled_control();

  // ---- the observers; they must be set before the first go_on()
  Outlets& outlets(std::size_t channel) { return outlets_.own[channel]; }
  Outlets& outlets() { return outlets(own_); }
  ChannelOutlets& together() { return outlets_; }
  /// Limits the speeds from now on: Outlets::timed receives the steps with the time that the machine really needs. The function may be
  /// called only if there is a single channel.
  ///   returns  the rules that limit the speed; nullopt if nothing limits it, so that the programmed times are the real ones
  std::optional<SpeedRules> look_ahead();
  /// Creates a planner for the axes of a channel, which plans the motions in least time.
  Planned& plan(std::size_t channel, const StopToken& stop = {});
  Planned* planned(std::size_t channel) { return planned_[channel].get(); }
  /// Passes a step of a channel to the observers when the virtual time of all channels has reached the beginning of the step. The function
  /// may be called only if there are several channels.
  void show(std::size_t channel, const Step& step) { channels_run_->show(channel, step); }

  // ---- running the session
  enum class State : std::uint8_t {
    running,
    held,     // the session is held before a block, by Control::holds_before
    stopped,  // an alarm has stopped the session, see stopped()
    ended,
  };
  /// Executes the next batch of actions: some dozen actions of a single channel, or one block of the channel with the lowest virtual time.
  State go_on();
  /// Calls go_on() until the session is held, stopped or ended.
  State run();
  /// Declares that no step follows. Steps that are stored for look-ahead are passed to the outlets as if the program ended here. The
  /// function may be called only if there is a single channel.
  State stop_here();
  /// Acknowledges the alarm that stopped the run. Then the run continues with the next block, as after a reset of the control.
  void acknowledge() { acknowledge(own_); }
  void acknowledge(std::size_t channel);
  /// Enters a line of the operator (MDI). The line is executed next, even after the end of the program or an alarm. Then the program
  /// continues.
  ///   pre  the session is held, stopped or ended, and not in the middle of a block (Control::in_block)
  void enter(const std::string& line) { enter(line, own_); }
  void enter(const std::string& line, std::size_t channel);
  /// Lets only this channel continue until it stops or is held again. enter() calls this function for the program's own channel. The
  /// function may be called only if there are several channels.
  void alone(std::size_t channel);
  /// If `on` is true, each channel stays at the block before which Control::holds_before has held it, until all channels are held, waiting
  /// or ended. The function may be called only if there are several channels.
  void hold_each(bool on) {
    if (channels_run_) channels_run_->hold_each(on);
  }
  /// Returns the present position of a channel: the coordinates of its axes, mm or degrees, as work and as machine coordinates.
  ToolPosition stand(std::size_t channel) const;
  ToolPosition stand() const { return stand(own_); }
  /// Declares that the axes of a channel have been moved by hand to the position `machine`, in machine coordinates.
  ///   pre  the channel is not in the middle of a block
  void stand_at(const Axes& machine) { stand_at(own_, machine); }
  void stand_at(std::size_t channel, const Axes& machine);
  /// Applies a change of the observers in mid-program. From now on the clock of the outlets is used, and plan() and look_ahead() start at
  /// the present position.
  void change_outlets();
  /// Returns the number of blocks that the control of a single channel has executed and that path and machine have processed.
  std::uint64_t blocks() const { return alone_ ? alone_->blocks() : control().blocks(); }
  /// Returns how the run of a channel ended.
  const Stopped& stopped(std::size_t channel) const;
  const Stopped& stopped() const { return stopped(own_); }
  /// Returns the time that a channel has waited for others, s.
  double waited(std::size_t channel) const;

  // ---- storing and restoring the state
  /// Returns a snapshot of everything that determines how the run continues. To be called between two calls of go_on(). The state of the
  /// planners is included; other data that outlets compute are not. Returns nullopt while the control waits for the result of a probe
  /// motion.
  std::optional<SessionSnapshot> snapshot();
  /// Restores a snapshot, from which the run continues. The snapshot may come from another session with the same program, control, machine,
  /// set-up and outlets.
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
  bool searched_ = false;       // true: the block search that the key `search` of the set-up requests has been done
  std::vector<bool> attached_;  // for each channel: true if the channel's planner (in planned_) receives the steps
  // these members are used with a single channel
  std::optional<Logic> logic_;
  std::unique_ptr<ChannelRun> alone_;
  // these members are used with several channels
  std::unique_ptr<Channels> channels_run_;
  State state_ = State::running;
};

}  // namespace kadr
