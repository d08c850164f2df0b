// Area milling: for every zone, tool, scheme and plunge the path stays clear of the walls and leaves nothing that the tool can reach.

#include "path/pocketing/mill.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>

#include "base/tolerance.h"
#include "path/pocketing/random_zone.h"
#include "path/pocketing/raster_reach.h"
#include "path/pocketing/verify.h"

namespace kadr::area::mill_test {
namespace {

Edges rectangle(double width, double height) {
  return {{{0, 0}, {width, 0}}, {{width, 0}, {width, height}}, {{width, height}, {0, height}}, {{0, height}, {0, 0}}};
}

std::vector<Zone> zones(const Edges& edges) {
  const auto chains = chained(edges);
  if (!chains) return {};
  const auto found = zones_of(*chains);
  return found ? *found : std::vector<Zone>();
}

const std::vector<Scheme> all_schemes{
    Scheme::zigzag, Scheme::zigzag_then_contour, Scheme::contour_then_zigzag, Scheme::spiral_out, Scheme::spiral_in,
    Scheme::comb,   Scheme::comb_then_contour,   Scheme::contour_then_comb};
const std::vector<Plunge> all_plunges{Plunge::hole, Plunge::tangential, Plunge::ramp};

TEST(Mill, EverySchemeAndPlungeInAPocket) {
  const std::vector<Zone> pocket = zones(rectangle(60, 40));
  ASSERT_EQ(pocket.size(), 1U);
  for (const Scheme scheme : all_schemes)
    for (const Plunge plunge : all_plunges) {
      Job job;
      job.scheme = scheme;
      job.plunge = plunge;
      job.depth = 4, job.layer = 2;
      const auto path = verified_path(pocket, job);
      ASSERT_TRUE(path) << int(scheme) << ' ' << int(plunge) << ' ' << name_of(path.error().id);
      EXPECT_NEAR(path->outcome.nearest_wall, 5, tol::same_point);
      EXPECT_NEAR(path->outcome.out_of_reach, (4 - pi) * 25, 0.01);  // four corners with the tool's radius
      EXPECT_EQ(path->path.layers, 2U);
      EXPECT_EQ(path->path.holes.empty(), plunge != Plunge::hole);
    }
}

TEST(Mill, RingsAreExactArcs) {
  Job job;
  job.scheme = Scheme::spiral_in;
  const auto path = verified_path(zones(test::circle({100, 50}, 30)), job);
  ASSERT_TRUE(path);
  for (const Move& move : path->path.moves)
    if (move.bulge > 0.9) {
      EXPECT_NEAR(std::remainder(length(Vec2{move.to.x, move.to.y} - Vec2{100, 50}), 5), 0, 1e-6);
    }
}

TEST(Mill, NarrowPlacesSplitTheZone) {
  // Two squares of 30 mm joined by a neck of 8 mm: a tool of 10 mm does not fit through the neck.
  const Edges dumbbell{{{0, 0}, {30, 0}},    {{30, 0}, {30, 11}},  {{30, 11}, {50, 11}}, {{50, 11}, {50, 0}},
                       {{50, 0}, {80, 0}},   {{80, 0}, {80, 30}},  {{80, 30}, {50, 30}}, {{50, 30}, {50, 19}},
                       {{50, 19}, {30, 19}}, {{30, 19}, {30, 30}}, {{30, 30}, {0, 30}},  {{0, 30}, {0, 0}}};
  const auto path = verified_path(zones(dumbbell), Job());
  ASSERT_TRUE(path);
  EXPECT_EQ(path->path.fields, 2U);
  EXPECT_GT(path->outcome.out_of_reach, 20 * 8 - 20);
}

TEST(Mill, TheToolDoesNotFit) {
  const auto path = area_path(zones(rectangle(60, 9)), Job());
  ASSERT_FALSE(path);
  EXPECT_EQ(path.error().id, AlarmId::tool_does_not_fit);
}

TEST(Mill, ASlotAsWideAsTheTool) {
  const auto path = verified_path(zones(rectangle(60, 10)), Job());
  ASSERT_TRUE(path) << name_of(path.error().id);
  EXPECT_NEAR(path->outcome.nearest_wall, 5, tol::area_wall);
}

TEST(Mill, AHoleOutsideIsRefused) {
  Job job;
  job.plunge = Plunge::hole;
  job.hole = Vec2{2, 2};
  const auto path = area_path(zones(rectangle(60, 40)), job);
  ASSERT_FALSE(path);
  EXPECT_EQ(path.error().id, AlarmId::mill_hole);
  job.hole = Vec2{30, 20};
  EXPECT_TRUE(verified_path(zones(rectangle(60, 40)), job));
}

TEST(Mill, OpenZonesAreEnteredFromTheAir) {
  Edges edges = rectangle(60, 40);
  for (Edge& e : edges) e.open = true;
  for (const Scheme scheme : all_schemes) {
    Job job;
    job.scheme = scheme;
    job.plunge = Plunge::ramp;
    const auto path = verified_path(zones(edges), job);
    ASSERT_TRUE(path) << int(scheme);
    EXPECT_EQ(path->outcome.out_of_reach, 0);
    const Vec3 down = path->path.moves[2].to;  // the moves are: above, near, down
    const Vec2 nearest{std::clamp(down.x, 0.0, 60.0), std::clamp(down.y, 0.0, 40.0)};
    EXPECT_GE(length(Vec2{down.x, down.y} - nearest), 5) << int(scheme) << " X" << down.x << " Y" << down.y << " Z" << down.z;
  }
}

TEST(Mill, VerificationSeesAGougeAndAnUncutRest) {
  const std::vector<Zone> pocket = zones(rectangle(60, 40));
  auto path = area_path(pocket, Job());
  ASSERT_TRUE(path);
  std::vector<Move> moves = path->moves;
  for (Move& move : moves) move.to.x += 0.01;
  EXPECT_EQ(verified(pocket, Job(), moves).fault->id, AlarmId::mill_wall);
  moves = path->moves;
  moves.resize(moves.size() / 2);
  EXPECT_EQ(verified(pocket, Job(), moves).fault->id, AlarmId::mill_uncut);
}

/// Found by the property below with seed 7432448717896982861. The path crosses remaining stock along the boundary. Where it is clipped,
/// the boundary begins with a chord of half a micrometre before the arc around a corner of the wall.
TEST(Mill, ARestBesideAnArcAroundACorner) {
  const double radii[] = {24.644, 24.116, 24.534, 18, 24.666}, bulges[] = {0, 0, -0.1, 0, 0};
  const bool open[] = {false, true, false, true, true};
  Edges edges = test::circle({7, 0}, 0.5);
  for (std::size_t i = 0; i < 5; ++i) {
    const auto corner = [&](std::size_t k) { return rotated(Vec2{radii[k % 5], 0}, 72.0 * static_cast<double>(k % 5)); };
    edges.push_back({corner(i), corner(i + 1), bulges[i], open[i]});
  }
  Job job;
  job.radius = 2.375;
  job.allowance = 0.3;
  job.step = 2 * job.radius * (0.2 + 0.7 * 0.282);
  job.scheme = Scheme::comb;
  job.depth = job.layer = 2;
  const auto path = verified_path(zones(edges), job);
  ASSERT_TRUE(path) << name_of(path.error().id);
  EXPECT_NEAR(path->outcome.nearest_wall, path->outcome.required, tol::area_wall / 4);
}

constexpr double most_left = 0.05;  // mm²

/// Logs each side of a drawing as text: from, to, bulge, open.
void log(const std::vector<Zone>& found, const Job& job) {
  RC_LOG() << "radius " << job.radius << " allowance " << job.allowance << " step " << job.step << " scheme " << int(job.scheme)
           << " plunge " << int(job.plunge) << " angle " << job.angle << '\n';
  for (const Zone& zone : found)
    for (const Edges& loop : zone.loops)
      for (const Edge& e : loop)
        RC_LOG() << e.from.x << ' ' << e.from.y << "  " << e.to.x << ' ' << e.to.y << "  " << e.bulge << ' ' << e.open << '\n';
}

/// At a wall that ends at an open side, the tool can cut from positions where its centre is outside the zone.
TEST(Mill, NothingReachableIsLeftBesideOpenSides) {
  const Edges triangle{{{0, 0}, {60, 0}}, {{60, 0}, {0, 22}, 0, true}, {{0, 22}, {0, 0}}};
  const Edges step{{{0, 0}, {40, 0}},    {{40, 0}, {40, 15}},  {{40, 15}, {48, 15}}, {{48, 15}, {48, 24}, 0, true},
                   {{48, 24}, {40, 24}}, {{40, 24}, {40, 40}}, {{40, 40}, {0, 40}},  {{0, 40}, {0, 0}}};
  const Edges narrow{{{0, 0}, {40, 0}}, {{40, 0}, {40, 6}}, {{40, 6}, {0, 6}, 0, true}, {{0, 6}, {0, 0}}};  // narrower than the tool
  for (const Edges& edges : {triangle, step, narrow})
    for (const Scheme scheme : all_schemes)
      for (const double tool_part : {0.5, 1.0, 1.4}) {
        Job job;
        job.scheme = scheme;
        job.step = tool_part * job.radius;
        const std::vector<Zone> found = zones(edges);
        const auto path = verified_path(found, job);
        ASSERT_TRUE(path) << int(scheme) << ' ' << name_of(path.error().id);
        EXPECT_LE(RasterReach(found, job).left(path->path.moves, tol::area_cusp), most_left) << int(scheme) << ' ' << job.step;
      }
}

/// If the path is cut short, the grid must find the remaining area; otherwise its check could never fail.
TEST(Mill, TheGridSeesAnUncutRest) {
  const std::vector<Zone> pocket = zones(rectangle(60, 40));
  const auto path = area_path(pocket, Job());
  ASSERT_TRUE(path);
  const RasterReach raster(pocket, Job());
  EXPECT_NEAR(raster.reachable(), 60 * 40 - (4 - pi) * 25, 0.04 * 200 + 2);  // the grid ignores what is reached by less than its margin
  std::vector<Move> moves = path->moves;
  EXPECT_EQ(raster.left(moves, tol::area_cusp), 0);
  moves.resize(moves.size() / 2);
  EXPECT_GT(raster.left(moves, tol::area_cusp), 100);
}

RC_GTEST_PROP(MillProperty, VerifiedWhateverTheZone, ()) {
  const std::vector<Zone> found = zones(test::random_drawing(*rc::gen::inRange(0, 2) == 0));
  RC_PRE(!found.empty());
  Job job;
  job.radius = 1.5 + test::share(*rc::gen::inRange(0, 4000));
  job.allowance = *rc::gen::inRange(0, 3) == 0 ? 0.3 : 0;
  job.step = 2 * job.radius * (0.2 + 0.7 * test::share(*rc::gen::inRange(0, 1001)));
  job.scheme = *rc::gen::elementOf(all_schemes);
  job.plunge = *rc::gen::elementOf(all_plunges);
  job.direction = *rc::gen::element(Direction::ccw, Direction::cw);
  job.angle = *rc::gen::element(0, 30, 90);
  job.depth = 2, job.layer = *rc::gen::element(1, 2);
  const auto path = verified_path(found, job);
  const RasterReach raster(found, job);
  if (path) {
    const double left = raster.left(path->path.moves, tol::area_cusp);
    if (left <= most_left) return;
    log(found, job);
    RC_FAIL("left: " + std::to_string(left) + " mm²");
  }
  const double reachable = raster.reachable();
  if (path.error().id == AlarmId::tool_does_not_fit && reachable <= most_left) return;
  log(found, job);
  RC_FAIL(std::string(name_of(path.error().id)) + ", reachable: " + std::to_string(reachable) + " mm²");
}

}  // namespace
}  // namespace kadr::area::mill_test
