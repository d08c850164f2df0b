// stock/bodies/moving_bodies: bodies meet where geometry puts the meeting; no meeting is missed, however short it is.

#include "stock/bodies/moving_bodies.h"

#include <gtest/gtest.h>

#include <cmath>

#include "stock/some_tools.h"

namespace kadr::moving_bodies_test {
namespace {

const std::vector<std::string> axis_names = {"X", "Y", "Z", "A", "C"};

AxisJoint linear(Vec3 along) { return {false, along, {}, false, false}; }
AxisJoint rotary(Vec3 about, Vec3 through) { return {true, about, through, false, false}; }

/// X and Z move the tool; Y, A and C move the part. A turns about a line along X at Z = -400, C about a vertical line.
MachineProfile trunnion() {
  MachineProfile machine;
  machine.axes["X"].joint = linear({1, 0, 0});
  machine.axes["Y"].joint = linear({0, 1, 0});
  machine.axes["Z"].joint = linear({0, 0, 1});
  machine.axes["A"].joint = rotary({1, 0, 0}, {0, 0, -400});
  machine.axes["C"].joint = rotary({0, 0, 1}, {0, 0, -400});
  machine.chains = {{"X", "Z"}, {"Y", "A", "C"}, {0, 0, 1}};
  return machine;
}

BodyShape box(Vec3 least, Vec3 most) { return {BodyShape::Form::box, least, most, {}, 0, 0, 0, {}}; }

class moving_bodies : public testing::Test {
 protected:
  void SetUp() override {
    ASSERT_NE(bodies_library(), nullptr) << "kadr-bodies.so is not beside the tests";
    bodies.emplace(MachineLinks(MachineTree(trunnion(), axis_names)), BodyWorld(*bodies_library()));
  }
  std::size_t add(const BodyShape& shape, const char* axis, BodyKind kind = BodyKind::machine) {
    const std::size_t number = count++;
    return bodies->add(*bodies->world().add(shape), bodies->links().moved_by(axis), kind, number);
  }
  std::vector<BodyMeeting> move(const Axes& from, const Axes& to) {
    std::vector<BodyMeeting> found;
    bodies->move(from, to, found);
    return found;
  }

