// motion/time/estimate: estimates the seconds of a program from its programmed feeds.

#include "motion/time/estimate.h"

#include <gtest/gtest.h>

#include "actions.h"

namespace kadr::estimate_test {
namespace {

using test::arc;
using test::straight;
using enum MotionKind;

const std::vector<std::string> names = {"X", "Y", "Z", "A"};
const AxisRoles roles = AxisRoles::of(names, 8);

MotionTime time_of(const Motion& m, double rpm = 0, const Setup& setup = {}, const Axes& from = {}) {
  TimeEstimate estimate(roles, rates_of(MachineProfile{}, setup, names));
  estimate.spindle(rpm);
  return estimate.motion(m, Curve(roles, from, m));
}

double seconds(const Motion& m, double rpm = 0, const Setup& setup = {}) { return time_of(m, rpm, setup).seconds; }

kadr::Setup without_acceleration() {
  kadr::Setup setup;
  setup.machine["*"].no_acceleration = true;
  return setup;
}

TEST(estimate, feed_in_each_unit) {
  Motion m = straight(feed, {30, 40, 0}, 100);
  EXPECT_DOUBLE_EQ(seconds(m), 30);
  m.feed = 0.1;
  m.unit = FeedUnit::mm_per_rev;
  EXPECT_DOUBLE_EQ(seconds(m, 1000), 30);
  m.unit = FeedUnit::per_min;
  m.feed = 4;
  EXPECT_DOUBLE_EQ(seconds(m), 15);
}

TEST(estimate, rotary_axis_alone_takes_degrees_for_mm) {
  Motion m = straight(feed, {0, 0, 0}, 90);
  m.to[3] = 180;
  EXPECT_DOUBLE_EQ(seconds(m), 120);
}

TEST(estimate, rapid_waits_for_the_slowest_axis) {
  kadr::Setup setup;
  setup.machine["*"].rapid = 6000;
  setup.machine["Z"].rapid = 1000;
  EXPECT_DOUBLE_EQ(seconds(straight(rapid, {100, 50, 0}), 0, setup), 1);
  EXPECT_DOUBLE_EQ(seconds(straight(rapid, {100, 50, 50}), 0, setup), 3);
  setup.rapid_override = 50;
  EXPECT_DOUBLE_EQ(seconds(straight(rapid, {100, 50, 50}), 0, setup), 6);
}

TEST(estimate, motions_that_never_end_are_counted_apart) {
  TimeEstimate estimate(roles, rates_of(MachineProfile{}, kadr::Setup{}, names));
  const Motion m = straight(feed, {1, 0, 0}, 0);
  const Axes from{};
  EXPECT_EQ(estimate.motion(m, Curve(roles, from, m)).seconds, 0);
  EXPECT_EQ(estimate.split().unknown, 1U);
  EXPECT_EQ(estimate.split().total(), 0);
}

TEST(estimate, split) {
  MachineProfile profile;
  profile.tool_change_s = 10;
  profile.spindle_start_s = 2;
  TimeEstimate estimate(roles, rates_of(profile, kadr::Setup{}, names));
  estimate.other({{}, Dwell{2.5}});
  estimate.other({{}, ToolChange{3}});
  estimate.other({{}, Spindle{SpindleDir::cw, 500}});
  estimate.other({{}, Spindle{SpindleDir::cw, 600}});  // it turns already
  EXPECT_DOUBLE_EQ(estimate.split().dwell, 2.5);
  EXPECT_DOUBLE_EQ(estimate.split().tool_change, 12);
}

// 04-27, 04-28: a quarter helix; the feed is along its arc or along the helix.
TEST(estimate, feed_of_a_helix) {
  Motion m = arc(arc_ccw, {0, 100, 20}, {}, 0.25);
  m.feed = 150;
  const Axes from{100, 0, 0};
  m.along = FeedAlong::arc;
  EXPECT_NEAR(time_of(m, 0, {}, from).seconds, 62.831853, 1e-6);
  m.along = FeedAlong::all_axes;
  EXPECT_NEAR(time_of(m, 0, {}, from).seconds, 63.339101, 1e-6);
  EXPECT_NEAR(time_of(m, 0, {}, from).length, 158.347754, 1e-6);
}

TEST(estimate, feed_of_a_spiral_is_along_its_path) {  // 04-25
  Motion m = arc(arc_ccw, {-30, 0, 0}, {}, 2.5);
  m.feed = 1000;
  EXPECT_NEAR(time_of(m, 0, {}, {90, 0, 0}).seconds, 56.6744, 1e-4);
}

TEST(estimate, feed_of_all_axes_alike) {  // 04-8: Z100 C45 F120
  Motion m = straight(feed, {0, 0, 100}, 120);
  m.to[3] = 45;
  m.along = FeedAlong::all_axes;
  EXPECT_NEAR(seconds(m), 54.82928, 1e-5);
}

// nct 4.4: the lead is along the axis with the longer travel; overrides have no effect.
TEST(estimate, threads) {
  MotionDetail detail;
  detail.lead = 2;
  Motion m = straight(thread, {0, 0, -20}, 0);
  m.detail = std::make_shared<MotionDetail>(detail);
  EXPECT_DOUBLE_EQ(seconds(m, 100), 6);
  kadr::Setup setup = without_acceleration();
  setup.feed_override = 50;
  m.to[0] = -10;
  const MotionTime cone = time_of(m, 100, setup);
  EXPECT_DOUBLE_EQ(cone.seconds, 6);
  EXPECT_DOUBLE_EQ(cone.feed_most, 2 * 100 * std::hypot(20, 10) / 20);
  EXPECT_EQ(time_of(m, 0, setup).seconds, 0);  // the spindle is stopped: counted separately
}

TEST(estimate, tapping_has_its_own_override) {
  kadr::Setup setup = without_acceleration();
  setup.feed_override = 50;
  Motion m = straight(feed, {0, 0, -10}, 625);
  EXPECT_DOUBLE_EQ(time_of(m, 0, setup).feed_most, 312.5);
  m.own_override = true;
  EXPECT_DOUBLE_EQ(time_of(m, 0, setup).feed_most, 625);
  EXPECT_DOUBLE_EQ(time_of(m, 0, setup).seconds, 0.96);
}

TEST(estimate, times_are_exact_only_without_acceleration) {
  const auto exact = [](const kadr::Setup& setup) { return rates_of(MachineProfile{}, setup, names).exact_times; };
  kadr::Setup setup;
  EXPECT_FALSE(exact(setup));
  for (const std::string& name : names) {
    EXPECT_FALSE(exact(setup));
    setup.machine[name].no_acceleration = true;
  }
  EXPECT_TRUE(exact(setup));
  EXPECT_TRUE(exact(without_acceleration()));
  EXPECT_FALSE(time_of(straight(feed, {1, 0, 0}, 100)).exact);
}

TEST(estimate, rapid_speed_along_the_path) {  // 04-3
  kadr::Setup setup = without_acceleration();
  setup.machine["X"].rapid = 30000;
  setup.machine["Y"].rapid = 15000;
  const MotionTime time = time_of(straight(rapid, {60, 40, 0}), 0, setup);
  EXPECT_NEAR(time.seconds, 0.16, 1e-9);
  EXPECT_NEAR(time.feed_most, 27041.6346, 1e-4);
}

TEST(estimate, each_spindle_for_itself) {
  MachineProfile profile;
  profile.spindle_start_s = 2;
  TimeEstimate estimate(roles, rates_of(profile, kadr::Setup{}, names));
  estimate.spindle(1000);
  estimate.other({{}, Spindle{SpindleDir::cw, 300, 2}});
  estimate.other({{}, Speed{50, false, 2}});
  estimate.other({{}, Sync{501, {1, 2}, 3}});
  EXPECT_DOUBLE_EQ(estimate.split().total(), 2);
  Motion m = straight(feed, {100, 0, 0}, 0.1);
  m.unit = FeedUnit::mm_per_rev;
  const Axes from{};
  EXPECT_DOUBLE_EQ(estimate.motion(m, Curve(roles, from, m)).seconds, 60);  // per revolution of spindle 1
}

// nct 11.5: a feed per revolution under G96 uses the spindle speed that the control computed for the commanded position.
TEST(estimate, surface_speed) {
  TimeEstimate estimate(roles, rates_of(MachineProfile{}, kadr::Setup{}, names));
  estimate.other({{}, Speed{120, true, 1, 0, 500}});
  Motion m = straight(feed, {100, 0, 0}, 0.1);
  m.unit = FeedUnit::mm_per_rev;
  const Axes from{};
  EXPECT_DOUBLE_EQ(estimate.motion(m, Curve(roles, from, m)).seconds, 120);
}

/// Facing at a constant surface speed of v m/min and a feed of f mm/rev: n = 1000 v / (π D), so the tool moves at f n along the radius, and
/// from D1 to D2 it needs ∫ dr / (f n) = π (D1² − D2²) / (4000 v f) min.
double facing_minutes(double d1, double d2, double v, double f) { return pi * (d1 - d2) * (d1 + d2) / (4000 * v * f); }

struct Facing {
  Facing(double v, double most_rpm, const MachineProfile& machine = {}) : estimate(roles, rates_of(machine, kadr::Setup{}, names)) {
    SurfaceSpeed law;
    law.on = true;
    law.metres = v;
    law.most = most_rpm;
    estimate.other({{}, Spindle{SpindleDir::cw, 100, 1, {}, {}}});
    estimate.other({{}, law});
  }
  double seconds(double d1, double d2, double f) {
    Motion m = straight(feed, {d2 / 2, 0, 0}, f);
    m.unit = FeedUnit::mm_per_rev;
    const Axes from{d1 / 2};
    return estimate.motion(m, Curve(roles, from, m)).seconds;
  }
  TimeEstimate estimate;
};

TEST(estimate, facing_at_constant_surface_speed) {
  EXPECT_NEAR(Facing(180, 5000).seconds(64, 20, 0.2), 60 * facing_minutes(64, 20, 180, 0.2), 1e-6);
  EXPECT_NEAR(Facing(180, 5000).seconds(20, 64, 0.2), 60 * facing_minutes(64, 20, 180, 0.2), 1e-6) << "outwards";
}

// G50 S2500: below D = 1000 v / (π 2500) the speed is constant.
TEST(estimate, facing_to_the_centre_is_limited_by_the_highest_spindle_speed) {
  const double v = 180, rpm = 2500, f = 0.2, d = 1000 * v / (pi * rpm);
  EXPECT_NEAR(Facing(v, rpm).seconds(64, 0, f), 60 * (facing_minutes(64, d, v, f) + d / 2 / (f * rpm)), 1e-6);
  MachineProfile machine;  // without G50 the spindle of the machine is the limit
  machine.most_rpm = rpm;
  EXPECT_NEAR(Facing(v, SurfaceSpeed::no_limit, machine).seconds(64, 0, f), 60 * (facing_minutes(64, d, v, f) + d / 2 / (f * rpm)), 1e-6);
}

}  // namespace
}  // namespace kadr::estimate_test
