// Sweeps that graze a lattice line while the tool turns: the material that they leave on this line and on the lines near it obeys the law.
// A turning surface can meet a line that nearly lies in it from both ends of the line, so the removed part is not one interval.
// STOCK_POINTS and STOCK_SEED as in sweep_test.

#include <gtest/gtest.h>

#include <array>
#include <cstdio>

#include "stock/tilted_twin.h"

namespace kadr::tilted_graze_test {
namespace {

constexpr double law = 2e-3;  // mm; the greatest error found was 1.6 µm: docs/stock.md
const Box3 block{{-1, -1, -1}, {9, 9, 9}};
constexpr std::array cells{0.25, 0.5};

/// Returns a point, mostly on the grazed line, otherwise on a line next to it; every third point is at an end or close to it.
LinePosition near_grazed(const Stock& stock, const Grazing& g, Chance& chance) {
  const Lattice& lattice = stock.lattice();
  Vec3 at = g.at;
  for (int d = 0; d < 3; ++d)
    if (d != g.family && chance.below(4) == 0) along(at, d) += (chance.below(3) - 1) * lattice.cell();
  along(at, g.family) += chance.below(4) == 0 ? chance.between(-10, 10) : some_size(chance, -2, 0.7);
  int brick[3], lane[3];
  for (int d = 0; d < 3; ++d) {
    along(at, d) = std::clamp(along(at, d), along(block.least, d) + 1e-6, along(block.most, d) - 1e-6);
    const double from_origin = along(at, d) - along(lattice.origin(), d);
    brick[d] = int(from_origin / lattice.edge());
    lane[d] = std::clamp(int((from_origin - brick[d] * lattice.edge()) / lattice.cell()), 0, brick_edge - 1);
  }
  LinePosition p{
      lattice.at({brick[0], brick[1], brick[2]}), g.family, lane[(g.family + 2) % 3] * brick_edge + lane[(g.family + 1) % 3], {}, {}};
  p.corner = lattice.corner(p.brick), p.at = p.corner;
  for (int d = 0; d < 3; ++d) along(p.at, d) = d == g.family ? along(at, d) : along(p.corner, d) + (lane[d] + 0.5) * lattice.cell();
  const Brick* b = stock.brick(p.brick);
  if (b == nullptr || chance.below(3) != 0) return p;
  const BrickLines& lines = b->family[std::size_t(g.family)];
  const bool from = lines.from_by[p.line] != of_blank, to = lines.to_by[p.line] != of_blank;
  if (!(lines.from[p.line] < lines.to[p.line]) || !(from || to)) return p;
  p.is_end = chance.below(2) == 0;
  const double end = double(from ? lines.from[p.line] : lines.to[p.line]) + (p.is_end ? 0 : some_size(chance, -3, -1));
  along(p.at, g.family) = along(p.corner, g.family) + std::clamp(end, 0.0, lattice.edge());
  return p;
}

TEST(TiltedGrazeProperty, LeavesWhatLiesOutsideOfTheSweptTool) {
  constexpr int places_of_a_sweep = 40;
  const std::uint64_t points = asked("STOCK_POINTS", 40000), seed = asked("STOCK_SEED", seed_of_properties());
  std::array<double, some_tools> worst{};
  std::uint64_t looked_at = 0, ends = 0, wrong = 0;
  int shown = 0;
  for (int round = 0; looked_at < points; ++round) {
    Chance chance(seed * 1000000007 + std::uint64_t(round));  // a generator for each round, so that a failing round can be repeated alone
    const auto which = SomeTool(round % some_tools);
    const ToolShape tool = some_tool(chance, which);
    if (tool.bodies.empty()) continue;
    Stock stock(box_blank(block), cells[std::size_t(chance.below(int(cells.size())))], 1);
    stock.add_tool(tool);
    Vec3 at;
    for (int d = 0; d < 3; ++d) {
      const int lane = int(chance.between(2, 8) / stock.lattice().cell());
      along(at, d) = along(stock.lattice().origin(), d) + (lane + 0.5) * stock.lattice().cell();
    }
    const Grazing grazing = some_grazing(tool, at, chance.below(3), chance);
    stock.add(grazing.sweep);
    stock.cut();
    for (int i = 0; i < places_of_a_sweep; ++i) {
      const LinePosition p = near_grazed(stock, grazing, chance);
      if (!within(block, p.at)) continue;
      ++looked_at, ends += p.is_end;
      const double distance = from_tilted(tool, grazing.sweep, p.at);
      if (!p.is_end && (distance > 0) == is_material(stock, p)) continue;
      double& most = worst[std::size_t(which)];
      most = std::max(most, std::fabs(distance));
      if (std::fabs(distance) <= law) continue;
      ++wrong;
      if (++shown <= 8)
        ADD_FAILURE() << name_of(which) << ", cell " << stock.lattice().cell() << ", seed " << seed << ": wrong by " << distance << " mm; "
                      << described(tool, {grazing.sweep}, p);
    }
  }
  for (int i = 0; i < some_tools; ++i) {
    EXPECT_LE(worst[std::size_t(i)], law) << name_of(SomeTool(i)) << ", seed " << seed;
    std::printf("%-22s greatest error %.6f mm\n", name_of(SomeTool(i)), worst[std::size_t(i)]);
  }
  std::printf("%llu places, %llu of them ends, %llu wrong\n", static_cast<unsigned long long>(looked_at),
              static_cast<unsigned long long>(ends), static_cast<unsigned long long>(wrong));
}

/// The ball of a ball end mill reaches the line at the start of the path, and the
/// shaft reaches it higher up at the end. The material between the two must remain.
TEST(TiltedGraze, BetweenBallAndShaftNothingIsTaken) {
  constexpr double cell = 0.25, first = 3.5, end = 8.8, step = 0.05;  // mm, along the line; material is removed below and above
  Stock stock(box_blank(block), cell, 1);
  ToolGeometry g;
  g.kind = ToolKind::ball;
  g.diameter = 2 * 3.46538829, g.flutes = g.length = 9.24843449;
  const ToolShape tool = shape_of(g);
  Sweep sweep;
  sweep.from = {3.368736447134836, -1.2349737882585237, -0.09813580790507806};
  sweep.to = {3.8212587756385501, -0.88657736670743259, -0.33610598689374116};
  sweep.from_direction = {-0.0077441674795722081, -0.015522971335279738, 0.99984952129356575};
  sweep.to_direction = {-0.01685641824266686, -0.010250767086794475, 0.99980537252915413};
  sweep.tool = stock.add_tool(tool);
  stock.add(sweep);
  stock.cut();
  const Lattice& lattice = stock.lattice();
  for (double z = first; z < end; z += step) {
    LinePosition p{0, 2, 0, {}, {1.125, 1.375, z}};
    int brick[3], lane[3];
    for (int d = 0; d < 3; ++d) {
      const double from_origin = along(p.at, d) - along(lattice.origin(), d);
      brick[d] = int(from_origin / lattice.edge()), lane[d] = int((from_origin - brick[d] * lattice.edge()) / cell);
    }
    p.brick = lattice.at({brick[0], brick[1], brick[2]}), p.line = lane[1] * brick_edge + lane[0];
    p.corner = lattice.corner(p.brick);
    EXPECT_GT(from_tilted(tool, sweep, p.at), 0) << z;
    EXPECT_TRUE(is_material(stock, p)) << z;
  }
}

}  // namespace
}  // namespace kadr::tilted_graze_test
