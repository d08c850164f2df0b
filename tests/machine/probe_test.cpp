// machine/probe: a round tip in a round hole. Mach3 10.7.12.3. The slow reference steps along the line.

#include "machine/probe.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>

namespace kadr::probe_test {
namespace {

const ProbeHole hole{2, 50, 20, 40, 0, 30};  // tip diameter 2, centre X50 Y20, diameter 40, top 0, depth 30

Vec3 touch(Vec3 from, Vec3 to) {
  const auto part = first_touch(hole, from, to);
  EXPECT_TRUE(part);
  return from + part.value_or(2) * (to - from);
}

void expect_at(Vec3 p, Vec3 q) { EXPECT_LT(length(p - q), 1e-7) << p.x << ' ' << p.y << ' ' << p.z; }

TEST(probe, wall) {
  expect_at(touch({50, 20, -5}, {100, 20, -5}), {68, 20, -5});
  expect_at(touch({50, 20, -5}, {0, 20, -5}), {32, 20, -5});
  expect_at(touch({50, 30, -5}, {100, 30, -5}), {50 + std::sqrt(18 * 18 - 100), 30, -5});
}

TEST(probe, faces) {
  expect_at(touch({50, 20, 10}, {50, 20, -100}), {50, 20, -28});  // bottom
  expect_at(touch({100, 20, 10}, {100, 20, -10}), {100, 20, 2});  // top face
}

TEST(probe, rim) {
  expect_at(touch({69, 20, 10}, {69, 20, -10}), {69, 20, std::sqrt(3)});  // 1 mm inside the edge
  expect_at(touch({50, 20, 1}, {100, 20, 1}), {70 - std::sqrt(3), 20, 1});
}

TEST(probe, free_ways) {
  EXPECT_FALSE(first_touch(hole, {50, 20, 10}, {50, 20, -20}));
  EXPECT_FALSE(first_touch(hole, {0, 0, 5}, {200, 100, 5}));
  EXPECT_FALSE(first_touch(hole, {68, 20, -5}, {50, 20, -5}));  // moves away from the wall that it touches
  EXPECT_FALSE(first_touch(hole, {100, 20, 2}, {100, 20, 20}));
}

TEST(probe, in_touch_already) {
  EXPECT_EQ(first_touch(hole, {69, 20, -5}, {50, 20, -5}), 0.0);  // inside the material
  EXPECT_NEAR(*first_touch(hole, {68, 20, -5}, {80, 20, -5}), 0, 1e-9);
}

double distance_to_workpiece(Vec3 p) {
  const double rho = std::hypot(p.x - hole.center_x, p.y - hole.center_y), radius = hole.diameter / 2;
  const double outside = rho >= radius ? p.z : std::hypot(radius - rho, std::max(p.z, 0.0));
  return std::min(outside, p.z + hole.depth);
}

RC_GTEST_PROP(probe, touches_where_the_stepping_twin_does, ()) {
  const auto number = [](int least, int most) { return *rc::gen::inRange(least * 1000, most * 1000) / 1000.0; };
  const Vec3 from{number(20, 80), number(-10, 50), number(3, 20)}, to{number(0, 100), number(-30, 70), number(-40, 10)};
  const double whole = length(to - from);
  RC_PRE(whole > 1);
  const auto part = first_touch(hole, from, to);
  constexpr int steps = 20'000;
  for (int i = 0; i <= steps; ++i) {
    const double at = double(i) / steps;
    const double free = distance_to_workpiece(from + at * (to - from)) - hole.tip_radius;
    if (part && at < *part) RC_ASSERT(free > -1e-6);
    if (free < -1e-5) {
      RC_ASSERT(part.has_value());
      RC_ASSERT(*part <= at);
      break;
    }
  }
  if (part) RC_ASSERT(std::abs(distance_to_workpiece(from + *part * (to - from)) - hole.tip_radius) < 1e-5);
}

}  // namespace
}  // namespace kadr::probe_test
