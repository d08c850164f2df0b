// control/fanuc/frames/transformations: under G51.1, G51 and G68 every program follows the original path with each point mapped. The
// maps are composed in the order in which they were switched on, and arcs are reversed where the plane is mirrored. NCT 16.

#include <functional>

#include "control/random_path.h"
#include "control/run_program.h"
#include "control/state/control_state.h"

namespace kadr::transformations_test {
namespace {

using namespace test;

constexpr double near = 1e-8;         // mm; numbers are written with 12 decimals and pass through several maps
constexpr double near_center = 1e-5;  // mm; for arcs by R
const std::string start = "G21 G90 F100\n";

using Map = std::function<Vec3(Vec3)>;

Vec3 point(const Axes& a) { return {a[0], a[1], a[2]}; }

kadr::Setup setup() {
  kadr::Setup s;
  s.parameters[*parameter_key("N1339")] = 0.01;
  return s;
}

std::vector<Motion> motions_of(const std::string& program) {
  const test::Run r = run("nct", program, setup());
  if (!r.alarms.empty()) RC_FAIL(program + "line " + std::to_string(r.alarms[0].origin.line) + ": " + r.first_alarm());
  return r.motions();
}

std::string word(const char* name, double value) {
  char text[64];
  std::snprintf(text, sizeof text, " %s%.9f", name, value);
  return text;
}

/// A transformation: the block that switches it on, its effect on a point, and the block that ends it.
struct Switch {
  std::string on, off;
  Map map;
  bool reverses = false;
};

Switch rotation(Choices& choose) {
  const double angle = choose.below(2) == 0 ? 90.0 * choose.between(-4, 4) : choose.between(-180'000, 180'000) / 1000.0;
  const Vec2 pole{choose.between(-50, 50) / 4.0, choose.between(-50, 50) / 4.0};
  return {"G17 G68" + word("X", pole.x) + word("Y", pole.y) + word("R", angle), "G69", [=](Vec3 p) {
            const Vec2 q = pole + rotated(Vec2{p.x, p.y} - pole, angle);
            return Vec3{q.x, q.y, p.z};
          }};
}

/// Scales all axes by the same magnitude, each with a sign of its own: circles stay circles.
Switch scaling(Choices& choose) {
  const double factor = choose.between(1, 40) / 8.0;
  const Vec3 c{choose.between(-50, 50) / 4.0, choose.between(-50, 50) / 4.0, choose.between(-50, 50) / 4.0};
  const std::string center = word("X", c.x) + word("Y", c.y) + word("Z", c.z);
  Vec3 by{factor, factor, factor};
  std::string factors = word("P", factor);
  if (choose.below(2) == 1) {
    for (double* one : {&by.x, &by.y, &by.z})
      if (choose.below(2) == 1) *one = -factor;
    factors = word("I", by.x) + word("J", by.y) + word("K", by.z);
  }
  return {"G51" + center + factors, "G50",
          [=](Vec3 p) {
            return Vec3{c.x + by.x * (p.x - c.x), c.y + by.y * (p.y - c.y), c.z + by.z * (p.z - c.z)};
          },
          by.x * by.y < 0};
}

Switch mirror(Choices& choose) {
  const double x = choose.between(-50, 50) / 4.0;
  return {"G51.1" + word("X", x), "G50.1 X0", [=](Vec3 p) { return Vec3{2 * x - p.x, p.y, p.z}; }, true};
}

/// Checks that the motions of `path` under the switches are the plain motions with each point mapped by `map`.
void expect_mapped(const Path& path, const std::string& before, const Map& map, bool reversed, Choices& choose) {
  const std::vector<Motion> plain = motions_of(start + "G0 X0 Y0 Z0\n" + written(path));
  const std::vector<Motion> moved = motions_of(start + before + "G90 G0 X0 Y0 Z0\n" + written(path, {Dimensions::mixed}, &choose));
  RC_ASSERT(plain.size() == moved.size());
  const double size = 1 + length(map({1, 0, 0}) - map({0, 0, 0}));
  for (std::size_t i = 0; i < plain.size(); ++i) {
    const bool arc = plain[i].turns != 0;
    const MotionKind opposed = plain[i].kind == MotionKind::arc_cw ? MotionKind::arc_ccw : MotionKind::arc_cw;
    RC_ASSERT(moved[i].kind == (arc && reversed ? opposed : plain[i].kind));
    RC_ASSERT(length(map(point(plain[i].to)) - point(moved[i].to)) <= near * size);
    RC_ASSERT(std::fabs(plain[i].turns - moved[i].turns) <= near);
    if (!arc) continue;
    const Vec3 center = map({plain[i].center.x, plain[i].center.y, plain[i].to[2]});
    RC_ASSERT(length(Vec2{center.x, center.y} - moved[i].center) <= near_center * size);
  }
}

RC_GTEST_PROP(transformations, compose_in_the_order_of_switching_on, ()) {
  Choices choose = choices(300);
  std::vector<Switch> on;
  if (choose.below(2) == 1) on.push_back(mirror(choose));
  const bool rotation_first = choose.below(2) == 1;
  if (rotation_first) on.push_back(rotation(choose));
  if (choose.below(2) == 1) on.push_back(scaling(choose));
  if (!rotation_first) on.push_back(rotation(choose));
  std::string before;
  bool reversed = false;
  for (const Switch& s : on) before += s.on + "\n", reversed = reversed != s.reverses;
  const Map all = [&](Vec3 p) {
    for (auto s = on.rbegin(); s != on.rend(); ++s) p = s->map(p);
    return p;
  };
  expect_mapped(random_path(choose, 1), before, all, reversed, choose);
}

RC_GTEST_PROP(transformations, come_and_go_without_a_trace, ()) {
  Choices choose = choices(300);
  const Switch outer = mirror(choose), second = scaling(choose), inner = rotation(choose);
  const std::string before = outer.on + "\n" + second.on + "\n" + inner.on + "\n" + inner.off + "\n" + second.off + "\n" + outer.off + "\n";
  expect_mapped(
      random_path(choose, 1), before, [](Vec3 p) { return p; }, false, choose);
}

RC_GTEST_PROP(transformations, four_right_angles_are_none, ()) {
  Choices choose = choices(300);
  const std::string quarter = "G68 X3 Y4 RI90\n";
  expect_mapped(
      random_path(choose, 1), "G68 X3 Y4 R90\n" + quarter + quarter + quarter, [](Vec3 p) { return p; }, false, choose);
}

RC_GTEST_PROP(transformations, mirrored_twice_is_as_programmed, ()) {
  Choices choose = choices(300);
  expect_mapped(
      random_path(choose, 1), "G51.1 X7\nG51 X7 I-1 J1 K1\n", [](Vec3 p) { return p; }, false, choose);
}

RC_GTEST_PROP(transformations, scaled_by_p_a_program_divided_by_p_is_the_program, ()) {
  Choices choose = choices(300);
  const Path path = random_path(choose, 3);
  const double factor = choose.between(1, 40) / 8.0;
  const auto plain = motions_of(start + written(path));
  const auto scaled = motions_of(start + "G51 X0 Y0 Z0" + word("P", factor) + "\n" + written(path, {Dimensions::absolute, factor}));
  RC_ASSERT(plain.size() == scaled.size());
  for (std::size_t i = 0; i < plain.size(); ++i) {
    RC_ASSERT(plain[i].kind == scaled[i].kind);
    RC_ASSERT(length(point(plain[i].to) - point(scaled[i].to)) <= near);
    RC_ASSERT(length(plain[i].center - scaled[i].center) <= near_center);
  }
}

/// Switching on does not move the tool, and a following increment in G91 is transformed by the linear part alone.
RC_GTEST_PROP(transformations, an_increment_behind_the_switch_is_mapped_from_where_the_tool_stands, ()) {
  Choices choose = choices(60);
  const Switch s = choose.below(2) == 0 ? rotation(choose) : scaling(choose);
  const Vec3 at{choose.between(-50, 50) / 4.0, choose.between(-50, 50) / 4.0, 1}, by{choose.between(1, 50) / 4.0, 2.5, -1};
  const auto motions = motions_of(start + "G0" + word("X", at.x) + word("Y", at.y) + word("Z", at.z) + "\n" + s.on + "\nG91" +
                                  word("X", by.x) + word("Y", by.y) + word("Z", by.z) + "\n");
  RC_ASSERT(motions.size() == 2U);
  const Vec3 shift = s.map(by) - s.map({});
  RC_ASSERT(length(point(motions[1].to) - (at + shift)) <= near);
}

// ---- the map itself

RC_GTEST_PROP(transform, back_is_the_inverse_and_directions_keep_their_length, ()) {
  Choices choose = choices(60);
  Transform t;
  for (std::size_t a = 0; a < 3; ++a) {
    t.scale[a] = choose.between(1, 40) / (choose.below(2) == 0 ? 8.0 : -8.0);
    t.scale_shift[a] = choose.between(-50, 50) / 4.0;
    t.mirror[a] = choose.below(2) == 0 ? std::int8_t{1} : std::int8_t{-1};
    t.added[a] = choose.between(-50, 50) / 4.0;
  }
  t.rotation = choose.between(-360'000, 360'000) / 1000.0;
  t.rotation_center = {choose.between(-50, 50) / 4.0, choose.between(-50, 50) / 4.0};
  t.turned_last = choose.below(2) == 0;
  t.refresh();
  Axes p{};
  for (std::size_t a = 0; a < 3; ++a) p[a] = choose.between(-1000, 1000) / 8.0;
  RC_ASSERT(length(point(t.to_programmed(t.to_work(p))) - point(p)) <= near);
  const PlaneAxes plane = axes_of(Plane::xy);
  const Vec2 a{3, 4}, b{-1, 2};
  RC_ASSERT(std::fabs(length(t.direction(a, plane)) - 5) <= near);
  const double turned = cross(t.direction(a, plane), t.direction(b, plane));
  RC_ASSERT(std::fabs(turned - (t.reverses(plane) ? -cross(a, b) : cross(a, b))) <= near);
}

TEST(transform, lengths_of_a_plane) {  // NCT 16.2
  Transform t;
  t.scale[0] = 0.5;
  t.scale[1] = -0.75;
  t.scale[2] = 1.25;
  t.refresh();
  EXPECT_EQ(t.corner_scale(axes_of(Plane::xy)), 0.625);
  EXPECT_EQ(t.corner_scale(axes_of(Plane::zx)), 0.875);
  EXPECT_EQ(t.radius_scale(axes_of(Plane::xy)), 0.5);
  EXPECT_EQ(t.radius_scale(axes_of(Plane::zx)), 1.25);
  EXPECT_EQ(t.radius_scale(axes_of(Plane::yz)), 0.75);
  EXPECT_TRUE(t.distorts(axes_of(Plane::xy)));
  EXPECT_TRUE(t.reverses(axes_of(Plane::xy)));
  EXPECT_FALSE(t.reverses(axes_of(Plane::zx)));
}

TEST(transform, a_rotation_leaves_the_planes_that_share_one_axis_with_it) {
  Transform t;
  t.rotation = 30;
  t.refresh();
  EXPECT_FALSE(t.leaves(axes_of(Plane::xy)));
  EXPECT_TRUE(t.leaves(axes_of(Plane::zx)));
  EXPECT_TRUE(t.leaves(axes_of(Plane::yz)));
  EXPECT_FALSE(t.leaves({3, 4, 2}));
  EXPECT_EQ(t.moved_with(1U), 3U);
  EXPECT_EQ(t.moved_with(4U), 4U);
}

}  // namespace
}  // namespace kadr::transformations_test
