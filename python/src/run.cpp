// One execution of a program. Used by module.cpp; tested by tests/python_binding.py.

#include "run.h"

#include <utility>

#include "interrupt.h"

namespace kadr::python {
namespace {

constexpr std::size_t most_warnings = 1000;

}  // namespace

class Run::Alone {
 public:
  explicit Alone(Run& run) : lock_(run.busy_, std::try_to_lock) {
    if (!lock_) throw Failed{"this session is at work in another thread"};
  }

 private:
  std::unique_lock<std::mutex> lock_;
};

Run::Run(std::shared_ptr<const ProgramSpec> spec, std::size_t most)
    : spec_(std::move(spec)), session_(spec_->open(stop_)), rows_(session_->control().axes().size()), most_(most) {
  const std::size_t channels = session_->channels().size();
  for (std::size_t i = 0; i < channels; ++i) {
    const Channel& channel = session_->channels()[i];
    clocks_.push_back(clock_of(*session_, i));
    tools_.push_back(static_cast<std::uint32_t>(std::max(channel.setup.tool, 0)));
    at_.push_back(channel.control->tool_position());
  }
  for (std::size_t i = 0; i < channels; ++i) look_at(i);
  session_->control().holds_before = [this](const Origin& block) {
    if (!stepping_ || std::exchange(may_pass_, false)) return false;
    next_ = block;
    return true;
  };
}

void Run::look_at(std::size_t channel) {
  Outlets& outlets = session_->outlets(channel);
  outlets.clock = &clocks_[channel];
  outlets.step = [this, channel](const Step& step) { take(step, channel); };
  outlets.writable = [this] { return !too_many_; };
  outlets.warning = [this](const AlarmReport& report) {
    if (warnings_.size() < most_warnings) warnings_.push_back(spec_->finding(report));
  };
}

void Run::take(const Step& step, std::size_t channel) {
  if (const auto* const change = std::get_if<ToolChange>(&step.action.what)) tools_[channel] = change->tool;
  at_[channel].take(step.action);
  const Motion* const motion = step.motion();
  if (motion == nullptr || too_many_) return;
  if (rows_.size() >= most_) too_many_ = true;
  else rows_.add(step, *motion, tools_[channel], session_->channels()[channel].number);
}

/// Runs until the session stops before a block, or ends.
void Run::go() {
  at_block_ = false;
  {
    const CatchInterrupt interrupt(stop_);
    do state_ = session_->go_on();
    while (state_ == Session::State::running);
  }
  if (too_many_) throw Failed{"more than " + std::to_string(most_) + " motions: max_motions"};  // even at the end of the program
  if (state_ == Session::State::held) return void(at_block_ = true);
  if (state_ != Session::State::stopped) return;
  if (stop_) throw Interrupted{};
  for (std::size_t i = 0; i < session_->channels().size(); ++i)
    if (const auto& report = session_->stopped(i).report) throw Alarmed{spec_->finding(*report)};
}

void Run::run() {
  const Alone alone(*this);
  stepping_ = false;
  go();
}

std::optional<Place> Run::step() {
  const Alone alone(*this);
  stepping_ = true;
  if (!at_block_) go();
  if (!at_block_) return std::nullopt;
  const Place passed = place_of(next_);
  may_pass_ = true;
  go();
  may_pass_ = false;
  return passed;
}

std::shared_ptr<const Run::Kept> Run::snapshot() {
  const Alone alone(*this);
  auto session = session_->snapshot();
  if (!session) throw Failed{"no snapshot while a probe is waited for"};
  return std::make_shared<const Kept>(
      Kept{spec_.get(), std::move(*session), clocks_, tools_, rows_, at_, warnings_, state_, at_block_, next_});
}

void Run::restore(const Kept& from) {
  const Alone alone(*this);
  if (from.spec != spec_.get()) throw Failed{"the snapshot is of another program, or of another control, machine or set-up"};
  if (const Status restored = session_->restore(from.session); !restored)
    throw Alarmed{spec_->finding(session_->control().report_for(restored.error(), Origin()))};
  for (std::size_t i = 0; i < clocks_.size(); ++i) clocks_[i] = from.clocks[i];
  tools_ = from.tools;
  rows_ = from.rows;
  at_ = from.at;
  warnings_ = from.warnings;
  state_ = from.state;
  at_block_ = from.at_block;
  next_ = from.next;
  may_pass_ = too_many_ = false;
  stop_ = false;
}

std::string Run::rows() const {
  std::string bytes;
  bytes.reserve(rows_.bytes());
  rows_.append_to(bytes);
  return bytes;
}

std::map<std::string, double> Run::position(bool machine) const {
  const auto& axes = session_->control().axes();
  const ToolPosition& at = at_[session_->own()];
  std::map<std::string, double> values;
  for (std::size_t i = 0; i < axes.size(); ++i) values[axes[i]] = machine ? at.machine[i] : at.work[i];
  return values;
}

std::string Run::state() const {
  switch (state_) {
    case Session::State::ended: return "ended";
    case Session::State::stopped: return "stopped";
    default: return "running";
  }
}

std::map<std::string, double> Run::variables() const {
  const FinalState ending = session_->control().ending();
  return {ending.variables.begin(), ending.variables.end()};
}

double Run::evaluate(const std::string& expression) {
  const Alone alone(*this);
  const auto value = session_->control().evaluate(expression);
  if (!value) throw Alarmed{spec_->finding(session_->control().report_for(value.error(), Origin()))};
  return *value;
}

Place Run::place_of(const Origin& origin) const {
  return {session_->control().file_name(origin.file), origin.line, origin.has_block ? std::int64_t{origin.block} : -1, origin.depth};
}

}  // namespace kadr::python
