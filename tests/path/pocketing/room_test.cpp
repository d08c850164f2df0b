// Room and sweep compared with Clipper alone, which is slow and works on the whole area at once.

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "path/pocketing/reachable_area.h"
#include "path/pocketing/sweep.h"

namespace kadr::area::room_test {
namespace {

/// Returns a star with a hole.
Polygons star() {
  Polygons area(2);
  for (int i = 0; i < 40; ++i) area[0].push_back(rotated(Vec2{i % 2 == 0 ? 30.0 : 20.0, 0}, 9.0 * i));
  for (int i = 0; i < 8; ++i) area[1].push_back(rotated(Vec2{6, 0}, -45.0 * i));
  return area;
}

TEST(Room, WhatSurelyLiesInsideDoes) {
  const Polygons area = star();
  const Room room(area);
  std::mt19937 random(5);
  std::uniform_real_distribution<double> place(-32, 32), turn(-3, 3);
  int inside = 0, held = 0;
  for (int i = 0; i < 20'000; ++i) {
    const Vec2 a{place(random), place(random)};
    const Polygon line{a, i % 2 == 0 ? Vec2{place(random), place(random)} : a + Vec2{turn(random), turn(random)}};
    double outside = 0;
    for (const Polygon& piece : lines_outside({line}, area)) outside += length(piece.back() - piece.front());
    const bool surely = room.surely_holds(line);
    EXPECT_FALSE(surely && outside > 1e-5) << i;
    inside += outside < 1e-5 ? 1 : 0;
    held += surely ? 1 : 0;
    EXPECT_EQ(room.holds(line, 1e-4), outside < 1e-4) << i;
  }
  EXPECT_GT(held, inside * 99 / 100);  // points inside are nearly always recognised without Clipper
  EXPECT_GT(inside, 4000);
}

TEST(Sweep, AsAllAtOnce) {
  Polygons rows;
  for (int i = 0; i < 60; ++i) rows.push_back({{0, 0.3 * i}, {40, 0.3 * i}, {40 + 0.1 * i, 30}});
  Polygon fan;
  for (int i = 0; i < 200; ++i) fan.push_back(rotated(Vec2{i % 2 == 0 ? 5.0 : 25.0, 0}, 1.9 * i));
  rows.push_back(fan);
  const Polygons once = swept(rows, 3, 0.002), in_turn = swept_all(rows, 3, 0.002, {});
  EXPECT_NEAR(area_of(once), area_of(in_turn), 0.05);
  EXPECT_LT(std::abs(area_of(less(once, in_turn))), 0.05);
  EXPECT_LT(std::abs(area_of(less(in_turn, once))), 0.05);
}

}  // namespace
}  // namespace kadr::area::room_test
