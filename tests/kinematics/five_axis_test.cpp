// kinematics/five_axis: two rotary axes, from positions to directions and back (NCT 25.1; spec/nct/25a, 25g).

#include "kinematics/five_axis.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <random>

namespace kadr::five_axis_test {
namespace {

constexpr Vec3 x{1, 0, 0}, y{0, 1, 0}, z{0, 0, 1};

FiveAxis machine(MachineGroup group, Vec3 first, Vec3 second, double first_sense = 1, double second_sense = 1) {
  FiveAxis m;
  m.group = group;
  m.first = {3, first, first_sense};
  m.second = {4, second, second_sense};
  m.table = {300, -200, -450};
  m.second_table = group == MachineGroup::table_table ? Vec3{0, 4, -60} : Vec3{};
  m.holder = {5, -3, 200};
  m.head = group == MachineGroup::head_head ? Vec3{20, 8, 50} : Vec3{};
  return m;
}

Vec3 leaned(Vec3 u, double degrees, Vec3 towards) {
  return std::cos(degrees * rad_per_deg) * u + std::sin(degrees * rad_per_deg) * towards;
}

/// Returns machines with all pairs of axes of 25a 3 in both senses, inclined axes included.
std::vector<FiveAxis> machines() {
  std::vector<FiveAxis> all;
  const std::pair<Vec3, Vec3> pairs[] = {
      {z, x}, {z, y}, {x, y}, {y, x}, {x, z}, {y, z}, {y, leaned(y, 45, z)}, {leaned(y, -45, z), z}, {z, leaned(z, 50, x)}};
  for (const MachineGroup group : {MachineGroup::head_head, MachineGroup::table_table, MachineGroup::head_table})
    for (const auto& [first, second] : pairs)
      for (const double a : {1., -1.})
        for (const double b : {1., -1.}) all.push_back(machine(group, first, second, a, b));
  return all;
}

double distance(Vec3 a, Vec3 b) { return length(a - b); }

/// The slow reference rotates the vector about one axis after the other, in the machine's own order, without multiplying matrices.
Vec3 slow_direction(const FiveAxis& m, RotaryPair at) {
  const auto turn = [](Vec3 v, Vec3 axis, double degrees) {  // Rodrigues' formula
    const double s = std::sin(degrees * rad_per_deg), c = std::cos(degrees * rad_per_deg);
    return c * v + s * cross(axis, v) + (1 - c) * dot(axis, v) * axis;
  };
  Vec3 t = m.tool;
  if (m.group == MachineGroup::head_head)
    return turn(turn(t, m.second.direction, m.second.sense * at.second), m.first.direction, m.first.sense * at.first);
  if (m.group == MachineGroup::head_table) {
    t = turn(t, m.first.direction, m.first.sense * at.first);
    return turn(t, m.second.direction, -m.second.sense * at.second);
  }
  return turn(turn(t, m.first.direction, -m.first.sense * at.first), m.second.direction, -m.second.sense * at.second);
}

TEST(five_axis, directions_are_those_of_the_manual) {  // 25a 8
  const FiveAxis cb = machine(MachineGroup::head_head, z, y), ac = machine(MachineGroup::table_table, x, z, -1, -1);
  EXPECT_NEAR(distance(cb.direction({0, 45}), {std::sqrt(0.5), 0, std::sqrt(0.5)}), 0, 1e-12);
  EXPECT_NEAR(distance(ac.direction({45, 90}), {std::sqrt(0.5), 0, std::sqrt(0.5)}), 0, 1e-12);
  EXPECT_NEAR(distance(cb.direction({-90, 90}), {0, -1, 0}), 0, 1e-12);
  const FiveAxis bc = machine(MachineGroup::head_table, y, z, 1, -1);
  EXPECT_NEAR(distance(bc.direction({-45, 90}), {0, -std::sqrt(0.5), std::sqrt(0.5)}), 0, 1e-12);
}

TEST(five_axis, as_turned_one_axis_after_the_other) {
  std::mt19937 random(25);
  std::uniform_real_distribution<double> angle(-400, 400);
  for (const FiveAxis& m : machines())
    for (int i = 0; i < 200; ++i) {
      const RotaryPair at{angle(random), angle(random)};
      ASSERT_NEAR(distance(m.direction(at), slow_direction(m, at)), 0, 1e-12);
    }
}

/// Issue 18: for a million random directions, the forward transformation of the inverse gives the same direction, and one of the
/// solutions equals the original positions.
TEST(five_axis, forward_of_inverse_is_the_same) {
  std::mt19937 random(18);
  std::uniform_real_distribution<double> angle(-180, 180);
  const auto all = machines();
  const int each = 1'000'000 / static_cast<int>(all.size()) + 1;
  double worst = 0;
  for (const FiveAxis& m : all)
    for (int i = 0; i < each; ++i) {
      const RotaryPair at{angle(random), angle(random)};
      const Vec3 wanted = m.direction(at);
      const RotarySolutions found = m.solutions(wanted);
      ASSERT_GT(found.count, 0);
      bool is_there = found.first_free || found.second_free;
      for (int n = 0; n < found.count; ++n) {
        const RotaryPair pair = found.pairs[static_cast<std::size_t>(n)];
        worst = std::max(worst, distance(m.direction(pair), wanted));
        const double off = std::hypot(std::remainder(pair.first - at.first, 360.), std::remainder(pair.second - at.second, 360.));
        is_there = is_there || off < 1e-3;  // near a pole the angle is less exact
      }
      ASSERT_TRUE(is_there) << at.first << " " << at.second;
    }
  EXPECT_LT(worst, 1e-6);
}

TEST(five_axis, places_there_and_back) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> angle(-180, 180), mm(-500, 500);
  for (const FiveAxis& m : machines())
    for (int i = 0; i < 50; ++i) {
      const RotaryPair at{angle(random), angle(random)}, zero{angle(random), angle(random)};
      const Vec3 p{mm(random), mm(random), mm(random)};
      EXPECT_NEAR(distance(m.point_in_part(at, m.point_on_machine(at, p, zero), zero), p), 0, 1e-9);
      EXPECT_NEAR(distance(m.point_on_machine(zero, p, zero), p), 0, 1e-9);  // measured in this position: the point does not move
      EXPECT_NEAR(distance(m.length_vector({}, {0, 0, 120}), {0, 0, 120}), 0, 1e-12);
    }
}

TEST(five_axis, what_no_position_reaches) {
  const FiveAxis nutating = machine(MachineGroup::head_head, z, leaned(z, 30, x));  // tilts the tool by at most 60°
  EXPECT_EQ(nutating.solutions(x).count, 0);
  EXPECT_FALSE(nutating.chosen(x, {}));
  EXPECT_GT(nutating.solutions(unit({1, 0, 1})).count, 0);
}

TEST(five_axis, a_pole_leaves_its_axis_where_it_is) {
  const FiveAxis ca = machine(MachineGroup::head_head, z, x);
  EXPECT_TRUE(ca.solutions(z).first_free);
  const auto pair = ca.chosen(z, {37, 10});
  ASSERT_TRUE(pair);
  EXPECT_EQ(pair->first, 37);
  EXPECT_NEAR(pair->second, 0, 1e-9);
}

/// The example of 25g 3, rules one and two.
TEST(five_axis, the_choice_of_25_11) {
  const FiveAxis cb = machine(MachineGroup::head_head, z, y);
  const auto chosen = [&](Vec3 t, RotaryPair from) { return cb.chosen(unit(t), from).value(); };
  const auto is = [](RotaryPair a, RotaryPair b) { return std::hypot(a.first - b.first, a.second - b.second) < 1e-4; };
  EXPECT_TRUE(is(chosen({0.5, 0, 0.8660254}, {0, 0}), {0, 30}));
  EXPECT_TRUE(is(chosen({1, 0, 1}, {0, 30}), {0, 45}));
  EXPECT_TRUE(is(chosen({0, 1, 1}, {0, 45}), {90, 45}));
  EXPECT_TRUE(is(chosen({-0.5, 0, 0.8660254}, {90, 30}), {180, 30}));
}

TEST(five_axis, limits_choose_the_other_pair_and_another_turn) {
  FiveAxis cb = machine(MachineGroup::head_head, z, y);
  cb.second.least = -120, cb.second.most = 10;
  const auto other = cb.chosen(unit({1, 0, 1}), {0, 0});
  ASSERT_TRUE(other);
  EXPECT_NEAR(other->second, -45, 1e-9);
  cb.first.least = 200, cb.first.most = 600;
  const auto turn = cb.chosen(unit({1, 0, 1}), {300, 0});
  ASSERT_TRUE(turn);
  EXPECT_NEAR(turn->first, 540, 1e-9);
  cb.first.most = 300;
  EXPECT_FALSE(cb.chosen(unit({1, 0, 1}), {250, 0}));
}

RC_GTEST_PROP(five_axis, continued_goes_no_farther_than_the_other_pair, ()) {
  const auto all = machines();
  const FiveAxis& m = all[*rc::gen::inRange<std::size_t>(0, all.size())];
  const RotaryPair at{*rc::gen::inRange(-1800, 1800) / 10., *rc::gen::inRange(-1800, 1800) / 10.};
  const RotaryPair from{*rc::gen::inRange(-7000, 7000) / 10., *rc::gen::inRange(-7000, 7000) / 10.};
  const Vec3 wanted = m.direction(at);
  const auto found = m.continued(wanted, from);
  RC_ASSERT(found.has_value());
  RC_ASSERT(distance(m.direction(*found), wanted) < 1e-6);
  RC_ASSERT(std::fabs(found->first - from.first) <= 180 + 1e-9);
  RC_ASSERT(std::fabs(found->second - from.second) <= 180 + 1e-9);
}

/// Checks all positions of the movable axis in steps of a hundredth of a degree: none comes nearer to the direction.
TEST(five_axis, near_a_pole_the_free_axis_may_stand) {
  for (const FiveAxis& m : machines()) {
    const RotaryPair present{25, -40};
    const Vec3 wanted = unit(m.direction({30, -37}));
    const auto kept = m.with_one_axis_moved(wanted, present);
    ASSERT_TRUE(kept);
    EXPECT_EQ(kept->first_stays, m.group == MachineGroup::head_head);
    EXPECT_EQ(kept->first_stays ? kept->at.first : kept->at.second, kept->first_stays ? present.first : present.second);
    const double off = distance(m.direction(kept->at), wanted);
    EXPECT_NEAR(2 * std::asin(off / 2) / rad_per_deg, kept->off, 1e-6);
    double nearest = 2;
    for (int i = -18000; i < 18000; ++i) {
      const RotaryPair tried = kept->first_stays ? RotaryPair{present.first, i / 100.} : RotaryPair{i / 100., present.second};
      nearest = std::min(nearest, distance(m.direction(tried), wanted));
    }
    EXPECT_LE(off, nearest + 1e-9);
  }
}

}  // namespace
}  // namespace kadr::five_axis_test
