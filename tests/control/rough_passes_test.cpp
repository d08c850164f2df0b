// The passes of G71, G72 and G73, by the numbers of the golden cases of fanuc-t (spec/fanuc-t 9.2 to 9.5), and the faults of a figure.

#include "control/fanuc/lathe/rough_passes.h"

#include <gtest/gtest.h>

#include <cmath>
#include <sstream>
#include <string>

#include "base/tolerance.h"

namespace kadr::rough_passes_test {
namespace {

using fanuc::ContourPiece;
using fanuc::FigureFault;
using fanuc::PatternPasses;
using fanuc::RoughFigure;
using fanuc::RoughPasses;
using fanuc::RoughStep;

/// Motions as text: `R 21 2; F 21 -20; W 20 -45 20 -40`. Rapid, feed, arc clockwise or counter-clockwise (C) to a radius X and a Z; the
/// centre of an arc follows.
std::vector<ContourPiece> motions(const std::string& text, Vec2 from) {
  std::vector<ContourPiece> pieces;
  std::istringstream all(text);
  for (std::string one; std::getline(all, one, ';');) {
    std::istringstream words(one);
    char kind = 0;
    ContourPiece piece;
    words >> kind >> piece.to.y >> piece.to.x >> piece.center.y >> piece.center.x;
    piece.from = from;
    piece.kind = kind == 'R' ? MotionKind::rapid : kind == 'F' ? MotionKind::feed : kind == 'W' ? MotionKind::arc_cw : MotionKind::arc_ccw;
    if (piece.is_arc()) {
      const double turn = angle_deg(piece.to - piece.center) - angle_deg(from - piece.center);
      piece.turns = std::fmod((kind == 'C' ? turn : -turn) + 720, 360) / 360;
    }
    pieces.push_back(piece);
    from = piece.to;
  }
  return pieces;
}

template <class Passes>
std::vector<ContourPiece> all_of(Passes passes) {
  std::vector<ContourPiece> pieces;
  while (const auto step = passes.next())
    if (length(step->motion.to - step->motion.from) > tol::level) pieces.push_back(step->motion);
  return pieces;
}

void expect_motions(const std::vector<ContourPiece>& found, const std::string& expected, Vec2 start) {
  const auto wanted = motions(expected, start);
  for (std::size_t i = 0; i < std::min(found.size(), wanted.size()); ++i) {
    EXPECT_EQ(found[i].kind, wanted[i].kind) << "motion " << i;
    EXPECT_LT(length(found[i].from - wanted[i].from), 1e-6) << "motion " << i;
    EXPECT_LT(length(found[i].to - wanted[i].to), 1e-6) << "motion " << i << " to X" << found[i].to.y << " Z" << found[i].to.x;
    if (found[i].is_arc()) {
      EXPECT_LT(length(found[i].center - wanted[i].center), 1e-6) << "motion " << i;
    }
  }
  EXPECT_EQ(found.size(), wanted.size());
}

/// A cycle block: S as radius X and Z, the figure from S on, and the words of the two blocks; u is a diameter.
struct Cycle {
  double x, z;
  std::string figure;
  double depth, back;
  double u = 0, w = 0;
  bool facing = false, pockets = false;
  Vec2 reversal_permitted{};

