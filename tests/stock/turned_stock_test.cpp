// Spinning parts that are cut exactly: volumes by closed formulas, and by a slow twin that knows the part only as a radius at each Z.

#include "stock/turned/turned_stock.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>

#include "config/tools/tool_library.h"
#include "stock/turned/turned_mesh.h"

namespace kadr::turned_stock_test {
namespace {

constexpr double pi = std::numbers::pi;
constexpr double nose_chord = 1e-3, path_chord = 2e-4;  // mm, as session/cutting/turned_cutting has them
constexpr double share = 1e-4;                          // permitted relative error of a volume
constexpr double all = 200;                             // mm; edges that are longer than any part here

/// An insert with edges so long that the part's outside is cut completely.
ToolGeometry insert(int tip_x, int tip_z, double nose, double angle) {
  ToolGeometry g;
  g.kind = ToolKind::turning;
  g.corner = nose;
  g.angle = angle;
  g.flutes = g.length = all;
  g.insert.tip_x = tip_x, g.insert.tip_z = tip_z;
  g.insert.lead = (tip_z == 0 ? 90.0 : 135.0) - angle / 2;
  return g;
}

struct Cut {
  TurnedStock stock;
  std::vector<InsertSweep> tool;
  double removed = 0;

  Cut(const TurnedRegion& blank, const ToolGeometry& geometry) : stock(blank), tool(insert_sweeps(shape_of(geometry), nose_chord)) {}

