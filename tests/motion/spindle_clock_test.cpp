// motion/spindle_clock: the spindle's angle over time. NCT 4.4, 18.1.9.

#include "motion/spindle_clock.h"

#include <gtest/gtest.h>

namespace kadr {
namespace {

Action act(const Spindle& spindle) { return {{}, spindle}; }
Action act(const Speed& speed) { return {{}, speed}; }

/// Cells that stand, one for each duration.
TimedCells still(const std::vector<std::pair<double, std::uint64_t>>& durations) {
  TimedCells cells;
  for (const auto& [seconds, mark] : durations) {
    cells.laws.push_back({seconds, 0, true, 0, 0, 0});
    cells.tags.push_back(mark);
  }
  return cells;
}

TEST(spindle_clock, turns_by_its_commands) {
  SpindleClock clock;
  clock.take(act(Spindle{SpindleDir::cw, 60, 1, {}, {}}));
  TimedCells cells = still({{0.5, clock.mark()}});
  clock.tell(cells);
  EXPECT_EQ(cells.spindle[0].at(0.5, 0), 180);
  clock.take(act(Spindle{SpindleDir::ccw, 60, 1, {}, {}}));
  clock.take(act(Spindle{SpindleDir::cw, 999, 2, {}, {}}));  // another one
  cells = still({{1, clock.mark()}});
  clock.tell(cells);
  EXPECT_EQ(cells.spindle[0].at(1, 0), -180);
  clock.take(act(Spindle{SpindleDir::orient, 0, 1, {}, {}}));
  cells = still({{1, clock.mark()}});
  clock.tell(cells);
  EXPECT_EQ(cells.spindle[0].at(1, 0), 0);
}

// S while the axes move: what was planned before goes at the old speed.
TEST(spindle_clock, a_new_speed_counts_from_what_is_planned_behind_it) {
  SpindleClock clock;
  clock.take(act(Spindle{SpindleDir::cw, 60, 1, {}, {}}));
  const std::uint64_t before = clock.mark();
  clock.take(act(Speed{300, false}));
  clock.take(act(Speed{120, false}));
  const std::uint64_t behind = clock.mark();
  TimedCells cells = still({{1, before}, {1, behind}});
  clock.tell(cells);
  EXPECT_EQ(cells.spindle[0].per_second, 360);
  EXPECT_EQ(cells.spindle[1].per_second, 720);
  EXPECT_EQ(cells.spindle[1].angle, 360);
}

// 4.4: the zero pulse, then Q; the ramp begins behind the pulse.
TEST(spindle_clock, waits_for_the_pulse_and_the_angle) {
  SpindleClock clock;
  clock.take(act(Spindle{SpindleDir::cw, 60, 1, {}, {}}));
  EXPECT_NEAR(clock.seconds_to(90, 0), 0.25, 1e-12);
  EXPECT_NEAR(clock.seconds_to(90, 0.1), 0.15, 1e-12);
  EXPECT_NEAR(clock.seconds_to(0, 0.1), 0.9, 1e-12);
  EXPECT_NEAR(clock.seconds_to(0, 1.1), 0.9, 1e-12);
  TimedCells cells = still({{0.25, clock.mark()}});
  clock.tell(cells);
  EXPECT_NEAR(clock.seconds_to(90, 0), 1, 1e-12);
}

TEST(spindle_clock, coupled_it_goes_with_the_axis) {
  SpindleClock clock;
  clock.take(act(Spindle{SpindleDir::cw, 60, 1, {}, {}}));
  clock.mark();
  clock.couple(-36);
  TimedCells cells = still({{1, clock.mark()}});
  cells.laws[0] = {1, 10, true, 10, 0, 0};
  clock.tell(cells);
  EXPECT_EQ(cells.spindle[0].at(0.5, 5), -180);
  clock.release();
  cells = still({{1, clock.mark()}});
  clock.tell(cells);
  EXPECT_EQ(cells.spindle[0].at(1, 0), -360);
}

}  // namespace
}  // namespace kadr