  Vec2 start() const { return {z, x}; }
  RoughFigure shape() const { return RoughFigure(motions(figure, start()), {facing, pockets, {w, u / 2}, reversal_permitted}); }
  RoughPasses passes(bool along_figure = true) const { return RoughPasses(shape(), {depth, back, 0, along_figure, {}}); }
  void expect(const std::string& expected) const {
    ASSERT_EQ(shape().fault(), FigureFault::none);
    expect_motions(all_of(passes()), expected, start());
  }
};

TEST(rough_passes, ft_089_straight_shoulder) {
  const Cycle cycle{23, 2, "R 10 2; F 10 -20; F 23 -20", 2, 0.5};
  cycle.expect(
      "R 21 2; F 21 -20; F 21.5 -19.5; R 21.5 2; R 19 2; F 19 -20; F 19.5 -19.5; R 19.5 2; R 17 2; F 17 -20; F 17.5 -19.5; R 17.5 2; R 15 "
      "2; F 15 -20; F 15.5 -19.5; R 15.5 2; R 13 2; F 13 -20; F 13.5 -19.5; R 13.5 2; R 11 2; F 11 -20; F 11.5 -19.5; R 11.5 2; R 10 2; F "
      "10 -20; F 23 -20; R 23 2");
}

TEST(rough_passes, ft_090_cone_with_allowance) {
  const Cycle cycle{25, 2, "R 10 2; F 10 -20; F 15 -30; F 23 -30", 2, 0.5, 0.4, 0.1};
  cycle.expect(
      "R 25.2 2.1; R 23.2 2.1; F 23.2 -29.9; F 23.7 -29.4; R 23.7 2.1; R 21.2 2.1; F 21.2 -29.9; F 21.7 -29.4; R 21.7 2.1; R 19.2 2.1; F "
      "19.2 -29.9; F 19.7 -29.4; R 19.7 2.1; R 17.2 2.1; F 17.2 -29.9; F 17.7 -29.4; R 17.7 2.1; R 15.2 2.1; F 15.2 -29.9; F 15.7 -29.4; R "
      "15.7 2.1; R 13.2 2.1; F 13.2 -25.9; F 13.7 -25.4; R 13.7 2.1; R 11.2 2.1; F 11.2 -21.9; F 11.7 -21.4; R 11.7 2.1; R 10.2 2.1; F "
      "10.2 -19.9; F 15.2 -29.9; F 23.2 -29.9; R 25 2");
}

TEST(rough_passes, ft_091_arc) {
  const Cycle cycle{25, 2, "R 10 2; F 10 -15; F 15 -25; F 15 -40; W 20 -45 20 -40; F 24 -45", 2, 0.5, 0.4, 0.1};
  cycle.expect(
      "R 25.2 2.1; R 23.2 2.1; F 23.2 -44.9; F 23.7 -44.4; R 23.7 2.1; R 21.2 2.1; F 21.2 -44.9; F 21.7 -44.4; R 21.7 2.1; R 19.2 2.1; F "
      "19.2 -44.798979486; F 19.7 -44.298979486; R 19.7 2.1; R 17.2 2.1; F 17.2 -43.9; F 17.7 -43.4; R 17.7 2.1; R 15.2 2.1; F 15.2 -24.9; "
      "F 15.7 -24.4; R 15.7 2.1; R 13.2 2.1; F 13.2 -20.9; F 13.7 -20.4; R 13.7 2.1; R 11.2 2.1; F 11.2 -16.9; F 11.7 -16.4; R 11.7 2.1; R "
      "10.2 2.1; F 10.2 -14.9; F 15.2 -24.9; F 15.2 -39.9; W 20.2 -44.9 20.2 -39.9; F 24.2 -44.9; R 25 2");
}

TEST(rough_passes, ft_092_infeed_at_feed) {
  const Cycle cycle{23, 2, "F 10 2; F 10 -20; F 23 -20", 4, 1};
  cycle.expect(
      "F 19 2; F 19 -20; F 20 -19; R 20 2; F 15 2; F 15 -20; F 16 -19; R 16 2; F 11 2; F 11 -20; F 12 -19; R 12 2; F 10 2; F 10 -20; F 23 "
      "-20; R 23 2");
}

TEST(rough_passes, ft_093_bore) {
  const Cycle cycle{10, 2, "R 20 2; F 20 -15; F 15 -25; F 11 -25", 2, 0.5, -0.4, 0.1};
  cycle.expect(
      "R 9.8 2.1; R 11.8 2.1; F 11.8 -24.9; F 11.3 -24.4; R 11.3 2.1; R 13.8 2.1; F 13.8 -24.9; F 13.3 -24.4; R 13.3 2.1; R 15.8 2.1; F "
      "15.8 -22.9; F 15.3 -22.4; R 15.3 2.1; R 17.8 2.1; F 17.8 -18.9; F 17.3 -18.4; R 17.3 2.1; R 19.8 2.1; F 19.8 -14.9; F 14.8 -24.9; "
      "F 10.8 -24.9; R 10 2");
}

TEST(rough_passes, ft_100_type_two_without_a_pocket) {
  const Cycle cycle{18, 2, "R 10 2; F 10 -20; F 15 -30; F 18 -30", 2, 0.5, 0, 0, false, true};
  cycle.expect(
      "R 16 2; F 16 -30; F 18 -30; F 18.5 -30; R 18.5 2; R 14 2; F 14 -28; F 15 -30; F 16 -30; F 16.5 -30; R 16.5 2; R 12 2; F 12 -24; F "
      "14 -28; F 14.5 -28; R 14.5 2; R 10 2; F 10 -20; F 15 -30; F 18 -30; R 18 2");
}

TEST(rough_passes, ft_101_type_two_with_a_pocket) {
  const Cycle cycle{25, 2, "R 10 2; F 10 -10; F 15 -15; F 15 -20; F 12 -25; F 12 -35; F 20 -45; F 24 -45", 2, 0.5, 0, 0, false, true};
  cycle.expect(
      "R 23 2; F 23 -45; F 24 -45; F 24.5 -45; R 24.5 2; R 21 2; F 21 -45; F 23 -45; F 23.5 -45; R 23.5 2; R 19 2; F 19 -43.75; F 20 -45; "
      "F "
      "21 -45; F 21.5 -45; R 21.5 2; R 17 2; F 17 -41.25; F 19 -43.75; F 19.5 -43.75; R 19.5 2; R 15 2; F 15 -15; F 15.5 -15; R 15.5 2; R "
      "13 2; F 13 -13; F 15 -15; F 15.5 -15; R 15.5 2; R 11 2; F 11 -11; F 13 -13; F 13.5 -13; R 15.5 -13; R 15.5 -15; F 15 -15; F 15 -20; "
      "F 15 -38.75; F 17 -41.25; F 17.5 -41.25; R 17.5 -20; R 15.5 -20; F 15 -20; F 13 -23.33333333; F 13 -36.25; F 15 -38.75; F 15.5 "
      "-38.75; R 25 -38.75; R 25 2; R 10 2; F 10 -10; F 15 -15; F 15 -20; F 12 -25; F 12 -35; F 20 -45; F 24 -45; R 25 2");
}

TEST(rough_passes, ft_115_facing) {
  const Cycle cycle{25, 2, "R 25 -7; F 10 -7; F 10 2", 2, 0.5, 0, 0, true};
  cycle.expect(
      "R 25 0; F 10 0; F 10.5 0.5; R 25 0.5; R 25 -2; F 10 -2; F 10.5 -1.5; R 25 -1.5; R 25 -4; F 10 -4; F 10.5 -3.5; R 25 -3.5; R 25 -6; "
      "F 10 -6; F 10.5 -5.5; R 25 -5.5; R 25 -7; F 10 -7; F 10 2; R 25 2");
}

TEST(rough_passes, ft_116_facing_with_allowance) {
  const Cycle cycle{26, 2, "R 26 -20; F 20 -20; F 10 -10; F 10 1", 3, 1, 0.4, 0.2, true};
  cycle.expect(
      "R 26.2 2.2; R 26.2 -0.8; F 10.2 -0.8; F 11.2 0.2; R 26.2 0.2; R 26.2 -3.8; F 10.2 -3.8; F 11.2 -2.8; R 26.2 -2.8; R 26.2 -6.8; F "
      "10.2 -6.8; F 11.2 -5.8; R 26.2 -5.8; R 26.2 -9.8; F 10.2 -9.8; F 11.2 -8.8; R 26.2 -8.8; R 26.2 -12.8; F 13.2 -12.8; F 14.2 -11.8; "
      "R 26.2 -11.8; R 26.2 -15.8; F 16.2 -15.8; F 17.2 -14.8; R 26.2 -14.8; R 26.2 -18.8; F 19.2 -18.8; F 20.2 -17.8; R 26.2 -17.8; R "
      "26.2 -19.8; F 20.2 -19.8; F 10.2 -9.8; F 10.2 1.2; R 26 2");
}

TEST(rough_passes, ft_118_pattern) {
  const Vec2 start{5, 30};
  const PatternPasses passes(motions("R 10 0; F 10 -20; F 20 -30", start), {{0.1, 0.2}, {2, 4}, 3});
  expect_motions(all_of(passes),
                 "R 34.2 7.1; R 14.2 2.1; F 14.2 -17.9; F 24.2 -27.9; R 32.2 6.1; R 12.2 1.1; F 12.2 -18.9; F 22.2 -28.9; R 30.2 5.1; R "
                 "10.2 0.1; F 10.2 -19.9; F 20.2 -29.9; R 30 5",
                 start);
}

/// With one pass the spec's formula divides by zero; the pass is shifted by the allowance only (9.5).
TEST(rough_passes, pattern_of_one_pass) {
  const Vec2 start{5, 30};
  const PatternPasses passes(motions("R 10 0; F 10 -20", start), {{0.1, 0.2}, {2, 4}, 1});
  expect_motions(all_of(passes), "R 30.2 5.1; R 10.2 0.1; F 10.2 -19.9; R 30 5", start);
}

TEST(rough_passes, without_the_pass_along_the_figure) {
  const Cycle cycle{16, 2, "R 10 2; F 10 -20; F 16 -20", 4, 0.5};
  expect_motions(all_of(cycle.passes(false)), "R 12 2; F 12 -20; F 12.5 -19.5; R 12.5 2; R 16 2", cycle.start());
}

/// Two pockets, with a ridge at 13 between them, e = 0.5, 5134 = 1.5: the rapid into the pocket ends 1.5 above the ridge.
TEST(rough_passes, clearance_before_a_pocket) {
  const Cycle cycle{16, 2, "R 12 2; F 12 -10; F 13 -10; F 12 -20; F 12 -30; F 16 -30", 3.5, 0.5, 0, 0, false, true};
  const auto found = all_of(RoughPasses(cycle.shape(), {3.5, 0.5, 1.5, false, {}}));
  expect_motions(
      found,
      "R 12.5 2; F 12.5 -10; F 13 -10; F 13.5 -10; R 14.5 -10; F 13 -10; F 12.5 -15; F 12.5 -30; F 16 -30; F 16.5 -30; R 16.5 2; "
      "R 16 2",
      cycle.start());
}

/// The figure ends below its ridge: on the way back the tool first moves out.
TEST(rough_passes, way_back_over_a_ridge) {
  const Cycle cycle{16, 2, "R 14 2; F 14 -10; F 15 -10; F 15 -20; F 12 -20; F 12 -30", 10, 0.5, 0, 0, false, true};
  cycle.expect("R 14 2; F 14 -10; F 15 -10; F 15 -20; F 12 -20; F 12 -30; R 16 -30; R 16 2");
}

/// The figure ends at radius 14.2 behind a ridge at 15. After the cut at 14 the tool stands at 14.5 behind the ridge, and rises above it
/// before it returns.
TEST(rough_passes, end_of_the_figure_behind_a_ridge) {
  const Cycle cycle{16, 2, "R 11 2; F 11 -10; F 15 -15; F 14.2 -15; F 14.2 -20", 2, 0.3, 0, 0, false, true};
  cycle.expect(
      "R 14 2; F 14 -13.75; F 15 -15; F 14.2 -15; F 14.2 -20; F 14.5 -20; R 15.3 -20; R 15.3 2; R 12 2; F 12 -11.25; F 14 -13.75; F 14.3 "
      "-13.75; R 14.3 2; R 11 2; F 11 -10; F 15 -15; F 14.2 -15; F 14.2 -20; R 16 -20; R 16 2");
}

TEST(rough_passes, a_copy_continues_with_the_same_motion) {
  RoughPasses passes = Cycle{25, 2, "R 10 2; F 10 -10; F 15 -15; F 12 -25; F 20 -45; F 24 -45", 2, 0.5, 0, 0, false, true}.passes();
  for (int i = 0; i < 27; ++i) (void)passes.next();
  const RoughPasses copy = passes;
  const auto rest = all_of(passes), same = all_of(copy);
  ASSERT_EQ(rest.size(), same.size());
  ASSERT_GT(rest.size(), 5U);
  for (std::size_t i = 0; i < rest.size(); ++i) EXPECT_EQ(rest[i].to, same[i].to);
}

TEST(rough_passes, each_level_ends_a_pass) {
  RoughPasses passes = Cycle{23, 2, "R 10 2; F 10 -20; F 23 -20", 2, 0.5}.passes();
  int ends = 0;
  while (const auto step = passes.next()) ends += step->ends_pass ? 1 : 0;
  EXPECT_EQ(ends, 7);  // six levels, and the pass along the figure
}

FigureFault fault(const std::string& figure, bool facing, bool pockets, Vec2 permitted = {}) {
  return Cycle{25, 2, figure, 2, 0.5, 0, 0, facing, pockets, permitted}.shape().fault();
}

TEST(rough_figure, ft_104_a_pocket_in_type_one) {
  const std::string figure = "R 10 2; F 10 -10; F 15 -15; F 12 -20; F 12 -30; F 24 -30";
  EXPECT_EQ(fault(figure, false, false), FigureFault::second_axis);
  EXPECT_EQ(fault(figure, false, true), FigureFault::none);
}

TEST(rough_figure, ft_105_z_turns_back) {
  EXPECT_EQ(fault("R 10 2; F 10 -10; F 15 -8; F 15 -30; F 24 -30", false, true), FigureFault::first_axis);
}

TEST(rough_figure, ft_117_x_turns_back_in_facing) {
  EXPECT_EQ(fault("R 25 -15; F 20 -15; F 22 -10; F 10 -5; F 10 1", true, false), FigureFault::second_axis);
}

TEST(rough_figure, depth_turns_back_in_facing) {
  EXPECT_EQ(fault("R 25 -15; F 20 -15; F 20 -10; F 10 -12; F 10 1", true, false), FigureFault::first_axis);
}

/// 5145 is for Z, 5146 for X; a reversal of 0.1 is within 0.1, but not within 0.05.
TEST(rough_figure, small_reversals_are_permitted) {
  const std::string in_z = "R 10 2; F 10 -10; F 15 -9.9; F 15 -30; F 24 -30", in_x = "R 10 2; F 10 -10; F 15 -12; F 14.9 -30; F 24 -30";
  EXPECT_EQ(fault(in_z, false, false, {0.1, 0}), FigureFault::none);
  EXPECT_EQ(fault(in_z, false, false, {0.05, 0.1}), FigureFault::first_axis);
  EXPECT_EQ(fault(in_x, false, false, {0, 0.1}), FigureFault::none);
  EXPECT_EQ(fault(in_x, false, false, {0.1, 0.05}), FigureFault::second_axis);
}

/// The half circle about X12 Z-10 reaches Z-8 between its ends at Z-10.
TEST(rough_figure, an_arc_that_turns_back_between_its_ends) {
  EXPECT_EQ(fault("R 10 2; F 10 -10; C 14 -10 12 -10; F 24 -30", false, true), FigureFault::first_axis);
}

TEST(rough_figure, over_the_start_point) {
  EXPECT_EQ(fault("R 10 2; F 10 -20; F 25 -20", false, false), FigureFault::none);
  EXPECT_EQ(fault("R 10 2; F 10 -20; F 25.001 -20", false, false), FigureFault::over_start);
  EXPECT_EQ(fault("R 10 2; F 10 -20; F 26 -20; F 24 -25", false, true), FigureFault::over_start);
}

TEST(rough_figure, an_arc_in_the_first_block) { EXPECT_EQ(fault("W 23 0 23 2; F 10 0; F 10 -10", false, true), FigureFault::first_block); }

}  // namespace
}  // namespace kadr::rough_passes_test
