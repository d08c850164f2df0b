// Channels: runs the programs of all channels of one machine in parallel in virtual time (nct 1.2, 14.5). It is used by cli.

#include "session/channels.h"

#include <fmt/core.h>

#include <algorithm>
#include <filesystem>
#include <limits>
#include <utility>

#include "control/shared_memory.h"
#include "control/start_fault.h"
#include "session/plc_commands.h"
#include "texts/session.h"

namespace kadr {
namespace {

/// Creates the control of one channel. The returned fault is not empty if the set-up does not fit the control.
SetupFault open_channel(Channel& channel, const ControlDef& def, Program program, RunLimits limits,
                        const std::shared_ptr<SharedMemory>& shared) {
  channel.control = std::make_unique<Control>(def, channel.setup, std::move(program), limits, shared);
  return channel.control->setup_fault();
}

/// Returns the folder of the main program. A run that must not write files searches called programs there.
std::string folder_of(const std::string& program) {
  const auto folder = std::filesystem::path(program).parent_path();
  return folder.empty() ? "." : folder.string();
}

}  // namespace

Setup setup_of_channel(const Setup& main, int number) {
  Setup s;
  s.channel = number;
  s.axes = main.channels.at(number).axes;
  s.channels = main.channels;
  s.channels.erase(number);
  s.channels[main.channel] = {"", main.axes};
  s.parameters = main.parameters;
  s.machine = main.machine;
  s.spindles = main.spindles;
  s.tool_table = main.tool_table;
  s.place_table = main.place_table;
  s.form_table = main.form_table;
  s.signals = main.signals;
  s.skip = main.skip;
  s.optional_stop = main.optional_stop;
  s.single_block = main.single_block;
  s.clock = main.clock;
  s.ini = main.ini;
  s.feed_override = main.feed_override;
  s.rapid_override = main.rapid_override;
  s.spindle_override = main.spindle_override;
  s.points = main.points;
  s.watch = main.watch;
  return s;
}

tl::expected<std::vector<Channel>, ChannelsFault> open_channels(const ControlDef& def, const Setup& setup, Program program,
                                                                RunLimits limits) {
  const auto refused = [](TextId<1> why, const auto& what) { return tl::unexpected(ChannelsFault{start_fault_of("", why, what), 0}); };
  if (!setup.channels.empty() && !def.machine_axes()) return refused(texts::session::no_channels, def.id);
  if (setup.channels.contains(setup.channel)) return refused(texts::session::own_channel, setup.channel);
  const std::string file = program.file;
  // true: the caller has not selected the folder in which called programs are searched
  if (!limits.writes_files && limits.files == RunLimits{}.files) limits.files = folder_of(file);
  const auto shared = setup.channels.empty() ? nullptr : std::make_shared<SharedMemory>();
  std::vector<Channel> channels;
  const auto open = [&](int number, Setup own, Program its) -> tl::expected<void, ChannelsFault> {
    channels.push_back({number, std::move(own), nullptr});
    if (SetupFault fault = open_channel(channels.back(), def, std::move(its), limits, shared); !fault.empty())
      return tl::unexpected(ChannelsFault{std::move(fault), shared ? number : 0});
    return {};
  };
  if (auto opened = open(setup.channel, setup, std::move(program)); !opened) return tl::unexpected(std::move(opened.error()));
  for (const auto& [number, other] : setup.channels) {
    const auto path = std::filesystem::path(file).parent_path() / fmt::format("channel{}.nct", number);
    auto opened = open(number, setup_of_channel(setup, number), {path.string(), text_source(other.program), Encoding::utf8});
    if (!opened) return tl::unexpected(std::move(opened.error()));
  }
  std::sort(channels.begin(), channels.end(), [](const Channel& a, const Channel& b) { return a.number < b.number; });
  return channels;
}

void TimeOrder::release(const std::vector<double>& clocks, const Sink& sink) {
  for (;;) {
    std::size_t first = queues_.size();
    for (std::size_t i = 0; i < queues_.size(); ++i)
      if (!queues_[i].empty() && (first == queues_.size() || queues_[i].front().before(queues_[first].front()))) first = i;
    if (first == queues_.size()) return;
    const Entry& entry = queues_[first].front();
    for (std::size_t i = 0; i < clocks.size(); ++i)
      if (queues_[i].empty() && clocks[i] < entry.at()) return;
    sink(first, entry.kept.step());
    queues_[first].pop_front();
  }
}

Channels::Channels(std::vector<Channel>& channels, const MachineProfile& profile, const Setup& setup, ChannelOutlets& outlets)
    : channels_(channels),
      outlets_(outlets),
      logic_{Plc(setup.events), {}},
      links_(channels, runs_),
      states_(channels.size(), State::running),
      stopped_(channels.size()),
      order_(channels.size()),
      held_(channels.size()) {
  for (std::size_t i = 0; i < channels.size(); ++i) {
    Control& control = *channels[i].control;
    logic_.channels.push_back(&control);
    control.return_each_block();
    control.set_waiting(Control::Waiting::meet);
    runs_.push_back(std::make_unique<ChannelRun>(control, profile, channels[i].setup, outlets.own[i], logic_));
    (void)runs_.back()->now();  // this call starts the clock of the channel, which counts the time from the first call of now()
  }
  for (std::size_t i = 0; i < channels.size(); ++i) {
    links_.relink(i);
    channels[i].control->on_cross_channel_axes = [this, i] { links_.relink(i); };
  }
  constexpr std::uint64_t never = ~std::uint64_t{0};
  common_.assign(channels.size(), never);
  share(0);
}

Channels::~Channels() {
  for (Channel& channel : channels_) channel.control->on_cross_channel_axes = nullptr;
}

std::size_t Channels::index_of(int number) const {
  return static_cast<std::size_t>(std::find_if(channels_.begin(), channels_.end(), [&](const Channel& c) { return c.number == number; }) -
                                  channels_.begin());
}

/// Returns the index of the running channel with the lowest virtual time; nullopt if no channel can run.
std::optional<std::size_t> Channels::next() {
  std::optional<std::size_t> first;
  for (std::size_t i = 0; i < states_.size(); ++i)
    if (states_[i] == State::running && !held_[i] && (!only_ || only_->channel == i) && (!first || now(i) < now(*first))) first = i;
  return first;
}

ChannelRun::State Channels::step() {
  if (over_) return ChannelRun::State::ended;
  if (const auto i = next()) {
    const ChannelRun::State state = step(*i);
    show_past();
    if (state != ChannelRun::State::held) return ChannelRun::State::running;
    if (!each_holds_) return state;
    held_[*i] = true;
    return ChannelRun::State::running;
  }
  if (std::find(held_.begin(), held_.end(), true) != held_.end()) return ChannelRun::State::held;
  if (std::find(states_.begin(), states_.end(), State::waiting) != states_.end() && end_deadlock()) return ChannelRun::State::running;
  if (!only_) end();
  return ChannelRun::State::ended;
}

void Channels::only(std::size_t channel) {
  if (only_) all();
  only_ = Only{channel, states_, std::exchange(stopped_, std::vector<Stopped>(states_.size())), std::exchange(over_, false)};
  states_[channel] = State::running;
}

void Channels::all() {
  if (!only_) return;
  states_ = only_->states;
  stopped_ = only_->stopped;
  stopped_[only_->channel] = {};
  over_ = only_->over;
  only_.reset();
}

void Channels::end() {
  over_ = true;
  if (std::all_of(states_.begin(), states_.end(), [](State s) { return s == State::ended; }))
    apply(logic_.plc.program_end(), *logic_.channels.front(), logic_.channels);
  show_past();
}

/// Copies tables and parameters that a block of channel `by` has changed to all other channels. They apply from the next block on, in
/// whichever channel that block is.
void Channels::share(std::size_t by) {
  if (channels_[by].control->common_version() == common_[by]) return;
  for (std::size_t i = 0; i < channels_.size(); ++i) {
    if (i != by) channels_[i].control->take_common(*channels_[by].control);
    common_[i] = channels_[i].control->common_version();
  }
}

/// Moves the axes of other channels that follow the axes of channel `by`. Returns false if a following axis must not move and the run
/// therefore stops.
bool Channels::carry(std::size_t by) {
  const Status carried = links_.carry(by);
  if (carried) return true;
  const Control& control = *channels_[by].control;
  stopped_[by].report = control.report_for(carried.error(), control.origin());
  if (outlets_.own[by].alarm(*stopped_[by].report)) {
    stopped_[by] = {};
    return true;
  }
  states_[by] = State::stopped;
  if (outlets_.stop_together && !only_) stop_all(by);
  return false;
}

ChannelRun::State Channels::step(std::size_t i) {
  const ChannelRun::State state = runs_[i]->step();
  share(i);
  if (state != ChannelRun::State::stopped && !carry(i)) return ChannelRun::State::stopped;
  switch (state) {
    case ChannelRun::State::running:
    case ChannelRun::State::held: break;
    case ChannelRun::State::waiting: begin_waiting(i); break;
    case ChannelRun::State::ended:
      states_[i] = State::ended;
      stopped_[i] = runs_[i]->stopped();
      if (outlets_.over && !only_) outlets_.over(i);
      break;
    case ChannelRun::State::stopped:
      stopped_[i] = runs_[i]->stopped();
      states_[i] = State::stopped;
      if (outlets_.stop_together && !only_) stop_all(i);
      return state;
  }
  wake(now(i));
  return state;
}

std::optional<Channels::Memory> Channels::memory() {
  Memory now{{}, logic_.plc, states_, stopped_, rendezvous_, order_, common_, links_.memory(), over_};
  for (const auto& run : runs_) {
    auto own = run->memory();
    if (!own) return std::nullopt;
    now.runs.push_back(std::move(*own));
  }
  return now;
}

Status Channels::resume_from(const Memory& memory) {
  for (std::size_t i = 0; i < runs_.size(); ++i) KADR_TRY(runs_[i]->resume_from(memory.runs[i]));
  logic_.plc = memory.plc;
  states_ = memory.states;
  stopped_ = memory.stopped;
  rendezvous_ = memory.rendezvous;
  order_ = memory.order;
  common_ = memory.common;
  links_.resume_from(memory.links);
  over_ = memory.over;
  return {};
}

void Channels::begin_waiting(std::size_t i) {
  const auto& meeting = channels_[i].control->meeting();
  if (!meeting) return;  // the machine's logic has already cancelled the waiting, so the channel continues
  states_[i] = State::waiting;
  if (only_) return;  // no other channel runs, so no channel can arrive at the waiting code
  if (outlets_.waits) outlets_.waits(i, *meeting);
  rendezvous_.arrive(channels_[i].number, meeting->code, meeting->channels, now(i));
  while (const auto met = rendezvous_.next()) release(*met, i);
}

/// Ends the waiting of the channels that have met. The trace gets one line for all these channels, from the channel that arrived last.
void Channels::release(const Rendezvous::Met& met, std::size_t last) {
  const Origin origin = channels_[last].control->meeting()->origin;
  std::vector<std::size_t> all;
  for (const std::uint8_t number : met.channels) {
    const std::size_t i = index_of(number);
    runs_[i]->wait_until(met.at);
    channels_[i].control->release();
    states_[i] = State::running;
    all.push_back(i);
  }
  if (outlets_.met) outlets_.met(all);
  runs_[last]->show({origin, Sync{met.code, met.channels, met.at}});
}

/// Continues the channels whose waiting the signal CP_NOWT has cancelled. `at`: the present virtual time, s.
void Channels::wake(double at) {
  for (std::size_t i = 0; i < states_.size(); ++i) {
    if (states_[i] != State::waiting || channels_[i].control->meeting()) continue;
    rendezvous_.leave(channels_[i].number);
    runs_[i]->wait_until(at);
    states_[i] = State::running;
    if (outlets_.met) outlets_.met({i});
  }
}

/// Raises an alarm in each waiting channel. This function is called when no channel can run, so that no channel can arrive at a waiting
/// code.
///   returns  true if the observers ignore the alarms (in a check of the program), so that the channels continue
bool Channels::end_deadlock() {
  bool goes_on = true;
  for (std::size_t i = 0; i < states_.size(); ++i) {
    if (!waits_in_vain(i)) continue;
    Control& control = *channels_[i].control;
    const Control::Meeting meeting = *control.meeting();
    const std::string code = fmt::format("M{}", meeting.code);
    stopped_[i].report =
        control.report_for(alarm(AlarmId::channels_wait, {}, double(channels_[i].number), std::string_view(code)), meeting.origin);
    goes_on = outlets_.own[i].alarm(*stopped_[i].report) && goes_on;
  }
  for (std::size_t i = 0; i < states_.size(); ++i) {
    if (!waits_in_vain(i)) continue;
    states_[i] = goes_on ? State::running : State::stopped;
    if (!goes_on) continue;
    rendezvous_.leave(channels_[i].number);
    channels_[i].control->release();
    stopped_[i] = {};
  }
  return goes_on;
}

void Channels::stop_all(std::size_t by) {
  for (std::size_t i = 0; i < states_.size(); ++i) {
    if (states_[i] != State::running && states_[i] != State::waiting) continue;
    states_[i] = State::stopped;
    stopped_[i].report = stopped_[by].report;
    stopped_[i].channel = channels_[by].number;
  }
}

/// Passes to the observers all steps that begin before the present time of every channel. A waiting channel counts with the time of the
/// earliest running channel, since only a running channel can end its waiting.
void Channels::show_past() {
  std::vector<double> clocks(states_.size(), std::numeric_limits<double>::infinity());
  double lowest = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < states_.size(); ++i)
    if (states_[i] == State::running) lowest = std::min(lowest, clocks[i] = now(i));
  for (std::size_t i = 0; i < states_.size(); ++i)
    if (states_[i] == State::waiting) clocks[i] = std::max(now(i), lowest);
  order_.release(clocks, outlets_.in_order);
}

}  // namespace kadr
