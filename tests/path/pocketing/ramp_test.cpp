// Ramps: never steeper than requested, inside the field, and back where they begin. There is no ramp where the tool would drill.

#include <gtest/gtest.h>

#include <cmath>

#include "base/tolerance.h"
#include "path/pocketing/plunge_ramp.h"

namespace kadr::area::ramp_test {
namespace {

Zone bore(double radius) { return {{{{{-radius, 0}, {radius, 0}, 1}, {{radius, 0}, {-radius, 0}, 1}}}}; }
Zone rectangle(double width, double height) {
  return {{{{{0, 0}, {width, 0}}, {{width, 0}, {width, height}}, {{width, height}, {0, height}}, {{0, height}, {0, 0}}}}};
}

/// Returns a pass too short for a ramp, beginning at the lowest point of the field.
Edges short_pass(const Field& field) {
  Vec2 low{0, 1e9};
  for (const Edges& loop : field.reach)
    for (const Edge& e : loop)
      for (const double part : {0.0, 0.5})
        if (at(e, part).y < low.y) low = at(e, part);
  return {{low, low + Vec2{0.06, 0}}};
}

TEST(Ramp, LawsWhateverTheRoom) {
  for (const Zone& zone : {bore(30), bore(7), bore(6.2), rectangle(60, 10.2), rectangle(30, 30)})
    for (const double deg : {0.5, 3.0, 20.0})
      for (const double drop : {0.1, 6.0, 40.0}) {
        Job job;
        job.ramp_deg = deg;
        const std::vector<Field> fields = fields_of(zone, job);
        ASSERT_EQ(fields.size(), 1U);
        const auto ramp = ramp_for(fields[0], job, short_pass(fields[0]), drop);
        ASSERT_TRUE(ramp) << deg << ' ' << drop;
        double once = 0;
        for (std::size_t i = 1; i < ramp->corners.size(); ++i) once += length(ramp->corners[i] - ramp->corners[i - 1]);
        EXPECT_NEAR(ramp->along, once * ramp->times, tol::same_point * ramp->times);
        EXPECT_LE(drop, ramp->along * std::tan(deg * rad_per_deg) + tol::same_point);
        EXPECT_TRUE(fields[0].roomy.holds(ramp->corners, tol::area_chord));
        EXPECT_TRUE(ramp->round ? length(ramp->corners.back() - ramp->corners.front()) < tol::contour_gap : ramp->times % 2 == 0);
      }
}

TEST(Ramp, NoneWhereTheToolWouldDrill) {
  // The tool centre has 2 · 0.9 mm of room, less than ramp_core · 5 mm; with 1.1 mm it has more.
  const Job job;
  EXPECT_FALSE(ramp_for(fields_of(bore(5.9), job)[0], job, {{{-0.9, 0}, {-0.89, 0}}}, 2));
  EXPECT_TRUE(ramp_for(fields_of(bore(6.1), job)[0], job, {{{-1.1, 0}, {-1.09, 0}}}, 2));
}

}  // namespace
}  // namespace kadr::area::ramp_test
