// ServoClock outputs positions at a fixed rate. Used by panel/panel_machine; tested by tests/panel/panel_machine_test.cpp.

#include "panel/servo_clock.h"

#include <algorithm>
#include <chrono>
#include <cmath>

namespace kadr {
namespace {

constexpr double seconds_a_minute = 60;

}  // namespace

ServoClock::ServoClock(double rate, const Axes& stand, const AxisRoles& roles) : rate_(rate), roles_(roles) {
  now_.machine = stand;
  show();
  thread_.begin_or_throw([this] { run(); });
}

ServoClock::~ServoClock() {
  playback_ = nullptr;
  {
    const std::lock_guard hold(idle_lock_);
    ends_ = true;
  }
  wakes_.notify_all();
  thread_.wait();
}

void ServoClock::play(Playback* playback) {
  std::unique_lock hold(idle_lock_);
  playback_.store(nullptr, std::memory_order_release);
  idles_.wait(hold, [this] { return idle_; });  // This wait ends after one instant of the clock at most.
  if (playback == nullptr) return;
  // The tag of the previous motion is deleted, because it may refer to the file of an entered line, which no longer exists.
  now_.played = 0, now_.motion = 0, now_.tag = 0;
  now_.plays = true;
  show();
  playback_.store(playback, std::memory_order_release);
  wakes_.notify_all();
}

void ServoClock::stand_at(const Axes& machine) {
  play(nullptr);
  const std::lock_guard hold(idle_lock_);
  now_.machine = machine;
  show();
}

void ServoClock::run() {
  using Clock = std::chrono::steady_clock;
  const auto period = std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(1 / rate_));
  Clock::time_point next;
  while (true) {
    Playback* const playback = playback_.load(std::memory_order_acquire);
    if (playback == nullptr) {
      std::unique_lock hold(idle_lock_);
      now_.plays = now_.held = false, now_.speed = 0;
      show();
      idle_ = true;
      idles_.notify_all();
      wakes_.wait(hold, [this] { return ends_ || playback_.load(std::memory_order_acquire) != nullptr; });
      if (ends_) return;
      idle_ = false;
      next = Clock::now();
      continue;
    }
    if (was_stopped()) now_.plays = false, now_.speed = 0, show_if_free();
    else tick(*playback);
    next += period;
    std::this_thread::sleep_until(next);
    now_.late = std::max(now_.late, std::chrono::duration<double>(Clock::now() - next).count());
  }
}

void ServoClock::tick(Playback& playback) {
  Axes at = now_.machine;
  if (playback.done() || playback.fill(at.data(), 1) == 0) {
    now_.plays = false, now_.speed = 0;
    return show_if_free();
  }
  double square = 0;
  for (const int axis : roles_.xyz)
    if (axis >= 0) square += std::pow(at[std::size_t(axis)] - now_.machine[std::size_t(axis)], 2);
  ++now_.instant;
  now_.machine = at;
  now_.tag = playback.tag(), now_.motion = playback.motion();
  now_.share = playback.share(), now_.played = playback.played();
  now_.held = playback.is_held(), now_.plays = !playback.done();
  now_.speed = std::sqrt(square) * rate_ * seconds_a_minute;
  show_if_free();
}

void ServoClock::show() {
  const std::lock_guard hold(shown_lock_);
  shown_ = now_;
}

/// Publishes the sample, unless a reader holds the lock. In this case the readers get the next sample, at the next instant.
void ServoClock::show_if_free() {
  if (const std::unique_lock hold(shown_lock_, std::try_to_lock); hold) shown_ = now_;
}

ServoSample ServoClock::sample() const {
  const std::lock_guard hold(shown_lock_);
  return shown_;
}

}  // namespace kadr
