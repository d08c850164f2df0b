// A machine with a controller of the Grbl family, with a thread of its own. Used by panel/grbl_axes, tested by
// tests/panel/panel_grbl_test.cpp over a pseudo-terminal.

#include "drive/grbl/grbl_machine.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "drive/grbl/grbl_fault.h"

namespace kadr::drive {
namespace {

constexpr double longest_read = 0.004;                // longest wait for bytes, s: a hold waits no longer before it is sent
constexpr double wait_for_idle = 1.5;                 // how long a job waits for a report of an idle controller, s
constexpr double jog_piece = 0.1, jog_ahead = 0.25;   // time of one piece of a jog, and of all pieces that are sent, s
constexpr double cancel_again = 0.1;                  // time after which the end of a jog is requested again, s
constexpr double homing_time = 180, answer_time = 2;  // s
constexpr double longest_stop = 12;                   // time for a stop when the machine is switched off, s
constexpr double seconds_of_minute = 60;

/// True if a stop has no sense: the connection is broken, or the controller has stopped by itself.
bool is_gone(LinkFault fault) {
  return fault == LinkFault::port_lost || fault == LinkFault::silent || fault == LinkFault::no_answer || fault == LinkFault::reset ||
         fault == LinkFault::alarm;
}

}  // namespace

tl::expected<std::unique_ptr<GrblMachine>, std::string> GrblMachine::connect(GrblPlace place, const StopToken& stop) {
  std::unique_ptr<GrblMachine> machine(new GrblMachine(std::move(place)));
  if (const auto opened = machine->open(); !opened) return tl::unexpected(opened.error());
  bool connected = false;
  const auto& view = machine->driver_->link().view();
  while (!connected || !view.machine) {
    if (stop.requested()) return tl::unexpected(std::string());
    for (const LinkEvent& event : machine->driver_->step(longest_read)) {
      if (event.kind == LinkEventKind::fault && view.phase != LinkPhase::ready) return tl::unexpected(fault_text(event, 0));
      connected = connected || event.kind == LinkEventKind::connected;
    }
  }
  machine->settings_ = machine->driver_->link().settings();
  machine->publish();
  machine->thread_.begin_or_throw([it = machine.get()] { it->live(); });
  return machine;
}

GrblMachine::~GrblMachine() {
  ends_ = true;
  thread_.wait();
}

tl::expected<void, std::string> GrblMachine::open() {
  LineSettings line;
  line.baud = place_.baud;
  auto port = open_port(place_.port, line);
  if (!port) return tl::unexpected(port.error());
  if (!place_.log.empty() && !log_) {
    auto log = BlackBox::open(place_.log);
    if (!log) return tl::unexpected(log.error());
    log_ = std::move(*log);
  }
  LinkOptions options;
  options.report_every = 0.1;
  options.line_rate = characters_per_second(place_.port, line);
  driver_ = std::make_unique<GrblDriver>(std::move(*port), log_.get(), options);
  return {};
}

void GrblMachine::live() {
  const auto work = [this] {
    obey();
    feed_job();
    feed_jog();
    for (const LinkEvent& event : driver_->step(longest_read)) take(event);
    publish();
  };
  while (!ends_) work();
  // Nothing may go on moving when the machine is switched off.
  const bool moves = driver_->link().view().phase != LinkPhase::ready || driver_->link().view().state != GrblState::idle;
  if (moves) stop();
  for (const double until = driver_->now() + longest_stop; moves && driver_->now() < until;) {
    work();
    const LinkPhase phase = driver_->link().view().phase;
    if (phase == LinkPhase::ready || phase == LinkPhase::lost) break;
  }
}

/// Passes the requests of the other threads to the link.
void GrblMachine::obey() {
  Wanted wanted;
  {
    const std::lock_guard hold(lock_);
    wanted = std::exchange(wanted_, {});
  }
  GrblLink& link = driver_->link();
  if (wanted.stop) link.stop();
  if (wanted.hold && !hold_back(true)) link.hold();
  if (wanted.resume && !hold_back(false)) link.resume();
  if (wanted.feed) link.override_feed(*wanted.feed);
  if (wanted.rapid) link.override_rapid(*wanted.rapid);
  if (wanted.spindle) link.override_spindle(*wanted.spindle);
  if (wanted.home) (void)link.command("$H", homing_time);
  if (wanted.unlock) (void)link.command("$X", answer_time);
  if (!wanted.reconnect) return;
  driver_.reset();  // the port must be free before it is opened again
  if (const auto opened = open(); opened) return;
  // The port is still gone: a driver without a port reports that.
  LinkOptions options;
  driver_ = std::make_unique<GrblDriver>(nullptr, log_.get(), options);
  driver_->link().port_lost();
}

/// Keeps a job that has not begun from beginning, or lets it begin. Returns false if there is no such job.
bool GrblMachine::hold_back(bool waits) {
  const std::lock_guard hold(lock_);
  if (job_is_open_ || status_.ended == status_.begun) return false;
  job_waits_ = waits;
  if (!waits) job_wanted_at_ = now();
  return true;
}

/// Begins the job of the client, and offers its lines to the link as the link asks for them.
void GrblMachine::feed_job() {
  GrblLink& link = driver_->link();
  const std::lock_guard hold(lock_);
  if (status_.ended == status_.begun || job_waits_) return;
  if (!job_is_open_) {
    if (link.view().phase == LinkPhase::stopping) return;
    job_is_open_ = link.begin_job();
    if (!job_is_open_ && now() - job_wanted_at_ < wait_for_idle) return;
    if (!job_is_open_) {
      LinkEvent busy;
      busy.kind = LinkEventKind::fault;
      busy.fault = LinkFault::busy;
      busy.text = std::string(name_of(link.view().state));
      status_.fault = busy;
      status_.ended = status_.begun;
      lines_.clear();
      return;
    }
  }
  while (link.wants_line() && !lines_.empty()) {
    link.offer(std::move(lines_.front()));
    lines_.pop_front();
  }
  if (lines_.empty() && job_ends_) link.end_of_job();
}

/// Sends the next piece of a jog if the controller has little of it, or ends the jog.
void GrblMachine::feed_jog() {
  GrblLink& link = driver_->link();
  const std::lock_guard hold(lock_);
  if (!jog_) return;
  GrblJog& jog = *jog_;
  const LinkView& view = link.view();
  if (view.phase != LinkPhase::ready) return jog_.reset();
  const double at = now();
  jog.released = jog.released || at - jog.kept_at > most_silence;
  if (!jog.released && jog.next != jog.end) {
    if (jog.sent_until - at > jog_ahead) return;
    const double piece = std::min(jog.feed / seconds_of_minute * jog_piece, std::fabs(jog.end - jog.next));
    const double next = jog.next + (jog.end > jog.next ? piece : -piece);
    if (!link.command(fmt::format("$J=G21G90G53{}{:.3f}F{:.1f}", "XYZ"[jog.axis], next, jog.feed), answer_time)) return;
    jog.next = next;
    jog.sent_until = std::max(at, jog.sent_until) + piece / jog.feed * seconds_of_minute;
    jog.acted_at = driver_->now();
    return;
  }
  const bool may_move = view.state == GrblState::jog || view.bytes_in_flight > 0;
  if (jog.released && may_move && driver_->now() - jog.acted_at > (jog.cancelled ? cancel_again : 0)) {
    link.cancel_jog();
    jog.cancelled = true;
    jog.acted_at = driver_->now();
    return;
  }
  const bool is_due = jog.released || at > jog.sent_until;
  if (is_due && view.state == GrblState::idle && view.bytes_in_flight == 0 && view.reported_at > jog.acted_at) jog_.reset();
}

void GrblMachine::take(const LinkEvent& event) {
  const std::lock_guard hold(lock_);
  switch (event.kind) {
    case LinkEventKind::fault:
      if (!status_.fault) {
        status_.fault = event;
        status_.pending_at_fault = driver_->link().seconds_pending();
      }
      end_job_now();
      if (!is_gone(event.fault)) driver_->link().stop();  // to rest, and an empty controller
      break;
    case LinkEventKind::finished:
    case LinkEventKind::stopped: end_job_now(); break;
    case LinkEventKind::connected: settings_ = driver_->link().settings(); break;
    case LinkEventKind::message: status_.message = event.text; break;
    case LinkEventKind::answered:
      if (event.number != 0) {
        status_.message = fmt::format("error:{} {}", event.number, event.text);
        if (jog_) jog_->released = true;
      }
      break;
    case LinkEventKind::probed:
      status_.probed = event.point;
      ++(event.point ? status_.probes : status_.probed_nothing);
      break;
    case LinkEventKind::held:
    case LinkEventKind::resumed:
    case LinkEventKind::stop_reached: break;
  }
}

/// The job is over: its lines are executed, or forgotten.
void GrblMachine::end_job_now() {
  status_.ended = status_.begun;
  job_is_open_ = job_waits_ = false;
  lines_.clear();
}

void GrblMachine::publish() {
  const LinkView& view = driver_->link().view();
  const std::lock_guard hold(lock_);
  status_.view = view;
  if (view.reported_at != last_report_) ++status_.reports;
  last_report_ = view.reported_at;
  reported_ = Clock::now() - std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(driver_->age()));
  status_.seconds_pending = driver_->link().seconds_pending();
  status_.jogs = jog_.has_value();
  status_.waits = job_waits_;
  status_.stopping = wanted_.stop || view.phase == LinkPhase::stopping;
  status_.log_failed = log_ && !log_->is_right();
}

