// The result of sweeps of tilted tools: the same for any threads and vector
// instructions of the processor, at any moment; what they touch; their surface.

#include "stock/cut/tilted_cut.h"

#include <gtest/gtest.h>

#include "stock/same_stock.h"
#include "stock/some_tilted.h"
#include "stock/stock_samples.h"
#include "stock/surface/surface.h"

namespace kadr::tilted_cut_test {
namespace {

const Box3 block{{-10, -10, -10}, {10, 10, 10}};
const Vec3 leaning{0, -0.5, 0.86602540378443865};  // tilted by 30 degrees

struct TiltedJob {
  std::vector<ToolShape> tools;
  std::vector<Sweep> sweeps;
};

TiltedJob some_tilted_job(Chance& chance, int sweeps) {
  TiltedJob job;
  for (int i = 0; i < 3; ++i) job.tools.push_back(some_tool(chance, SomeTool(chance.below(some_tools))));
  for (int i = 0; i < sweeps; ++i) {
    Sweep s = chance.below(3) == 0 ? some_move(chance) : some_tilted_move(chance);
    s.from = s.from - Vec3{3, 3, 0}, s.to = s.to - Vec3{3, 3, 0};
    s.tool = std::uint16_t(chance.below(3));
    job.sweeps.push_back(s);
  }
  return job;
}

Stock uncut(const TiltedJob& job, double cell, int threads) {
  Stock stock(box_blank(block), cell, threads);
  for (const ToolShape& t : job.tools) stock.add_tool(t);
  return stock;
}

Stock cut(const TiltedJob& job, double cell, int threads) {
  Stock stock = uncut(job, cell, threads);
  for (const Sweep& s : job.sweeps) stock.add(s);
  stock.cut();
  return stock;
}

TEST(TiltedCut, ThreadsChangeNoBit) {
  Chance chance(1);
  for (int round = 0; round < 3; ++round) {
    const TiltedJob job = some_tilted_job(chance, 25);
    const Stock one = cut(job, 0.4, 1), two = cut(job, 0.4, 2), four = cut(job, 0.4, 4);
    EXPECT_TRUE(same(one, two));
    EXPECT_TRUE(same(one, four));
    for (std::size_t i = 0; i < one.sweeps(); ++i) ASSERT_EQ(one.removed_by(i), four.removed_by(i));
  }
}

TEST(TiltedCut, TheProcessorsVectorsChangeNoBit) {
  if (widest_lanes() == LaneWidth::pair) GTEST_SKIP() << "this processor has no wider vectors";
  Chance chance(2);
  const BrickScale scale(0.75);
  const double edge = double(scale.edge);
  for (int round = 0; round < 100; ++round) {
    Brick pair, wide;
    for (Brick* brick : {&pair, &wide}) {
      for (BrickLines& lines : brick->family)
        for (int i = 0; i < brick_lines; ++i) lines.from[i] = 0, lines.to[i] = scale.edge, lines.from_by[i] = lines.to_by[i] = of_blank;
      refresh_tops(*brick, scale.cell);
    }
    for (int i = 0; i < 5; ++i) {
      const ToolShape tool = some_tool(chance, SomeTool(chance.below(some_tools)));
      const Sweep s = some_tilted_move(chance);
      const TiltedPath path = TiltedPath{s.from, s.to, s.from_direction, s.to_direction}.between(0.5, 0.51);
      const TiltedSweep sweep(path, {}, edge);
      for (const ConvexBody& body : tool.bodies) {
        const TiltedBody lean = tilted_body(body);
        const LocalSweep tip = local_sweep(path.from, path.to, {1, 1, 1}, edge);
        const SweptBody upright = swept_body(body);
        const TiltedCut one{sweep, lean, tip, upright};
        CutOutcome by_pair, by_wide;
        cut_brick_tilted(pair, scale, one, i, by_pair, LaneWidth::pair);
        cut_brick_tilted(wide, scale, one, i, by_wide, LaneWidth::wide);
        ASSERT_EQ(by_pair.length, by_wide.length);
        ASSERT_TRUE(same_brick(&pair, &wide)) << "round " << round << ", sweep " << i;
      }
    }
  }
}

TEST(TiltedCut, AnyMomentIsAsIfCutSoFar) {
  Chance chance(3);
  const TiltedJob job = some_tilted_job(chance, 16);
  Stock all = uncut(job, 0.5, 2);
  all.keep_past(1 << 24);
  std::vector<std::size_t> so_far;
  for (const Sweep& s : job.sweeps) all.add(s), so_far.push_back(all.sweeps());
  all.cut();
  for (std::size_t i = 0; i < job.sweeps.size(); i += 5) {
    const TiltedJob part{job.tools, {job.sweeps.begin(), job.sweeps.begin() + std::ptrdiff_t(i) + 1}};
    EXPECT_TRUE(same(all.at(so_far[i]), cut(part, 0.5, 1))) << "after " << i;
  }
  // Shortly before the end of a sweep the result is nearly that of the whole sweep.
  for (std::size_t count = 0; count + 1 < so_far.back(); count += 7)
    EXPECT_NEAR(volume_of(surface_of(all.at(count, 0.999999))), volume_of(surface_of(all.at(count + 1))), 0.05) << count;
}

/// The section that a flat end of 10 mm cuts out of a block 20 mm long in X,
/// with its tip at the middle of the top face and 5 mm below it: a trapezoid.
TEST(TiltedCut, ASlotHasItsSection) {
  for (const ToolKind kind : {ToolKind::flat, ToolKind::bull, ToolKind::taper}) {
    Stock stock(box_blank(block), 0.25, 2);
    stock.add_tool(test::tool_of(kind, 10, 40));
    stock.add({{-30, 0, 5}, {30, 0, 5}, 0, false, leaning, leaning});
    stock.cut();
    const Surface surface = surface_of(stock);
    EXPECT_LT(volume_of(surface), 8000);
    if (kind != ToolKind::flat) continue;
    EXPECT_NEAR(8000 - volume_of(surface), 20 * 50 / leaning.z, 0.3);
  }
}

/// The tool's end and sides cut planes: each point of the cut lies in one of them, and edges stay sharp.
TEST(TiltedCut, PointsLieInTheFaces) {
  Stock stock(box_blank(block), 0.5, 2);
  stock.add_tool(test::tool_of(ToolKind::flat, 10, 40));
  stock.add({{-30, 0, 5}, {30, 0, 5}, 0, false, leaning, leaning});
  stock.cut();
  const Surface surface = surface_of(stock);
  double worst = 0, all = 0, count = 0;
  for (std::size_t i = 0; i < surface.made_by.size(); ++i) {
    if (surface.made_by[i] == of_blank) continue;
    const double y = double(surface.points[3 * i + 1]), z = double(surface.points[3 * i + 2]) - 5;
    const double across = y * leaning.z - z * leaning.y, along_tool = y * leaning.y + z * leaning.z;
    const double off = std::min(std::fabs(along_tool), std::fabs(std::fabs(across) - 5));
    worst = std::max(worst, off), all += off, ++count;
  }
  EXPECT_LT(worst, 0.05);  // in a cell that the edge leaves again near its side
  EXPECT_LT(all / count, 0.002);
}

TEST(TiltedCut, AHolderThatIsTiltedIsReported) {
  ToolGeometry g;
  g.kind = ToolKind::flat, g.diameter = 4, g.flutes = 4, g.length = 4;
  g.holder = {{20, 0}, {20, 20}};
  Stock stock(box_blank(block), 0.5, 2);
  stock.add_tool(shape_of(g));
  const Vec3 flat{0, -std::sqrt(0.96), 0.2};
  stock.add({{-30, 0, 9}, {30, 0, 9}, 0, false, flat, flat});
  stock.add({{-30, 0, 30}, {30, 0, 30}, 0, false, flat, flat});
  const std::vector<Touch> touches = stock.cut();
  ASSERT_FALSE(touches.empty());
  EXPECT_EQ(touches.back().sweep, 0u);
  EXPECT_EQ(touches.back().part, ToolPart::holder);
}

TEST(TiltedCut, HalvedPartsTakeTheSame) {
  for (const ToolKind kind : {ToolKind::flat, ToolKind::ball}) {
    double removed[2] = {};
    for (const int halves : {1, 2}) {
      Stock stock(box_blank(block), 0.25, 2);
      stock.add_tool(test::tool_of(kind, 6, 40));
      const TiltedPath all{{-12, -2, 6}, {12, 2, 6}, {0.3, 0, std::sqrt(0.91)}, {-0.2, 0.3, std::sqrt(0.87)}};
      const int count = 100 * halves;
      for (int i = 0; i < count; ++i) {
        const TiltedPath w = all.between(double(i) / count, double(i + 1) / count);
        stock.add({w.from, w.to, 0, false, w.from_direction, w.to_direction});
      }
      stock.cut();
      for (std::size_t i = 0; i < stock.sweeps(); ++i) removed[halves - 1] += stock.removed_by(i);
    }
    EXPECT_NEAR(removed[0] / removed[1], 1, 5e-5);
  }
}

}  // namespace
}  // namespace kadr::tilted_cut_test
