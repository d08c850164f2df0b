// action/tool_position, path/curve/machine_extents: machine coordinates along a motion, with rotated and unrotated frames. NCT 10.2.3.

#include <gtest/gtest.h>

#include "actions.h"
#include "choices.h"
#include "path/curve/machine_extents.h"

namespace kadr::frame_test {
namespace {

using test::arc;
using test::straight;
using enum MotionKind;

const AxisRoles roles = AxisRoles::of({"X", "Y", "Z", "B"}, 8);

/// M_Z(30) · M_Y(20) · M_X(10), in the order of nct 10.2.3.
FrameTurn rotation_of_the_manual() {
  const SinCos a = sincos_deg(10), b = sincos_deg(20), g = sincos_deg(30);
  FrameTurn r;
  r.rows = {Vec3{g.cos * b.cos, g.cos * b.sin * a.sin - g.sin * a.cos, g.cos * b.sin * a.cos + g.sin * a.sin},
            Vec3{g.sin * b.cos, g.sin * b.sin * a.sin + g.cos * a.cos, g.sin * b.sin * a.cos - g.cos * a.sin},
            Vec3{-b.sin, b.cos * a.sin, b.cos * a.cos}};
  return r;
}

TEST(frame, turned_work_coordinates) {  // golden 10-14
  const FrameTurn rotation = rotation_of_the_manual();
  const Axes machine = turned(&rotation, {10, 20, 30, 7});
  EXPECT_NEAR(machine[0], 10.6743, 1e-4);
  EXPECT_NEAR(machine[1], 22.8906, 1e-4);
  EXPECT_NEAR(machine[2], 27.6058, 1e-4);
  EXPECT_EQ(machine[3], 7);
  EXPECT_EQ(turned(nullptr, {10, 20, 30, 7}), (Axes{10, 20, 30, 7}));
}

TEST(frame, main_axes_may_stand_anywhere_or_be_missing) {
  FrameTurn quarter;  // about Z, from X towards Y
  quarter.rows = {Vec3{0, -1, 0}, Vec3{1, 0, 0}, Vec3{0, 0, 1}};
  quarter.main = {2, 0, -1};
  EXPECT_EQ(turned(&quarter, {5, 9, 3}), (Axes{3, 9, -5}));
}

/// NCT 20.3, 20.4: any exchange and reversal of axes on top of a rotation, and back. Each machine axis travels the programmed distance
/// of the axis that it is exchanged with.
RC_GTEST_PROP(frame, exchanged_and_reversed_axes_there_and_back, ()) {
  test::Choices choose = test::choices(40);
  auto turn = std::make_shared<FrameTurn>(rotation_of_the_manual());
  AxisDrives& drives = turn->drives;
  for (std::size_t i = 3; i > 0; --i)
    std::swap(drives.axis[i], drives.axis[static_cast<std::size_t>(choose.between(0, static_cast<int>(i)))]);
  drives.reversed = static_cast<AxisMask>(choose.between(0, 15));
  drives.is_own = drives == AxisDrives();
  Placement frame;
  frame.origin = {100, -50, 20, 5};
  frame.length = {0, 0, 80, 0};
  frame.turn = turn;
  const Axes work{choose.between(-100, 100) / 1.0, choose.between(-100, 100) / 1.0, 3, 7};
  const Axes machine = frame.machine_of(work), back = frame.work_of(machine);
  auto own = std::make_shared<FrameTurn>(rotation_of_the_manual());
  frame.turn = own;
  const Axes undriven = frame.machine_of(work), turned_back = turned_back_axes(*turn, turned_axes(*turn, work));
  for (std::size_t a = 0; a < 4; ++a) {
    RC_ASSERT(std::fabs(back[a] - work[a]) < 1e-9);
    RC_ASSERT(std::fabs(turned_back[a] - work[a]) < 1e-9);
    RC_ASSERT(machine[drives.of(a)] == drives.sense(a) * undriven[a]);
  }
}

/// The slow reference computes origin + length + turn · (shift + work) for each point.
RC_GTEST_PROP(frame, points_of_an_arc_in_a_turned_frame, ()) {
  test::Choices choose = test::choices(40);
  const auto rotation = std::make_shared<FrameTurn>(rotation_of_the_manual());
  const Axes origin{100, -50, 20, 5}, shift{3, 2, 1, 0};
  const auto machine = [&](const Axes& work) {
    Axes moved = work;
    for (std::size_t i = 0; i < 3; ++i) moved[i] += shift[i];
    moved = turned(rotation.get(), moved);
    for (std::size_t i = 0; i < 4; ++i) moved[i] += origin[i];
    return moved;
  };
  const Vec3 from{choose.between(1, 100) / 1.0, 0, 0};
  const double turns = choose.between(1, 300) / 100.0;
  const Vec2 end = rotated({from.x * 1.2, 0}, 360 * turns);
  Motion m = arc(arc_ccw, {end.x, end.y, choose.between(-20, 20) / 1.0}, {}, turns);
  m.machine = machine(m.to);
  const ToolPosition start{{from.x, from.y, from.z}, machine({from.x, from.y, from.z}), rotation};
  const Curve curve(roles, start.work, m);
  const Extents box = machine_extents(roles, start, m);
  for (int i = 0; i <= 20; ++i) {
    const double part = i / 20.0;
    const Axes there = machine_along(roles, start, m, curve.at(part), part), expected = machine(curve.at(part));
    for (std::size_t k = 0; k < 4; ++k) {
      RC_ASSERT(std::abs(there[k] - expected[k]) <= 1e-9);
      RC_ASSERT(there[k] >= box.least[k] - 1e-9 && there[k] <= box.most[k] + 1e-9);
    }
  }
}

TEST(frame, extents_in_a_turned_frame_are_exact) {
  FrameTurn about_x;  // by 60°: the circle in XY is tilted
  const SinCos a = sincos_deg(60);
  about_x.rows = {Vec3{1, 0, 0}, Vec3{0, a.cos, -a.sin}, Vec3{0, a.sin, a.cos}};
  const ToolPosition start{{10, 0, 0}, {10, 0, 0}, std::make_shared<FrameTurn>(about_x)};
  const Extents box = machine_extents(roles, start, arc(arc_ccw, {10, 0, 0}, {}, 1));
  EXPECT_NEAR(box.most[0], 10, 1e-9);
  EXPECT_NEAR(box.most[1], 5, 1e-9);
  EXPECT_NEAR(box.least[2], -10 * a.sin, 1e-9);
}

TEST(frame, position_keeps_the_rotation_until_the_next_frame) {
  ToolPosition position;
  const auto rotation = std::make_shared<const FrameTurn>(rotation_of_the_manual());
  position.take(FrameChange{{.turn = rotation}, {1, 2, 3}});
  position.take(straight(feed, {4, 5, 6}));
  EXPECT_EQ(position.turn, rotation);
  position.take(FrameChange{{}, {4, 5, 6}});
  EXPECT_EQ(position.turn, nullptr);
}

TEST(frame, axis_that_rolls_over_counts_on_until_the_end) {  // nct 5.6
  MotionDetail detail;
  detail.rolled = 8;
  detail.travel[3] = 30;
  Motion m = straight(rapid, {});
  m.to[3] = 20;
  m.machine[3] = 25;
  m.detail = std::make_shared<MotionDetail>(detail);
  const ToolPosition start{{0, 0, 0, 350}, {0, 0, 0, 355}};
  EXPECT_EQ(machine_along(roles, start, m, {0, 0, 0, 365}, 0.5)[3], 370);
  EXPECT_EQ(machine_along(roles, start, m, m.to, 1)[3], 25);
  EXPECT_EQ(machine_extents(roles, start, m).least[3], 25);
  EXPECT_EQ(machine_extents(roles, start, m).most[3], 355);
}

}  // namespace
}  // namespace kadr::frame_test
