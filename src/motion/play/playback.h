#pragma once
// Playback: the axes' positions at the servo rate, from cells as the planner hands them out, with feed hold, resume and override at
// any moment.
//
//   planner ─offer─▶ CellRing ─▶ cursor on the plan ─fill─▶ positions
//
// An override o lets time on the plan run at o times its rate: the path stays, speed falls with o, acceleration with o², jerk with o³.
// Between two overrides the rate follows an OverrideRamp. Before one is taken it is tried out in all instants of the servo clock that it
// will last, and at the ends of the cells between: where an axis would exceed its acceleration or jerk, a longer one is tried. A share of
// the trying is done at each instant, so that none takes long. A pause of the program is not lengthened by an override, but by a feed hold.
// Where the switches do not act (threads, G63: CellSource::switches) the share is 1 again as soon as a ramp allows; a thread, before which
// the axes stand, begins at 1. The spindle goes on turning by the clock whatever the axes do; before a thread they wait for its angle.
//
// If cells come too late it brakes by itself and goes on when there are enough.

#include <atomic>
#include <cstdint>

#include "motion/least_time/cell_ring.h"
#include "motion/least_time/planner.h"
#include "motion/play/override_ramp.h"

namespace kadr {

class Playback {
 public:
  /// `rate`: of the servo clock, Hz. `cells`: as many are kept at most.
  Playback(MotionLimits limits, double rate, std::size_t cells = 8192);

  // who plans: one thread

  /// Takes cells from the `first` on, as many as there is room for: how many.
  std::size_t offer(const TimedCells& cells, std::size_t first) { return ring_.offer(cells, first); }
  /// No more cells come.
  void finish() { ring_.finish(); }

  // who operates: any thread

  /// 0 … 1 of the planned speed; 0 is feed hold. More than 1 is 1: the plan itself has to be faster then.
  void override_to(double share) { wanted_.store(share > 0 ? share < 1 ? share : 1 : 0, std::memory_order_relaxed); }

  // the servo clock: one thread

  /// Positions at the next instants, `count` rows of all axes; never allocates. Fewer when the motion is over: the last row is its end.
  std::size_t fill(double* positions, std::size_t count);
  /// The end was handed out.
  bool done() const { return done_; }
  /// The share that has been reached.
  double share() const { return ramp_.at(on_ramp_).share; }
  /// It stands by an override of 0.
  bool is_held() const { return started_ && ramp_.at(on_ramp_).share <= 0 && goal_ <= 0 && wanted_.load(std::memory_order_relaxed) <= 0; }
  /// The tag of the cell of the last instant.
  std::uint64_t tag() const { return tag_; }
  /// The spindle's angle at the last instant, degrees.
  double spindle() const { return spindle_; }
  /// s on the plan that can still be played without more cells.
  double ahead() const { return ring_.offered() - played_ - at_.t; }
  /// Less than this ahead, s on the plan, and it brakes.
  static constexpr double reserve = 1;
  /// Instants at which it had to stand at once for want of cells: none unless braking takes longer than the reserve.
  std::uint64_t starved() const { return starved_; }

 private:
  /// A place on the plan.
  struct Cursor {
    std::uint64_t cell = 0;
    double t = 0;  // s into it
  };
  bool is_over(const Cursor& at) const { return at.cell >= ring_.end(); }
  template <class Crossed>
  bool advance(Cursor& at, const OverrideRamp& ramp, double on_ramp, Crossed&& crossed) const;
  bool advance(Cursor& at, const OverrideRamp& ramp, double on_ramp) const;
  void show(const Cursor& at, double* x);
  bool is_allowed(const Cursor& at, const OverrideShare& pace) const;
  double asked();
  double wait_for_spindle(std::uint64_t cell);
  bool go_on();
  void step();
  void steer();
  void try_ramp(double target, double seconds);
  void exceed_a_little();
  void go_on_trying();
  double shortest(double target) const;

  MotionLimits limits_;
  double period_;
  CellRing ring_;
  std::atomic<double> wanted_{1};

  Cursor at_;
  OverrideRamp ramp_{1};  // the one in force
  double on_ramp_ = 0;    // s since it began
  double played_ = 0;     // s, of the cells that are through
  std::uint64_t instant_ = 0, tag_ = 0, starved_ = 0;
  double spindle_ = 0, slip_ = 0;  // degrees; slip: beyond the planned angle
  double last_override_ = 1;       // above 0
  bool started_ = false, done_ = false;

  // the next one
  bool trying_ = false, tried_ = false;  // tried_: it may be taken
  double goal_ = 1;                      // the share it is all about, or that in force
  OverrideRamp next_{1};
  std::uint64_t begins_ = 0;  // instant
  Cursor probe_;
  double on_next_ = 0;  // s, of the probe on the next ramp
  double over_ = 0;     // share of the jerk limits that it may exceed them by: a feed hold must come to pass
};

}  // namespace kadr
