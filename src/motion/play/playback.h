#pragma once
// Playback: the axes' positions at the servo rate, from the cells that the planner emits, with feed hold, resume and override at any
// time.
//
//   planner ─offer─▶ CellRing ─▶ cursor on the plan ─fill─▶ positions
//
// An override o runs plan time at o times its rate: the path stays the same, speed scales with o, acceleration with o², jerk with o³.
// Between two overrides the rate follows an OverrideRamp. Before a ramp is accepted it is checked at all instants of the servo clock that
// it will last, and at the ends of the cells between: where an axis would exceed its acceleration or jerk, a longer ramp is tried, or one
// to an intermediate share, from which more jerk is left for the change. The check is spread over several instants, so that none takes
// long. A pause of the program is not lengthened by an override, only by a feed hold. Where the switches do not act (threads, G63:
// CellSource::switches) the share returns to 1 as soon as a ramp allows; a thread, before which the axes are at rest, starts at 1. The
// spindle keeps rotating by the clock whatever the axes do; before a thread they wait for its angle.
//
// If cells arrive too late it brakes by itself, and continues when there are enough.

#include <atomic>
#include <cstdint>
#include <optional>

#include "motion/least_time/cell_ring.h"
#include "motion/least_time/planner.h"
#include "motion/play/override_ramp.h"

namespace kadr {

class Playback {
 public:
  /// `rate`: of the servo clock, Hz. `cells`: capacity of the cell ring.
  Playback(MotionLimits limits, double rate, std::size_t cells = 8192);

  // called by the planning thread

  /// Appends cells from the `first` on, as many as fit. Returns their number.
  std::size_t offer(const TimedCells& cells, std::size_t first) { return ring_.offer(cells, first); }
  /// Marks that no more cells follow.
  void finish() { ring_.finish(); }

  /// Plan time of all cells offered so far, s.
  double offered() const { return ring_.offered(); }

  // called by the operator, from any thread

  /// Requests a share, 0 … 1, of the planned speed; 0 is feed hold. More than 1 counts as 1: that would need a faster plan.
  void override_to(double share) { wanted_.store(share > 0 ? share < 1 ? share : 1 : 0, std::memory_order_relaxed); }

  // called by the servo clock, in one thread

  /// Writes the positions at the next instants, `count` rows of all axes; never allocates. Returns the number of rows: 0 before the first
  /// cell arrives, fewer than `count` when the motion is over (the last row is then its end).
  std::size_t fill(double* positions, std::size_t count);
  /// True if the end of the motion was written.
  bool done() const { return now_.done; }
  /// The share that is currently reached.
  double share() const { return now_.ramp.at(now_.on_ramp).share; }
  /// True if the axes are held by an override of 0.
  bool is_held() const {
    return now_.started && now_.ramp.at(now_.on_ramp).share <= 0 && now_.goal <= 0 && wanted_.load(std::memory_order_relaxed) <= 0;
  }
  /// The tag of the cell at the last instant.
  std::uint64_t tag() const { return now_.tag; }
  /// The motion of that cell, as AxisMotion counts them; 0: the axes are at rest.
  std::uint64_t motion() const { return now_.motion; }
  /// The spindle's angle at the last instant, degrees.
  double spindle() const { return now_.spindle; }
  /// Plan time already played, s.
  double played() const { return now_.played + now_.at.t; }
  /// Plan time that can still be played without further cells, s.
  double ahead() const { return ring_.offered() - played(); }
  /// It brakes if less plan time than this is ahead, s.
  static constexpr double reserve = 1;
  /// Number of instants at which it had to stop abruptly because cells were missing: 0 unless braking takes longer than the reserve.
  std::uint64_t starved() const { return now_.starved; }

 private:
  /// A position in the plan.
  struct Cursor {
    std::uint64_t cell = 0;
    double t = 0;  // s since the start of the cell
  };
  struct Place {
    Cursor at;
    OverrideRamp ramp{1};  // the current ramp
    double on_ramp = 0;    // s since its start
    double played = 0;     // s, of the completed cells
    std::uint64_t instant = 0, tag = 0, motion = 0, starved = 0;
    double spindle = 0, slip = 0;  // degrees; slip: excess over the planned angle
    double last_override = 1;      // the last override above 0
    bool started = false, done = false;

    // the next ramp
    bool trying = false, tried = false;  // tried: it may be used
    double goal = 1;                     // the share finally wanted, or the current one
    OverrideRamp next{1};
    std::uint64_t begins = 0;  // instant at which it starts
    Cursor probe;
    double on_next = 0;  // s, position of the probe on the next ramp
    double over = 0;     // allowed excess over the jerk limits, as a share: a feed hold must not fail
  };

 public:
  /// The position and the cells still to be played. To be copied or restored only while no other thread is active.
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