GrblStatus GrblMachine::status() const {
  const std::lock_guard hold(lock_);
  GrblStatus now = status_;
  now.jogs = jog_.has_value();
  now.age = std::chrono::duration<double>(Clock::now() - reported_).count();
  return now;
}

GrblSettings GrblMachine::settings() const {
  const std::lock_guard hold(lock_);
  return settings_;
}

std::uint64_t GrblMachine::begin_job() {
  const std::lock_guard hold(lock_);
  lines_.clear();
  job_ends_ = job_waits_ = false;
  wanted_.hold = wanted_.resume = false;
  job_wanted_at_ = now();
  return ++status_.begun;
}

void GrblMachine::offer(JobLine line) {
  const std::lock_guard hold(lock_);
  if (status_.ended != status_.begun) lines_.push_back(std::move(line));
}

void GrblMachine::end_job() {
  const std::lock_guard hold(lock_);
  job_ends_ = true;
}

std::size_t GrblMachine::queued() const {
  const std::lock_guard hold(lock_);
  return lines_.size();
}

void GrblMachine::hold() {
  const std::lock_guard hold(lock_);
  wanted_.hold = true, wanted_.resume = false;
}

void GrblMachine::resume() {
  const std::lock_guard hold(lock_);
  wanted_.resume = true, wanted_.hold = false;
}

