// One sweep of any tool: a point of a lattice line is material exactly where it lies outside the volume swept by the tool.
// STOCK_POINTS and STOCK_SEED in the environment set the number of points and their random seed; dev/properties changes the seed.

#include <gtest/gtest.h>

#include <array>
#include <cstdio>

#include "stock/line_positions.h"
#include "stock/some_tools.h"

namespace kadr::sweep_test {
namespace {

constexpr double permitted = 1e-3;  // mm
const Box3 block{{-1, -1, -1}, {9, 9, 9}};

std::string sweeps_described(const ToolShape& tool, const std::vector<Sweep>& sweeps, const LinePosition& p) {
  const ToolGeometry& g = tool.geometry;
  char text[600];
  std::snprintf(text, sizeof text, "diameter %.17g corner %.17g angle %.17g tip %.17g flutes %.17g, family %d place (%.9g %.9g %.9g)",
                g.diameter, g.corner, g.angle, g.tip, g.flutes, p.family, p.at.x, p.at.y, p.at.z);
  std::string all = text;
  for (const ConvexBody& body : tool.bodies)
    for (const RoundSolid& r : body.solids) {
      std::snprintf(text, sizeof text, "\n  form %d from %.9g to %.9g radius %.9g to %.9g", int(r.form), r.bottom, r.top, r.bottom_radius,
                    r.top_radius);
      all += text;
    }
  for (const Sweep& s : sweeps) {
    std::snprintf(text, sizeof text, "\n  from (%.17g %.17g %.17g) way (%.9g %.9g %.9g)", s.from.x, s.from.y, s.from.z, s.to.x - s.from.x,
                  s.to.y - s.from.y, s.to.z - s.from.z);
    all += text;
  }
  return all;
}

// Every fourth tool performs several sweeps.
TEST(SweepProperty, LeavesWhatLiesOutsideOfTheSweptTool) {
  constexpr int places_of_a_sweep = 60;
  const std::uint64_t points = asked("STOCK_POINTS", 120000), seed = asked("STOCK_SEED", seed_of_properties());
  Chance chance(seed);
  std::array<double, some_tools> worst{};
  std::uint64_t looked_at = 0;
  int shown = 0;
  for (int round = 0; looked_at < points; ++round) {
    const auto which = SomeTool(round % some_tools);
    const ToolShape tool = some_tool(chance, which);
    std::vector<Sweep> sweeps{some_move(chance)};
    while (round / some_tools % 4 == 3 && sweeps.size() < 4) sweeps.push_back(some_move(chance));
    Stock stock(box_blank(block), 0.5, 1);
    stock.add_tool(tool);
    for (const Sweep& s : sweeps) stock.add(s);
    stock.cut();
    for (int i = 0; i < places_of_a_sweep; ++i) {
      const LinePosition p = some_place(stock, chance);
      if (!within(block, p.at)) continue;
      ++looked_at;
      double distance = from_swept(tool, sweeps.front(), p.at);
      for (const Sweep& s : sweeps) distance = std::min(distance, from_swept(tool, s, p.at));
      if (!p.is_end && (distance > 0) == is_material(stock, p)) continue;
      double& most = worst[std::size_t(which)];
      most = std::max(most, std::fabs(distance));
      if (std::fabs(distance) > permitted && ++shown <= 8)
        ADD_FAILURE() << name_of(which) << ", seed " << seed << ": wrong by " << distance << " mm; " << sweeps_described(tool, sweeps, p);
    }
  }
  for (int i = 0; i < some_tools; ++i) {
    EXPECT_LE(worst[std::size_t(i)], permitted) << name_of(SomeTool(i)) << ", seed " << seed;
    std::printf("%-22s greatest error %.6f mm\n", name_of(SomeTool(i)), worst[std::size_t(i)]);
  }
}

}  // namespace
}  // namespace kadr::sweep_test
