#pragma once
// ServoClock is the clock that outputs positions at a fixed rate. At each instant its thread reads the next positions of the axes from a
// Playback and publishes them. Planning, serving and drawing cannot delay this thread.
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

/// The state of the axes at one instant of the servo clock.
struct ServoSample {
  std::uint64_t instant = 0;  // number of instants so far at which the clock played a motion
  Axes machine{};             // position of the axes in machine coordinates, mm or degrees
  std::uint64_t tag = 0;      // tag of the plan at this position; Spent::of() returns the program line of a tag
  std::uint64_t motion = 0;   // Playback::motion()
  double share = 1;           // the override that is reached, as a factor of the planned speed
  double played = 0;   // time of the plan that has been played, s; at an override below 1 it passes more slowly than the clock's time
  double speed = 0;    // path speed of the axes X, Y and Z together, mm/min
  bool plays = false;  // true if the playback has more motion to play
  bool held = false;   // true if an override of 0 (feed hold) has stopped the axes
  double late = 0;     // the greatest delay of an instant of the servo clock so far, s
  double age = 0;      // how old the position is, s; 0 on a virtual machine
};

class ServoClock {
 public:
  /// `rate` is the number of instants per second. `stand` is the position of the axes at the start, in machine coordinates.
  ServoClock(double rate, const Axes& stand, const AxisRoles& roles);
  ~ServoClock();
  ServoClock(const ServoClock&) = delete;  // Copying is disabled because the clock's thread refers to this object.
  ServoClock& operator=(const ServoClock&) = delete;

  /// Plays the motion of `playback` from the next instant on. With nullptr the axes stay at their position. When the function returns, the
  /// clock no longer uses the previous playback.
  void play(Playback* playback);
  /// Sets the position of the axes while no motion is played.
  void stand_at(const Axes& machine);
  /// Emergency stop: from the next instant on, no position changes until release(). Any thread may call it.
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
  std::condition_variable wakes_;  // condition that wakes the clock's thread when there is motion to play
  std::condition_variable idles_;  // condition that is notified when the clock's thread begins to wait
  bool idle_ = false;
  ServoSample now_;  // The present sample. Other threads may write it only while the clock's thread waits.

  // Protects the published sample. The clock's thread never waits for this lock while a motion is played.
  mutable std::mutex shown_lock_;
  ServoSample shown_;
  Thread thread_;
};

}  // namespace kadr