void GrblMachine::stop() {
  const std::lock_guard hold(lock_);
  wanted_.stop = status_.stopping = true, wanted_.resume = false;
  lines_.clear();
}

void GrblMachine::override_feed(int percent) {
  const std::lock_guard hold(lock_);
  wanted_.feed = percent;
}

void GrblMachine::override_rapid(int percent) {
  const std::lock_guard hold(lock_);
  wanted_.rapid = percent;
}

void GrblMachine::override_spindle(int percent) {
  const std::lock_guard hold(lock_);
  wanted_.spindle = percent;
}

void GrblMachine::begin_jog(std::size_t axis, double end, double feed) {
  const std::lock_guard hold(lock_);
  if (!status_.view.machine) return;
  GrblJog& jog = jog_.emplace();
  jog.axis = axis, jog.end = end, jog.feed = feed;
  jog.next = (*status_.view.machine)[axis];
  jog.kept_at = now();
}

void GrblMachine::keep_jogging() {
  const std::lock_guard hold(lock_);
  if (jog_) jog_->kept_at = now();
}

void GrblMachine::end_jog() {
  const std::lock_guard hold(lock_);
  if (jog_) jog_->released = true;
}

void GrblMachine::home() {
  const std::lock_guard hold(lock_);
  wanted_.home = true;
}

void GrblMachine::unlock() {
  const std::lock_guard hold(lock_);
  wanted_.unlock = true;
}

void GrblMachine::reconnect() {
  const std::lock_guard hold(lock_);
  wanted_.reconnect = true;
}

void GrblMachine::forget_fault() {
  const std::lock_guard hold(lock_);
  status_.fault.reset();
}

}  // namespace kadr::drive
