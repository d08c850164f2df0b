#pragma once
// Playback: the axes' positions at the servo rate, from cells as the planner hands them out, with feed hold, resume and override at
// any moment.
//
//   planner ─offer─▶ CellRing ─▶ cursor on the plan ─fill─▶ positions
//
// An override o lets time on the plan run at o times its rate: the path stays, speed falls with o, acceleration with o², jerk with o³.
// Between two overrides the rate follows an OverrideRamp. Before one is taken it is tried out in all instants of the servo clock that it
// will last, and at the ends of the cells between: where an axis would exceed its acceleration or jerk, a longer one is tried, or one to a
// share on the way, from which on more jerk is left for the change. A share of the trying is done at each instant, so that none takes long.
// A pause of the program is not lengthened by an override, but by a feed hold. Where the switches do not act (threads, G63:
// CellSource::switches) the share is 1 again as soon as a ramp allows; a thread, before which the axes stand, begins at 1. The spindle goes
// on turning by the clock whatever the axes do; before a thread they wait for its angle.
//
// If cells come too late it brakes by itself and goes on when there are enough.

#include <atomic>
#include <cstdint>
#include <optional>

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

  /// s on the plan, of all cells offered so far.
  double offered() const { return ring_.offered(); }

  // who operates: any thread

  /// 0 … 1 of the planned speed; 0 is feed hold. More than 1 is 1: the plan itself has to be faster then.
  void override_to(double share) { wanted_.store(share > 0 ? share < 1 ? share : 1 : 0, std::memory_order_relaxed); }

  // the servo clock: one thread

  /// Positions at the next instants, `count` rows of all axes; never allocates. Fewer when the motion is over: the last row is its end.
  std::size_t fill(double* positions, std::size_t count);
  /// The end was handed out.
  bool done() const { return now_.done; }
  /// The share that has been reached.
  double share() const { return now_.ramp.at(now_.on_ramp).share; }
  /// It stands by an override of 0.
  bool is_held() const {
    return now_.started && now_.ramp.at(now_.on_ramp).share <= 0 && now_.goal <= 0 && wanted_.load(std::memory_order_relaxed) <= 0;
  }
  /// The tag of the cell of the last instant.
  std::uint64_t tag() const { return now_.tag; }
  /// And its motion, counted by AxisMotion; 0: the axes stand.
  std::uint64_t motion() const { return now_.motion; }
  /// The spindle's angle at the last instant, degrees.
  double spindle() const { return now_.spindle; }
  /// s on the plan that are through.
  double played() const { return now_.played + now_.at.t; }
  /// … that can still be played without more cells.
  double ahead() const { return ring_.offered() - played(); }
  /// Less than this ahead, s on the plan, and it brakes.
  static constexpr double reserve = 1;
  /// Instants at which it had to stand at once for want of cells: none unless braking takes longer than the reserve.
  std::uint64_t starved() const { return now_.starved; }

 private:
  /// A place on the plan.
  struct Cursor {
    std::uint64_t cell = 0;
    double t = 0;  // s into it
  };
  struct Place {
    Cursor at;
    OverrideRamp ramp{1};  // the one in force
    double on_ramp = 0;    // s since it began
    double played = 0;     // s, of the cells that are through
    std::uint64_t instant = 0, tag = 0, motion = 0, starved = 0;
    double spindle = 0, slip = 0;  // degrees; slip: beyond the planned angle
    double last_override = 1;      // above 0
    bool started = false, done = false;

    // the next one
    bool trying = false, tried = false;  // tried: it may be taken
    double goal = 1;                     // the share it is all about, or that in force
    OverrideRamp next{1};
    std::uint64_t begins = 0;  // instant
    Cursor probe;
    double on_next = 0;  // s, of the probe on the next ramp
    double over = 0;     // share of the jerk limits that it may exceed them by: a feed hold must come to pass
  };

 public:
  /// Where it is, and the cells that are still to be played. While nobody else is at work.
  struct Memory {
    Place place;
    double wanted = 1;
    CellRing::Memory cells;
  };
  Memory memory() const { return {now_, wanted_.load(), ring_.memory()}; }
  void remember(const Memory& memory) {
    now_ = memory.place;
    wanted_ = memory.wanted;
    ring_.remember(memory.cells);
  }

 private:
  bool is_over(const Cursor& at) const { return at.cell >= ring_.end(); }
  template <class Crossed>
  bool advance(Cursor& at, const OverrideRamp& ramp, double on_ramp, double seconds, Crossed&& crossed) const;
  bool advance(Cursor& at, const OverrideRamp& ramp, double on_ramp) const;
  void show(const Cursor& at, double* x);
  bool is_allowed(const Cursor& at, const OverrideShare& pace) const;
  double asked();
  double wait_for_spindle(std::uint64_t cell);
  bool go_on();
  void step();
  void steer();
  void try_ramp(double target, double seconds);
  std::optional<double> share_on_the_way() const;
  void exceed_a_little();
  void go_on_trying();
  double shortest(double target) const;

  MotionLimits limits_;
  double period_;
  CellRing ring_;
  std::atomic<double> wanted_{1};

  Place now_;
};

}  // namespace kadr
