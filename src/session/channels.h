#pragma once
// Channels: runs the programs of all channels of one machine in parallel in virtual time (nct 1.2, 14.5).
//
//   The channel with the lowest virtual time executes its next block. If several channels have the same time, the channel with the lowest
//   number comes first. At a waiting code a channel waits until all channels that the word P lists have arrived. Then all of them continue
//   at the time of the last arrival. The observers receive the steps of all channels in the order of virtual time.

#include <deque>
#include <functional>
#include <memory>
#include <vector>

#include "base/result.h"
#include "config/setup/setup_file.h"
#include "machine/rendezvous.h"
#include "session/axis_links.h"
#include "session/channel_run.h"

namespace kadr {

struct Channel {
  int number = 1;
  Setup setup;  // the set-up of this channel
  std::unique_ptr<Control> control;
};

/// A set-up key that the control does not support, and the number of the channel concerned (0 if there is only one channel).
struct ChannelsFault {
  SetupFault fault;
  int channel = 0;
};

/// Opens the program's own channel and the other channels of the set-up. The result is sorted by channel number. Channel n executes the
/// file channelN.nct in the folder of the main program. Subprograms are searched in the same folder.
tl::expected<std::vector<Channel>, ChannelsFault> open_channels(const ControlDef& def, const Setup& setup, Program program,
                                                                RunLimits limits);

/// Returns the initial set-up of a channel other than the program's own. Parameters, machine, panel and tool tables belong to the machine,
/// so all channels share them. Offsets, work offsets, variables and positions belong to the channel and are all 0 at first (INFERRED).
Setup setup_of_channel(const Setup& main, int number);

/// The observers of a run with several channels: the outlets of each channel, by index of the channel, and functions that Channels calls
/// for all channels together, in the order of time.
struct ChannelOutlets {
  std::vector<Outlets> own;
  // true: an alarm that the observer does not ignore stops all channels (INFERRED); false: it stops only its own channel, as in a check
  bool stop_together = true;
  std::function<void(std::size_t channel, const Step&)> in_order;
  /// A function of the observer; Channels calls it when a channel starts to wait for others, after all earlier steps of that channel have
  /// been passed to the observers.
  std::function<void(std::size_t channel, const Control::Meeting&)> waits;
  /// A function of the observer; Channels calls it when channels continue after waiting, because they have met or because the waiting of a
  /// single channel was cancelled.
  std::function<void(const std::vector<std::size_t>& channels)> met;
  /// A function of the observer; Channels calls it when the program of a channel has ended.
  std::function<void(std::size_t channel)> over;
};

/// Sorts the steps of several channels by the time at which they begin. A step is passed to the observers later than the machine executes
/// it. Therefore each step is stored with the tool position at its beginning.
class TimeOrder {
 public:
  explicit TimeOrder(std::size_t channels) : queues_(channels) {}
  /// Adds a step. The steps of one channel must be added in the order of time.
  void put(std::size_t channel, const Step& step) { queues_[channel].push_back({++count_, KeptStep(step)}); }

  using Sink = std::function<void(std::size_t channel, const Step&)>;
  /// Passes to `sink` all stored steps that no later step can precede. `clocks`: for each channel, the earliest time at which its next step
  /// can begin, s.
  void release(const std::vector<double>& clocks, const Sink& sink);

 private:
  struct Entry {
    // number of the step in the order of arrival; of two steps with equal times, the one with the lower number comes first
    std::uint64_t number;
    KeptStep kept;
    double at() const { return kept.begins; }
    bool before(const Entry& other) const { return at() < other.at() || (at() == other.at() && number < other.number); }
  };
  std::vector<std::deque<Entry>> queues_;
  std::uint64_t count_ = 0;
};

class Channels {
 public:
  /// `profile`: the machine. `setup`: the set-up of the machine; each channel has its own set-up in `channels`.
  Channels(std::vector<Channel>& channels, const MachineProfile& profile, const Setup& setup, ChannelOutlets& outlets);
  ~Channels();
  Channels(const Channels&) = delete;  // not copyable: the controls have pointers to this object
  Channels& operator=(const Channels&) = delete;

  /// Executes the next block of the running channel with the lowest virtual time.
  ///   returns  ended if no channel can continue
  ChannelRun::State step();
  /// Returns how each channel ended, by index of the channel.
  const std::vector<Stopped>& stopped() const { return stopped_; }

  double now(std::size_t channel) { return runs_[channel]->now(); }
  double waited(std::size_t channel) const { return runs_[channel]->waited(); }
  const ToolPosition& position(std::size_t channel) const { return runs_[channel]->position(); }
  /// Declares that the axes of a channel have been moved by hand to the position `machine`, in machine coordinates.
  void stand_at(std::size_t channel, const Axes& machine) { runs_[channel]->stand_at(machine); }
  /// Stops all channels except `channel` until the call of all(). To be called when the operator has entered a line in that channel.
  void only(std::size_t channel);
  /// Lets all channels run again. An alarm that stopped the single running channel counts as acknowledged.
  void all();
  /// If `on` is true, a channel that is held stays held while the other channels continue, until every channel is held, waiting or ended.
  void hold_each(bool on) { each_holds_ = on, held_.assign(held_.size(), false); }
  /// Stores a step that comes from an outlet. The observers receive the step when the virtual time of all channels has reached its
  /// beginning.
  void show(std::size_t channel, const Step& step) { order_.put(channel, step); }

 private:
  enum class State : std::uint8_t { running, waiting, ended, stopped };

 public:
  /// A snapshot of everything that determines how the channels continue.
  struct Memory {
    std::vector<ChannelRun::Memory> runs;
    Plc plc;
    std::vector<State> states;
    std::vector<Stopped> stopped;
    Rendezvous rendezvous;
    TimeOrder order;
    std::vector<std::uint64_t> common;
    std::vector<LinkedAxis> links;
    bool over = false;
  };
  std::optional<Memory> memory();
  Status resume_from(const Memory& memory);

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
  TimeOrder order_;
  // for each channel: version of the shared tables and parameters when the contents were last the same in all channels
  std::vector<std::uint64_t> common_;
  bool over_ = false;
  bool each_holds_ = false;
  std::vector<bool> held_;  // by channel: true if the channel is held; used only if each_holds_
  /// The channel that runs alone, and the states of all channels before the others were stopped.
  struct Only {
    std::size_t channel;
    std::vector<State> states;
    std::vector<Stopped> stopped;
    bool over;
  };
  std::optional<Only> only_;
};

}  // namespace kadr
