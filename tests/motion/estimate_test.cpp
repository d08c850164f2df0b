// motion/estimate: seconds from programmed feeds.

#include "motion/estimate.h"

#include <gtest/gtest.h>

#include "actions.h"

namespace kadr {
namespace {

using test::straight;
using enum MotionKind;

const std::vector<std::string> names = {"X", "Y", "Z", "A"};
const AxisRoles roles = AxisRoles::of(names, 8);

double seconds(const Motion& m, double rpm = 0, const Setup& setup = {}) {
  TimeEstimate estimate(roles, rates_of(MachineProfile{}, setup, names));
  estimate.spindle(rpm);
  return estimate.motion(m, Axes{}, Curve(roles, Axes{}, m).length());
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
  EXPECT_EQ(estimate.motion(straight(feed, {1, 0, 0}, 0), Axes{}, 1), 0);
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
  estimate.other({{}, Spindle{SpindleDir::cw, 600}});  // turns already
  EXPECT_DOUBLE_EQ(estimate.split().dwell, 2.5);
  EXPECT_DOUBLE_EQ(estimate.split().tool_change, 12);
}

}  // namespace
}  // namespace kadr
