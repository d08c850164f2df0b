// Sweeps of any tilted tool: a point of a lattice line is material exactly where it lies outside the volume swept by the tool.
// STOCK_POINTS and STOCK_SEED as in sweep_test.

#include <gtest/gtest.h>

#include <array>
#include <cstdio>

#include "stock/tilted_twin.h"

namespace kadr::tilted_sweep_test {
namespace {

constexpr double cell = 0.5;
constexpr double law = 1e-3;  // mm
const Box3 block{{-1, -1, -1}, {9, 9, 9}};

// Every fourth tool performs several sweeps.
TEST(TiltedSweepProperty, LeavesWhatLiesOutsideOfTheSweptTool) {
  constexpr int places_of_a_sweep = 60;
  const std::uint64_t points = asked("STOCK_POINTS", 40000), seed = asked("STOCK_SEED", seed_of_properties());
  Chance chance(seed);
  std::array<double, some_tools> worst{};
  std::uint64_t looked_at = 0, ends = 0;
  int shown = 0;
  for (int round = 0; looked_at < points; ++round) {
    const auto which = SomeTool(round % some_tools);
    const ToolShape tool = some_tool(chance, which);
    std::vector<Sweep> sweeps{some_tilted_move(chance)};
    while (round / some_tools % 4 == 3 && sweeps.size() < 3) sweeps.push_back(some_tilted_move(chance));
    Stock stock(box_blank(block), cell, 1);
    stock.add_tool(tool);
    for (const Sweep& s : sweeps) stock.add(s);
    stock.cut();
    for (int i = 0; i < places_of_a_sweep; ++i) {
      const LinePosition p = some_place(stock, chance);
      if (!within(block, p.at)) continue;
      ++looked_at, ends += p.is_end;
      double distance = std::numeric_limits<double>::infinity();
      for (const Sweep& s : sweeps) distance = std::min(distance, from_tilted(tool, s, p.at));
      if (!p.is_end && (distance > 0) == is_material(stock, p)) continue;
      double& most = worst[std::size_t(which)];
      most = std::max(most, std::fabs(distance));
      if (std::fabs(distance) > law && ++shown <= 8)
        ADD_FAILURE() << name_of(which) << ", seed " << seed << ": wrong by " << distance << " mm; " << described(tool, sweeps, p);
    }
  }
  for (int i = 0; i < some_tools; ++i) {
    EXPECT_LE(worst[std::size_t(i)], law) << name_of(SomeTool(i)) << ", seed " << seed;
    std::printf("%-22s greatest error %.6f mm\n", name_of(SomeTool(i)), worst[std::size_t(i)]);
  }
  std::printf("%llu places, %llu of them ends\n", static_cast<unsigned long long>(looked_at), static_cast<unsigned long long>(ends));
}

/// Checks the ends of the material that one sweep leaves on a line, in one brick: no end has a greater error than the law allows.
void expect_ends(const ToolGeometry& geometry, const Sweep& sweep, int family, Vec3 at) {
  const ToolShape tool = shape_of(geometry);
  Stock stock(box_blank(block), cell, 1);
  stock.add_tool(tool);
  stock.add(sweep);
  stock.cut();
  for (std::size_t b = 0; b < stock.lattice().size(); ++b) {
    const Vec3 corner = stock.lattice().corner(b);
    int lane[3];
    bool holds = true;
    for (int d = 0; d < 3; ++d) {
      lane[d] = int(std::floor((along(at, d) - along(corner, d)) / cell));
      holds = holds && lane[d] >= 0 && lane[d] < brick_edge;
    }
    if (!holds) continue;
    LinePosition p{b, family, lane[(family + 2) % 3] * brick_edge + lane[(family + 1) % 3], corner, at};
    for (int i = 0; i < 400; ++i) {
      along(p.at, family) = along(corner, family) + stock.lattice().edge() * (i + 0.5) / 400;
      if (!within(block, p.at)) continue;
      const double distance = from_tilted(tool, sweep, p.at);
      if (std::fabs(distance) <= law) continue;
      EXPECT_EQ(is_material(stock, p), distance > 0) << along(p.at, family) << ": " << distance;
    }
  }
}

// The vertical line enters the shaft at its first position. With the tool
// direction at the middle of the path it would seem to leave the shaft there.
TEST(TiltedSweep, ALineAllButInTheSideOfABullNose) {
  ToolGeometry g;
  g.kind = ToolKind::bull, g.diameter = 5.182752367505902, g.flutes = 11.584219372690388, g.corner = 0.63957597865510418;
  const Sweep sweep{{1.4600878591124609, 4.2342648076101241, 0.51630845686064042},
                    {1.4600878591124609, 4.7819193826597548, 0.51630845686064042},
                    0,
                    false,
                    {0.014794938708142667, 0, 0.99989054890453999},
                    {-0.085333148546146487, 0.048311401531356379, 0.99518051741444258}};
  expect_ends(g, sweep, 2, {2.25, 1.75, 6.02344643});
}

// The line is almost parallel to the path. Its distance from the ball hardly changes,
// so the position of the path nearest to the line must be found more precisely.
TEST(TiltedSweep, ALineAllButAlongTheWayOfABallOfShortFlutes) {
  ToolGeometry g;
  g.kind = ToolKind::ball, g.diameter = 2 * 1.3191593285946681, g.flutes = 2.0012710986066544;
  const Vec3 from{3.8095767255833444, 8.4344127609283621, 7.4661087052720827}, direction{0.52430622860008358, 0, 0.85152978729528706};
  const Sweep sweep{from, from + Vec3{0.29313846309983305, -8.0186267668552702, 0.00095436046129115937}, 0, false, direction, direction};
  expect_ends(g, sweep, 1, {3.25, 8.0677425119939699, 8.25});
}

// The tool cuts only a fifth of a millimetre of the line, and only with the shift that the tool has at that moment.
TEST(TiltedSweep, ALineThatAShortBallGrazes) {
  ToolGeometry g;
  g.kind = ToolKind::ball, g.diameter = 2 * 0.766274649, g.flutes = 0.841946324;
  const Vec3 from{2.19599484, 2.90191782, 0.00111404693}, direction{-0.27814162699967, -0.88702224699895, -0.36854954699956};
  const Vec3 turned = direction - Vec3{0, 0, 0.03};
  const Sweep sweep{from, from + Vec3{-0.011544244, 0.293525526, -1.57726882e-05}, 0, false, direction, (1 / length(turned)) * turned};
  expect_ends(g, sweep, 2, {1.75, 3.25, -0.332570552});
}

// The line lies in the face at the first position of the tool, and enters the tool far from where it leaves it. With the shift at that
// position the tool seems to reach beyond the material.
TEST(TiltedSweep, ALineAllButInTheFaceOfABullNose) {
  ToolGeometry g;
  g.kind = ToolKind::bull, g.diameter = 2 * 5.88308022, g.corner = 0.541652657, g.flutes = 7.29488887;
  const Vec3 from{5.26314564, 11.4334889, 1.75972122}, turned{1, -0.002895, 0.005015};
  const Sweep sweep{from, from + Vec3{0, -0.127122522, 0}, 0, false, {1, 0, 0}, (1 / length(turned)) * turned};
  expect_ends(g, sweep, 2, {5.25, 7.75, 1.14168251});
}

TEST(TiltedSweep, ALineAllButInAConeOfAFormTool) {
  ToolGeometry g;
  g.kind = ToolKind::form, g.flutes = 6.78856099;
  g.profile = {{10.08447702, 0}, {1.003864756, 3.73388676}, {4.44187804, 4.29947901}, {7.35349852, 6.78856099}};
  const Vec3 from{0.520894953, 10.3563889, 6.67364259}, direction{-0.107099927, 0.849078424, 0.517296274},
      turned{0.002325694, 0.744162354, 0.667994747};
  const Sweep sweep{from, from + Vec3{0, 0, -7.8259377}, 0, false, (1 / length(direction)) * direction, (1 / length(turned)) * turned};
  expect_ends(g, sweep, 0, {-0.828653875, 7.75, 1.75});
}

// The line leaves the turning face over its rim, half a brick away from where it enters the face.
TEST(TiltedSweep, ALineAllButInAFaceOfAFormTool) {
  ToolGeometry g;
  g.kind = ToolKind::form, g.diameter = 8.8452043349950564, g.flutes = 3.5195135152101051;
  g.profile = {{11.780573280760237, 0}, {2.6981640504857345, 1.9617155574557088}, {7.0491638578517275, 3.5195135152101051}};
  const Sweep sweep{{3.2087081774285924, 8.3424665814630625, 6.7007397199604277},
                    {3.1957218017264455, 8.352106755356635, 6.7007407358775612},
                    0,
                    false,
                    {0.042985432101564337, 0.056365551845015065, -0.99748442453616726},
                    {-0.034762983395672298, 0.044403849667659638, -0.99840865036322879}};
  expect_ends(g, sweep, 0, {8.83817244, 8.75, 6.75});
}

}  // namespace
}  // namespace kadr::tilted_sweep_test
