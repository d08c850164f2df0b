// motion/time/polar_feed: limits the feed near the rotation centre. NCT 4.5; golden case 04-50.

#include "motion/time/polar_feed.h"

#include <gtest/gtest.h>

#include "actions.h"
#include "choices.h"

namespace kadr::polar_feed_test {
namespace {

using test::straight;
using enum MotionKind;

const AxisRoles roles = AxisRoles::of({"X", "C"}, 2);

/// A motion on the polar surface; the start of the axes follows from the start in the plane.
struct Polar {
  Axes from{};
  Motion motion;
  Curve curve() const { return {roles, from, motion}; }
};

Polar polar(MotionKind kind, Vec2 from, Vec2 to) {
  MotionDetail detail;
  detail.surface = PathSurface::polar;
  detail.flat_from = from;
  detail.flat_to = to;
  Polar p;
  p.from = {length(from), angle_deg(from)};
  p.motion = straight(kind, {}, 1000);
  p.motion.first = 0;
  p.motion.second = 1;
  p.motion.to = {length(to), p.from[1] + FlatPath::line(from, to).swept(1)};
  p.motion.detail = std::make_shared<MotionDetail>(detail);
  return p;
}

// 04-50: at radius 1 the path is tangential; the feed is 3600 · π/180 · 1.
TEST(polar_feed, at_the_nearest_point) {
  const Polar p = polar(feed, {50, 1}, {-50, 1});
  const Curve curve = p.curve();
  const PolarFeed limits{1000, 3600};
  EXPECT_NEAR(feed_at(curve, limits, 0.5), 62.831853, 1e-6);
  EXPECT_EQ(feed_at(curve, limits, 0.999), 1000);
  EXPECT_EQ(highest_feed(curve, limits), 1000);
  EXPECT_EQ(minutes(curve, {1000, 0}), 0.1);
}

// By hand: on a line at distance d from the centre the rotary axis turns at d·F/r² rad/min. Where r² ≥ d·F/most the feed is not
// limited. Closer to the centre the axis turns at its limit through the angle between the two bounds.
TEST(polar_feed, time_by_formula) {
  for (const double distance : {5.0, 1.0, 1e-3, 1e-6}) {
    const Polar p = polar(feed, {50, distance}, {-50, distance});
    const double most = 3600, bound = std::sqrt(std::max(0.0, distance * 1000 / (most * rad_per_deg) - distance * distance));
    const double expected = (100 - 2 * bound) / 1000 + 2 * std::atan2(bound, distance) / rad_per_deg / most;
    EXPECT_NEAR(minutes(p.curve(), {1000, most}), expected, 1e-8 * expected) << distance;
  }
}

RC_GTEST_PROP(polar_feed, no_axis_is_too_fast_and_one_limit_holds, ()) {
  test::Choices choose = test::choices(40);
  const auto number = [&] { return choose.between(-50'000, 50'000) / 1000.0; };
  const Polar p = polar(feed, {number() + 0.0005, number()}, {number(), number() + 0.0005});
  const Curve curve = p.curve();
  const PolarFeed limits{1.0 * choose.between(10, 5'000), 1.0 * choose.between(10, 5'000)};
  const double part = choose.between(0, 100) / 100.0, feed = feed_at(curve, limits, part);
  const double rate = curve.rate(FeedAlong::path, part);
  RC_PRE(rate > 0.01);
  const double rotary = std::abs(curve.rates(part)[1]) * feed / rate;
  RC_ASSERT(feed <= limits.feed * (1 + 1e-12));
  RC_ASSERT(rotary <= limits.max_rotary_speed * (1 + 1e-9));
  RC_ASSERT(feed >= limits.feed * (1 - 1e-9) || rotary >= limits.max_rotary_speed * (1 - 1e-9));
}

RC_GTEST_PROP(polar_feed, time_agrees_with_its_sampled_twin, ()) {
  test::Choices choose = test::choices(40);
  const Vec2 from{choose.between(-50, 50) / 1.0, choose.between(5, 500) / 10.0},
      to{choose.between(-50, 50) / 1.0, choose.between(5, 500) / 10.0};
  RC_PRE(length(to - from) > 0.1);
  const Polar p = polar(feed, from, to);
  const Curve curve = p.curve();
  const PolarFeed limits{1000, 1.0 * choose.between(100, 10'000)};
  constexpr int steps = 20'000;
  double sum = 0;
  for (int i = 0; i < steps; ++i) sum += curve.length() / steps / feed_at(curve, limits, (i + 0.5) / steps);
  RC_ASSERT(std::abs(minutes(curve, limits) - sum) <= 1e-5 * sum);
}

TEST(polar_feed, rapid_goes_as_fast_as_the_slower_axis) {
  const Polar out = polar(rapid, {10, 0}, {60, 0});
  EXPECT_NEAR(rapid_minutes(out.curve(), roles, {10000, 3600}), 50 / 10000.0, 1e-12);
  const Polar past = polar(rapid, {50, 1}, {-50, 1});
  const double turns_only = 2 * std::atan(50) / rad_per_deg / 360;  // such a slow rotary axis limits nearly all of the line
  const double time = rapid_minutes(past.curve(), roles, {1e9, 360});
  EXPECT_NEAR(time, turns_only, 1e-6);
}

}  // namespace
}  // namespace kadr::polar_feed_test
