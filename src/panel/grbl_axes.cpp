// The axes of a real machine with a controller of the Grbl family. Used by panel/panel_machine through ChannelAxes; tested by
// tests/panel/panel_grbl_test.cpp with a double of the controller behind a pseudo-terminal.

#include "panel/grbl_axes.h"

#include <fmt/core.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <thread>
#include <utility>

#include "config/texts.h"
#include "drive/grbl/grbl_fault.h"
#include "texts/grbl_machine.h"

namespace kadr {
namespace {

using drive::GrblState;
using drive::GrblStatus;
using drive::LinkFault;
using drive::LinkPhase;

constexpr double half_rapid = 0.5, quarter_rapid = 0.25;  // overrides of rapids that Grbl has besides 100 %
constexpr double least_feed = 0.1, least_spindle = 0.5;   // least overrides
constexpr auto stops_within = std::chrono::seconds(8);    // time for standstill and reset
constexpr auto look_again = std::chrono::milliseconds(5);

int percent(double share) { return int(std::lround(100 * share)); }

std::string state_text(const drive::LinkView& view) {
  const bool has_parts = view.state == GrblState::hold || view.state == GrblState::door;
  return has_parts ? fmt::format("{}:{}", name_of(view.state), view.substate) : std::string(name_of(view.state));
}

bool is_lost(const drive::LinkView& view) { return view.phase == LinkPhase::lost || view.phase == LinkPhase::closed; }

}  // namespace

GrblAxes::GrblAxes(std::shared_ptr<drive::GrblMachine> machine, std::vector<std::string> names, const AxisRoles& its_roles)
    : ChannelAxes(1, std::move(names), its_roles), machine_(std::move(machine)), writer_(machine_->settings()) {}

ServoSample GrblAxes::sample() const {
  const GrblStatus now = machine_->status();
  ServoSample sample;
  sample.instant = now.reports;
  if (now.view.machine) std::copy(now.view.machine->begin(), now.view.machine->end(), sample.machine.begin());
  const bool works = now.ended != now.begun;
  sample.motion = works ? now.view.line.value_or(0) : 0;
  sample.share = now.view.overrides.feed / 100.0;
  sample.speed = is_lost(now.view) ? 0 : now.view.feed;
  sample.plays = works || now.jogs;
  sample.held = works && (now.waits || (now.view.phase == LinkPhase::held && state_text(now.view) == "Hold:0"));
  sample.age = now.age;
  return sample;
}

std::optional<RealMachine> GrblAxes::real() const {
  const GrblStatus now = machine_->status();
  RealMachine real;
  real.port = machine_->place().port;
  real.controller = now.view.version;
  real.state = state_text(now.view);
  real.inputs = now.view.pins;
  real.age = now.age;
  real.pending = now.seconds_pending;
  real.is_lost = is_lost(now.view);
  real.is_locked = now.view.state == GrblState::alarm;
  return real;
}

void GrblAxes::stop_at_once() {
  stopped_ = true;
  machine_->stop();
}

/// Grbl has three overrides of rapids, and its feed override begins at 10 %; 0 is a feed hold.
PanelOverrides GrblAxes::possible(PanelOverrides wanted) const {
  wanted.rapid = wanted.rapid <= quarter_rapid ? quarter_rapid : wanted.rapid <= half_rapid ? half_rapid : 1;
  if (wanted.feed > 0) wanted.feed = std::max(wanted.feed, least_feed);
  wanted.spindle = std::max(wanted.spindle, least_spindle);
  return wanted;
}

std::string GrblAxes::fault() {
  if (!refused_.empty()) return std::exchange(refused_, {});
  const GrblStatus now = machine_->status();
  return now.fault ? drive::fault_text(*now.fault, now.pending_at_fault) : std::string();
}

std::string GrblAxes::not_ready() const {
  const GrblStatus now = machine_->status();
  if (is_lost(now.view)) return translated(texts::grbl_machine::no_port);
  if (now.view.state == GrblState::alarm) return translated(texts::grbl_machine::locked);
  if (now.stopping || now.view.phase != LinkPhase::ready || now.jogs || now.ended != now.begun)
    return translated(texts::grbl_machine::not_idle, state_text(now.view));
  return {};
}

void GrblAxes::recover() {
  const GrblStatus now = machine_->status();
  if (is_lost(now.view)) {
    machine_->reconnect();
    const auto end = std::chrono::steady_clock::now() + stops_within;
    const auto is_made = [&] {
      const GrblStatus then = machine_->status();
      return then.view.phase == LinkPhase::ready && then.view.machine;
    };
    while (!is_made() && std::chrono::steady_clock::now() < end) std::this_thread::sleep_for(look_again);
  }
  if (machine_->status().view.phase == LinkPhase::faulted) {
    machine_->stop();
    wait_for_rest();
  }
  machine_->forget_fault();
  writer_ = drive::GrblWriter(machine_->settings());
  writer_.forget();
  sent_.reset();
}

bool GrblAxes::home() {
  machine_->home();
  return true;
}

bool GrblAxes::unlock() {
  machine_->unlock();
  return true;
}

void GrblAxes::open_leg(const PanelOverrides& shares, bool by_hand) {
  blocks_.clear();
  writer_.forget();  // the first line of a leg states everything, so nothing of a leg depends on what was before
  writer_.run_dry(shares.dry_feed);
  writer_.restore_spindle(!by_hand);
  is_open_ = true;
  job_ = 0;
  jogs_ = holds_ = false;
}

void GrblAxes::begin_leg(Session& session, std::size_t channel, const PanelOverrides& shares) {
  session.outlets(channel).wants_times = true;
  open_leg(shares, false);
}

void GrblAxes::begin_by_hand(const Channel&, const MachineProfile&, const ToolPosition&, const PanelOverrides& shares) {
  open_leg(shares, true);
}

void GrblAxes::take(const Step& step) {
  if (!is_open_ || !refused_.empty()) return;
  if (step.motion() != nullptr) {
    pending.motion = ++motion_;
    blocks_.add(pending);
  }
  auto lines = writer_.write(step, motion_);
  if (!lines) {
    refused_ = lines.error();
    return;
  }
  for (drive::JobLine& line : *lines) {
    if (job_ == 0) job_ = machine_->begin_job();
    machine_->offer(std::move(line));
  }
}

bool GrblAxes::begin_jog(std::size_t axis, double end, double feed) {
  constexpr int first_rate = 110;
  constexpr double usual_rate = 500;  // mm/min, Grbl's default
  const double most = machine_->settings().value(first_rate + int(axis), usual_rate);
  open_leg({}, true);
  is_open_ = false;
  jogs_ = true;
  machine_->begin_jog(axis, end, feed > 0 ? std::min(feed, most) : most);
  return true;
}

bool GrblAxes::begin_probe(std::size_t axis, double end, double feed) {
  const GrblStatus now = machine_->status();
  if (!now.view.machine) return false;
  open_leg({}, true);
  touches_ = now.probes;
  job_ = machine_->begin_job();
  for (drive::JobLine& line : writer_.probe(*now.view.machine, axis, end, feed)) machine_->offer(std::move(line));
  end_leg();
  return true;
}

std::optional<Axes> GrblAxes::touched() const {
  const GrblStatus now = machine_->status();
  if (now.probes == touches_ || !now.probed) return std::nullopt;
  Axes at{};
  std::copy(now.probed->begin(), now.probed->end(), at.begin());
  return at;
}

void GrblAxes::end_leg(std::shared_ptr<PanelMeeting>, const Origin&) {
  if (!is_open_) return;
  is_open_ = false;
  if (job_ != 0) machine_->end_job();
}

void GrblAxes::note_block() {
  if (const PanelBlock* const block = blocks_.at(sample().motion)) on = *block;
}

void GrblAxes::apply_overrides(const PanelOverrides& shares, bool stands) {
  if (jogs_) {
    if (stands) machine_->end_jog();
    return;
  }
  const bool holds = stands || shares.feed <= 0;
  if (is_working() && holds != holds_) {
    holds_ = holds;
    holds ? machine_->hold() : machine_->resume();
  }
  if (!sent_ || sent_->feed != shares.feed) machine_->override_feed(percent(shares.feed > 0 ? shares.feed : 1));
  if (!sent_ || sent_->rapid != shares.rapid) machine_->override_rapid(percent(shares.rapid));
  if (!sent_ || sent_->spindle != shares.spindle) machine_->override_spindle(percent(shares.spindle));
  sent_ = shares;
}

bool GrblAxes::is_working() const {
  const GrblStatus now = machine_->status();
  return job_ != 0 && now.ended < job_;
}

bool GrblAxes::is_over() const {
  if (jogs_) return !machine_->status().jogs;
  return !is_open_ && !is_working();
}

bool GrblAxes::stands() const {
  if (jogs_) return !machine_->status().jogs;
  return !is_working() || sample().held;
}

void GrblAxes::settle() {
  is_open_ = jogs_ = false;
  job_ = 0;
}

void GrblAxes::wait_for_rest() const {
  const auto end = std::chrono::steady_clock::now() + stops_within;
  const auto is_stopping = [&] {
    const GrblStatus now = machine_->status();
    return !is_lost(now.view) && now.stopping;
  };
  while (is_stopping() && std::chrono::steady_clock::now() < end) std::this_thread::sleep_for(look_again);
}

/// Stops the axes, and waits until the controller is empty.
void GrblAxes::drop() {
  const bool moves = is_working() || jogs_;
  is_open_ = jogs_ = false;
  blocks_.clear();
  if (moves && !stopped_) machine_->stop();
  if (moves || stopped_) {
    wait_for_rest();
    sent_.reset();
  }
  job_ = 0;
}

}  // namespace kadr
