// PanelMachine, its thread and the operator's requests. Used by view/page/page_panel; tested by tests/panel/panel_machine_test.cpp.

#include "panel/panel_machine.h"

#include <fmt/core.h>

#include <algorithm>
#include <chrono>
#include <utility>

#include "config/language.h"
#include "texts/panel.h"

namespace kadr {
namespace {

using Failed = tl::unexpected<std::string>;

constexpr auto look_every = std::chrono::milliseconds(4);     // interval at which the machine's thread checks a motion
constexpr auto look_at_rest = std::chrono::milliseconds(50);  // the same for a real machine at rest
constexpr double seen_share = 1e-6;  // least decrease of the override (0 to 1) that counts as the effect of a feed hold
constexpr auto seen_within = std::chrono::milliseconds(20);  // time limit until a request's effect is visible; some axes can hardly brake
// Time limit for the start of a request. If it expires, the machine is busy and the request is dropped.
constexpr auto answers_within = std::chrono::seconds(2);
constexpr auto queued_after = std::chrono::seconds(2);  // time limit until a request that has started is reported as queued
constexpr auto done_within = std::chrono::seconds(60);  // time limit for the completion of a request whose result the caller needs

/// Waits until `is` returns true, but only for a short time, so that the caller's next query of the state shows the effect of a request.
template <class Is>
void wait_until_seen(Is is) {
  const auto end = std::chrono::steady_clock::now() + seen_within;
  while (!is() && std::chrono::steady_clock::now() < end) std::this_thread::sleep_for(std::chrono::milliseconds(1));
}

}  // namespace

PanelMachine::~PanelMachine() { switch_off(); }

void PanelMachine::switch_off() {
  ends_ = true;  // This flag is set before stop_at_once() is called, so that the stop does not count as an emergency stop of the operator.
  stop_at_once();
  const std::lock_guard one_at_a_time(off_lock_);
  thread_.wait();
}

/// Lets the machine's thread execute a request and returns its result: done, queued if the request has started but takes long, or an error
/// if the request was dropped.
///   wait  for_end: the caller needs the result of the request, which only reads
PanelMachine::Answer PanelMachine::ask(std::function<Answer()> what, Wait wait) {
  std::future<Answer> answer;
  std::uint64_t number = 0;
  std::shared_ptr<bool> is_queued;
  {
    const std::lock_guard hold(lock_);
    if (ends_) return Failed(translated(texts::panel::off));
    requests_.push_back({[what = std::move(what), lang = thread_language()] {
                           set_thread_language(lang);  // error sentences are in the language of the thread that made the request
                           return what();
                         },
                         {},
                         number = ++request_count_});
    answer = requests_.back().answer.get_future();
    is_queued = requests_.back().is_queued;
  }
  wakes_.notify_all();
  if (answer.wait_for(answers_within) == std::future_status::ready) return answer.get();
  {
    const std::lock_guard hold(lock_);
    if (std::erase_if(requests_, [&](const Request& one) { return one.number == number; }) != 0)
      return Failed(translated(texts::panel::busy));
  }
  if (wait == Wait::for_end) {
    if (answer.wait_for(done_within) == std::future_status::ready) return answer.get();
    return Failed(translated(texts::panel::not_over_yet));
  }
  if (answer.wait_for(queued_after) == std::future_status::ready) return answer.get();
  const std::lock_guard hold(lock_);
  if (answer.wait_for(std::chrono::seconds(0)) == std::future_status::ready) return answer.get();
  *is_queued = true;
  return Outcome::queued;
}

void PanelMachine::execute_requests() {
  while (true) {
    Request next;
    {
      const std::lock_guard hold(lock_);
      if (requests_.empty()) return;
      next = std::move(requests_.front());
      requests_.pop_front();
    }
    Answer answer;
    try {
      answer = next.what();
      show();
    } catch (const std::bad_alloc&) {
      stop_at_once();
      answer = Failed(translated(texts::panel::out_of_memory));
    }
    give_answer(next, answer);
  }
}

/// Passes the answer to the caller. If the caller does not wait any more, the panel displays why the request was not executed.
void PanelMachine::give_answer(Request& request, const Answer& answer) {
  {
    const std::lock_guard hold(lock_);
    request.answer.set_value(answer);
    if (answer || !*request.is_queued) return;
  }
  panel_state_.message = answer.error();
  show();
}

/// Executes what is due in the machine's thread, and then waits for the next event.
///   returns  false if the machine is switched off
bool PanelMachine::look_round() {
  if (!ends_ && must_stop()) stand_still();
  execute_requests();
  if (running_ && !must_stop()) watch_run();
  if (retables_) apply_edited_tables();
  if (is_real()) watch_machine();
  std::unique_lock hold(lock_);
  if (ends_) return false;
  const auto has_request = [this] { return ends_ || !requests_.empty() || must_stop(); };
  if (running_ || retables_) wakes_.wait_for(hold, look_every, has_request);
  else if (is_real()) wakes_.wait_for(hold, look_at_rest, has_request);
  else wakes_.wait(hold, has_request);
  return true;
}

void PanelMachine::live() {
  for (bool goes_on = true; goes_on;) {
    try {
      goes_on = look_round();
    } catch (const std::bad_alloc&) {  // the program has run out of memory, so the axes are stopped
      stop_at_once();
    }
  }
  drop_run();
  while (!requests_.empty()) requests_.front().answer.set_value({}), requests_.pop_front();
}

void PanelMachine::stand_still() {
  drop_run();
  retables_.reset();
  panel_state_.mode = PanelMode::emergency;
  notify("emergency");
  show();
}

void PanelMachine::watch_run() {
  provide();
  if (held_until_ && std::chrono::steady_clock::now() > *held_until_) let_go();
  const bool stand = std::all_of(lanes_.begin(), lanes_.end(), [](const auto& lane) { return lane->stands(); });
  if (resets_ && stand) {
    drop_run();
    if (const Answer opened = start_over(); !opened) panel_state_.message = opened.error();
    return;
  }
  const bool held = std::any_of(lanes_.begin(), lanes_.end(), [](const auto& lane) { return lane->sample().held; });
  panel_state_.mode = stand && held ? PanelMode::held : PanelMode::running;
  if (is_over() || (lets_go_ && stand)) end_run();
  show();
}

/// Returns the line of the block that the machine is executing if this block belongs to the program; otherwise the line of the next block.
AlarmReport::Line PanelMachine::line_of(const ServoSample& sample) const {
  const bool runs = running_ && running_->of == Run::Of::program;
  if (!runs && stepping_->next()) return stepping_->line();
  Origin origin = lane_->on.entered ? Origin() : lane_->block();
  if (const Spent at = Spent::of(sample.tag); runs && sample.motion == 0 && at.line != 0 && lane_->waits_for() == nullptr)
    origin.line = at.line, origin.file = at.file;
  return origin.line == 0 ? AlarmReport::Line() : session_->control().line_at(origin);
}

void PanelMachine::show() {
  PanelState now = panel_state_;
  for (const auto& lane : lanes_) lane->note_block();
  now.sample = lane_->sample();
  now.block = lane_->on;
  now.limit = lane_->limit();
  now.real = lane_->real();
  show_channels(now);
  now.entered = running_ && running_->of == Run::Of::line;
  now.goes_there = going_.has_value();
  now.takes_tables = retables_.has_value();
  now.line = line_of(now.sample);
  now.hit = stepping_->hit();
  now.can_undo = before_.size();
  now.blocks = session_->blocks();
  save_location(now);
  now.save_fault = panel_state_.save_fault;
  apply_overrides();
  const std::lock_guard hold(lock_);
  shown_ = std::move(now);
}

void PanelMachine::show_channels(PanelState& now) const {
  if (is_alone()) return;
  for (std::size_t i = 0; i < lanes_.size(); ++i) {
    const ChannelAxes& lane = *lanes_[i];
    PanelChannel& shown = now.channels.emplace_back();
    shown.number = lane.number, shown.axes = lane.axes;
    shown.sample = lane.sample(), shown.block = lane.on;
    if (lane.block().line != 0 && !lane.on.entered) shown.line = session_->channels()[i].control->line_at(lane.block());
    if (const PanelMeeting* const meeting = lane.waits_for()) shown.waits = *meeting;
  }
}

PanelState PanelMachine::state() {
  const std::lock_guard hold(lock_);
  PanelState now = shown_;
  now.sample = lane_->sample();
  if (now.real) now.real = lane_->real();
  return now;
}

PanelMachine::Answer PanelMachine::may_begin() const {
  if (retables_) return Failed(translated(texts::panel::taking_tables));
  if (const std::string why = lane_->not_ready(); !running_ && !why.empty()) return Failed(why);
  switch (panel_state_.mode) {
    case PanelMode::standing:
    case PanelMode::ended: return {};
    case PanelMode::running:
    case PanelMode::held: return Failed(translated(texts::panel::running));
    case PanelMode::alarm: return Failed(translated(texts::panel::in_alarm));
    case PanelMode::emergency: return Failed(translated(texts::panel::in_emergency));
  }
  return {};
}

void PanelMachine::apply_overrides() {
  for (const auto& lane : lanes_) lane->apply_overrides(panel_state_.shares, holds_ || resets_ || lets_go_);
}

/// Continues the program. After a feed hold, the function returns only when the axes move again.
PanelMachine::Answer PanelMachine::run(std::optional<Stepping::How> how) {
  const Answer runs = ask([this, how]() -> Answer {
    if (running_) {
      holds_ = false;
      apply_overrides();
      return {};
    }
    if (const Answer may = may_begin(); !may) return may;
    if (panel_state_.asks) return Failed(translated(texts::panel::waits_for_answer));
    if (panel_state_.mode == PanelMode::ended)
      if (const Answer opened = open(lane_->sample().machine); !opened) return opened;
    panel_state_.message.clear(), panel_state_.why.clear();
    panel_state_.alarm.reset();
    notify("run", {}, stepping_->line().number);
    how_ = how;
    begin(Run::Of::program, own_);
    return {};
  });
  if (runs) wait_until_seen([this] { return state().mode != PanelMode::held; });
  return runs;
}

PanelMachine::Answer PanelMachine::answer(double answer) {
  if (!(answer >= 0 && answer <= 3)) return Failed(translated(texts::panel::answer_limits));
  return ask([this, answer]() -> Answer {
    if (const Answer may = may_begin(); !may) return may;
    if (!panel_state_.asks) return Failed(translated(texts::panel::nothing_asked));
    asks_->set_answer(answer);
    panel_state_.asks = false;
    panel_state_.message.clear(), panel_state_.why.clear();
    how_.reset();
    begin(Run::Of::program, own_);
    return {};
  });
}

/// Starts a feed hold. The function returns only when the axes have slowed down, so that the caller's next query of the state shows the
/// hold.
PanelMachine::Answer PanelMachine::hold() {
  const double share = lane_->sample().share;
  const Answer held = ask([this]() -> Answer {
    holds_ = running_.has_value();
    if (holds_) notify("hold", {}, lane_->on.origin.line);
    apply_overrides();
    return {};
  });
  wait_until_seen([&] {
    const ServoSample at = lane_->sample();
    return !at.plays || at.held || at.share < share - seen_share;
  });
  return held;
}

PanelMachine::Answer PanelMachine::reset() {
  stops_ = true;  // The flag stops the session, because the present block of the program might never end.
  return ask([this]() -> Answer {
    panel_state_.message.clear(), panel_state_.why.clear();
    for (const auto& lane : lanes_) lane->release();
    notify("reset");
    if (!running_) return start_over();
    resets_ = true;
    apply_overrides();
    return {};
  });
}

void PanelMachine::stop_at_once() {
  for (const auto& lane : lanes_) lane->stop_at_once();
  stops_ = true;
  // While this function owns the lock, the machine's thread is waiting, or the thread checks for a stop before it waits.
  const std::lock_guard hold(lock_);
  wakes_.notify_all();
}

PanelMachine::Answer PanelMachine::set_single(bool on) {
  return ask([this, on]() -> Answer {
    panel_state_.single = on;
    if (on && running_ && running_->of == Run::Of::program) stepping_->hold_next();
    return {};
  });
}

PanelMachine::Answer PanelMachine::set_optional_stop(bool on) {
  return ask([this, on]() -> Answer {
    if (panel_state_.optional_stop == on) return {};
    panel_state_.optional_stop = on;
    obey_switches();
    begin_search();
    return {};
  });
}

PanelMachine::Answer PanelMachine::set_skip(int number, bool on) {
  if (number < 1 || number > 9) return Failed(translated(texts::panel::skip_limits));
  return ask([this, number, on]() -> Answer {
    if (on) panel_state_.skip.insert(number);
    else panel_state_.skip.erase(number);
    obey_switches();
    begin_search();
    return {};
  });
}

PanelMachine::Answer PanelMachine::set_overrides(const PanelOverrides& shares) {
  const auto is_share = [](double share) { return share >= 0 && share <= 1; };
  if (!(shares.feed >= 0 && shares.feed <= PanelOverrides::max_feed) || !is_share(shares.rapid))
    return Failed(translated(texts::panel::override_limits));
  if (!(shares.spindle >= PanelOverrides::least_spindle && shares.spindle <= PanelOverrides::max_spindle))
    return Failed(translated(texts::panel::spindle_limits));
  if (!(shares.dry_feed >= 0 && shares.dry_feed <= 1e5)) return Failed(translated(texts::panel::dry_run_limits));
  return ask([this, shares]() -> Answer {
    panel_state_.shares = lane_->possible(shares);
    notify("override", fmt::format("F {:.0f} % G0 {:.0f} % S {:.0f} %{}", 100 * shares.feed, 100 * shares.rapid, 100 * shares.spindle,
                                   shares.dry_feed > 0 ? fmt::format(" dry {:.0f}", shares.dry_feed) : std::string()));
    apply_overrides();
    return {};
  });
}

tl::expected<std::size_t, std::string> PanelMachine::add_stop(StopPoint point) {
  // The number is in shared memory, because the request that sets it may be executed after this call has timed out.
  const auto number = std::make_shared<std::size_t>(0);
  const Answer answer = ask(
      [this, number, point = std::move(point)]() -> Answer {
        if (panel_state_.stops.size() == max_stops) return Failed(translated(texts::panel::too_many_stops));
        if (!point.condition.empty())
          if (const auto holds = stepping_->holds(point.condition); !holds) return Failed(translated(texts::panel::condition_wrong));
        *number = stepping_->add(point);
        panel_state_.stops.emplace(*number, point);
        return {};
      },
      Wait::for_end);
  if (!answer) return Failed(answer.error());
  return *number;
}

PanelMachine::Answer PanelMachine::remove_stop(std::size_t number) {
  return ask([this, number]() -> Answer {
    if (!stepping_->remove(number)) return Failed(translated(texts::panel::no_such_stop));
    panel_state_.stops.erase(number);
    return {};
  });
}

}  // namespace kadr
