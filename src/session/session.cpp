// Session: opens and runs a session, and stores and restores its state. It is used by cli, fuzz, bench and embedding programs, and tested
// by tests/session.

#include "session/session.h"

#include <algorithm>
#include <utility>

#include "config/control/control_file.h"
#include "config/machine/machine_axes.h"
#include "control/start_fault.h"
#include "motion/look_ahead/control_speed.h"
#include "motion/time/estimate.h"
#include "session/assumed_axes.h"
#include "session/block_search.h"
#include "session/give_machine.h"
#include "session/plc_commands.h"
#include "texts/session.h"

namespace kadr {

struct SessionSnapshot::Content {
  std::optional<ChannelRun::Memory> alone;
  std::optional<Plc> plc;
  std::optional<Channels::Memory> together;
  std::vector<std::optional<Planned::Memory>> planned;
  Session::State state = Session::State::running;
  bool searched = false;
};

Session::Session(SessionSpec spec) : spec_(std::move(spec)) {}
Session::~Session() = default;

tl::expected<std::unique_ptr<Session>, ChannelsFault> Session::open(SessionSpec spec) {
  if (const std::string system = system_of(*spec.control, spec.setup); !system.empty())
    if (auto def = load_control(system)) spec.control = std::make_shared<const ControlDef>(std::move(*def));
  // std::make_unique cannot be used, since the constructor is private
  auto session = std::unique_ptr<Session>(new Session(std::move(spec)));
  give_machine(session->spec_.setup, session->spec_.machine, *session->spec_.control);
  assume_axes(session->spec_.setup, session->spec_.program.source.get(), *session->spec_.control);
  if (!session->spec_.setup.search.empty() && !session->spec_.setup.channels.empty())
    return tl::unexpected(ChannelsFault{start_fault_of("search", texts::session::search_in_channels), 0});
  auto channels = open_channels(*session->spec_.control, session->spec_.setup, std::move(session->spec_.program), session->spec_.limits);
  if (!channels) return tl::unexpected(std::move(channels.error()));
  session->channels_ = std::move(*channels);
  const auto is_own = [&](const Channel& channel) { return channel.number == session->spec_.setup.channel; };
  session->own_ =
      static_cast<std::size_t>(std::find_if(session->channels_.begin(), session->channels_.end(), is_own) - session->channels_.begin());
  session->outlets_.own.resize(session->channels_.size());
  session->planned_.resize(session->channels_.size());
  session->attached_.resize(session->channels_.size());
  for (Outlets& outlets : session->outlets_.own) {
    outlets.warning = [](const AlarmReport&) {};
    outlets.alarm = [](const AlarmReport&) { return false; };
    outlets.stop = session->spec_.limits.stop;
  }
  return session;
}

std::optional<SpeedRules> Session::look_ahead() {
  if (channels_.size() != 1) return std::nullopt;
  const Control& control = *channels_.front().control;
  SpeedRules rules = speed_rules(channels_.front().setup, control.axes(), spec_.machine);
  if (control.has_machine_parameters()) obey_parameters(rules, channels_.front().setup, control.axes());
  // INFERRED: the corner tolerance applies to every control that states no limit of speed changes at corners
  else if (!plan_by_blocks(rules, channels_.front().setup, def())) rules.blend = spec_.machine.tolerance;
  if (rules.in_force) rules_ = rules;
  return rules_;
}

Planned& Session::plan(std::size_t channel, const StopToken& stop) {
  const Channel& of = channels_[channel];
  planned_[channel] = std::make_unique<Planned>(of, spec_.machine, begun_ ? stand(channel) : of.control->tool_position(), stop);
  attached_[channel] = false;
  return *planned_[channel];
}

void Session::attach_planners() {
  for (std::size_t i = 0; i < channels_.size(); ++i) {
    if (!planned_[i] || attached_[i]) continue;
    attached_[i] = true;
    // the planner computes the feed of each motion from the time of the step, so the steps must have times
    outlets_.own[i].wants_times = true;
    outlets_.own[i].step = [look = std::move(outlets_.own[i].step), planned = planned_[i].get()](const Step& step) {
      if (look) look(step);
      planned->consume(step);
    };
  }
}

/// Connects the control, the machine and the observers. The session calls this function when the observers are known, before the first
/// batch of actions.
void Session::begin() {
  begun_ = true;
  attach_planners();
  if (channels_.size() > 1) {
    channels_run_ = std::make_unique<Channels>(channels_, spec_.machine, spec_.setup, outlets_);
    return;
  }
  Channel& only = channels_.front();
  logic_.emplace(Logic{Plc(spec_.setup.events), {only.control.get()}});
  alone_ = std::make_unique<ChannelRun>(*only.control, spec_.machine, only.setup, outlets_.own.front(), *logic_);
  if (rules_) alone_->look_ahead(*rules_);
}

Session::State Session::end(ChannelRun::State state) {
  if (state == ChannelRun::State::ended) apply(logic_->plc.program_end(), *channels_.front().control, logic_->channels);
  alone_->finish();
  return state == ChannelRun::State::ended ? State::ended : State::stopped;
}

Session::State Session::go_on() {
  if (!spec_.setup.search.empty() && !std::exchange(searched_, true))
    if (const auto stood = begin_by_search()) return state_ = *stood;
  if (!begun_) begin();
  if (state_ == State::ended || state_ == State::stopped) return state_;
  const ChannelRun::State state = alone_ ? alone_->step() : channels_run_->step();
  switch (state) {
    case ChannelRun::State::running:
    case ChannelRun::State::waiting: return state_ = State::running;
    case ChannelRun::State::held: return state_ = alone_ ? State::held : together(state);
    case ChannelRun::State::stopped:
    case ChannelRun::State::ended: break;
  }
  return state_ = alone_ ? end(state) : together(state);
}

Session::State Session::together(ChannelRun::State state) {
  const auto& all = channels_run_->stopped();
  const bool stood = std::any_of(all.begin(), all.end(), [](const Stopped& s) { return s.report.has_value(); });
  channels_run_->all();
  if (state == ChannelRun::State::held) return State::held;
  return stood ? State::stopped : State::ended;
}

/// Starts the program at the block that the key `search` of the set-up names, as the control's own block search does (nct 13.1). INFERRED:
/// the manual does not say how the axes move to the start of that block, so they are placed there without a motion.
///   returns  nullopt if the run continues; otherwise the state in which it stopped
std::optional<Session::State> Session::begin_by_search() {
  const auto holds_before = std::exchange(control().holds_before, nullptr);
  const std::vector<InForce> at_first = control().in_force();
  std::optional<BlockSearch> found;
  attached_.assign(attached_.size(), true);  // the planners receive nothing of the search
  {
    StopPoint target;
    target.block = static_cast<std::uint32_t>(std::stoul(spec_.setup.search.substr(1)));
    Stepping stepping(*this);
    found = search_block(*this, stepping, target);
  }
  control().holds_before = holds_before;
  attached_.assign(attached_.size(), false);
  if (!found) {
    if (state_ == State::stopped) return state_;
    alone_->refuse(alarm(AlarmId::search_not_reached, {}, std::string_view(spec_.setup.search)));
    return State::stopped;
  }
  for (std::size_t i = 0; i < planned_.size(); ++i)
    if (planned_[i]) planned_[i]->begin_at(stand(i));
  change_outlets();
  for (const BlockSearch::Code& code : found->carried_out) alone_->show(code.action);
  for (const InForce& missing : found->forgotten)
    if (std::find(at_first.begin(), at_first.end(), missing) == at_first.end())
      alone_->warn(control().report_for(warning(AlarmId::search_forgets, {}, std::string_view(missing.code)), found->restart.at));
  state_ = State::running;
  return std::nullopt;
}

Session::State Session::run() {
  State state = State::running;
  while (state == State::running) state = go_on();
  return state;
}

Session::State Session::stop_here() {
  if (!begun_ || !alone_) return state_;
  const ChannelRun::State state = alone_->let_out();
  return state_ = state == ChannelRun::State::stopped ? State::stopped : State::ended;
}

void Session::acknowledge(std::size_t channel) {
  if (Control& stopped = *channels_[channel].control; stopped.is_stopped()) stopped.go_on();
  if (alone_) alone_->acknowledge();
  state_ = State::running;
}

void Session::enter(const std::string& line, std::size_t channel) {
  if (!begun_) begin();
  acknowledge(channel);
  alone(channel);
  channels_[channel].control->enter(line);
}

void Session::alone(std::size_t channel) {
  if (!begun_) begin();
  if (channels_run_) channels_run_->only(channel);
}

Control& Session::settled_control() { return alone_ ? alone_->settled() : control(); }

ToolPosition Session::stand(std::size_t channel) const {
  if (channels_run_) return channels_run_->position(channel);
  return alone_ ? alone_->position() : channels_[channel].control->tool_position();
}

void Session::stand_at(std::size_t channel, const Axes& machine) {
  if (!begun_) begin();
  if (alone_) alone_->stand_at(machine);
  else channels_run_->stand_at(channel, machine);
}

void Session::change_outlets() {
  if (!begun_) return;
  attach_planners();
  if (!alone_) return;
  alone_->change_clock();
  if (rules_) alone_->look_ahead(*rules_);
}

const Stopped& Session::stopped(std::size_t channel) const {
  static const Stopped not_yet;
  if (!begun_) return not_yet;
  return alone_ ? alone_->stopped() : channels_run_->stopped()[channel];
}

double Session::waited(std::size_t channel) const { return channels_run_ ? channels_run_->waited(channel) : 0; }

std::optional<SessionSnapshot> Session::snapshot() {
  if (!begun_) begin();
  auto now = std::make_shared<SessionSnapshot::Content>();
  now->state = state_;
  now->searched = searched_;
  if (alone_) {
    now->plc = logic_->plc;
    if (!(now->alone = alone_->memory())) return std::nullopt;
  } else if (!(now->together = channels_run_->memory())) {
    return std::nullopt;
  }
  for (const auto& planned : planned_) now->planned.push_back(planned ? std::optional(planned->memory()) : std::nullopt);
  return SessionSnapshot(std::move(now));
}

Status Session::restore(const SessionSnapshot& from) {
  if (!begun_) begin();
  const SessionSnapshot::Content& then = from.content();
  if (alone_) {
    KADR_TRY(alone_->resume_from(*then.alone));
    logic_->plc = *then.plc;
  } else {
    KADR_TRY(channels_run_->resume_from(*then.together));
  }
  for (std::size_t i = 0; i < planned_.size(); ++i)
    if (planned_[i] && then.planned[i]) planned_[i]->resume_from(*then.planned[i]);
  state_ = then.state;
  searched_ = then.searched;
  return {};
}

}  // namespace kadr
