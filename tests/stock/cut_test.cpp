// The result of many sweeps does not depend on their order, the threads or the processor's vector instructions. Further tests: mirrored
// sweeps, repeated sweeps, and lines in several pieces.

#include <gtest/gtest.h>

#include <functional>
#include <map>
#include <tuple>

#include "stock/same_stock.h"
#include "stock/some_tools.h"
#include "stock/surface/surface.h"

namespace kadr::cut_test {
namespace {

const Box3 block{{-10, -10, -10}, {10, 10, 10}};

struct Job {
  std::vector<ToolShape> tools;
  std::vector<Sweep> sweeps;
};

Job some_job(Chance& chance, int sweeps) {
  Job job;
  for (int i = 0; i < 3; ++i) job.tools.push_back(some_tool(chance, SomeTool(chance.below(some_tools))));
  for (int i = 0; i < sweeps; ++i) {
    Sweep s = some_move(chance);
    const Vec3 down{3, 3, chance.between(-2, 4)};
    s.from = s.from - down, s.to = s.to - down;
    s.tool = std::uint16_t(chance.below(3));
    job.sweeps.push_back(s);
  }
  return job;
}

Stock cut(const Job& job, double cell, int threads) {
  Stock stock(box_blank(block), cell, threads);
  for (const ToolShape& t : job.tools) stock.add_tool(t);
  for (const Sweep& s : job.sweeps) stock.add(s);
  stock.cut();
  return stock;
}

/// A lattice line: its family and the numbers of its lattice points along the two other axes.
using LineKey = std::tuple<int, int, int>;  // family, along (family + 1) % 3, along (family + 2) % 3
using Left = std::map<LineKey, double>;     // mm of remaining material

Left left_of(const Stock& stock) {
  Left left;
  for (std::size_t b = 0; b < stock.lattice().size(); ++b) {
    if (stock.state(b) == Stock::State::empty) continue;
    const BrickPlace p = stock.lattice().place(b);
    const int at[3] = {p.x, p.y, p.z};
    for (int family = 0; family < 3; ++family) {
      const auto sum = [&](int line) -> double& {
        return left[{family, at[(family + 1) % 3] * brick_edge + line % brick_edge, at[(family + 2) % 3] * brick_edge + line / brick_edge}];
      };
      for (int line = 0; line < brick_lines; ++line) {
        if (stock.brick(b) == nullptr) {
          sum(line) += stock.lattice().edge();
          continue;
        }
        const BrickLines& lines = stock.brick(b)->family[std::size_t(family)];
        sum(line) += std::max(0.0, double(lines.to[line]) - double(lines.from[line]));
      }
      if (stock.brick(b) == nullptr) continue;
      for (const FurtherInterval& f : stock.brick(b)->family[std::size_t(family)].further) sum(f.line) += double(f.to) - double(f.from);
    }
  }
  return left;
}

/// Compares two results. On a line that grazes a round tool, the error is the square root of the tool's error.
void expect_alike(const Left& a, const Left& b, const std::function<LineKey(LineKey)>& key_in_b) {
  double worst = 0, all = 0;
  for (const auto& [key, length] : a) {
    const auto other = b.find(key_in_b(key));
    const double differs = std::fabs(length - (other == b.end() ? 0 : other->second));
    worst = std::max(worst, differs), all += differs;
  }
  EXPECT_LE(worst, 0.02);
  EXPECT_LE(all / double(a.size()), 2e-5);
}

TEST(Cut, ThreadsChangeNoBit) {
  Chance chance(1);
  for (int round = 0; round < 4; ++round) {
    const Job job = some_job(chance, 60);
    const Stock one = cut(job, 0.25, 1), two = cut(job, 0.25, 2), four = cut(job, 0.25, 4);
    EXPECT_TRUE(same(one, two));
    EXPECT_TRUE(same(one, four));
    for (std::size_t i = 0; i < job.sweeps.size(); ++i) {
      EXPECT_EQ(one.removed_by(i), four.removed_by(i));
      EXPECT_EQ(one.depth_of(i), four.depth_of(i));
      EXPECT_EQ(one.cuts_anything(i), four.cuts_anything(i));
    }
  }
}

TEST(Cut, TheProcessorsVectorsChangeNoBit) {
  if (widest_lanes() == LaneWidth::pair) GTEST_SKIP() << "this processor has no wider vectors";
  Chance chance(2);
  const BrickScale scale(0.75);
  for (int round = 0; round < 300; ++round) {
    Brick pair, wide;
    for (Brick* brick : {&pair, &wide}) {
      for (BrickLines& lines : brick->family)
        for (int i = 0; i < brick_lines; ++i) lines.from[i] = 0, lines.to[i] = scale.edge, lines.from_by[i] = lines.to_by[i] = of_blank;
      refresh_tops(*brick, scale.cell);
    }
    for (int i = 0; i < 5; ++i) {
      const ToolShape tool = some_tool(chance, SomeTool(chance.below(some_tools)));
      const Sweep s = some_move(chance);
      for (const ConvexBody& body : tool.bodies) {
        const LocalSweep local = local_sweep(s.from, s.to, around_tip(body), double(scale.edge));
        CutOutcome by_pair, by_wide;
        cut_brick(pair, scale, local, swept_body(body), i, by_pair, LaneWidth::pair);
        cut_brick(wide, scale, local, swept_body(body), i, by_wide, LaneWidth::wide);
        ASSERT_EQ(by_pair.length, by_wide.length);
        ASSERT_EQ(by_pair.depth, by_wide.depth);
        ASSERT_EQ(by_pair.longest, by_wide.longest);
        ASSERT_TRUE(same_brick(&pair, &wide)) << "round " << round << ", sweep " << i;
      }
    }
  }
}

TEST(Cut, TheOrderOfSweepsDoesNotMatter) {
  Chance chance(3);
  for (int round = 0; round < 20; ++round) {
    Job job = some_job(chance, 8);
    const Left there = left_of(cut(job, 0.5, 1));
    double all = 0;
    for (const auto& [key, length] : there) all += length;
    EXPECT_GT(all, 3 * 8000 / 0.25 * 0.2);
    EXPECT_LT(all, 3 * 8000 / 0.25 * 0.999);
    std::reverse(job.sweeps.begin(), job.sweeps.end());
    expect_alike(there, left_of(cut(job, 0.5, 1)), [](LineKey k) { return k; });
  }
}

TEST(Cut, OnceMoreTakesNothing) {
  Chance chance(4);
  for (int round = 0; round < 10; ++round) {
    const Job job = some_job(chance, 8);
    const Stock once = cut(job, 0.5, 1);
    Stock twice = cut(job, 0.5, 1);
    for (const Sweep& s : job.sweeps) twice.add(s);
    twice.cut();
    EXPECT_TRUE(same(once, twice));
    for (std::size_t i = job.sweeps.size(); i < twice.sweeps(); ++i) EXPECT_EQ(twice.removed_by(i), 0);
  }
}

// The block has the same width on both sides of 0, and so do its lattice points.
TEST(Cut, MirroredMovesLeaveTheMirroredPart) {
  Chance chance(5);
  const double cell = 0.5;
  const auto mirrored = [&](int i) { return int(std::lround(20 / cell)) + 1 - i; };
  for (int round = 0; round < 20; ++round) {
    const Job job = some_job(chance, 4);
    const Left there = left_of(cut(job, cell, 1));
    Job other = job;
    for (Sweep& s : other.sweeps) s.from.x = -s.from.x, s.to.x = -s.to.x;
    expect_alike(there, left_of(cut(other, cell, 1)), [&](LineKey k) {
      const auto [family, u, v] = k;
      return LineKey(family, family == 2 ? mirrored(u) : u, family == 1 ? mirrored(v) : v);
    });
    other = job;
    for (Sweep& s : other.sweeps) std::swap(s.from.x, s.from.y), std::swap(s.to.x, s.to.y);
    expect_alike(there, left_of(cut(other, cell, 1)), [](LineKey k) {
      const auto [family, u, v] = k;
      return LineKey(family == 2 ? 2 : 1 - family, v, u);
    });
    other = job;
    for (Sweep& s : other.sweeps) std::swap(s.from, s.to);
    expect_alike(there, left_of(cut(other, cell, 1)), [](LineKey k) { return k; });
  }
}

TEST(Cut, ShiftedMovesLeaveTheShiftedPart) {
  Chance chance(6);
  for (int round = 0; round < 10; ++round) {
    const Job job = some_job(chance, 4);
    const Vec3 shift{100 + chance.between(0, 1), -50, 7.25};
    Stock shifted(box_blank({block.least + shift, block.most + shift}), 0.5, 1);
    for (const ToolShape& t : job.tools) shifted.add_tool(t);
    for (const Sweep& s : job.sweeps) shifted.add({s.from + shift, s.to + shift, s.tool, false});
    shifted.cut();
    expect_alike(left_of(cut(job, 0.5, 1)), left_of(shifted), [](LineKey k) { return k; });
  }
}

TEST(Cut, BatchesChangeNoBit) {
  Chance chance(7);
  for (int round = 0; round < 6; ++round) {
    const Job job = some_job(chance, 30);
    const Stock at_once = cut(job, 0.5, 1);
    Stock one_by_one(box_blank(block), 0.5, 1);
    for (const ToolShape& t : job.tools) one_by_one.add_tool(t);
    for (const Sweep& s : job.sweeps) one_by_one.add(s), one_by_one.cut();
    EXPECT_TRUE(same(at_once, one_by_one));
  }
}

// Small tools, so that bricks have a long history; with hardly any room for copies, or with enough.
TEST(Cut, AnyMomentIsAsIfCutSoFar) {
  Chance chance(8);
  for (const std::size_t room : {std::size_t(0), std::size_t(200'000), std::size_t(100'000'000)}) {
    Job job;
    ToolGeometry g;
    g.diameter = 1, g.kind = ToolKind::ball, g.flutes = 12, g.length = 20;
    job.tools.push_back(shape_of(g));
    Vec3 at{0, 0, 8};
    for (int i = 0; i < 1500; ++i) {
      const Vec3 to{chance.between(-6, 6), chance.between(-6, 6), chance.between(4, 10.5)};
      job.sweeps.push_back({at, to, 0, false});
      at = to;
    }
    Stock stock(box_blank(block), 0.5, 2);
    stock.keep_past(room);
    for (const ToolShape& t : job.tools) stock.add_tool(t);
    for (std::size_t i = 0; i < job.sweeps.size(); ++i) {
      stock.add(job.sweeps[i]);
      if (i % 600 == 599) stock.cut();
    }
    stock.cut();
    EXPECT_LE(stock.bytes_of_past(), room + stock.lattice().size() * (sizeof(BrickPast) + 3 * 4 * 1500));
    for (const std::size_t count :
         {std::size_t(0), std::size_t(1), std::size_t(chance.below(1500)), std::size_t(1499), std::size_t(1500)}) {
      Job so_far = job;
      so_far.sweeps.resize(count);
      EXPECT_TRUE(same(stock.at(count), cut(so_far, 0.5, 1))) << count << " of the sweeps";
    }
  }
}

/// A groove through the whole block and far beyond it; the kept sweep is only a part of the groove.
TEST(Cut, APartOfTheNextSweep) {
  ToolGeometry g;
  g.diameter = 4, g.flutes = 12, g.length = 20;
  const Vec3 from{-400, 0, 6}, to{100, 0, 6};
  Stock stock(box_blank(block), 0.5, 1);
  stock.keep_past(1 << 20);
  stock.add_tool(shape_of(g));
  stock.add({{0, 3, 8}, {0, -3, 8}, 0});
  stock.add({from, to, 0});
  stock.cut();
  for (const double share : {0.0, 0.3, 0.79, 0.8, 0.801, 0.805, 0.9, 1.0}) {
    Stock wanted(box_blank(block), 0.5, 1);
    wanted.add_tool(shape_of(g));
    wanted.add({{0, 3, 8}, {0, -3, 8}, 0});
    wanted.add({from, from + share * (to - from), 0});
    wanted.cut();
    EXPECT_NEAR(volume_of(surface_of(stock.at(1, share))), volume_of(surface_of(wanted)), 1e-2) << share;
  }
  EXPECT_TRUE(same(stock.at(2), stock.at(2, 0.5))) << "nothing comes after the last";
}

// Three grooves of an end mill of 2 mm along Y, at X 1 to 3, 5 to 7 and 9 to 11, 3 mm deep: four walls, all in one brick.
TEST(Cut, ALineInSeveralPieces) {
  ToolGeometry g;
  g.diameter = 2, g.flutes = 10;
  Stock stock(box_blank({{0, 0, -8}, {12, 12, 0}}), 1, 1);
  stock.add_tool(shape_of(g));
  for (const double x : {10.0, 2.0, 6.0}) stock.add({{x, -5, -3}, {x, 20, -3}, 0, false});
  stock.cut();
  const Brick& brick = *stock.brick(0);
  const Vec3 corner = stock.lattice().corner(0);
  const auto row = [&](double y, double z) { return int(z - corner.z) * brick_edge + int(y - corner.y); };
  const int line = row(5.5, -1.5);
  std::vector<std::tuple<double, double, int, int>> pieces;
  const BrickLines& lines = brick.family[0];
  pieces.emplace_back(lines.from[line] + float(corner.x), lines.to[line] + float(corner.x), lines.from_by[line], lines.to_by[line]);
  for (const FurtherInterval& f : lines.further)
    if (f.line == line) pieces.emplace_back(f.from + float(corner.x), f.to + float(corner.x), f.from_by, f.to_by);
  std::sort(pieces.begin(), pieces.end());
  EXPECT_EQ(pieces,
            (std::vector<std::tuple<double, double, int, int>>{{0, 1, of_blank, 1}, {3, 5, 1, 2}, {7, 9, 2, 0}, {11, 12, 0, of_blank}}));
  for (std::size_t i = 0; i < 3; ++i) EXPECT_NEAR(stock.removed_by(i), 2 * 12 * 3, 1e-3);
}

// A T-slot cutter has entered from the side, so there is material above and
// below it: vertical lines are in two pieces. Then a mill removes one piece.
TEST(Cut, AnUndercutAndWhatIsAboveItTakenAway) {
  ToolGeometry slot, mill;
  slot.kind = ToolKind::tslot, slot.diameter = 6, slot.flutes = 2, slot.length = 20, slot.shank = {{2, 2}, {2, 20}};
  mill.diameter = 6, mill.flutes = 20;
  Stock stock(box_blank({{0, 0, -10}, {12, 12, 0}}), 0.5, 1);
  stock.add_tool(shape_of(slot)), stock.add_tool(shape_of(mill));
  stock.add({{6, -10, -7}, {6, 30, -7}, 0, false});
  stock.cut();
  EXPECT_NEAR(stock.removed_by(0), 12 * (6 * 2 + 2 * 5), 1e-2);
  stock.add({{4, -10, -3}, {4, 30, -3}, 1, false});
  stock.cut();
  EXPECT_NEAR(stock.removed_by(1), 12 * (6 - 2) * 3, 1e-2);
}

// A tool wider than bricks removes whole bricks; their volume still counts for the sweep.
TEST(Cut, WholeBricks) {
  ToolGeometry g;
  g.diameter = 40, g.flutes = 30;
  Stock stock(box_blank({{0, 0, -20}, {60, 60, 0}}), 0.5, 1);
  stock.add_tool(shape_of(g));
  stock.add({{30, 30, 5}, {30, 30, -10}, 0, false});
  stock.add({{30, 30, -10}, {40, 30, -10}, 0, false});
  stock.cut();
  EXPECT_NEAR(stock.removed_by(0), pi * 400 * 10, 20);
  EXPECT_NEAR(stock.removed_by(1), 10 * 40 * 10, 40);
}

}  // namespace
}  // namespace kadr::cut_test
