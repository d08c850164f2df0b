#pragma once
// ServoClock: the machine's clock. Its thread takes the next positions of the axes from a Playback at each instant, and publishes where
// the axes are. Planning, serving and drawing cannot delay it.
//
//   planner ──offer──▶ Playback ──▶ one position per instant ──▶ sample(), from any thread

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
  std::uint64_t instant = 0;  // number of instants, counted while it plays
  Axes machine{};             // mm, degrees
  std::uint64_t tag = 0;      // Spent::of(): the line it belongs to
  std::uint64_t motion = 0;   // Playback::motion()
  double share = 1;           // reached share of the planned speed
  double played = 0;          // s of the plan that have been played
  double speed = 0;           // of X, Y, Z combined, mm/min
  bool plays = false;         // motion is still to come
  bool held = false;          // by an override of 0
  double late = 0;            // s by which an instant was late, the maximum so far
};

class ServoClock {
 public:
  /// `rate`: Hz. `stand`: machine coordinates at the start. `roles`: of the axes.
  ServoClock(double rate, const Axes& stand, const AxisRoles& roles);
  ~ServoClock();
  ServoClock(const ServoClock&) = delete;  // its thread uses this object
  ServoClock& operator=(const ServoClock&) = delete;

  /// Plays from the next instant on. nullptr: the axes stay where they are. On return the previous playback is no longer used.
  void play(Playback* playback);
  /// Sets the position of the axes; nothing is played.
  void stand_at(const Axes& machine);
  /// Emergency stop: from the next instant on no position is output until release(). May be called from any thread.
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
  std::condition_variable wakes_;  // there is something to play
  std::condition_variable idles_;  // the thread is waiting
  bool idle_ = false;
  ServoSample now_;  // written by the clock's thread; by others only while it waits

  mutable std::mutex shown_lock_;  // while it plays, the clock never waits for this lock
  ServoSample shown_;
  Thread thread_;
};

}  // namespace kadr
