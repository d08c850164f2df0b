#pragma once
// Channels: runs the channels of one machine in parallel in virtual time (nct 1.2, 14.5).
//
//   The channel with the lowest clock runs its next block; of equal clocks the lowest channel number. At a waiting code it stops until all
//   channels that P names have arrived; they continue at the time of the last one. Their steps are shown in the order of virtual time.

#include <deque>
#include <functional>
#include <memory>
#include <vector>

#include "base/result.h"
#include "config/setup_file.h"
#include "machine/rendezvous.h"
#include "session/axis_links.h"
#include "session/channel_run.h"

namespace kadr {

struct Channel {
  int number = 1;
  Setup setup;  // as this channel has it
  std::unique_ptr<Control> control;
};

/// A key of the set-up that the control does not support, and the channel concerned (0: there is only one).
struct ChannelsFault {
  SetupFault fault;
  int channel = 0;
};

/// Opens the program's own channel and the channels of the set-up, sorted by number. The program of channel n is the file channelN.nct in
/// the folder of the main program; subprograms are searched there.
tl::expected<std::vector<Channel>, ChannelsFault> open_channels(const ControlDef& def, const Setup& setup, Program program,
                                                                RunLimits limits);

/// The initial set-up of a channel other than the program's own: parameters, machine, panel and tool tables belong to the machine and are
/// shared; offsets, work zeros, variables and positions belong to the channel and are all 0 (INFERRED).
Setup setup_of_channel(const Setup& main, int number);

/// Observers of the channels: the outlets of each, by index; and those that receive, in the order of time, what was given to show().
struct ChannelOutlets {
  std::vector<Outlets> own;
  bool stop_together = true;  // an alarm that is not passed over stops all channels (INFERRED); false: only its own (checking)
  std::function<void(std::size_t channel, const Step&)> in_order;
  /// A channel starts waiting for others; everything that it has done before has been passed on.
  std::function<void(std::size_t channel, const Control::Meeting&)> waits;
  /// These channels continue together: they have met, or the only one no longer needs to wait.
  std::function<void(const std::vector<std::size_t>& channels)> met;
  /// The program of a channel has ended.
  std::function<void(std::size_t channel)> over;
};

/// Sorts the steps of several channels by the time at which they begin. A step is emitted later than the machine executes it, so it is
/// kept with the tool position it began at.
class InOrder {
 public:
  explicit InOrder(std::size_t channels) : queues_(channels) {}
  /// Each channel must put its steps in the order of time.
  void put(std::size_t channel, const Step& step) { queues_[channel].push_back({++count_, KeptStep(step)}); }

  using Sink = std::function<void(std::size_t channel, const Step&)>;
  /// Emits the steps that no later put() can precede. `clocks`: the time from which on each channel may still put a step.
  void release(const std::vector<double>& clocks, const Sink& sink);

 private:
  struct Entry {
    std::uint64_t number;  // of equal times, the step that was put first comes first
    KeptStep kept;
    double at() const { return kept.begins; }
    bool before(const Entry& other) const { return at() < other.at() || (at() == other.at() && number < other.number); }
  };
  std::vector<std::deque<Entry>> queues_;
  std::uint64_t count_ = 0;
};

class Channels {
 public:
  /// `profile`, `setup`: those of the machine.
  Channels(std::vector<Channel>& channels, const MachineProfile& profile, const Setup& setup, ChannelOutlets& outlets);
  ~Channels();
  Channels(const Channels&) = delete;  // the controls call it back
  Channels& operator=(const Channels&) = delete;

  /// Executes the next block of the channel with the lowest time.
  ///   returns  ended if no channel can continue
  ChannelRun::State step();
  /// How each channel ended, by index.
  const std::vector<Stopped>& stopped() const { return stopped_; }

  double now(std::size_t channel) { return runs_[channel]->now(); }
  double waited(std::size_t channel) const { return runs_[channel]->waited(); }
  const ToolPosition& position(std::size_t channel) const { return runs_[channel]->position(); }
  /// States that the axes of a channel have been moved by hand.
  void stand_at(std::size_t channel, const Axes& machine) { runs_[channel]->stand_at(machine); }
  /// A line has been entered in this channel: only this channel runs until all() is called.
  void only(std::size_t channel);
  /// All channels run again; the alarm that stopped the single one is acknowledged.
  void all();
  /// A channel that is held stays there, while the others continue until each is held, waiting or ended.
  void hold_each(bool on) { each_holds_ = on, held_.assign(held_.size(), false); }
  /// Takes a step from an outlet; it is shown when its time has come.
  void show(std::size_t channel, const Step& step) { order_.put(channel, step); }

 private:
  enum class State : std::uint8_t { running, waiting, ended, stopped };

 public:
  /// Everything that determines how the channels continue, as a value.
  struct Memory {
    std::vector<ChannelRun::Memory> runs;
    Plc plc;
    std::vector<State> states;
    std::vector<Stopped> stopped;
    Rendezvous rendezvous;
    InOrder order;
    std::vector<std::uint64_t> common;
    std::vector<LinkedAxis> links;
    bool over = false;
  };
  std::optional<Memory> memory();
  Status remember(const Memory& memory);

 private:
  std::optional<std::size_t> next();
  ChannelRun::State step(std::size_t i);
  void share(std::size_t by);
  bool carry(std::size_t by);
  void end();
  void begin_waiting(std::size_t i);
  void release(const Rendezvous::Met& met, std::size_t last);
  void wake(double at);
  bool end_deadlock();
  bool waits_in_vain(std::size_t i) const { return states_[i] == State::waiting && (!only_ || only_->channel == i); }
  void stop_all(std::size_t by);
  void show_past();
  std::size_t index_of(int number) const;

  std::vector<Channel>& channels_;
  ChannelOutlets& outlets_;
  Logic logic_;
  std::vector<std::unique_ptr<ChannelRun>> runs_;
  AxisLinks links_;
  std::vector<State> states_;
  std::vector<Stopped> stopped_;
  Rendezvous rendezvous_;
  InOrder order_;
  std::vector<std::uint64_t> common_;  // versions of the shared data of each channel, when all of them last agreed
  bool over_ = false;
  bool each_holds_ = false;
  std::vector<bool> held_;  // used if each_holds_
  /// The channel that runs alone, and the states of all before that.
  struct Only {
    std::size_t channel;
    std::vector<State> states;
    std::vector<Stopped> stopped;
    bool over;
  };
  std::optional<Only> only_;
};

}  // namespace kadr
