// The surface of turned parts for display: it encloses the part, threads are helices with the outline of the insert.

#include "stock/turned/turned_surface.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

#include "stock/turned/few_corners.h"

namespace kadr::turned_surface_test {
namespace {

constexpr double pi = std::numbers::pi;

/// A groove of 60° and 2 mm lead on a bar.
ThreadGroove groove(bool outer = true) {
  ThreadGroove g;
  const double wide = 3, deep = wide * std::sqrt(3.0);
  g.outline = outer ? TurnedPolygon{{0, 0}, {deep, -wide}, {deep, wide}} : TurnedPolygon{{0, 0}, {-deep, wide}, {-deep, -wide}};
  if (outer) std::swap(g.outline[1], g.outline[2]);
  g.from = {outer ? 9.0 : 11.0, 5}, g.to = {outer ? 9.0 : 11.0, -15};
  g.start = 5, g.lead = 2, g.is_outer = outer;
  return g;
}

/// The slow twin: the deepest of the insert at many places of its path.
double slow_radius(const ThreadGroove& g, double angle, double z) {
  double best = g.is_outer ? 1e9 : -1;
  for (int k = -40; k <= 40; ++k) {
    const double tip = g.start + g.lead * (k + (g.left_handed ? -1 : 1) * angle / (2 * pi));
    if (tip < std::min(g.from.y, g.to.y) || tip > std::max(g.from.y, g.to.y)) continue;
    const auto side = outline_at(g.outline, z - tip, g.is_outer);
    if (!side) continue;
    const double radius = g.from.x + *side;
    best = g.is_outer ? std::min(best, radius) : std::max(best, radius);
  }
  return best;
}

TEST(ThreadGroove, IsAHelixWithTheOutlineOfTheInsert) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> angles(0, 2 * pi), places(-20, 8);
  for (const bool outer : {true, false})
    for (const bool left : {true, false}) {
      ThreadGroove g = groove(outer);
      g.left_handed = left;
      for (int i = 0; i < 2000; ++i) {
        const double angle = angles(random), z = places(random);
        EXPECT_NEAR(g.radius(angle, z), slow_radius(g, angle, z), 1e-9) << angle << " " << z;
      }
      EXPECT_NEAR(g.radius(0, 1), outer ? 9 : 11, 1e-9) << "the root";
      EXPECT_NEAR(g.radius(0, 0), outer ? 9 + std::sqrt(3.0) : 11 - std::sqrt(3.0), 1e-9) << "the crest";
      EXPECT_NEAR(g.radius(pi / 2, left ? 0.5 : 1.5), outer ? 9 : 11, 1e-9);
    }
}

TEST(TurnedSurface, EnclosesTheRegion) {
  TurnedRegion region = cylinder_region(-30, 0, 40, 10);
  const TurnedView part{region, {}, {}, 0.01};
  const Surface surface = turned_surface(part);
  EXPECT_NEAR(volume_of(surface), volume_of(region), 0.01 * area_of(surface));
  EXPECT_EQ(surface.made_by.size(), surface.point_count());
  EXPECT_EQ(turned_section(part, 1).size(), 1U);
  EXPECT_EQ(turned_edges(part).size(), 4U);
}

TEST(TurnedSurface, AThreadRemovesItsGroove) {
  for (const bool outer : {true, false}) {
    const TurnedRegion region = outer ? cylinder_region(-30, 0, 20) : cylinder_region(-30, 0, 60, 20);
    ThreadGroove within = groove(outer);  // its ends are on the bar, so that the surface is closed
    within.from.y = within.start = -5;
    const std::vector<ThreadGroove> threads{within};
    const Surface with = turned_surface({region, threads, {}, 0.005}), without = turned_surface({region, {}, {}, 0.005});
    // Per revolution a triangle of depth 1 and half width 1 / √3 is removed; its centroid is a third of the depth below the surface.
    const double turns = 10 / 2.0, area = 1 / std::sqrt(3.0);
    const double removed = turns * area * 2 * pi * (outer ? 10 - 1 / 3.0 : 10 + 1 / 3.0);
    EXPECT_NEAR(volume_of(without) - volume_of(with), removed, 0.06 * removed) << outer;
    const double surface = outer ? 9 : 11;
    double deepest = surface;
    for (std::size_t i = 0; i < with.point_count(); ++i) {
      const double r = std::hypot(with.point(i).x, with.point(i).y);
      if (r > 0 && r < 20) deepest = outer ? deepest : std::max(deepest, r);
      if (outer && r > 1e-6) {
        EXPECT_GE(r, 9 - 1e-5);
      }
    }
    EXPECT_LE(deepest, 11 + 1e-5);
  }
}

TEST(TurnedSurface, MakersStayApart) {
  const TurnedRegion region = cylinder_region(-30, 0, 40);
  const auto maker = [](Vec2 a, Vec2 b) { return a.x == 20 && b.x == 20 ? 7 : -1; };
  const Surface surface = turned_surface({region, {}, maker, 0.01});
  for (std::size_t i = 0; i < surface.point_count(); ++i)
    if (surface.made_by[i] == 7) {
      EXPECT_NEAR(std::hypot(surface.point(i).x, surface.point(i).y), 20, 1e-4);
    }
  EXPECT_NE(std::count(surface.made_by.begin(), surface.made_by.end(), 7), 0);
}

TEST(FewCorners, KeepsWithinTheDeviationAndWhatIsFixed) {
  TurnedPolygon circle;
  for (int i = 0; i < 400; ++i) circle.push_back({20 + 5 * std::cos(i * pi / 200), 5 * std::sin(i * pi / 200)});
  std::vector<bool> fixed(400);
  fixed[123] = true;
  const auto needed = needed_corners(circle, fixed, 0.05);
  const auto count = std::count(needed.begin(), needed.end(), true);
  EXPECT_GT(count, 12);
  EXPECT_LT(count, 60);
  EXPECT_TRUE(needed[123]);
}

}  // namespace
}  // namespace kadr::turned_surface_test
