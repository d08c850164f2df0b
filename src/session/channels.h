#pragma once
// The channels of one machine side by side in virtual time (nct 1.2, 14.5).
//
//   The channel whose clock is lowest runs its next block; of equal ones the lowest number. At a waiting code it stops until all
//   channels that P names have come; they go on at the time of the last. What they do is shown in the order of virtual time.

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
  Setup setup;  // as this channel sees it
  std::unique_ptr<Control> control;
};

/// A key of the set-up that the control has not, in one of several channels (0: there is one only).
struct ChannelsFault {
  SetupFault fault;
  int channel = 0;
};

/// The program's own channel and those of the set-up, in the order of their numbers. The program of channel n is the file
/// channelN.nct in the folder of the main program: subprograms are looked for there.
tl::expected<std::vector<Channel>, ChannelsFault> open_channels(const ControlDef& def, const Setup& setup, Program program,
                                                                RunLimits limits);

/// What a channel beside the program's own starts with: parameters, machine, panel and tool tables are the machine's; offsets, work
/// zeros, variables and positions its own, all 0 (INFERRED).
Setup setup_of_channel(const Setup& main, int number);

/// What looks at the channels: their own outlets, by index; and, in the order of time, what these have handed to show().
struct ChannelOutlets {
  std::vector<Outlets> own;
  bool stop_together = true;  // an alarm that is not passed over stops all channels (INFERRED), or only its own (checking)
  std::function<void(std::size_t channel, const Step&)> in_order;
  /// A channel waits for others; all that it has done before is handed out.
  std::function<void(std::size_t channel, const Control::Meeting&)> waits;
  /// They go on together: they have met, or the one need not wait any more.
  std::function<void(const std::vector<std::size_t>& channels)> met;
  /// The program of a channel is over.
  std::function<void(std::size_t channel)> over;
};

/// Steps of several channels, sorted by the time at which they begin. They come later than the machine takes them: each is kept with
/// where the tool stood then.
class InOrder {
 public:
  explicit InOrder(std::size_t channels) : queues_(channels) {}
  /// In the order of time, channel by channel.
  void put(std::size_t channel, const Step& step) { queues_[channel].push_back({++count_, KeptStep(step)}); }

  using Sink = std::function<void(std::size_t channel, const Step&)>;
  /// Emits what nothing can come before any more. `clocks`: from which time on each channel may still put something.
  void release(const std::vector<double>& clocks, const Sink& sink);

 private:
  struct Entry {
    std::uint64_t number;  // of equal times the first one put
    KeptStep kept;
    double at() const { return kept.begins; }
    bool before(const Entry& other) const { return at() < other.at() || (at() == other.at() && number < other.number); }
  };
  std::vector<std::deque<Entry>> queues_;
  std::uint64_t count_ = 0;
};

class Channels {
 public:
  /// `profile`, `setup`: of the machine.
  Channels(std::vector<Channel>& channels, const MachineProfile& profile, const Setup& setup, ChannelOutlets& outlets);
  ~Channels();
  Channels(const Channels&) = delete;  // the controls call it back
  Channels& operator=(const Channels&) = delete;

  /// Carries the next block of the channel whose time is lowest out.
  ///   returns  ended: nothing more can come
  ChannelRun::State step();
  /// How each came to its end, by index.
  const std::vector<Stopped>& stopped() const { return stopped_; }

  double now(std::size_t channel) { return runs_[channel]->now(); }
  double waited(std::size_t channel) const { return runs_[channel]->waited(); }
  const ToolPosition& position(std::size_t channel) const { return runs_[channel]->position(); }
  /// The axes of a channel have been moved by hand.
  void stand_at(std::size_t channel, const Axes& machine) { runs_[channel]->stand_at(machine); }
  /// A line has been entered in this channel: it goes on alone, until all() calls.
  void only(std::size_t channel);
  /// All go on again; an alarm that stopped the one is answered for.
  void all();
  /// A channel that is held stays where it is, and the others go on until each is held, waits or has ended.
  void hold_each(bool on) { each_holds_ = on, held_.assign(held_.size(), false); }
  /// An outlet's step: it is shown when its time has come.
  void show(std::size_t channel, const Step& step) { order_.put(channel, step); }

 private:
  enum class State : std::uint8_t { running, waiting, ended, stopped };

 public:
  /// All that decides how they go on: a value.
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
  std::vector<std::uint64_t> common_;  // versions of what they have in common, as it was when all had the same
  bool over_ = false;
  bool each_holds_ = false;
  std::vector<bool> held_;  // where each_holds_
  /// One that goes on alone, and how all stood before.
  struct Only {
    std::size_t channel;
    std::vector<State> states;
    std::vector<Stopped> stopped;
    bool over;
  };
  std::optional<Only> only_;
};

}  // namespace kadr
