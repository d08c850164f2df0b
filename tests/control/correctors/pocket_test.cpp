// control/correctors/pocket: compared with the sampled area as the slow reference.
// No area remains inside the wall, and nothing outside is cut. spec/correctors 3.

#include "control/correctors/pocket.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "base/tolerance.h"

namespace kadr::correctors::pocket_test {
namespace {

double any_number(double least, double most) { return least + *rc::gen::inRange(0, 10'001) / 10'000.0 * (most - least); }

double distance_to_line(Vec2 p, Vec2 a, Vec2 b) {
  const Vec2 delta = b - a;
  const double all = dot(delta, delta);
  const double part = all == 0 ? 0.0 : std::clamp(dot(p - a, delta) / all, 0.0, 1.0);
  return length(p - a - part * delta);
}

/// Returns the least distance of a point from the tool's path in a whole pass.
double distance_to_path(Vec2 p, const PocketRounds& rounds, double direction) {
  double least = length(p);  // the plunge in the middle
  Vec2 at{};
  for (double i = 0; i < rounds.count(); ++i) {
    const PocketRound round = rounds.at(i);
    const Vec2 start{round.x, 0};
    least = std::min(least, distance_to_line(p, at, start));
    at = start;
    for (const PocketPiece& piece : pieces_of(round, direction)) {
      if (!piece.is_arc) {
        least = std::min(least, distance_to_line(p, at, piece.to));
      } else {
        const double turn =
            direction * angle_deg({dot(at - piece.center, piece.to - piece.center), cross(at - piece.center, piece.to - piece.center)});
        EXPECT_NEAR(turn, round.corner > 0 ? 90 : 0, 1e-3);
        for (int k = 0; k <= 32; ++k)
          least = std::min(least, length(p - piece.center - rotated(at - piece.center, direction * turn * k / 32)));
      }
      at = piece.to;
    }
    EXPECT_NEAR(length(at - start), 0, tol::same_point);
  }
  return least;
}

/// Returns the signed distance from the wall, negative inside.
double beyond_wall(Vec2 p, const PocketCycle& pocket) {
  const double r = pocket.corner;
  const Vec2 q{std::fabs(p.x) - pocket.x / 2 + r, std::fabs(p.y) - pocket.y / 2 + r};
  return length(Vec2{std::max(q.x, 0.0), std::max(q.y, 0.0)}) + std::min(std::max(q.x, q.y), 0.0) - r;
}

RC_GTEST_PROP(pocket, no_area_stays_inside_the_wall, ()) {
  PocketCycle pocket;
  const double radius = any_number(2, 10);
  pocket.x = 2 * radius + any_number(0, 60);
  pocket.y = 2 * radius + any_number(0, 60);
  pocket.corner = any_number(radius, std::min(pocket.x, pocket.y) / 2);
  pocket.stepover = any_number(5, 40);
  const double direction = *rc::gen::element(1.0, -1.0);
  const auto rounds = PocketRounds::of(pocket, radius, {});
  RC_ASSERT(rounds.has_value());
  const double chord = radius * 0.01;  // the sampled corners lie inside the arcs by up to 1 - cos(90°/64)
  for (int i = 0; i <= 24; ++i)
    for (int j = 0; j <= 24; ++j) {
      const Vec2 p{(i / 24.0 - 0.5) * (pocket.x + 4), (j / 24.0 - 0.5) * (pocket.y + 4)};
      const double wall = beyond_wall(p, pocket), off_path = distance_to_path(p, *rounds, direction);
      if (wall < -chord) RC_ASSERT(off_path < radius + chord);
      if (wall > chord) RC_ASSERT(off_path > radius - chord);
    }
}

RC_GTEST_PROP(pocket, rounds_lie_no_further_apart_than_the_stepover, ()) {
  PocketCycle pocket;
  const double radius = any_number(2, 10);
  pocket.x = 2 * radius + any_number(0, 60);
  pocket.y = 2 * radius + any_number(0, 60);
  pocket.corner = radius;
  pocket.stepover = any_number(5, 40);
  const auto rounds = PocketRounds::of(pocket, radius, {});
  RC_ASSERT(rounds.has_value());
  double before = 0;
  for (double i = 0; i < rounds->count(); ++i) {
    const double now = std::min(rounds->at(i).x, rounds->at(i).y);
    RC_ASSERT(now - before <= pocket.stepover / 100 * 2 * radius + tol::same_point);
    RC_ASSERT(now >= before);
    before = now;
  }
}

TEST(pocket, passes_count_the_rest) {
  PocketCycle pocket;
  pocket.z = -12;
  pocket.pass = 5;
  EXPECT_EQ(PocketRun::passes(pocket), 3);
  pocket.z = -10;
  EXPECT_EQ(PocketRun::passes(pocket), 2);
  pocket.z = -0.3;
  pocket.pass = 0.1;  // rounding must not add a fourth pass
  EXPECT_EQ(PocketRun::passes(pocket), 3);
}

}  // namespace
}  // namespace kadr::correctors::pocket_test