  std::optional<MovingBodies> bodies;
  std::size_t count = 0;
};

TEST_F(moving_bodies, boxes_meet_where_they_do) {
  add(box({-50, -50, 0}, {50, 50, 200}), "Z");
  add(box({300, -50, -100}, {400, 50, 100}), "bed");
  const auto found = move({}, {500, 0, 0});
  ASSERT_EQ(found.size(), 1U);
  EXPECT_NEAR(500 * found[0].part, 250, bodies_meet);
  EXPECT_NEAR(found[0].at.x, 300, bodies_meet);
  EXPECT_NEAR(found[0].depth, 100, 10);  // the shortest way out of the other body, sampled at eighths of the path
  EXPECT_TRUE(move({500, 0, 0}, {510, 0, 0}).empty());
}

TEST_F(moving_bodies, once_until_they_part) {
  add(box({-50, -50, 0}, {50, 50, 200}), "Z");
  add(box({300, -50, -100}, {400, 50, 100}), "bed");
  EXPECT_TRUE(move({}, {249.9, 0, 0}).empty());
  EXPECT_EQ(move({249.9, 0, 0}, {250.1, 0, 0}).size(), 1U);
  EXPECT_TRUE(move({250.1, 0, 0}, {251, 0, 0}).empty());
  EXPECT_TRUE(move({251, 0, 0}, {240, 0, 0}).empty());
  EXPECT_EQ(move({240, 0, 0}, {251, 0, 0}).size(), 1U);
}

// A wall of 0.1 mm, and a motion of 2 m.
TEST_F(moving_bodies, nothing_is_jumped_over) {
  add(box({-1, -1, 0}, {1, 1, 10}), "Z");
  add(box({700, -1, -1}, {700.1, 1, 11}), "bed");
  const auto found = move({}, {2000, 0, 0});
  ASSERT_EQ(found.size(), 1U);
  EXPECT_NEAR(2000 * found[0].part, 699, bodies_meet);
}

TEST_F(moving_bodies, past_each_other_by_little) {
  add(box({-50, -50, 0.02}, {50, 50, 200}), "Z");
  add(box({300, -50, -100}, {400, 50, 0}), "bed");
  EXPECT_TRUE(move({}, {1000, 0, 0}).empty());
  EXPECT_LT(bodies->queries(), 20U);  // few queries: the motion is parallel to a plane between the bodies
}

// The axis of the part moves in the opposite sense: the part moves by -Y.
TEST_F(moving_bodies, the_part_goes_the_other_way) {
  add(box({-50, -50, 0}, {50, 50, 200}), "Z");
  add(box({-50, 150, 0}, {50, 250, 10}), "Y");
  EXPECT_TRUE(move({}, {0, -300, 0}).empty());
  EXPECT_TRUE(move({0, -300, 0}, {}).empty());
  const auto found = move({}, {0, 300, 0});
  ASSERT_EQ(found.size(), 1U);
  EXPECT_NEAR(300 * found[0].part, 100, bodies_meet);
}

// A table's edge, 300 mm from the axis of A and at its level, rises by 300 sin a; the underside of the head is 150 mm above it.
TEST_F(moving_bodies, a_table_swings_into_the_head) {
  add(box({-200, -400, -250}, {200, 400, -50}), "Z");
  add(box({-100, 0, -401}, {100, 300, -400}), "C");
  const auto found = move({}, {0, 0, 0, 90});
  ASSERT_EQ(found.size(), 1U);
  EXPECT_NEAR(90 * found[0].part, 30, bodies_meet / (300 * rad_per_deg * std::cos(pi / 6)) + 1e-6);
  EXPECT_NEAR(found[0].at.z, -250, bodies_meet);
}

// Bodies of the same branch: the clamp on the table that C turns hits the yoke that A carries, at the near side of a box, at an angle.
TEST_F(moving_bodies, a_table_turns_into_its_yoke) {
  add(box({-300, 200, -450}, {300, 250, -300}), "A");
  add(box({150, -10, -400}, {220, 10, -350}), "C");
  const auto found = move({}, {0, 0, 0, 0, 90});
  ASSERT_EQ(found.size(), 1U);
  // The corner (220, 10) reaches y = 200 when 220 sin c + 10 cos c = 200.
  const double angle = (std::asin(200 / std::hypot(220, 10)) - std::atan2(10, 220)) / rad_per_deg;
  EXPECT_NEAR(90 * found[0].part, angle, 0.01);
}

TEST_F(moving_bodies, what_touches_at_zero_is_built_so) {
  add(box({-200, -200, -420}, {200, 200, -400}), "C");
  add(box({-300, -300, -500}, {300, 300, -420}), "A");
  add(box({-50, -50, 0}, {50, 50, 200}), "Z");
  const auto built = bodies->accept_initial_contacts();
  ASSERT_EQ(built.size(), 1U);
  EXPECT_EQ(built[0].first, 0U);
  EXPECT_EQ(built[0].second, 1U);
  EXPECT_TRUE(bodies->accept_initial_contacts().empty());
  EXPECT_TRUE(move({}, {0, 0, 0, 0, 180}).empty());
  EXPECT_EQ(move({}, {0, 0, -450}).size(), 2U);  // the head passes through the table into the body that carries it
}

// Contact of the tool with blank and fixture is checked by the cut itself, contact
// with the table here. The first part of the tool that touches is reported.
TEST_F(moving_bodies, a_tool_and_its_work) {
  const std::size_t table = add(box({-200, -200, -420}, {200, 200, -400}), "C");
  const std::size_t vise = add(box({-50, -50, -400}, {50, 50, -300}), "C", BodyKind::work);
  const std::size_t link = bodies->links().moved_by("Z");
  const auto cutter = *bodies->world().add(BodyShape(box({-5, -5, -100}, {5, 5, -50})));
  const auto holder = *bodies->world().add(BodyShape(box({-80, -80, -50}, {80, 80, 0})));
  const std::size_t first = bodies->add(cutter, link, BodyKind::tool, 77), second = bodies->add(holder, link, BodyKind::tool, 77);
  EXPECT_TRUE(move({}, {0, 0, -299}).empty());
  const auto found = move({0, 0, -299}, {0, 0, -360});
  ASSERT_EQ(found.size(), 1U);
  EXPECT_EQ(found[0].first, table);
  EXPECT_EQ(found[0].second, first);
  bodies->show(first, false), bodies->show(second, false), bodies->show(vise, false);
  EXPECT_TRUE(move({0, 0, -200}, {0, 0, -360}).empty());
}

// law: for any motion, at a meeting the bodies are less than 0.01 mm apart,
// and before it they are not; no meeting is missed that small steps find.
TEST_F(moving_bodies, random_motions) {
  const std::size_t head = add(box({-60, -70, -200}, {60, 70, 0}), "Z"), table = add(box({-150, -150, -420}, {150, 150, -400}), "C");
  (void)head, (void)table;
  Chance chance(5);
  int met = 0;
  for (int i = 0; i < 300; ++i) {
    Axes from{}, to{};
    for (std::size_t a = 0; a < 5; ++a) {
      const double reach = a < 3 ? 150 : 60;
      from[a] = chance.between(-reach, reach), to[a] = chance.between(-reach, reach);
    }
    bodies->jump();
    const auto at_start = move(from, from);
    if (!at_start.empty()) continue;
    const auto found = move(from, to);
    double seen = 2;
    for (int k = 0; k <= 400 && seen > 1; ++k) {
      Axes at = from;
      for (std::size_t a = 0; a < 5; ++a) at[a] += k / 400.0 * (to[a] - from[a]);
      bodies->jump();
      if (!move(at, at).empty()) seen = k / 400.0;
    }
    if (found.empty()) {
      EXPECT_GT(seen, 1);
      continue;
    }
    ++met;
    EXPECT_LE(found[0].part, seen + 1e-9);
    if (seen <= 1) {
      EXPECT_GE(found[0].part, seen - 1 / 400.0 - 1e-9);
    }
  }
  EXPECT_GT(met, 10);
}

}  // namespace
}  // namespace kadr::moving_bodies_test
