// path/compensation/radius_compensation: the path is nowhere nearer to the contour
// than the tool's radius. The slow reference is the sampled path. NCT 15.5.

#include "path/compensation/radius_compensation.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>

#include "contours.h"

namespace kadr::radius_compensation_test {
namespace {

using test::any_number;
using test::Contour;
using test::sampled;

std::vector<Motion> compensated(const std::vector<Motion>& motions) {
  RadiusCompensation compensation{ToolPosition{}};
  std::vector<Motion> all;
  for (std::size_t i = 0; i < motions.size(); ++i) {  // one at a time: delayed actions must come out in the right order
    ActionBatch batch;
    batch.add().what = motions[i];
    EXPECT_FALSE(compensation.take(batch, i + 1 == motions.size()));
    for (const Action& action : batch) all.push_back(std::get<Motion>(action.what));
  }
  return all;
}

RC_GTEST_PROP(radius_compensation, the_path_is_nowhere_nearer_than_the_radius, ()) {
  const auto side = *rc::gen::element<std::int8_t>(1, -1);
  const double radius = any_number(1, 5);
  const bool first_arc = *rc::gen::arbitrary<bool>(), second_arc = *rc::gen::arbitrary<bool>();
  const auto element = [&](Contour& c, bool arc) {
    if (arc) c.arc(any_number(40, 80), *rc::gen::element(0.2, -0.2), side, radius);
    else c.line(any_number(60, 100), side, radius);
  };
  const int most = first_arc || second_arc ? 60 : 140;  // at most this angle keeps the elements apart
  Contour c;
  c.line(20, side, radius).side_step = SideStep::begins;
  element(c, first_arc);
  c.direction = rotated(c.direction, any_number(-most, most));
  element(c, second_arc);
  c.line(20, 0, radius).side_step = SideStep::ends;
  const auto path = compensated(c.motions);
  RC_ASSERT(path.size() >= 4U);
  const Axes first{20, 0, 0};
  const auto contour = sampled({c.motions.begin() + 1, c.motions.end() - 1}, first);
  const auto tool = sampled({path.begin() + 1, path.end() - 1}, path.front().to);
  // Samples of the contour are so close together that their sagitta makes a tool on the path seem nearer by at most this tolerance.
  for (const Vec2 t : tool)
    for (const Vec2 p : contour) RC_ASSERT(length(t - p) > radius - 10 * tol::same_point);
  double farthest = 0;  // the path follows the contour: each of its points is near it
  for (const Vec2 t : tool) {
    double nearest = 1e9;
    for (const Vec2 p : contour) nearest = std::min(nearest, length(t - p));
    farthest = std::max(farthest, nearest);
  }
  RC_ASSERT(farthest < 2.3 * radius + 2);  // at acute corners the path extends up to √5 radii
}

/// Returns the same contour for a control with a CompensationApproach of its own.
std::vector<Motion> joined_by(CornerJoin join, std::vector<Motion> motions) {
  for (Motion& m : motions) {
    m.join_corner = join;
    m.entry = CompensationApproach::normal;
  }
  return motions;
}

double nearest_of(Vec2 to, const std::vector<Vec2>& points) {
  double nearest = 1e9;
  for (const Vec2 p : points) nearest = std::min(nearest, length(to - p));
  return nearest;
}

RC_GTEST_PROP(radius_compensation, arcs_and_straight_joins_are_nowhere_nearer_than_the_radius, ()) {
  const auto side = *rc::gen::element<std::int8_t>(1, -1);
  const auto join = *rc::gen::element(CornerJoin::arc, CornerJoin::straight);
  const double radius = any_number(1, 5);
  const std::array<bool, 2> arc{*rc::gen::arbitrary<bool>(), *rc::gen::arbitrary<bool>()};
  const int most = arc[0] || arc[1] ? 60 : 140;  // at most this angle keeps the elements apart
  Contour c;
  c.line(20, side, radius).side_step = SideStep::begins;
  for (std::size_t i = 0; i < arc.size(); ++i) {
    if (arc[i]) c.arc(any_number(40, 80), *rc::gen::element(0.2, -0.2), side, radius);
    else c.line(any_number(60, 100), side, radius);
    if (i == 0) c.direction = rotated(c.direction, any_number(-most, most));
  }
  c.line(20, 0, radius).side_step = SideStep::ends;
  const auto motions = joined_by(join, c.motions);
  const auto path = compensated(motions);
  const auto contour = sampled({motions.begin() + 1, motions.end() - 1}, {20, 0, 0});
  const auto tool = sampled({path.begin() + 1, path.end() - 1}, path.front().to);
  const double reach = join == CornerJoin::arc ? radius : 3 * radius;  // tan 70° · r beyond the sharpest corner
  for (const Vec2 t : tool) {
    RC_ASSERT(nearest_of(t, contour) > radius - 10 * tol::same_point);
    RC_ASSERT(nearest_of(t, contour) < reach + 1);  // half the distance between two samples
  }
}

TEST(radius_compensation, a_frame_that_moves_keeps_the_tool_beside) {
  RadiusCompensation compensation{ToolPosition{}};
  Contour c;
  c.line(20, 1, 5).side_step = SideStep::begins;
  c.line(50, 1, 5);
  ActionBatch batch;
  for (const Motion& m : joined_by(CornerJoin::arc, c.motions)) batch.add().what = m;
  FrameChange frame{};
  frame.work = {-30, 0, 0};
  batch.add().what = frame;
  ASSERT_FALSE(compensation.take(batch, false));
  ASSERT_EQ(batch.size(), 3U);
  EXPECT_EQ(std::get<Motion>(batch[1].what).to[1], 5);
  EXPECT_EQ(std::get<FrameChange>(batch[2].what).work[0], -30);
  EXPECT_EQ(std::get<FrameChange>(batch[2].what).work[1], 5);
  EXPECT_TRUE(compensation.off_contour());
}

TEST(radius_compensation, a_corner_too_flat_for_a_motion_of_its_own) {
  Contour c;
  c.line(20, 1, 0.1).side_step = SideStep::begins;
  c.line(50, 1, 0.1);
  c.direction = rotated(c.direction, -1e-4);  // 1.7e-6 radians: 1.7e-7 mm on the arc
  c.line(50, 1, 0.1);
  const auto path = compensated(joined_by(CornerJoin::arc, c.motions));
  ASSERT_EQ(path.size(), 3U);
  for (const Motion& m : path) EXPECT_EQ(m.kind, MotionKind::feed);
}

TEST(radius_compensation, other_actions_keep_their_place) {
  RadiusCompensation compensation{ToolPosition{}};
  Contour c;
  c.line(20, 1, 5).side_step = SideStep::begins;
  c.line(50, 1, 5);
  c.direction = {0, -1};
  c.line(50, 1, 5);
  ActionBatch batch;
  batch.add().what = c.motions[0];
  batch.add().what = c.motions[1];
  batch.add().what = Dwell{1};
  batch.add().what = c.motions[2];
  ASSERT_FALSE(compensation.take(batch, true));
  ASSERT_EQ(batch.size(), 4U);  // an outside corner of 90 degrees between two lines has one point
  EXPECT_EQ(std::get<Motion>(batch[1].what).to[0], 75);
  EXPECT_TRUE(std::holds_alternative<Dwell>(batch[2].what));
  EXPECT_EQ(std::get<Motion>(batch[3].what).to[0], 75);
}

TEST(radius_compensation, too_many_actions_between) {
  RadiusCompensation compensation{ToolPosition{}};
  Contour c;
  c.line(20, 1, 5).side_step = SideStep::begins;
  ActionBatch batch;
  batch.add().what = c.motions[0];
  for (int i = 0; i < 100; ++i) batch.add().what = Dwell{1};
  const auto fault = compensation.take(batch, false);
  ASSERT_TRUE(fault);
  EXPECT_EQ(fault->alarm.id, AlarmId::compensation_buffer);
}

}  // namespace
}  // namespace kadr::radius_compensation_test