  /// Moves the programmed point along a polyline; x is the radius, y is Z.
  void go(const std::vector<Vec2>& corners) {
    for (std::size_t i = 1; i < corners.size(); ++i)
      for (const InsertSweep& body : tool) removed += stock.remove(body.swept(corners[i - 1], corners[i])).volume;
  }
};

/// Corners of an arc about `centre`, from one angle to another, degrees from the radius' direction towards Z.
std::vector<Vec2> arc(Vec2 centre, double radius, double from, double to) {
  const double turn = (to - from) * pi / 180;
  const int count = int(std::ceil(std::fabs(turn) / (2 * std::acos(1 - path_chord / radius))));
  std::vector<Vec2> corners;
  for (int i = 0; i <= count; ++i) {
    const double angle = from * pi / 180 + turn * i / count;
    corners.push_back(centre + radius * Vec2{std::cos(angle), std::sin(angle)});
  }
  return corners;
}

double cone(double height, double a, double b) { return pi * height / 3 * (a * a + a * b + b * b); }

TEST(TurnedStock, CylinderAndItsBlank) {
  Cut cut(cylinder_region(-40, 0, 40), insert(-1, -1, 0.8, 80));
  EXPECT_NEAR(cut.stock.volume(), pi * 400 * 40, 1e-6);
  cut.go({{15, 3}, {15, -45}});
  EXPECT_NEAR(cut.stock.volume(), pi * 225 * 40, 1e-3);
  EXPECT_NEAR(cut.removed, pi * 175 * 40, 1e-3);
  EXPECT_NEAR(cut.stock.area().whole, 2 * pi * 225 + 2 * pi * 15 * 40, 0.01);
  EXPECT_NEAR(cut.stock.area().machined, 2 * pi * 15 * 40, 0.01);
}

TEST(TurnedStock, TubeIsBored) {
  ToolGeometry bar = insert(1, -1, 0.4, 55);
  bar.flutes = bar.length = 12;  // a longer insert would cut beyond the axis too
  Cut cut(cylinder_region(-40, 0, 60, 20), bar);
  EXPECT_NEAR(cut.stock.volume(), pi * (900 - 100) * 40, 1e-6);
  cut.go({{18, 3}, {18, -45}});
  EXPECT_NEAR(cut.stock.volume(), pi * (900 - 324) * 40, 1e-3);
}

// spec/fanuc-t 7.2: on a cone of the angle φ the tip of a compensated tool runs parallel to the contour, shifted in Z by −r (1 − tan(φ /
// 2)).
TEST(TurnedStock, ConeWithCompensatedNose) {
  const double nose = 1.2, slope = 0.25, half = std::atan(slope) / 2, shift = -nose * (1 - std::tan(half));
  Cut cut(cylinder_region(-40, 0, 60), insert(-1, -1, nose, 60));
  const double before = 10 - 5 * slope, after = 10 + 50 * slope;
  cut.go({{before, 5 + shift}, {after, -50 + shift}});
  EXPECT_NEAR(cut.stock.volume(), cone(40, 10, 10 + 40 * slope), share * cone(40, 10, 20));
}

// A ball of radius 15 at the end of a shaft of Ø30, by G3: the tip of a compensated tool runs on an arc of the radius plus that of the
// nose, whose centre is shifted by the vector from nose to tip.
TEST(TurnedStock, BallByArc) {
  const double nose = 0.8, radius = 15;
  Cut cut(cylinder_region(-50, 0, 44), insert(-1, -1, nose, 35));
  std::vector<Vec2> path = arc({-nose, -radius - nose}, radius + nose, 90, 0);
  path.insert(path.begin(), {-2 * nose, path.front().y});
  path.push_back({radius, -55});
  cut.go(path);
  const double wanted = 2 * pi / 3 * std::pow(radius, 3) + pi * radius * radius * 35;
  EXPECT_NEAR(cut.stock.volume(), wanted, share * wanted);
}

TEST(TurnedStock, GrooveAsWideAsTheInsert) {
  ToolGeometry g;
  g.kind = ToolKind::turning;
  g.flutes = g.length = 20;
  g.insert.tip_x = -1, g.insert.tip_z = -1;
  g.insert.width = 3, g.insert.lead = 90;
  Cut cut(cylinder_region(-40, 0, 40), g);
  cut.go({{25, -20}, {12, -20}, {25, -20}});
  EXPECT_NEAR(cut.removed, pi * (400 - 144) * 3, 1e-3);
}

TEST(TurnedStock, FaceIsCleanWhenTheTipPassesTheAxisByTheNose) {
  Cut stub(cylinder_region(-40, 2, 40), insert(-1, -1, 0.8, 80)), clean(cylinder_region(-40, 2, 40), insert(-1, -1, 0.8, 80));
  stub.go({{25, 0}, {0, 0}});
  clean.go({{25, 0}, {-0.8, 0}});
  const auto above = [](const Cut& cut) { return cut.stock.volume() - pi * 400 * 40; };
  EXPECT_GT(above(stub), 0.01);  // spec/fanuc-t 7.2: a stub is left
  EXPECT_LT(above(clean), above(stub));
  EXPECT_TRUE(!clean.stock.radii_at(1e-3) || clean.stock.radii_at(1e-3)->y < 20);
}

TEST(TurnedStock, DrillOnTheAxis) {
  ToolGeometry g;
  g.kind = ToolKind::drill;
  g.diameter = 10, g.angle = 118, g.flutes = 60, g.length = 80;
  Cut cut(cylinder_region(-40, 0, 40), g);
  cut.go({{0, 5}, {0, -20}});
  const double tall = 5 / std::tan(59 * pi / 180);
  EXPECT_NEAR(cut.removed, pi * 25 * (20 - tall) + cone(tall, 0, 5), share * 1000);
}

TEST(TurnedStock, TouchTellsWhereAndRemovesNothing) {
  Cut cut(cylinder_region(-40, 0, 40), insert(-1, -1, 0, 80));
  const TurnedTouch touch = cut.stock.touch(cut.tool.front().swept({18, 5}, {18, -10}));
  EXPECT_NEAR(touch.depth(), 2, 1e-5);
  EXPECT_NEAR(touch.least.x, 18, 1e-5);
  EXPECT_NEAR(touch.most.y, 0, 1e-5);
  EXPECT_NEAR(cut.stock.volume(), pi * 400 * 40, 1e-6);
}

TEST(TurnedStock, MeshIsClosedAndHasTheVolume) {
  Cut cut(cylinder_region(-40, 0, 40, 8), insert(-1, -1, 0.8, 55));
  cut.go({{12, 3}, {12, -10}, {16, -20}, {25, -20}});
  for (const double deviation : {0.1, 0.01, 0.001}) {
    const Mesh mesh = turned_mesh(cut.stock.region(), deviation);
    std::map<std::pair<std::uint32_t, std::uint32_t>, int> edges;
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
      const std::uint32_t a = mesh.triangles[t], b = mesh.triangles[t % 3 == 2 ? t - 2 : t + 1];
      ++edges[{a, b}], --edges[{b, a}];
    }
    EXPECT_TRUE(std::all_of(edges.begin(), edges.end(), [](const auto& e) { return e.second == 0; }));
    EXPECT_NEAR(volume_of(mesh), cut.stock.volume(), deviation * cut.stock.area().whole);
    EXPECT_GT(volume_of(mesh), 0);
  }
}

/// The height of the insert's boundary above its programmed point, at a distance along Z; for an insert that points to −X.
double boundary(double along, double nose, double half_angle) {
  const double tangent = nose * std::cos(half_angle);
  if (std::fabs(along) <= tangent) return nose - std::sqrt(std::max(0.0, nose * nose - along * along));
  return nose - nose * std::sin(half_angle) + (std::fabs(along) - tangent) / std::tan(half_angle);
}

/// The radius that a move leaves at z: the least of a convex function of the position along the move.
double left_at(double z, Vec2 from, Vec2 to, double nose, double half_angle) {
  const auto height = [&](double part) {
    const Vec2 tip = from + part * (to - from);
    return tip.x + boundary(z - tip.y, nose, half_angle);
  };
  double low = 0, high = 1;
  for (int i = 0; i < 40; ++i) {
    const double a = low + (high - low) / 3, b = high - (high - low) / 3;
    (height(a) < height(b) ? high : low) = height(a) < height(b) ? b : a;
  }
  return height((low + high) / 2);
}

RC_GTEST_PROP(TurnedStock, VolumeIsThatOfTheRadiiThatTheMovesLeave, ()) {
  constexpr double nose = 0.8, angle = 35, radius = 20, length = 30;
  const int moves = *rc::gen::inRange(1, 12);
  std::vector<Vec2> corners;
  for (int i = 0; i <= moves; ++i) corners.push_back({*rc::gen::inRange(500, 2100) / 100.0, *rc::gen::inRange(-3500, 500) / 100.0});
  Cut cut(cylinder_region(-length, 0, 2 * radius), insert(-1, 0, nose, angle));
  cut.go(corners);
  constexpr int count = 600;
  double volume = 0;
  for (int k = 0; k < count; ++k) {
    const double z = -length * (k + 0.5) / count;
    double left = radius;
    for (int i = 0; i < moves; ++i)
      left = std::min(left, left_at(z, corners[std::size_t(i)], corners[std::size_t(i) + 1], nose, angle * pi / 360));
    volume += pi * left * left * length / count;
  }
  RC_ASSERT(std::fabs(cut.stock.volume() - volume) < 3 * share * pi * radius * radius * length);
  RC_ASSERT(std::fabs(cut.stock.volume() + cut.removed - cut.stock.blank_volume()) < 1e-2);
}

}  // namespace
}  // namespace kadr::turned_stock_test
