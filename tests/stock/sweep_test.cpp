// What one sweep of any tool leaves: a point of a lattice line is material exactly where it lies outside of what the tool sweeps.
//
// STOCK_POINTS and STOCK_SEED in the environment say how many points are looked at, and which; dev/properties changes the seed.

#include <gtest/gtest.h>

#include <array>
#include <cstdio>

#include "stock/some_tools.h"

namespace kadr {
namespace {

constexpr double permitted = 1e-3;  // mm
const Box3 block{{-1, -1, -1}, {9, 9, 9}};

/// A place on a lattice line.
struct LinePlace {
  std::size_t brick;
  int family, line;
  Vec3 corner, at;      // of the brick; the place
  bool is_end = false;  // that the sweep has made: on the surface of what it sweeps
};

bool is_material(const Stock& stock, const LinePlace& p) {
  if (stock.brick(p.brick) == nullptr) return stock.state(p.brick) == Stock::State::full;
  const BrickLines& lines = stock.brick(p.brick)->family[std::size_t(p.family)];
  const double along_line = along(p.at, p.family) - along(p.corner, p.family);
  bool within = lines.from[p.line] < lines.to[p.line] && along_line >= double(lines.from[p.line]) && along_line <= double(lines.to[p.line]);
  for (const FurtherInterval& f : lines.further)
    within = within || (f.line == p.line && along_line >= double(f.from) && along_line <= double(f.to));
  return within;
}

/// Most lie at an end that the sweep has made or close to it, if there is one on the line.
LinePlace some_place(const Stock& stock, Chance& chance) {
  const Lattice& lattice = stock.lattice();
  const std::size_t brick = std::size_t(chance.below(int(lattice.size())));
  LinePlace p{brick, chance.below(3), chance.below(brick_lines), lattice.corner(brick), {}};
  p.at = p.corner;
  along(p.at, (p.family + 1) % 3) += (p.line % brick_edge + 0.5) * lattice.cell();
  along(p.at, (p.family + 2) % 3) += (p.line / brick_edge + 0.5) * lattice.cell();
  double from_corner = chance.between(0, lattice.edge());
  const double beside = chance.between(-0.01, 0.01);
  const int wanted = chance.below(3);
  if (const Brick* b = stock.brick(brick); b != nullptr && wanted != 0) {
    const BrickLines& lines = b->family[std::size_t(p.family)];
    const bool any = lines.from[p.line] < lines.to[p.line], from = any && lines.from_by[p.line] != of_blank,
               to = any && lines.to_by[p.line] != of_blank;
    p.is_end = wanted == 1 && (from || to);
    if (from || to) from_corner = double(from ? lines.from[p.line] : lines.to[p.line]) + (p.is_end ? 0 : beside);
  }
  along(p.at, p.family) += std::clamp(from_corner, 0.0, lattice.edge());
  return p;
}

bool within(const Box3& box, Vec3 at) {
  bool inside = true;
  for (int d = 0; d < 3; ++d) inside = inside && along(at, d) > along(box.least, d) && along(at, d) < along(box.most, d);
  return inside;
}

std::string told(const ToolShape& tool, const std::vector<Sweep>& sweeps, const LinePlace& p) {
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

// Every fourth tool makes several sweeps.
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
      const LinePlace p = some_place(stock, chance);
      if (!within(block, p.at)) continue;
      ++looked_at;
      double distance = from_swept(tool, sweeps.front(), p.at);
      for (const Sweep& s : sweeps) distance = std::min(distance, from_swept(tool, s, p.at));
      if (!p.is_end && (distance > 0) == is_material(stock, p)) continue;
      double& most = worst[std::size_t(which)];
      most = std::max(most, std::fabs(distance));
      if (std::fabs(distance) > permitted && ++shown <= 8)
        ADD_FAILURE() << name_of(which) << ", seed " << seed << ": wrong by " << distance << " mm; " << told(tool, sweeps, p);
    }
  }
  for (int i = 0; i < some_tools; ++i) {
    EXPECT_LE(worst[std::size_t(i)], permitted) << name_of(SomeTool(i)) << ", seed " << seed;
    std::printf("%-22s greatest error %.6f mm\n", name_of(SomeTool(i)), worst[std::size_t(i)]);
  }
}

}  // namespace
}  // namespace kadr
