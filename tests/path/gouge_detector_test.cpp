// path/compensation/gouge_detector, path/compensation/contour_closing: the warnings about closed contours, compared with a slow reference
// that sweeps the tool over the part.

#include <gtest/gtest.h>

#include <iostream>

#include "closed_contours.h"
#include "path/compensation/contour_closing.h"

namespace kadr::gouge_detector_test {
namespace {

using test::ClosedContour;
using test::ContourMaker;
using test::Style;

constexpr std::size_t styles = static_cast<std::size_t>(Style::count);

struct Tally {
  int alarms = 0, good = 0, false_ones = 0, bad = 0, missed = 0;
};

/// The sampled reference is accurate to a few hundredths of a millimetre;
/// depths between these two limits count neither as a cut nor as none.
constexpr double certain_cut = 0.05, certainly_none = 1e-3;

Tally tally(bool slender, int contours, Style style, std::uint64_t first_seed) {
  Tally t;
  for (int i = 0; i < contours; ++i) {
    const std::uint64_t seed = first_seed + static_cast<std::uint64_t>(i);
    const ClosedContour contour = ContourMaker(seed).any(slender);
    const test::WatchedRun run = test::carried_out(contour, style);
    if (run.alarm) {
      ++t.alarms;
      continue;
    }
    const double depth = test::true_cut(contour, run);
    if (depth > certain_cut) {
      ++t.bad;
      if (run.reported == 0 && ++t.missed < 5) std::cout << "missed: seed " << seed << " depth " << depth << '\n';
    } else if (depth < certainly_none) {
      ++t.good;
      if (run.reported > 0 && ++t.false_ones < 5)
        std::cout << "false: seed " << seed << " told " << run.reported << " twin " << depth << '\n';
    }
  }
  return t;
}

void expect_true(bool slender, int contours, std::uint64_t first_seed) {
  for (std::size_t s = 0; s < styles; ++s) {
    const Tally t = tally(slender, contours, static_cast<Style>(s), first_seed);
    std::cout << "style " << s << ": " << t.good << " good, " << t.false_ones << " of them with a warning; " << t.bad
              << " that cut into the part, " << t.missed << " of them without; " << t.alarms << " refused\n";
    EXPECT_LE(t.false_ones * 100, t.good);
    EXPECT_EQ(t.missed, 0);
  }
}

TEST(gouge_detector, at_most_one_good_contour_in_a_hundred_is_told) { expect_true(false, 200, 1); }
TEST(gouge_detector, no_cut_is_missed_where_the_tool_is_too_large) { expect_true(true, 200, 5001); }

// ---- position where a contour closes

std::vector<PlanePiece> lines(std::initializer_list<Vec2> points) {
  std::vector<PlanePiece> pieces;
  for (auto p = points.begin(); p + 1 != points.end(); ++p) pieces.push_back(PlanePiece::line(p[0], p[1]));
  return pieces;
}

void expect_loop(const std::vector<PlanePiece>& pieces, std::size_t first, double first_part, std::size_t last, double last_part) {
  const auto loop = closing(pieces, 0);
  ASSERT_TRUE(loop);
  // The end of one segment is the same position as the beginning of the next.
  EXPECT_NEAR(double(loop->first) + loop->first_part, double(first) + first_part, 1e-9);
  EXPECT_NEAR(double(loop->last) + loop->last_part, double(last) + last_part, 1e-9);
}

TEST(contour_closing, along_the_extensions_of_two_sides) {  // examples/nct/cam_plate.nct
  expect_loop(lines({{0, -10}, {0, 30}, {40, 30}, {40, 0}, {-10, 0}}), 0, 0.25, 3, 0.8);
}

TEST(contour_closing, a_corner_without_run_in_or_out) { expect_loop(lines({{0, 0}, {0, 30}, {40, 30}, {40, 0}, {0, 0}}), 0, 0, 3, 1); }

TEST(contour_closing, lines_to_a_point_and_away_from_it) {
  expect_loop(lines({{-10, 15}, {0, 15}, {0, 30}, {40, 30}, {40, 0}, {0, 0}, {0, 15}, {-10, 15}}), 1, 0, 5, 1);
}

TEST(contour_closing, over_the_beginning_all_that_overlaps_belongs_to_it) {
  expect_loop(lines({{-10, 15}, {0, 15}, {0, 30}, {40, 30}, {40, 0}, {0, 0}, {0, 20}, {-10, 20}}), 1, 0, 5, 1);
}

TEST(contour_closing, run_in_and_run_out_that_meet_before_the_part_too) {
  // In from the upper left, out to the lower left, then up across the approach.
  expect_loop(lines({{-30, 15}, {0, 15}, {0, 30}, {40, 30}, {40, 0}, {0, 0}, {0, 15}, {-10, 5}, {-10, 25}}), 1, 0, 5, 1);
}

TEST(contour_closing, a_circle_is_closed_by_its_own_end) {
  std::vector<PlanePiece> pieces{PlanePiece::arc({-10, 10}, {0, 0}, {0, 10}, 0.25), PlanePiece::arc({0, 0}, {0, 0}, {0, 30}, 1),
                                 PlanePiece::arc({0, 0}, {10, 10}, {0, 10}, 0.25)};
  expect_loop(pieces, 1, 0, 1, 1);
}

TEST(contour_closing, an_open_contour_has_no_loop) {
  EXPECT_FALSE(closing(lines({{0, 0}, {0, 30}, {40, 30}, {40, 10}}), 0));
  // A knot of 40 mm in a path of 400 mm.
  EXPECT_FALSE(closing(lines({{0, 0}, {180, 0}, {180, 10}, {170, 10}, {170, -10}, {170, -190}}), 0));
  EXPECT_FALSE(closing({}, 0));
}

TEST(contour_closing, what_is_cut_out_of_a_piece) {
  const PlanePiece line = cut_out(PlanePiece::line({0, 0}, {8, 0}), 0.25, 1);
  EXPECT_NEAR(line.from.x, 2, 1e-12);
  EXPECT_EQ(line.to.x, 8);
  const PlanePiece arc = cut_out(PlanePiece::arc({10, 0}, {-10, 0}, {0, 0}, 0.5), 0.5, 1);
  EXPECT_NEAR(arc.from.y, 10, 1e-12);
  EXPECT_NEAR(arc.turns, 0.25, 1e-12);
}

// ---- contours longer than the buffer

/// Follows a polygon of `sides` sides around a circle with a tool of radius 5 outside, entered and left along the extensions of two
/// sides. `notch` is the side with a slot 4 mm wide and 8 mm deep, too narrow for the tool.
double reported_for_polygon(int sides, int notch) {
  constexpr double tool = 5;
  const double radius = 4.0 * sides / pi;  // sides of 8 mm
  const auto corner = [&](int i) { return rotated({radius, 0}, -360.0 * i / sides); };
  std::vector<Vec2> at{corner(0) - 20 / length(corner(1) - corner(0)) * (corner(1) - corner(0))};
  for (int i = 1; i <= sides; ++i) {
    at.push_back(corner(i));
    if (i != notch) continue;
    const Vec2 side = corner(i + 1) - corner(i), in = -8 / length(corner(i)) * corner(i);
    for (const Vec2 p : {0.25 * side, 0.25 * side + in, 0.75 * side + in, 0.75 * side}) at.push_back(corner(i) + p);
  }
  at.back() = at.back() + 20 / length(corner(0) - corner(-1)) * (corner(0) - corner(-1));
  RadiusCompensation compensation{ToolPosition{{radius + 60, 40}, {radius + 60, 40}}};
  double reported = 0;
  for (std::size_t i = 0; i <= at.size(); ++i) {
    Motion m = test::straight(MotionKind::feed, {i < at.size() ? at[i].x : radius + 60, i < at.size() ? at[i].y : -40, 0});
    m.named = 3;
    m.side = 1;
    m.tool_radius = tool;
    m.side_step = i == 0 ? SideStep::begins : i == at.size() ? SideStep::ends : SideStep::none;
    ActionBatch batch;
    batch.add() = test::action(m, static_cast<std::uint32_t>(i + 1));
    EXPECT_FALSE(compensation.take(batch, i == at.size()));
    for (const CompensationFault& w : compensation.warnings()) {
      reported = std::max(reported, w.alarm.args[0].number());
      EXPECT_GT(w.other.line, 0u);
    }
  }
  return reported;
}

TEST(gouge_detector, run_in_and_run_out_of_a_long_contour) {
  for (const int sides : {30, 47, 48, 49, 95, 96, 97, 200}) EXPECT_EQ(reported_for_polygon(sides, 0), 0) << sides;
}

TEST(gouge_detector, a_notch_anywhere_in_a_long_contour) {
  for (const int sides : {30, 60, 97, 200})
    for (const int notch : {1, 2, 20, sides / 2, sides - 3, sides - 1})
      EXPECT_GT(reported_for_polygon(sides, notch), 0.5) << sides << ' ' << notch;
}

}  // namespace
}  // namespace kadr::gouge_detector_test
