// The report on one sweep: how deep it cuts, and whether it cuts at all, compared with the material before and after the sweep.

#include <gtest/gtest.h>

#include <map>
#include <vector>

#include "stock/some_tools.h"

namespace kadr::removed_test {
namespace {

using Pieces = std::vector<std::pair<double, double>>;
using Lines = std::map<std::tuple<int, std::size_t, int>, Pieces>;  // family, brick, line

Lines lines_of(const Stock& stock) {
  Lines all;
  const double edge = stock.lattice().edge();
  for (std::size_t b = 0; b < stock.lattice().size(); ++b)
    for (int family = 0; family < 3; ++family)
      for (int i = 0; i < brick_lines; ++i) {
        Pieces& pieces = all[{family, b, i}];
        if (stock.state(b) == Stock::State::full) pieces.emplace_back(0, edge);
        const Brick* const brick = stock.brick(b);
        if (brick == nullptr) continue;
        const BrickLines& lines = brick->family[std::size_t(family)];
        if (lines.from[i] < lines.to[i]) pieces.emplace_back(double(lines.from[i]), double(lines.to[i]));
        for (const FurtherInterval& f : lines.further)
          if (f.line == i) pieces.emplace_back(double(f.from), double(f.to));
      }
  return all;
}

/// Returns the parts of `before` that are not in `after`.
Pieces without(const Pieces& before, const Pieces& after) {
  Pieces gone = before;
  for (const auto& [from, to] : after) {
    Pieces rest;
    for (const auto& [low, high] : gone) {
      if (low < from) rest.emplace_back(low, std::min(high, from));
      if (high > to) rest.emplace_back(std::max(low, to), high);
      if (low >= from && high <= to) continue;
    }
    gone = rest;
  }
  return gone;
}

struct Gone {
  double highest = -1e9, longest = 0;  // `highest` for vertical lines, `longest` for all lines
};

Gone gone_between(const Stock& stock, const Lines& before, const Lines& after) {
  Gone gone;
  for (const auto& [key, pieces] : before) {
    const auto& [family, brick, line] = key;
    for (const auto& [low, high] : without(pieces, after.at(key))) {
      if (high - low < 1e-5) continue;
      gone.longest = std::max(gone.longest, high - low);
      if (family == 2) gone.highest = std::max(gone.highest, stock.lattice().corner(brick).z + high);
    }
  }
  return gone;
}

ToolShape without_shank(ToolKind kind, double diameter) {
  ToolGeometry g;
  g.kind = kind;
  g.diameter = diameter;
  g.corner = diameter / 5;
  g.angle = kind == ToolKind::taper ? 15 : 90;
  g.flutes = g.length = 40;
  return shape_of(g);
}

TEST(Removed, DepthAndLongestPieceAreThoseOfTheMaterial) {
  Chance chance(11);
  for (int round = 0; round < int(asked("REMOVED_ROUNDS", 8)); ++round) {
    Stock stock(box_blank({{-8, -8, -8}, {8, 8, 8}}), chance.between(0.4, 0.9), 2);
    for (const ToolKind kind : {ToolKind::flat, ToolKind::ball, ToolKind::bull, ToolKind::taper})
      stock.add_tool(without_shank(kind, chance.between(2, 9)));
    Lines before = lines_of(stock);
    for (int i = 0; i < 12; ++i) {
      const double z = chance.between(-6, 7);
      const Vec3 from{chance.between(-12, 12), chance.between(-12, 12), z}, to{chance.between(-12, 12), chance.between(-12, 12), z};
      stock.add({from, to, std::uint16_t(chance.below(4)), false});
      stock.cut();
      const Lines after = lines_of(stock);
      const Gone gone = gone_between(stock, before, after);
      ASSERT_NEAR(stock.depth_of(stock.sweeps() - 1), std::max(gone.highest - z, 0.0), 2e-4) << round << ' ' << i;
      const bool cuts = stock.cuts_anything(stock.sweeps() - 1);
      ASSERT_TRUE(cuts || gone.longest < 1.01 * stock.least_piece()) << round << ' ' << i;
      ASSERT_TRUE(!cuts || gone.longest > 0.99 * stock.least_piece()) << round << ' ' << i;
      before = after;
    }
  }
}

TEST(Removed, ARampIsAsDeepAsItGoesDown) {
  for (const double slope : {0.1, 0.5, -0.1, -0.5}) {
    Stock stock(box_blank({{0, 0, -30}, {60, 60, 0}}), 0.5, 1);
    const std::uint16_t tool = stock.add_tool(without_shank(ToolKind::flat, 10));
    const double low = 20 * std::abs(slope);
    stock.add({{10, 30, slope > 0 ? -low : 0}, {30, 30, slope > 0 ? 0 : -low}, tool, false});
    stock.add({{10, 30, slope > 0 ? -low - 1 : -1}, {30, 30, slope > 0 ? -1 : -low - 1}, tool, false});
    stock.cut();
    EXPECT_NEAR(stock.depth_of(0), low, 1e-3);
    EXPECT_NEAR(stock.depth_of(1), 1, 0.5 * std::abs(slope) + 1e-3);  // tolerance: one cell of travel at the end of the first sweep
  }
}

}  // namespace
}  // namespace kadr::removed_test
