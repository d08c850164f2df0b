#pragma once
// ServoClock: the machine's clock. A thread of its own that at each instant takes the next positions of the axes off a Playback, and shows
// where they are. Nothing that plans, serves or draws can hold it up.
//
//   who plans ──offer──▶ Playback ──▶ one position an instant ──▶ sample(), from any thread

#include <atomic>
#include <condition_variable>
#include <cstdint>
#include <mutex>

#include "action/axis_roles.h"
#include "base/thread.h"
#include "motion/play/playback.h"

namespace kadr {

/// Where the axes are at an instant of the clock.
struct ServoSample {
  std::uint64_t instant = 0;  // counted while it plays
  Axes machine{};             // mm, degrees
  std::uint64_t tag = 0;      // Spent::of(): the line that it belongs to
  std::uint64_t motion = 0;   // Playback::motion()
  double share = 1;           // of the planned speed that has been reached
  double played = 0;          // s on the plan that are through
  double speed = 0;           // of X, Y, Z together, mm/min
  bool plays = false;         // motion is to come
  bool held = false;          // by an override of 0
  double late = 0;            // s by which an instant came too late, the greatest so far
};

class ServoClock {
 public:
  /// `rate`: Hz. `stand`: machine coordinates at the start. `roles`: of the axes.
  ServoClock(double rate, const Axes& stand, const AxisRoles& roles);
  ~ServoClock();
  ServoClock(const ServoClock&) = delete;  // its thread looks at it
  ServoClock& operator=(const ServoClock&) = delete;

  /// From the next instant on. nullptr: the axes stand where they are; then the one before is no longer looked at.
  void play(Playback* playback);
  /// The axes are put there; nothing is played.
  void stand_at(const Axes& machine);
  /// Emergency stop: from the next instant on no position is handed out until release(). From any thread.
  void stop_at_once() { stopped_.store(true, std::memory_order_release); }
  void release() { stopped_.store(false, std::memory_order_release); }
  bool was_stopped() const { return stopped_.load(std::memory_order_acquire); }
  ServoSample sample() const;

 private:
  void run();
  void tick(Playback& playback);
  void show();
  void show_if_free();

  const double rate_;
  const AxisRoles roles_;
  std::atomic<Playback*> playback_{nullptr};
  std::atomic<bool> stopped_{false}, ends_{false};
  std::mutex idle_lock_;
  std::condition_variable wakes_;  // something is to be played
  std::condition_variable idles_;  // the thread waits
  bool idle_ = false;
  ServoSample now_;  // of the clock's thread; of others while it waits

  mutable std::mutex shown_lock_;  // the clock never waits for it while it plays
  ServoSample shown_;
  Thread thread_;
};

}  // namespace kadr
