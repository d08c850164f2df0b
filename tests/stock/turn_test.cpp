// Turning tools: the material that they leave on a rotating part, compared with the distance from their swept volume and with volumes
// computed by hand.
// STOCK_POINTS and STOCK_SEED in the environment set the number of points and their random seed; dev/properties changes the seed.

#include <gtest/gtest.h>

#include <cstdio>

#include "config/tools/tool_formats.h"
#include "stock/line_positions.h"
#include "stock/material_around.h"
#include "stock/some_inserts.h"
#include "stock/stock_samples.h"
#include "stock/surface/surface.h"
#include "stock/surface/turned_normal.h"

namespace kadr::turn_test {
namespace {

constexpr double permitted = 1e-3;  // mm
const Box3 bar{{-9, -9.2, -1}, {9.4, 9, 9}};

struct Place {
  std::size_t brick;
  int family, line;
  double along_line;  // distance from the brick's corner
  Vec3 at;
  bool is_end = false;  // an end made by a sweep
};

bool is_left(const Stock& stock, const Place& p) {
  if (stock.brick(p.brick) == nullptr) return stock.state(p.brick) == Stock::State::full;
  const BrickLines& lines = stock.brick(p.brick)->family[std::size_t(p.family)];
  const auto holds = [&](float from, float to) { return from < to && p.along_line >= double(from) && p.along_line <= double(to); };
  return holds(lines.from[p.line], lines.to[p.line]) ||
         std::any_of(lines.further.begin(), lines.further.end(),
                     [&](const FurtherInterval& f) { return f.line == p.line && holds(f.from, f.to); });
}

/// Returns a point; two in three are at or close to an end that a sweep has made.
Place some_place_by_turning(const Stock& stock, Chance& chance) {
  Place p{std::size_t(chance.below(int(stock.lattice().size()))), chance.below(3), chance.below(brick_lines), 0, {}};
  const double cell = stock.lattice().cell();
  p.along_line = chance.between(0, stock.lattice().edge());
  const int wanted = chance.below(3);
  if (const Brick* b = stock.brick(p.brick); b != nullptr && wanted != 0) {
    const BrickLines& lines = b->family[std::size_t(p.family)];
    std::vector<double> ends;
    const auto see = [&](float from, float to, std::int32_t from_by, std::int32_t to_by) {
      if (!(from < to)) return;
      if (from_by != of_blank) ends.push_back(double(from));
      if (to_by != of_blank) ends.push_back(double(to));
    };
    see(lines.from[p.line], lines.to[p.line], lines.from_by[p.line], lines.to_by[p.line]);
    for (const FurtherInterval& f : lines.further)
      if (f.line == p.line) see(f.from, f.to, f.from_by, f.to_by);
    p.is_end = wanted == 1 && !ends.empty();
    if (!ends.empty()) p.along_line = ends[std::size_t(chance.below(int(ends.size())))] + (p.is_end ? 0 : chance.between(-0.01, 0.01));
  }
  p.along_line = std::clamp(p.along_line, 0.0, stock.lattice().edge());
  p.at = stock.lattice().corner(p.brick);
  along(p.at, p.family) += p.along_line;
  along(p.at, (p.family + 1) % 3) += (p.line % brick_edge + 0.5) * cell;
  along(p.at, (p.family + 2) % 3) += (p.line / brick_edge + 0.5) * cell;
  return p;
}

std::string described(const ToolShape& tool, const Sweep& s, const Place& p) {
  char text[300];
  std::snprintf(text, sizeof text, "family %d place (%.9g %.9g %.9g) from (%.17g %.17g) to (%.17g %.17g) tip %d %d", p.family, p.at.x,
                p.at.y, p.at.z, s.from.x, s.from.z, s.to.x, s.to.z, tool.geometry.insert.tip_x, tool.geometry.insert.tip_z);
  std::string all = text;
  for (const InsertBody& body : tool.insert) {
    all += "\n ";
    for (const InsertCorner& c : body.corners) {
      std::snprintf(text, sizeof text, " (%.9g %.9g r %.9g)", c.centre.x, c.centre.z, c.radius);
      all += text;
    }
  }
  return all;
}

// Every fourth tool moves along several paths.
TEST(TurnProperty, LeavesWhatLiesOutsideOfTheRings) {
  const std::uint64_t points = asked("STOCK_POINTS", 30000), seed = asked("STOCK_SEED", seed_of_properties());
  Chance chance(seed);
  double worst = 0;
  std::uint64_t looked_at = 0, at_ends = 0;
  int shown = 0;
  for (int round = 0; looked_at < points; ++round) {
    const ToolShape tool = some_insert(chance);
    std::vector<Sweep> sweeps{some_sweep(chance)};
    while (round % 4 == 3 && sweeps.size() < 4) sweeps.push_back(some_sweep(chance));
    Stock stock(box_blank(bar), 0.5, 1);
    stock.add_tool(tool);
    for (const Sweep& s : sweeps) stock.add(s);
    stock.cut();
    for (int i = 0; i < 60; ++i) {
      const Place p = some_place_by_turning(stock, chance);
      if (!within(bar, p.at)) continue;
      ++looked_at, at_ends += p.is_end;
      double distance = 1e30;
      Sweep nearest = sweeps.front();
      for (const Sweep& s : sweeps)
        if (const double d = from_rings(tool, s, p.at); d < distance) distance = d, nearest = s;
      if (!p.is_end && (distance > 0) == is_left(stock, p)) continue;
      worst = std::max(worst, std::fabs(distance));
      if (std::fabs(distance) > permitted && ++shown <= 5)
        ADD_FAILURE() << "seed " << seed << ": wrong by " << distance << " mm; " << described(tool, nearest, p) << (p.is_end ? " end" : "");
    }
  }
  EXPECT_GT(at_ends, points / 20);
  EXPECT_LE(worst, permitted) << "seed " << seed;
  std::printf("%llu places, %llu of them ends; greatest error %.6f mm\n", static_cast<unsigned long long>(looked_at),
              static_cast<unsigned long long>(at_ends), worst);
}

/// Where the distance is smooth, the normal is the direction in which it increases.
TEST(TurnProperty, NormalIsTheGradientOfTheDistance) {
  Chance chance(asked("STOCK_SEED", seed_of_properties()));
  int compared = 0;
  for (int round = 0; round < 400; ++round) {
    const ToolShape tool = some_insert(chance);
    Sweep sweep = some_sweep(chance);
    if (length(sweep.to - sweep.from) > 50) continue;
    KeptSweep kept{{float(sweep.from.x), 0, float(sweep.from.z)}, {float(sweep.to.x), 0, float(sweep.to.z)}, 0, false, false};
    sweep.from = {double(kept.from[0]), 0, double(kept.from[2])}, sweep.to = {double(kept.to[0]), 0, double(kept.to[2])};
    const int family = chance.below(3);
    Vec3 inside = 0.5 * (sweep.from + sweep.to) + Vec3{chance.between(-4, 4), 0, chance.between(-4, 4)};
    const double turn = chance.between(0, 2 * pi);
    inside = {inside.x * std::cos(turn), inside.x * std::sin(turn), inside.z};
    if (from_rings(tool, sweep, inside) > -0.01) continue;
    Vec3 outside = inside;
    for (int i = 0; i < 200 && from_rings(tool, sweep, outside) < 0; ++i) along(outside, family) += 0.1;
    if (from_rings(tool, sweep, outside) < 0) continue;
    for (int i = 0; i < 45; ++i) {
      const Vec3 middle = 0.5 * (inside + outside);
      (from_rings(tool, sweep, middle) < 0 ? inside : outside) = middle;
    }
    constexpr double h = 1e-4;
    Vec3 forth, back;
    const double here = from_rings(tool, sweep, outside);
    for (int d = 0; d < 3; ++d) {
      Vec3 a = outside, b = outside;
      along(a, d) += h, along(b, d) -= h;
      along(forth, d) = (from_rings(tool, sweep, a) - here) / h, along(back, d) = (here - from_rings(tool, sweep, b)) / h;
    }
    const Vec3 grows = 0.5 * (forth + back);
    if (length(forth - back) > 0.02 || std::fabs(length(grows) - 1) > 0.02 || std::fabs(along(grows, family)) < 0.05) continue;
    const Vec3 normal = turned_normal(kept, tool, {outside, family, false}, {});
    ++compared;
    EXPECT_LT(length(normal + grows), 0.03) << "round " << round << " " << described(tool, sweep, {0, family, 0, 0, outside});
  }
  EXPECT_GT(compared, 40);
}

std::shared_ptr<const Blank> rod(double diameter) { return cylinder_blank({0, 0}, -40, 0, diameter); }

/// Checks the volume of the surface within the error that docs/stock.md states.
void expect_volume(const Stock& stock, double exact) {
  const Surface surface = surface_of(stock);
  EXPECT_NEAR(volume_of(surface), exact, 0.02 * stock.lattice().cell() * area_of(surface));
}

const ToolShape right_hand = shape_of(insert(-1, -1, 80, 0, 12));

TEST(turn, a_step_is_a_cylinder_less) {
  // From diameter 40 down to 30 over 20 mm of the rod.
  const auto stock = test::cut_along(rod(40), 0.5, right_hand, {{15, 0, 2}, {15, 0, -20}, {22, 0, -20}});
  expect_volume(*stock, pi * (20 * 20 * 40.0 - (20 * 20 - 15 * 15) * 20.0));
}

TEST(turn, on_the_far_side_of_the_axis_the_same) {
  ToolGeometry g = insert(1, -1, 80, 0, 12);
  const auto stock = test::cut_along(rod(40), 0.5, shape_of(g), {{-15, 0, 2}, {-15, 0, -20}, {-22, 0, -20}});
  expect_volume(*stock, pi * (20 * 20 * 40.0 - (20 * 20 - 15 * 15) * 20.0));
}

TEST(turn, a_cone) {
  const auto stock = test::cut_along(rod(40), 0.5, right_hand, {{0, 0, 0}, {20, 0, -20}, {25, 0, -25}});
  expect_volume(*stock, pi * 20 * 20 * (20 + 20 / 3.0));
}

TEST(turn, a_face_as_far_as_the_axis) {
  const auto stock = test::cut_along(rod(40), 0.5, right_hand, {{25, 0, -3}, {-0.5, 0, -3}});
  expect_volume(*stock, pi * 20 * 20 * 37.0);
}

TEST(turn, a_ball) {
  // The path consists of chords within 0.2 µm of the circle. The lower edge rises outwards, so the tip cuts.
  ToolGeometry g = insert(-1, 0, 30, 0, 30);
  g.insert.lead = 93;
  std::vector<Vec3> path;
  for (int i = 0; i <= 400; ++i) {
    const SinCos at = sincos_deg(i * 90.0 / 400);
    path.push_back({15 * at.sin, 0, -15 + 15 * at.cos});
  }
  path.push_back({25, 0, -15});
  const auto stock = test::cut_along(rod(40), 0.5, shape_of(g), path);
  expect_volume(*stock, pi * 20 * 20 * 25.0 + 2.0 / 3 * pi * 15 * 15 * 15);
}

TEST(turn, a_groove_with_round_corners) {
  ToolGeometry g;
  g.kind = ToolKind::turning;
  g.insert.width = 4, g.corner = 1, g.flutes = 10;
  g.insert.tip_x = -1, g.insert.tip_z = -1;
  complete(g);
  const auto stock = test::cut_along(rod(40), 0.5, shape_of(g), {{25, 0, -20}, {14, 0, -20}});
  // The area between each arc and its corner, and the distance of its centroid from the corner.
  const double rest = 1 - pi / 4, middle = (10 - 3 * pi) / (12 - 3 * pi), corners = 2 * rest * 2 * pi * (14 + middle);
  expect_volume(*stock, pi * 20 * 20 * 40 - (pi * (20 * 20 - 14 * 14) * 4 - corners));
}

TEST(turn, a_nose_radius_stands_where_its_imaginary_tip_is) {
  const auto stock = test::cut_along(rod(40), 0.5, shape_of(insert(-1, -1, 80, 0.8, 12)), {{15, 0, 2}, {15, 0, -20}});
  // The tip cuts the cylinder; at the shoulder the nose leaves a fillet, followed by the edge at 95°.
  const auto radius_at = [&](double z) {
    double r = 14;
    while (from_rings(stock->tool(0), {{15, 0, 2}, {15, 0, -20}, 0, false}, {r, 0, z}) > 0) r += 0.001;
    return r;
  };
  EXPECT_NEAR(radius_at(-10), 15, 0.0011);
  EXPECT_NEAR(radius_at(-19.9), 15.8 - std::sqrt(0.8 * 0.8 - 0.7 * 0.7), 0.0011);
  const Surface surface = surface_of(*stock);
  EXPECT_NEAR(box_of(surface).most.z, 0, 1e-4);
}

TEST(turn, same_bits_for_any_number_of_threads_and_in_the_past) {
  Chance chance(7);
  const ToolShape tool = some_insert(chance);
  std::vector<Vec3> path{{25, 0, 2}};
  for (int i = 0; i < 60; ++i) path.push_back({chance.between(4, 22), 0, chance.between(-35, 1)});
  const auto one = test::cut_along(rod(40), 0.5, tool, path, 1), three = test::cut_along(rod(40), 0.5, tool, path, 3);
  Stock kept(rod(40), 0.5, 2);
  kept.keep_past(1 << 20);
  kept.add_tool(tool);
  for (std::size_t i = 1; i < path.size(); ++i) kept.add({path[i - 1], path[i], 0, false});
  kept.cut();
  const Stock then = kept.at(20);
  const auto first = test::cut_along(rod(40), 0.5, tool, {path.begin(), path.begin() + 21}, 2);
  const auto same = [](const Stock& a, const Stock& b) {
    for (std::size_t i = 0; i < a.lattice().size(); ++i) {
      ASSERT_EQ(a.state(i), b.state(i));
      if (a.brick(i) == nullptr) continue;
      for (std::size_t f = 0; f < 3; ++f) {
        const BrickLines &l = a.brick(i)->family[f], &m = b.brick(i)->family[f];
        for (int k = 0; k < brick_lines; ++k) {
          ASSERT_EQ(l.from[k], m.from[k]);
          ASSERT_EQ(l.to[k], m.to[k]);
          ASSERT_EQ(l.to_by[k], m.to_by[k]);
        }
        ASSERT_EQ(l.further.size(), m.further.size());
      }
    }
  };
  same(*one, *three);
  same(*one, kept);
  same(then, *first);
}

TEST(turn, what_is_watched_is_told_in_radii) {
  ToolGeometry g = insert(-1, -1, 80, 0, 5);
  g.insert.holder = {{6, -1}, {20, 12}};
  Stock stock(rod(40), 0.25, 2);
  stock.add_tool(shape_of(g));
  stock.add({{19, 0, 2}, {19, 0, -20}, 0, true});     // the edge cuts 1 mm deep
  stock.add({{25, 0, -20}, {12, 0, -20}, 0, false});  // so deep that the holder touches the part
  const auto touches = stock.cut();
  ASSERT_EQ(touches.size(), 2u);
  EXPECT_EQ(touches[0].part, ToolPart::cutting);
  EXPECT_NEAR(touches[0].around.least.x, 19, 0.05);
  EXPECT_NEAR(touches[0].around.most.x, 20, 0.05);
  EXPECT_NEAR(touches[0].around.least.z, -20, 0.3);
  EXPECT_NEAR(touches[0].volume, pi * (20 * 20 - 19 * 19) * 20, 40);
  EXPECT_EQ(touches[1].part, ToolPart::holder);
  EXPECT_NEAR(touches[1].around.least.x, 18, 0.05);
  EXPECT_NEAR(stock.removed_by(0), pi * (20 * 20 - 19 * 19) * 20, 40);
}

TEST(turn, the_table_of_linuxcnc_and_the_turners_words_say_the_same) {
  const auto table = tools_of_linuxcnc("T1 P1 D0.8 I+85 J+25 Q2\nT2 P2 D0.8 I95 J155 Q1\nT3 P3 D4 I0 J0 Q9\n", "lathe.tbl");
  ASSERT_TRUE(table) << table.error();
  ASSERT_EQ(table->tools.size(), 3u);
  const ToolGeometry &one = table->tools[0], &two = table->tools[1];
  EXPECT_NEAR(*one.insert.lead, 95, 1e-9);
  EXPECT_NEAR(one.angle, 60, 1e-9);
  EXPECT_EQ(one.insert.tip_z, -1);
  EXPECT_NEAR(*two.insert.lead, 95, 1e-9);
  EXPECT_EQ(two.insert.tip_z, 1);
  EXPECT_EQ(table->tools[2].corner, 2);
  // The edges have the directions of I and J, measured from +z towards +x.
  const auto direction = [](const InsertBody& body, std::size_t from) {
    const InsertPoint &a = body.corners[from].centre, &b = body.corners[2].centre;
    return std::atan2(b.x - a.x, b.z - a.z) / rad_per_deg;
  };
  const InsertBody back = insert_bodies(one).front(), front = insert_bodies(two).front();
  EXPECT_NEAR(back.corners[0].centre.x, 0.4, 1e-12);
  EXPECT_NEAR(back.corners[0].centre.z, 0.4, 1e-12);
  EXPECT_NEAR(direction(back, 3), 85, 1e-9);
  EXPECT_NEAR(direction(back, 1), 25, 1e-9);
  EXPECT_NEAR(front.corners[0].centre.z, -0.4, 1e-12);
  EXPECT_NEAR(direction(front, 3), 155, 1e-9);
  EXPECT_NEAR(direction(front, 1), 95, 1e-9);
}

TEST(Turn, RadiiOfTheMaterialAround) {
  Stock stock(cylinder_blank({0, 0}, -30, 0, 40), 0.5, 1);
  ToolGeometry g;
  g.kind = ToolKind::flat, g.diameter = 16, g.flutes = 40;
  const std::uint16_t mill = stock.add_tool(shape_of(g));
  stock.add({{0, 0, 5}, {0, 0, -20}, mill});
  (void)stock.cut();
  const auto wall = material_around(stock, 15, -10);
  ASSERT_TRUE(wall);
  EXPECT_NEAR(wall->inner, 8, 1e-3);
  EXPECT_NEAR(wall->outer, 20, 1e-3);
  EXPECT_FALSE(material_around(stock, 21, -10));
  EXPECT_FALSE(material_around(stock, 5, -10));
  EXPECT_FALSE(material_around(stock, 15, 5));
  const auto below = material_around(stock, 15, -25);
  ASSERT_TRUE(below);
  EXPECT_EQ(below->inner, 0);
}

}  // namespace
}  // namespace kadr::turn_test
