// Arcs under unequal scale factors (G51, Mach3 10.7.15): every segment
// has its ends on the ellipse and stays within the tolerance of it.

#include <gtest/gtest.h>

#include <cmath>

#include "base/tolerance.h"
#include "control/run_program.h"

namespace kadr::ellipse_test {
namespace {

std::vector<Motion> feeds_of(const std::string& program) {
  std::vector<Motion> feeds;
  for (const Action& action : test::run("mach3", program).actions)
    if (const auto* motion = std::get_if<Motion>(&action.what); motion != nullptr && motion->kind == MotionKind::feed)
      feeds.push_back(*motion);
  return feeds;
}

/// Half an ellipse, 20 by 5 mm, about the work origin.
const std::string half = "G21 G90 F100\nG0 X20 Y0\nG51 X4 Y1\nG3 X-5 Y0 I-5 J0\nG50\nM2\n";

TEST(ellipse, every_end_lies_on_it) {
  for (const Motion& m : feeds_of(half)) EXPECT_NEAR(std::pow(m.to[0] / 20, 2) + std::pow(m.to[1] / 5, 2), 1, 1e-9);
}

TEST(ellipse, chords_stay_within_the_tolerance) {
  Vec2 from{20, 0};
  for (const Motion& m : feeds_of(half)) {
    const Vec2 to{m.to[0], m.to[1]};
    const Vec2 middle = 0.5 * (from + to);
    // In the plane scaled so that the ellipse becomes a circle of 20 mm, the gap is at least as large as at the ellipse.
    EXPECT_LE(20 - length(Vec2{middle.x, 4 * middle.y}), 4 * tol::ellipse_chord);
    from = to;
  }
}

TEST(ellipse, ends_exactly_at_its_end) {
  const auto feeds = feeds_of(half);
  ASSERT_GT(feeds.size(), 50U);
  EXPECT_EQ(feeds.back().to[0], -20);
  EXPECT_EQ(feeds.back().to[1], 0);
}

TEST(ellipse, rises_evenly_as_a_helix) {
  const auto feeds = feeds_of("G21 G90 F100\nG0 X20 Y0 Z0\nG51 X4 Y1\nG3 X-5 Y0 Z-4 I-5 J0\nG50\nM2\n");
  const double step = -4.0 / static_cast<double>(feeds.size());
  for (std::size_t i = 0; i < feeds.size(); ++i) EXPECT_NEAR(feeds[i].to[2], step * static_cast<double>(i + 1), 1e-9);
}

}  // namespace
}  // namespace kadr::ellipse_test
