// motion/least_time/tcp_corner: the effect that rounding a corner of the axes has on tip and direction, checked with the machine's
// forward transformation. NCT 25.14.

#include "motion/least_time/tcp_corner.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "kinematics/five_axis_transform.h"

namespace kadr::tcp_corner_test {
namespace {

constexpr double tolerance = 0.01;  // mm
constexpr AxisMask rotary = 0b11000;

FiveAxisTransform head() {
  FiveAxisTransformData d;
  d.machine.group = MachineGroup::head_head;
  d.machine.first = {3, {0, 0, 1}, 1};
  d.machine.second = {4, {0, 1, 0}, 1};
  d.length = {0, 0, 150};
  d.controls_tip = d.follows_head = true;
  return FiveAxisTransform(d);
}

Vec3 tip_of(const Axes& work) { return {work[0], work[1], work[2]}; }

struct Corner {
  std::array<Axes, 3> work, machine;
  TcpPiece before, after;
};

Corner corner(const FiveAxisTransform& space, const std::array<Axes, 3>& work) {
  Corner c{work, {}, {}, {}};
  for (std::size_t i = 0; i < 3; ++i) c.machine[i] = space.machine_of(work[i], work[i]);
  c.before = tcp_piece(5, c.machine[0], c.machine[1], tip_of(work[0]), tip_of(work[1]), 10);
  c.after = tcp_piece(5, c.machine[1], c.machine[2], tip_of(work[1]), tip_of(work[2]), 10);
  return c;
}

/// Returns the axis positions at the corner, moved into its inside by `by`.
Axes rounded(const Corner& c, double by) {
  double turn = 0;
  for (std::size_t a = 0; a < 5; ++a) turn += std::pow(c.after.along[a] - c.before.along[a], 2);
  Axes at = c.machine[1];
  for (std::size_t a = 0; a < 5; ++a) at[a] += by * (c.after.along[a] - c.before.along[a]) / std::sqrt(turn);
  return at;
}

struct Off {
  double tip = 1e9, direction = 0;  // deviation of the tip in mm, of the direction in degrees
};

/// Returns the deviation from the nearest point of the programmed path, found in small steps, and from the direction programmed there.
Off off_path(const FiveAxisTransform& space, const Corner& c, const Pose& pose) {
  Off off;
  for (std::size_t piece = 0; piece < 2; ++piece)
    for (int step = 0; step <= 2000; ++step) {
      const double part = step / 2000.0;
      Axes at{};
      for (std::size_t a = 0; a < 5; ++a) at[a] = c.work[piece][a] + part * (c.work[piece + 1][a] - c.work[piece][a]);
      const double distance = length(pose.tip - tip_of(at));
      if (distance >= off.tip) continue;
      const Vec3 wanted = space.pose(space.machine_of(at, at)).direction;
      off = {distance, std::atan2(length(cross(wanted, pose.direction)), dot(wanted, pose.direction)) / rad_per_deg};
    }
  return off;
}

TEST(tcp_corner, tip_and_direction_stay_within) {
  const FiveAxisTransform space = head();
  std::mt19937 random(25);
  std::uniform_real_distribution<double> any(-1, 1);
  for (int n = 0; n < 200; ++n) {
    std::array<Axes, 3> work{};
    work[0] = {50 * any(random), 50 * any(random), 0, 90 * any(random), 20 + 30 * any(random)};
    for (std::size_t i = 1; i < 3; ++i) {
      work[i] = work[i - 1];
      work[i][0] += 1 + 0.5 * any(random), work[i][1] += 0.8 * any(random), work[i][2] += 0.3 * any(random);
      work[i][3] += 0.5 * any(random), work[i][4] += 0.5 * any(random);
    }
    const Corner c = corner(space, work);
    const double by = tcp_tolerance(c.before, c.after, tolerance, rotary);
    ASSERT_GT(by, 0);
    const Off off = off_path(space, c, space.pose(rounded(c, by)));
    EXPECT_LE(off.tip, 1.1 * tolerance) << n;
    EXPECT_LE(off.direction, 0.012) << n;
  }
}

/// A sharp corner of the axes that hardly moves the tip may be rounded by more than the tip's tolerance.
TEST(tcp_corner, what_the_tip_does_not_feel_may_be_rounded_more) {
  const FiveAxisTransform space = head();
  std::array<Axes, 3> work{};
  work[0] = {0, 0, 0, 0, 30};
  work[1] = {1, 0, 0, 0, 30};
  work[2] = {2, 0, 0, 0, 30.05};
  const Corner c = corner(space, work);
  EXPECT_GT(tcp_tolerance(c.before, c.after, tolerance, rotary), 1.5 * tolerance);  // here the direction limits the rounding
}

/// If the rotary axes do not move, it is an ordinary corner.
TEST(tcp_corner, of_the_tip_alone_is_its_tolerance) {
  const FiveAxisTransform space = head();
  std::array<Axes, 3> work{};
  work[0] = {0, 0, 0, 10, 30};
  work[1] = {1, 0, 0, 10, 30};
  work[2] = {1, 1, 0, 10, 30};
  const Corner c = corner(space, work);
  EXPECT_NEAR(tcp_tolerance(c.before, c.after, tolerance, rotary), tolerance, 1e-9);
  EXPECT_TRUE(c.after.keeps_pace(c.before));
}

TEST(tcp_corner, pieces_of_no_length_are_not_known) {
  EXPECT_FALSE(tcp_piece(5, {}, {}, {}, {1, 0, 0}, 10).known);
  EXPECT_FALSE(TcpPiece().keeps_pace(TcpPiece()));
}

}  // namespace
}  // namespace kadr::tcp_corner_test
