// control: properties of every path: rotated, mirrored, divided, in
// inches, in increments, from another origin. Mach3 10.7; spec mach3 4.

#include "control/random_path.h"
#include "control/run_program.h"

namespace kadr::properties_test {
namespace {

using namespace test;

constexpr double near = 1e-9;  // mm
const std::string start = "G21 F100\n";

MotionKind opposite(MotionKind kind) {
  return kind == MotionKind::arc_cw ? MotionKind::arc_ccw : kind == MotionKind::arc_ccw ? MotionKind::arc_cw : kind;
}
Vec3 point(const Axes& a) { return {a[0], a[1], a[2]}; }
/// Returns the centre in space; its coordinate normal to the arc's plane is 0.
Vec3 center_of(const Motion& m) {
  Axes center{};
  center[m.first] = m.center.x, center[m.second] = m.center.y;
  return point(center);
}
/// Returns `p` with its coordinate normal to the arc's plane set to 0.
Vec3 in_plane(Vec3 p, const Motion& m) {
  const Axes all{p.x, p.y, p.z};
  Axes kept{};
  kept[m.first] = all[m.first], kept[m.second] = all[m.second];
  return point(kept);
}
bool same_point(Vec3 a, Vec3 b, double within) { return length(a - b) <= within; }

std::vector<Motion> motions_of(const std::string& program, const Setup& setup = {}) {
  const Run r = run("mach3", program, setup);
  if (!r.alarms.empty()) RC_FAIL(program + "line " + std::to_string(r.alarms[0].origin.line) + ": " + r.first_alarm());
  return r.motions();
}

/// Checks that each motion equals the other, with points changed by `moved` and the arc direction by `turned`.
template <class Moved, class Turned>
void expect_same(const std::vector<Motion>& one, const std::vector<Motion>& other, Moved moved, Turned turned, double within = near) {
  RC_ASSERT(one.size() == other.size());
  for (std::size_t i = 0; i < one.size(); ++i) {
    RC_ASSERT(other[i].kind == turned(one[i].kind));
    RC_ASSERT(same_point(moved(point(one[i].to)), point(other[i].to), within));
    RC_ASSERT(std::fabs(one[i].turns - other[i].turns) <= within);
    if (!is_arc(one[i].kind)) continue;
    RC_ASSERT(one[i].first == other[i].first && one[i].second == other[i].second);
    RC_ASSERT(same_point(in_plane(moved(center_of(one[i])), other[i]), center_of(other[i]), within * 1e3));  // less exact by R
  }
}
const auto as_it_is = [](auto x) { return x; };

RC_GTEST_PROP(path, is_followed, ()) {
  Choices choose = choices(300);
  const Path path = random_path(choose, 3);
  const std::vector<Motion> motions = motions_of(start + written(path));
  RC_ASSERT(motions.size() == path.size());
  Axes at{};
  for (std::size_t i = 0; i < path.size(); ++i) {
    RC_ASSERT(motions[i].kind == path[i].kind);
    RC_ASSERT(same_point(point(motions[i].to), point(path[i].to), near));
    if (is_arc(path[i].kind)) {
      RC_ASSERT(motions[i].first == first_axis(path[i].plane) && motions[i].second == second_axis(path[i].plane));
      RC_ASSERT(same_point(center_of(motions[i]), in_plane(point(path[i].center), motions[i]), 1e-6));
      RC_ASSERT((motions[i].turns > 0.5 + 1e-9) == path[i].long_arc);
    }
    at = path[i].to;
  }
}

RC_GTEST_PROP(path, in_increments_is_the_same, ()) {
  Choices choose = choices(300);
  const Path path = random_path(choose, 3);
  const auto absolute = motions_of(start + written(path));
  expect_same(absolute, motions_of(start + written(path, {Dimensions::incremental})), as_it_is, as_it_is);
  expect_same(absolute, motions_of(start + written(path, {Dimensions::mixed}, &choose)), as_it_is, as_it_is);
}

RC_GTEST_PROP(path, by_radius_is_that_by_centre, ()) {
  Choices choose = choices(300);
  const Path path = random_path(choose, 3);
  expect_same(motions_of(start + written(path)), motions_of(start + written(path, {Dimensions::absolute, 1, 12, false})), as_it_is,
              as_it_is);
}

RC_GTEST_PROP(path, in_inches_is_the_same, ()) {
  Choices choose = choices(300);
  const Path path = random_path(choose, 3);
  const auto inches = motions_of("G20 F" + std::to_string(100 / 25.4) + "\n" + written(path, {Dimensions::mixed, 25.4}, &choose));
  expect_same(motions_of(start + written(path)), inches, as_it_is, as_it_is, 1e-6);
}

RC_GTEST_PROP(path, from_another_zero_only_the_machine_differs, ()) {
  Choices choose = choices(300);
  const Path path = random_path(choose, 3);
  const AxisValues offset{{"X", choose.between(-500, 500) / 8.0}, {"Y", choose.between(-500, 500) / 8.0}, {"Z", 12.5}};
  Setup shifted;
  shifted.work_offsets["G54"] = offset;
  shifted.start_in_work = true;
  const auto here = motions_of(start + written(path, {Dimensions::mixed}, &choose));
  const auto there = motions_of(start + written(path), shifted);
  expect_same(here, there, as_it_is, as_it_is);
  const Vec3 by{offset.at("X"), offset.at("Y"), offset.at("Z")};
  for (std::size_t i = 0; i < here.size(); ++i) RC_ASSERT(same_point(point(here[i].machine) + by, point(there[i].machine), near));
}

RC_GTEST_PROP(path, turned_by_G68_is_the_path_turned, ()) {
  Choices choose = choices(300);
  const Path path = random_path(choose, 1);
  const double angle = choose.below(2) == 0 ? 90.0 * choose.between(-4, 4) : choose.between(-180'000, 180'000) / 1000.0;
  const Vec2 pole{choose.between(-50, 50) / 4.0, choose.between(-50, 50) / 4.0};
  const std::string turn =
      "G0 G90 X0 Y0 Z0\nG68 A" + std::to_string(pole.x) + " B" + std::to_string(pole.y) + " R" + std::to_string(angle) + "\nG0 X0 Y0 Z0\n";
  auto turned = motions_of(start + turn + written(path, {Dimensions::mixed}, &choose));
  turned.erase(turned.begin(), turned.begin() + 2);
  const auto rotate = [&](Vec3 p) {
    const Vec2 q = pole + rotated(Vec2{p.x, p.y} - pole, angle);
    return Vec3{q.x, q.y, p.z};
  };
  expect_same(motions_of(start + written(path)), turned, rotate, as_it_is);
}

RC_GTEST_PROP(path, mirrored_by_G51_is_the_path_mirrored_with_its_arcs_opposed, ()) {
  Choices choose = choices(300);
  const Path path = random_path(choose, 3);
  const std::size_t axis = choose.below(3);
  const std::string mirror = std::string("G51 ") + "XYZ"[axis] + "-1\n";
  const auto mirrored = motions_of(start + mirror + written(path, {Dimensions::mixed}, &choose));
  const auto plain = motions_of(start + written(path));
  RC_ASSERT(plain.size() == mirrored.size());
  for (std::size_t i = 0; i < plain.size(); ++i) {
    Vec3 to = point(plain[i].to), center = center_of(plain[i]);
    (axis == 0 ? to.x : axis == 1 ? to.y : to.z) *= -1;
    (axis == 0 ? center.x : axis == 1 ? center.y : center.z) *= -1;
    const bool opposed = is_arc(plain[i].kind) && (axis == plain[i].first || axis == plain[i].second);
    RC_ASSERT(mirrored[i].kind == (opposed ? opposite(plain[i].kind) : plain[i].kind));
    RC_ASSERT(same_point(point(mirrored[i].to), to, near));
    if (is_arc(plain[i].kind)) RC_ASSERT(same_point(center_of(mirrored[i]), center, near));
    RC_ASSERT(std::fabs(mirrored[i].turns - plain[i].turns) <= near);
  }
}

RC_GTEST_PROP(path, scaled_by_G51_is_as_much_longer, ()) {
  Choices choose = choices(300);
  const Path path = random_path(choose, 3);
  const double factor = choose.between(1, 80) / 8.0;
  const std::string words = std::to_string(factor);
  const auto scaled =
      motions_of(start + "G51 X" + words + " Y" + words + " Z" + words + "\n" + written(path, {Dimensions::mixed}, &choose));
  expect_same(
      motions_of(start + written(path)), scaled, [&](Vec3 p) { return factor * p; }, as_it_is, near * 10);
}

RC_GTEST_PROP(path, with_its_lines_split_has_the_same_ends_and_length, ()) {
  Choices choose = choices(300);
  const Path path = random_path(choose, 3);
  Path split;
  Axes at{};
  for (const Piece& p : path) {
    if (!is_arc(p.kind)) {
      Piece half = p;
      for (std::size_t a = 0; a < 3; ++a) half.to[a] = at[a] + (p.to[a] - at[a]) * 0.375;
      split.push_back(half);
    }
    split.push_back(p);
    at = p.to;
  }
  const auto total = [](const std::vector<Motion>& motions) {
    double sum = 0;
    Axes from{};
    for (const Motion& m : motions) sum += path_length(m, from), from = m.to;
    return sum;
  };
  const auto whole = motions_of(start + written(path));
  const auto parts = motions_of(start + written(split));
  RC_ASSERT(same_point(point(whole.back().to), point(parts.back().to), near));
  RC_ASSERT(std::fabs(total(whole) - total(parts)) <= 1e-6);
}

RC_GTEST_PROP(path, carried_out_twice_is_the_same_bit_by_bit, ()) {
  Choices choose = choices(300);
  const std::string program = start + written(random_path(choose, 3), {Dimensions::mixed}, &choose);
  RC_ASSERT(exactly(run("mach3", program).actions) == exactly(run("mach3", program).actions));
}

// ---- the same for codes that generate motions of their own

TEST(circular_pocket, mirrored_turns_the_other_way) {
  const auto plain = motions_of("G21 F100\nG12 I5\n");
  const auto mirrored = motions_of("G21 F100\nG51 X-1\nG12 I5\n");
  ASSERT_EQ(plain.size(), 3u);
  ASSERT_EQ(mirrored.size(), 3u);
  EXPECT_EQ(plain[1].kind, MotionKind::arc_cw);
  EXPECT_EQ(mirrored[1].kind, MotionKind::arc_ccw);
  EXPECT_EQ(mirrored[1].to[0], -5);
}

TEST(circular_pocket, with_unequal_scales_is_an_alarm) {  // an arc becomes an ellipse: see ellipse_test
  EXPECT_EQ(run("mach3", "G21 F100\nG51 X2 Y1\nG12 I5\n").first_alarm(), "not_together");
}

TEST(rotation, is_of_the_XY_plane_only) {  // Mach3 10.7.20
  EXPECT_EQ(run("mach3", "G21 F100\nG18\nG68 A0 B0 R30\n").first_alarm(), "plane_wrong");
  EXPECT_EQ(run("mach3", "G21 F100\nG68 A0 B0 R30\nG18 G2 X10 I5\n").first_alarm(), "plane_wrong");
}

}  // namespace
}  // namespace kadr::properties_test
