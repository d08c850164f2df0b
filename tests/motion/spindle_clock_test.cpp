// motion/time/spindle_clock: the spindle's angle over time. NCT 4.4, 18.1.9.

#include "motion/time/spindle_clock.h"

#include <gtest/gtest.h>

namespace kadr::spindle_clock_test {
namespace {

Action act(const Spindle& spindle) { return {{}, spindle}; }
Action act(const Speed& speed) { return {{}, speed}; }

/// Returns a time in which the axes do not move.
TimeLaw still(double seconds) { return {seconds, 0, true, 0, 0, 0}; }

TEST(spindle_clock, turns_by_its_commands) {
  SpindleClock clock;
  clock.take(act(Spindle{SpindleDir::cw, 60, 1, {}, {}}));
  EXPECT_EQ(clock.turn(clock.per_second(), still(0.5)).at(0.5, 0), 180);
  clock.take(act(Spindle{SpindleDir::ccw, 60, 1, {}, {}}));
  clock.take(act(Spindle{SpindleDir::cw, 999, 2, {}, {}}));  // a different spindle
  EXPECT_EQ(clock.turn(clock.per_second(), still(1)).at(1, 0), -180);
  clock.take(act(Spindle{SpindleDir::orient, 0, 1, {}, {}}));
  EXPECT_EQ(clock.turn(clock.per_second(), still(1)).at(1, 0), 0);
}

// 180 m/min at D 10 would be 5730 rev/min.
TEST(spindle_clock, the_highest_speed_of_the_machine_limits_constant_surface_speed) {
  SpindleClock clock;
  clock.limit(2500);
  clock.take(act(Spindle{SpindleDir::cw, 100, 1, {}, {}}));
  SurfaceSpeed law;
  law.on = true;
  law.metres = 180;
  clock.take(Action{{}, law});
  clock.arrive(Axes{5});
  EXPECT_DOUBLE_EQ(clock.per_second(), 2500 * 6);
  clock.arrive(Axes{50});
  EXPECT_NEAR(clock.per_second(), 6 * 1000 * 180 / (pi * 100), 1e-9);
}

// A new S while the axes move: motions that were planned before keep the old speed.
TEST(spindle_clock, a_new_speed_counts_from_what_is_planned_behind_it) {
  SpindleClock clock;
  clock.take(act(Spindle{SpindleDir::cw, 60, 1, {}, {}}));
  const double before = clock.per_second();
  clock.take(act(Speed{300, false}));
  clock.take(act(Speed{120, false}));
  EXPECT_EQ(clock.turn(before, still(1)).per_second, 360);
  const SpindleTurn after = clock.turn(clock.per_second(), still(1));
  EXPECT_EQ(after.per_second, 720);
  EXPECT_EQ(after.angle, 360);
}

// 4.4: waits for the zero pulse, then for the angle Q; the ramp begins after the pulse.
TEST(spindle_clock, waits_for_the_pulse_and_the_angle) {
  SpindleClock clock;
  clock.take(act(Spindle{SpindleDir::cw, 60, 1, {}, {}}));
  EXPECT_NEAR(clock.seconds_to(90, 0), 0.25, 1e-12);
  EXPECT_NEAR(clock.seconds_to(90, 0.1), 0.15, 1e-12);
  EXPECT_NEAR(clock.seconds_to(0, 0.1), 0.9, 1e-12);
  EXPECT_NEAR(clock.seconds_to(0, 1.1), 0.9, 1e-12);
  clock.turn(clock.per_second(), still(0.25));
  EXPECT_NEAR(clock.seconds_to(90, 0), 1, 1e-12);
}

// 11.5: at 200 m/min; at the centre the last speed remains; near it the speed is at most what a spindle can turn.
TEST(spindle_turning, by_the_speed_at_the_surface) {
  SpindleTurning turning;
  turning.rpm = 500;
  turning.surface = {true, 1, 0, 200};
  EXPECT_NEAR(turning.at({50}), 636.6198, 1e-4);
  EXPECT_EQ(turning.at({-1e-6}), 1e5);
  EXPECT_EQ(turning.at({0}), 500);
  turning.arrive({25});
  turning.surface.on = false;
  EXPECT_NEAR(turning.at({50}), 1273.2395, 1e-4);
  turning.on = false;
  EXPECT_EQ(turning.at({50}), 0);
}

// 11.4: the main spindle of a channel can change; each spindle continues to turn.
TEST(spindle_clock, another_one_leads) {
  SpindleClock clock;
  clock.take(act(Spindle{SpindleDir::cw, 60, 1, {}, {}}));
  clock.take(act(Spindle{SpindleDir::ccw, 120, 2, {}, {}}));
  EXPECT_EQ(clock.turn(clock.per_second(), still(1)).angle, 0);
  clock.select_leading(2);
  EXPECT_EQ(clock.per_second(), -720);
  EXPECT_EQ(clock.turn(clock.per_second(), still(1)).angle, -720);
  clock.select_leading(1);
  EXPECT_EQ(clock.turn(clock.per_second(), still(1)).angle, 720);
}

TEST(spindle_clock, coupled_it_goes_with_the_axis) {
  SpindleClock clock;
  clock.take(act(Spindle{SpindleDir::cw, 60, 1, {}, {}}));
  clock.couple(-36);
  EXPECT_EQ(clock.turn(clock.per_second(), {1, 10, true, 10, 0, 0}).at(0.5, 5), -180);
  clock.release();
  EXPECT_EQ(clock.turn(clock.per_second(), still(1)).at(1, 0), -360);
}

}  // namespace
}  // namespace kadr::spindle_clock_test
