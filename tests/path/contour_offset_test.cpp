// path/compensation/contour_offset: offset vectors at junctions. NCT 15.5: the worked numbers of 15.5.2, and properties of random
// junctions.

#include "path/compensation/contour_offset.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <vector>

#include "base/tolerance.h"

namespace kadr::contour_offset_test {
namespace {

constexpr double left = 1, right = -1;  // G41, G42

/// Elements that end or begin at the origin.
ContourElement line_to(Vec2 direction) { return ContourElement::line(-20 * direction, {}); }
ContourElement line_from(Vec2 direction) { return ContourElement::line({}, 20 * direction); }
ContourElement arc_to(Vec2 center, double turns) {
  return ContourElement::arc(center + rotated(Vec2{} - center, -360 * turns), {}, center, turns);
}
ContourElement arc_from(Vec2 center, double turns) {
  return ContourElement::arc({}, center + rotated(Vec2{} - center, 360 * turns), center, turns);
}
constexpr double g3 = 0.1, g2 = -0.1;

struct Row {
  const char* name;
  ContourElement first, second;
  double side;
  std::vector<Vec2> vectors;
};

void expect_vectors(const Row& row, const std::optional<JunctionVectors>& got) {
  ASSERT_TRUE(got) << row.name;
  ASSERT_EQ(got->count, row.vectors.size()) << row.name;
  for (std::size_t i = 0; i < row.vectors.size(); ++i) {
    EXPECT_NEAR(got->at[i].x, row.vectors[i].x, 1e-6) << row.name << " " << i;
    EXPECT_NEAR(got->at[i].y, row.vectors[i].y, 1e-6) << row.name << " " << i;
  }
}

const ContourElement along_x = line_to({1, 0});

TEST(contour_offset, worked_numbers_of_the_manual) {
  const Row rows[] = {
      {"line/line inside", along_x, line_from({0.6, 0.8}), left, {{-5, 10}}},
      {"line/line obtuse", along_x, line_from({0.6, 0.8}), right, {{5, -10}}},
      {"line/line acute", along_x, line_from({-0.6, 0.8}), right, {{10, -10}, {14, -2}}},
      {"line/line back", along_x, line_from({-1, 0}), right, {{10, -10}, {10, 10}}},
      {"line/arc inside", along_x, arc_from({-15, 20}, g3), left, {{-3.819660113, 10}}},
      {"line/arc obtuse", along_x, arc_from({-15, 20}, g3), right, {{3.333333333, -10}, {6, -8}}},
      {"line/arc acute", along_x, arc_from({-20, -15}, g3), right, {{10, -10}, {14, -2}, {8, 6}}},
      {"arc/line inside", arc_to({-15, 20}, g2), line_from({-1, 0}), right, {{-3.819660113, 10}}},
      {"arc/line obtuse", arc_to({-15, 20}, g2), line_from({-1, 0}), left, {{6, -8}, {3.333333333, -10}}},
      {"arc/line acute", arc_to({-20, -15}, g2), line_from({-1, 0}), left, {{8, 6}, {14, -2}, {10, -10}}},
      {"arc/arc inside", arc_to({0, -25}, g2), arc_from({40, 0}, g2), left, {{-9.226279, 8.762046}}},
      {"arc/arc right angle", arc_to({0, -25}, g2), arc_from({40, 0}, g2), right, {{0, -10}, {10, -10}, {10, 0}}},
      {"arc/arc acute", arc_to({0, -25}, g2), arc_from({-20, -15}, g3), right, {{0, -10}, {10, -10}, {14, -2}, {8, 6}}},
  };
  for (const Row& row : rows) expect_vectors(row, junction(row.first, row.second, 10, row.side));
}

TEST(contour_offset, start_up_and_cancel) {
  const ContourElement up = line_from({0.6, 0.8}), back = line_from({-0.6, 0.8});
  expect_vectors({"start-up inside", along_x, up, left, {{-8, 6}}}, start_up(along_x, up, 10, left));
  expect_vectors({"start-up obtuse", along_x, up, right, {{0, -10}, {5, -10}}}, start_up(along_x, up, 10, right));
  expect_vectors({"start-up acute", along_x, back, right, {{0, -10}, {10, -10}, {14, -2}}}, start_up(along_x, back, 10, right));
  expect_vectors({"cancel inside", along_x, up, left, {{0, 10}}}, cancel(along_x, up, 10, left));
  expect_vectors({"cancel obtuse", along_x, up, right, {{5, -10}, {8, -6}}}, cancel(along_x, up, 10, right));
  expect_vectors({"cancel acute", along_x, back, right, {{10, -10}, {14, -2}, {8, 6}}}, cancel(along_x, back, 10, right));
}

TEST(contour_offset, offsets_that_do_not_meet) {
  EXPECT_FALSE(junction(along_x, arc_from({-3, 4}, g3), 10, left));  // the tool is too large for the inside of R5
  EXPECT_FALSE(intersection(offset_at_end(along_x, 10, left), offset_at_start(line_from({1, 0}), 10, right), {}));
  const auto straight_on = junction(along_x, line_from({1, 0}), 10, left);
  ASSERT_TRUE(straight_on);
  EXPECT_EQ(straight_on->count, 1);
  EXPECT_EQ(straight_on->first(), (Vec2{0, 10}));
}

TEST(contour_offset, a_full_circle_between_two_sides_goes_further_than_round) {  // golden 15-27
  const ContourElement circle = ContourElement::arc({50, 0}, {50, 0}, {0, 0}, 1);
  const double x = std::sqrt(3600.0 - 100);
  EXPECT_NEAR(compensated_turns(circle, {x - 50, -10}, {x - 50, 10}), 1.053300378, 1e-8);
}

// ---- properties

double any_number(int least, int most) { return *rc::gen::inRange(least * 1000, most * 1000 + 1) / 1000.0; }
Vec2 any_direction() { return rotated({1, 0}, any_number(-180, 180)); }

ContourElement any_to() {
  if (*rc::gen::arbitrary<bool>()) return line_to(any_direction());
  return arc_to(any_number(12, 80) * any_direction(), *rc::gen::element(g2, g3));
}
ContourElement any_from() {
  if (*rc::gen::arbitrary<bool>()) return line_from(any_direction());
  return arc_from(any_number(12, 80) * any_direction(), *rc::gen::element(g2, g3));
}

/// Returns the distance of a point from the offset of an element.
double distance_from(const OffsetElement& e, Vec2 point) {
  return e.is_arc ? std::fabs(length(point - e.center) - e.radius) : std::fabs(dot(point, e.normal) - e.distance);
}

RC_GTEST_PROP(contour_offset, an_inside_vector_lies_on_both_offsets_an_outside_path_keeps_the_radius, ()) {
  const ContourElement first = any_to(), second = any_from();
  const double side = *rc::gen::element(left, right), radius = any_number(1, 10);
  const auto vectors = junction(first, second, radius, side);
  const Corner corner = corner_of(first.end, second.start, side);
  if (!vectors) {
    RC_ASSERT(corner == Corner::inside);
    return;
  }
  if (corner == Corner::inside) {
    RC_ASSERT(distance_from(offset_at_end(first, radius, side), vectors->first()) < 10 * tol::same_point);
    RC_ASSERT(distance_from(offset_at_start(second, radius, side), vectors->first()) < 10 * tol::same_point);
    return;
  }
  for (std::size_t i = 0; i + 1 < vectors->count; ++i)
    for (int step = 0; step <= 20; ++step) {
      const Vec2 point = vectors->at[i] + step / 20.0 * (vectors->at[i + 1] - vectors->at[i]);
      RC_ASSERT(length(point) > radius - tol::same_point);
    }
  RC_ASSERT(distance_from(offset_at_end(first, radius, side), vectors->first()) < tol::same_point);
  RC_ASSERT(distance_from(offset_at_start(second, radius, side), vectors->last()) < tol::same_point);
}

RC_GTEST_PROP(contour_offset, turned_or_reversed_the_vectors_follow, ()) {
  const ContourElement first = any_to(), second = any_from();
  const double side = *rc::gen::element(left, right), radius = any_number(1, 10), angle = any_number(-180, 180);
  const auto turn = [&](const ContourElement& e) {
    const Vec2 from = rotated(e.from, angle), to = rotated(e.to, angle);
    return e.is_arc ? ContourElement::arc(from, to, rotated(e.center, angle), e.turns) : ContourElement::line(from, to);
  };
  const auto reverse = [&](const ContourElement& e) {
    return e.is_arc ? ContourElement::arc(e.to, e.from, e.center, -e.turns) : ContourElement::line(e.to, e.from);
  };
  const auto plain = junction(first, second, radius, side);
  const auto turned = junction(turn(first), turn(second), radius, side);
  const auto back = junction(reverse(second), reverse(first), radius, -side);
  RC_PRE(std::fabs(cross(first.end, second.start)) > 1e-4 && std::fabs(dot(first.end, second.start)) > 1e-4);  // away from the limits
  RC_ASSERT(plain.has_value() == turned.has_value());
  RC_ASSERT(plain.has_value() == back.has_value());
  if (!plain) return;
  RC_ASSERT(plain->count == turned->count && plain->count == back->count);
  for (std::size_t i = 0; i < plain->count; ++i) {
    RC_ASSERT(length(rotated(plain->at[i], angle) - turned->at[i]) < 1e-6);
    RC_ASSERT(length(plain->at[i] - back->at[plain->count - 1 - i]) < 1e-6);
  }
}

RC_GTEST_PROP(contour_offset, the_way_onto_a_contour_touches_its_line, ()) {
  const auto any = [](int least, int most) { return *rc::gen::inRange(least * 1000, most * 1000) / 1000.0; };
  const double side = *rc::gen::element(1.0, -1.0), radius = any(1, 5);
  const Vec2 travel = rotated(Vec2{radius + any(1, 50), 0}, any(0, 360));
  const auto along = entry_direction(travel, radius, side);
  RC_ASSERT(along.has_value());
  RC_ASSERT(std::fabs(length(*along) - 1) < tol::same_point);
  const Vec2 end = travel + radius * side_normal(*along, side);
  RC_ASSERT(std::fabs(cross(end, *along)) < tol::same_point);  // the path goes straight to the point …
  RC_ASSERT(side * cross(*along, travel) < 0);                 // … with the point on its other side
}

TEST(contour_offset, no_way_onto_a_contour_within_the_tool) {
  EXPECT_FALSE(entry_direction({5, 0}, 5, 1));
  EXPECT_FALSE(entry_direction({0, 0}, 5, 1));
}

TEST(contour_offset, joined_inside_and_outside) {
  const auto first = ContourElement::line({0, 0}, {30, 0});
  const auto down = ContourElement::line({30, 0}, {30, -30}), up = ContourElement::line({30, 0}, {30, 30});
  const auto arc = joined(first, down, 5, 1, CornerJoin::arc);
  ASSERT_TRUE(arc && arc->round && arc->count == 2);
  EXPECT_NEAR(arc->last().x, 5, tol::same_point);
  const auto lines = joined(first, down, 5, 1, CornerJoin::straight);
  ASSERT_TRUE(lines && !lines->round && lines->count == 1);
  EXPECT_NEAR(lines->first().x, 5, tol::same_point);
  EXPECT_NEAR(lines->first().y, 5, tol::same_point);
  for (const CornerJoin join : {CornerJoin::arc, CornerJoin::straight}) {
    const auto inside = joined(first, up, 5, 1, join);
    ASSERT_TRUE(inside && inside->count == 1);
    EXPECT_NEAR(inside->first().x, -5, tol::same_point);
    EXPECT_NEAR(inside->first().y, 5, tol::same_point);
  }
  EXPECT_FALSE(joined(first, ContourElement::line({30, 0}, {0, 0}), 5, 1, CornerJoin::straight));
}

TEST(contour_offset, what_fits) {
  const auto line = ContourElement::line({0, 0}, {8, 0});
  EXPECT_TRUE(fits(line, {5, 5}, {3, 5}, 5, 1));
  EXPECT_FALSE(fits(line, {5, 5}, {-5, 5}, 5, 1));
  const auto arc = ContourElement::arc({0, 0}, {10, 10}, {0, 10}, 0.25);
  EXPECT_TRUE(fits(arc, {0, 9}, {-9, 0}, 9, 1));
  EXPECT_FALSE(fits(arc, {0, 10}, {-10, 0}, 10, 1));
  EXPECT_TRUE(fits(arc, {0, -20}, {20, 0}, 20, -1));
}

}  // namespace
}  // namespace kadr::contour_offset_test
