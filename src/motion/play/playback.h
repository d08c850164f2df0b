#pragma once
// Playback computes the axes' positions at the servo rate from the cells that the planner emits. Feed hold, resume and override are
// possible at any time.
//
//   planner ─offer─▶ CellRing ─▶ cursor on the plan ─fill─▶ positions
//
// An override o advances plan time at the rate o. The path stays the same; speed scales with o, acceleration with o², jerk with o³. Between
// two overrides the rate follows an OverrideRamp. Before a ramp is accepted, it is checked at all instants of the servo clock during the
// ramp and at all cell boundaries between these instants. If an axis would exceed its acceleration or jerk limit, a longer ramp is tried,
// or a ramp to an intermediate override, at which the plan itself uses less jerk. The check is spread over several servo instants, so that
// no single instant takes long. An override does not lengthen a dwell; a feed hold does. Where the operator's switches have no effect
// (thread cutting, G63: CellSource::switches), the override returns to 1 as soon as a ramp allows. Thread cutting starts at the override 1,
// because the axes are at rest before it. The spindle rotates in real time at any override. Before thread cutting the axes wait for the
// spindle angle.
//
// If cells arrive too late, Playback brakes the axes, and continues when enough cells are available.

#include <atomic>
#include <cstdint>
#include <optional>

#include "motion/least_time/cell_ring.h"
#include "motion/least_time/planner.h"
#include "motion/play/override_ramp.h"

namespace kadr {

class Playback {
 public:
  /// `rate` is the frequency of the servo clock in Hz. `cells` is the capacity of the cell ring in cells.
  Playback(MotionLimits limits, double rate, std::size_t cells = 8192);

  // The thread that plans the motion calls the functions below, which pass planned cells to Playback.

  /// Appends the cells with the index `first` and above to the ring, as many as fit. Returns the number of appended cells.
  std::size_t offer(const TimedCells& cells, std::size_t first) { return ring_.offer(cells, first); }
  /// Marks the end of the cells. After this call the planner must not offer further cells.
  void finish() { ring_.finish(); }

  /// The plan time of all cells offered so far, s.
  double offered() const { return ring_.offered(); }

  // The operator's request of an override below may come from any thread.

  /// Requests an override, 0 to 1, as a factor of the planned speed; 0 is a feed hold. A value above 1 counts as 1, because it would need a
  /// faster plan.
  void override_to(double share) { requested_.store(share > 0 ? share < 1 ? share : 1 : 0, std::memory_order_relaxed); }

  // The thread of the servo clock calls the functions below, which read positions.

  /// Writes the positions at the next instants of the servo clock: `count` rows with the positions of all axes. The function never
  /// allocates memory. It returns the number of rows: 0 before the first cell arrives, and fewer than `count` when the motion is over. The
  /// last row is then the end position.
  std::size_t fill(double* positions, std::size_t count);
  /// True if the end of the motion was written.
  bool done() const { return now_.done; }
  /// The current override, 0 to 1.
  double share() const { return now_.ramp.at(now_.on_ramp).share; }
  /// True if an override of 0 (feed hold) keeps the axes at rest.
  bool is_held() const {
    return now_.started && now_.ramp.at(now_.on_ramp).share <= 0 && now_.goal <= 0 && requested_.load(std::memory_order_relaxed) <= 0;
  }
  /// The tag of the cell at the last instant of the servo clock.
  std::uint64_t tag() const { return now_.tag; }
  /// The number of the motion at the last instant of the servo clock, as AxisMotion counts motions; 0: the axes are at rest.
  std::uint64_t motion() const { return now_.motion; }
  /// The spindle angle at the last instant of the servo clock, degrees.
  double spindle() const { return now_.spindle; }
  /// The plan time that is already played, s.
  double played() const { return now_.played + now_.at.t; }
  /// The plan time that can still be played without further cells, s.
  double ahead() const { return ring_.offered() - played(); }
  /// Playback brakes the axes if the planned motion that is left to play takes less than this time, s.
  static constexpr double reserve = 1;
  /// The number of servo instants at which the axes had to stop abruptly because no cells were available. It is 0 unless braking takes
  /// longer than the reserve.
  std::uint64_t starved() const { return now_.starved; }

 private:
  /// A position in the plan: a cell and a time in this cell.
  struct Cursor {
    std::uint64_t cell = 0;
    double t = 0;  // time of the plan since the start of the cell, s; at an override below 1 it passes more slowly than the clock's time
  };
  struct Place {
    Cursor at;
    OverrideRamp ramp{1};  // the ramp that is being played
    double on_ramp = 0;    // time since the start of the ramp that is being played, s
    double played = 0;     // time of the plan, s, at the end of the completed cells
    std::uint64_t instant = 0, tag = 0, motion = 0, starved = 0;
    // `spindle` is the spindle angle, and `slip` is the actual spindle angle minus the planned angle, both in degrees.
    double spindle = 0, slip = 0;
    double last_override = 1;  // the last requested override above 0, as a factor of the planned speed
    bool started = false, done = false;

    // The fields below belong to the next override ramp, which is checked against the axis limits before Playback uses it.
    bool trying = false, tried = false;
    double goal = 1;  // override to which the ramp under check leads; without such a ramp the current override
    OverrideRamp next{1};
    std::uint64_t begins = 0;  // number of the servo instant at which the ramp `next` starts
    Cursor probe;              // position in the plan up to which the ramp `next` is checked
    double on_next = 0;        // time of the last checked position since the start of the ramp `next`, s
    // Allowed excess of the ramp `next` over the jerk limits, as a fraction of these limits. It is above 0 so that a feed hold cannot fail.
    double over = 0;
  };

 public:
  /// The state of Playback: the position in the plan, and the cells that are not yet played. Copy or restore it only while no other thread
  /// uses this Playback.
  struct Memory {
    Place place;
    double requested = 1;
    CellRing::Memory cells;
  };
  Memory memory() const { return {now_, requested_.load(), ring_.memory()}; }
  void resume_from(const Memory& memory) {
    now_ = memory.place;
    requested_ = memory.requested;
    ring_.resume_from(memory.cells);
  }

 private:
  bool is_over(const Cursor& at) const { return at.cell >= ring_.end(); }
  template <class Crossed>
  bool advance(Cursor& at, const OverrideRamp& ramp, double on_ramp, double seconds, Crossed&& crossed) const;
  bool advance(Cursor& at, const OverrideRamp& ramp, double on_ramp) const;
  void show(const Cursor& at, double* x);
  bool is_allowed(const Cursor& at, const OverrideFactor& pace) const;
  double requested_share();
  double wait_for_spindle(std::uint64_t cell);
  bool go_on();
  void step();
  void steer();
  void try_ramp(double target, double seconds);
  std::optional<double> split_share() const;
  void exceed_a_little();
  void keep_trying();
  double shortest(double target) const;

  MotionLimits limits_;
  double period_;
  CellRing ring_;
  std::atomic<double> requested_{1};

  Place now_;
};

}  // namespace kadr
