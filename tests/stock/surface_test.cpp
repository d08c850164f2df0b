// stock/surface/surface: the remaining stock as a closed mesh, compared with volumes computed by hand and with the lattice lines.

#include "stock/surface/surface.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "stock/mesh/mesh_edges.h"
#include "stock/some_tools.h"
#include "stock/stock_samples.h"

namespace kadr::surface_test {
namespace {

using test::block;
using test::cut_along;
using test::tool_of;

constexpr double block_volume = 200'000;

void expect_manifold(const Surface& surface) {
  const MeshEdges edges = edges_of(surface);
  EXPECT_EQ(edges.open, 0U);
  EXPECT_EQ(edges.doubled, 0U);
  EXPECT_EQ(surface.made_by.size(), surface.point_count());
  for (const std::uint32_t t : surface.triangles) ASSERT_LT(t, surface.point_count());
}

double removed_by(const Surface& surface) { return block_volume - volume_of(surface); }

/// Returns the volume in mm³ from the lines of one family.
double volume_by_lines(const Stock& stock, std::size_t family) {
  double sum = 0;
  for (std::size_t i = 0; i < stock.lattice().size(); ++i) {
    if (stock.state(i) == Stock::State::full) sum += brick_lines * stock.lattice().edge();
    if (stock.brick(i) == nullptr) continue;
    const BrickLines& lines = stock.brick(i)->family[family];
    for (int k = 0; k < brick_lines; ++k) sum += std::max(0.0, double(lines.to[k]) - double(lines.from[k]));
    for (const FurtherInterval& f : lines.further) sum += double(f.to) - double(f.from);
  }
  return sum * stock.lattice().cell() * stock.lattice().cell();
}

TEST(surface, a_box_is_exact) {
  for (const double cell : {0.7, 1.0, 2.3}) {
    const Stock stock(box_blank({{1, 2, 3}, {11.3, 22.1, 8.25}}), cell, 1);
    const Surface surface = surface_of(stock);
    expect_manifold(surface);
    EXPECT_NEAR(volume_of(surface), 10.3 * 20.1 * 5.25, 1e-3) << cell;
    const Box3 box = box_of(surface);
    EXPECT_NEAR(box.least.x, 1, 1e-5);
    EXPECT_NEAR(box.most.z, 8.25, 1e-5);
    for (const std::int32_t by : surface.made_by) EXPECT_EQ(by, of_blank);
  }
}

TEST(surface, a_cylinder) {
  const double exact = pi * 10 * 10 * 12;
  for (const double cell : {0.5, 1.0}) {
    const Stock stock(cylinder_blank({3, 4}, -12, 0, 20), cell, 2);
    const Surface surface = surface_of(stock);
    expect_manifold(surface);
    // Points at which the tangents meet lie outside the circle by at most h²
    // / 2r, where h is half a cell; as a share of the volume this is h² / r².
    EXPECT_NEAR(volume_of(surface), exact, exact * cell * cell / 400) << cell;
  }
}

/// A slot from side to side with a section of `section` mm²; the error of the
/// faces between points is less than 0.05 % of it for each mm of the cell.
TEST(surface, slots_have_their_section) {
  const std::vector<Vec3> path{{50.0371, -20, -4.0437}, {50.0371, 120, -4.0437}};
  struct Case {
    ToolShape tool;
    double section;
  };
  const double d = 4.0437, flat = 6 * d, ball = pi * 9 / 2 + 6 * (d - 3), bull = 6 * d - 2 * (1 - pi / 4);
  const double taper = d * (2 * 3 - 2 * 8 * std::tan(12 * rad_per_deg)) + d * d * std::tan(12 * rad_per_deg);
  for (const auto& [tool, section] : {Case{tool_of(ToolKind::flat, 6), flat},
                                      {tool_of(ToolKind::ball, 6), ball},
                                      {tool_of(ToolKind::bull, 6), bull},
                                      {tool_of(ToolKind::taper, 6, 8), taper}})
    for (const double cell : {0.25, 0.5}) {
      const auto stock = cut_along(box_blank(block), cell, tool, path);
      const Surface surface = surface_of(*stock);
      expect_manifold(surface);
      EXPECT_NEAR(removed_by(surface), section * 100, section * 100 * 5e-4 * cell) << int(tool.geometry.kind) << " " << cell;
    }
}

TEST(surface, a_t_slot_keeps_its_undercut) {
  const double z = -10.0437, section = 10 * 2 + 4 * (-z - 2);
  for (const double cell : {0.5, 0.25}) {
    const auto stock = cut_along(box_blank(block), cell, test::t_slot_cutter(10, 2, 4), {{50.0371, -20, z}, {50.0371, 120, z}});
    const Surface surface = surface_of(*stock);
    expect_manifold(surface);
    EXPECT_NEAR(removed_by(surface), section * 100, section * 100 * 2e-4) << cell;
  }
}

TEST(surface, a_ring_of_chords) {
  const double r = 10, z = -8.0437;
  std::vector<Vec3> path;
  const int chords = 800;
  for (int k = 0; k <= chords; ++k)
    path.push_back({50.0371 + r * std::cos(2 * pi * k / chords), 49.9613 + r * std::sin(2 * pi * k / chords), z});
  const auto stock = cut_along(box_blank(block), 0.25, tool_of(ToolKind::flat, 6), path);
  const Surface surface = surface_of(*stock);
  expect_manifold(surface);
  const double exact = pi * (13 * 13 - 7 * 7) * -z;
  EXPECT_NEAR(removed_by(surface), exact, exact * 1e-4);
}

TEST(surface, sharp_edges_stay) {
  const auto stock = cut_along(box_blank(block), 1, tool_of(ToolKind::flat, 8), {{50.3, -20, -5.3}, {50.3, 120, -5.3}});
  const Surface surface = surface_of(*stock);
  std::size_t on_edge = 0;
  for (std::size_t i = 0; i < surface.point_count(); ++i) {
    const Vec3 p = surface.point(i);
    if (std::fabs(p.x - 46.3) < 0.001 && std::fabs(p.z + 5.3) < 0.001) ++on_edge;
  }
  EXPECT_GE(on_edge, 100U);  // one point in each cell along the foot of the wall
}

TEST(surface, points_know_their_sweep) {
  const auto stock =
      cut_along(box_blank(block), 1, tool_of(ToolKind::flat, 8), {{20, -20, -5.3}, {20, 120, -5.3}, {60, 120, -7.3}, {60, -20, -7.3}});
  const Surface surface = surface_of(*stock);
  for (std::size_t i = 0; i < surface.point_count(); ++i) {
    const Vec3 p = surface.point(i);
    if (std::fabs(p.z + 5.3) < 0.01 && p.x > 17 && p.x < 23 && p.y > 2 && p.y < 98) {
      EXPECT_EQ(surface.made_by[i], 0);
    }
    if (std::fabs(p.z + 7.3) < 0.01 && p.x > 57 && p.x < 63 && p.y > 2 && p.y < 98) {
      EXPECT_EQ(surface.made_by[i], 2);
    }
    if (p.z < -19.9) {
      EXPECT_EQ(surface.made_by[i], of_blank);
    }
  }
}

/// A floor in a plane of lattice points, or at the border of bricks. There
/// the families differ by a tiny amount, which must not appear at the edges.
TEST(surface, floors_in_planes_of_the_lattice) {
  for (const double z : {-4.5, -4.0, -5.0, -15.0, -4.5000001})  // cells of 1 mm from -21: points are at halves, bricks meet at -5
    for (const ToolKind kind : {ToolKind::flat, ToolKind::bull}) {
      const auto stock = cut_along(box_blank(block), 1, tool_of(kind, 8), {{50.3, -20, z}, {50.3, 120, z}});
      const Surface surface = surface_of(*stock);
      expect_manifold(surface);
      const double corner = kind == ToolKind::bull ? 8.0 / 6 : 0, section = 8 * -z - 2 * corner * corner * (1 - pi / 4);
      EXPECT_NEAR(removed_by(surface), section * 100, section * 100 * 2e-3) << z << " " << int(kind);
    }
}

struct Program {
  std::vector<ToolShape> tools;
  std::vector<Sweep> sweeps;
};

Program random_program(Chance& chance) {
  Program p;
  for (int i = 0; i < some_tools; ++i) p.tools.push_back(some_tool(chance, SomeTool(i)));
  const auto place = [&] { return Vec3{chance.between(-5, 35), chance.between(-5, 35), chance.between(-12, 3)}; };
  Vec3 at = place();
  for (int i = 0; i < 12; ++i) {
    Vec3 to = place();
    if (chance.below(3) == 0) to.z = at.z;
    if (chance.below(5) == 0) to.x = at.x, to.y = at.y;
    p.sweeps.push_back({at, to, std::uint16_t(chance.below(some_tools)), false});
    at = to;
  }
  return p;
}

std::unique_ptr<Stock> run(const Program& p, std::shared_ptr<const Blank> blank, double cell, int threads) {
  auto stock = std::make_unique<Stock>(std::move(blank), cell, threads);
  for (const ToolShape& t : p.tools) stock->add_tool(t);
  for (const Sweep& s : p.sweeps) stock->add(s);
  stock->cut();
  return stock;
}

/// A family of lines does not see the position of a parallel face between its lines. The error is up to half a cell, over at most half
/// of the area, because faces with opposite normals have opposite errors.
RC_GTEST_PROP(surface, random_programs_are_closed_and_hold_what_the_lines_hold, (unsigned seed)) {
  Chance chance(seed);
  const Program p = random_program(chance);
  const bool round = chance.below(2) == 0;
  const auto blank = round ? cylinder_blank({15, 15}, -11.3, 0, 29) : box_blank({{0, 0, -11.3}, {30, 28, 0}});
  const auto stock = run(p, blank, 0.5, 2);
  const Surface surface = surface_of(*stock);
  const MeshEdges edges = edges_of(surface);
  RC_ASSERT(edges.open == 0U);
  RC_ASSERT(edges.doubled == 0U);
  const double cell = 0.5, bound = 0.5 * cell * 0.5 * area_of(surface);
  const double volume = volume_of(surface);
  for (std::size_t family = 0; family < 3; ++family) {
    const double by_lines = volume_by_lines(*stock, family);
    RC_LOG() << "family " << family << ": " << by_lines << ", by the mesh " << volume << ", bound " << bound << "\n";
    RC_ASSERT(std::fabs(volume - by_lines) < bound);
  }
}

RC_GTEST_PROP(surface, any_number_of_threads_gives_the_same_bits, (unsigned seed)) {
  Chance chance(seed);
  const Program p = random_program(chance);
  const auto blank = box_blank({{0, 0, -11.3}, {30, 28, 0}});
  const Surface one = surface_of(*run(p, blank, 1, 1));
  for (const int threads : {2, 4}) {
    const Surface other = surface_of(*run(p, blank, 1, threads));
    RC_ASSERT(one.points == other.points);
    RC_ASSERT(one.triangles == other.triangles);
    RC_ASSERT(one.made_by == other.made_by);
  }
}

/// The lattice of this block begins at -1, -1, -21, so the seams are at X 15, Y 15 and Z -5.
TEST(surface, a_cut_at_the_seam_of_two_bricks_knows_its_sweep) {
  const auto stock = cut_along(box_blank(block), 1, tool_of(ToolKind::flat, 10),
                               {{20, 20, 5}, {20, 20, -5}, {80, 20, -5}, {80, 28, -5}, {20, 28, -5}, {20, 20, -5}});
  const Surface surface = surface_of(*stock);
  expect_manifold(surface);
  std::size_t floor = 0, walls = 0;
  for (std::size_t i = 0; i < surface.point_count(); ++i) {
    const Vec3 at = surface.point(i);
    const bool inside = at.x > 14.9 && at.x < 85.1 && at.y > 14.9 && at.y < 33.1 && at.z < -0.1 && at.z > -5.1;
    if (!inside) continue;
    ++(at.z < -4.9 ? floor : walls);
    const std::int32_t by = surface.made_by[i];
    ASSERT_NE(by, of_blank) << at.x << " " << at.y << " " << at.z;
    if (at.x > 30 && at.x < 70 && at.y > 15.5 && at.y < 22.5) {
      EXPECT_EQ(by, 1) << at.x << " " << at.y;
    }
  }
  EXPECT_GT(floor, 1000U);
  EXPECT_GT(walls, 500U);
}

}  // namespace
}  // namespace kadr::surface_test
