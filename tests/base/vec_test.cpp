// base/vec: exact trigonometry in degrees, and the laws stated in its docstrings.

#include "base/vec.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <bit>
#include <cstdint>
#include <cstring>
#include <random>

namespace kadr::vec_test {
namespace {

std::uint64_t bits(double x) { return std::bit_cast<std::uint64_t>(x + 0.0); }  // makes −0 equal to 0

/// Returns an angle whose sum with 90 is exact: a multiple of 1/1024 within some revolutions.
double exact_angle() { return *rc::gen::inRange(-4'000'000, 4'000'000) / 1024.0; }
Vec2 any_vector() { return {*rc::gen::inRange(-1'000'000, 1'000'000) / 1000.0, *rc::gen::inRange(-1'000'000, 1'000'000) / 1000.0}; }

TEST(sincos_deg, exactly_0_and_1_at_multiples_of_90) {
  constexpr int sines[] = {0, 1, 0, -1};
  for (int k = -1000; k <= 1000; ++k) {
    const SinCos turn = sincos_deg(90.0 * k);
    EXPECT_EQ(turn.sin, sines[k & 3]) << k;
    EXPECT_EQ(turn.cos, sines[(k + 1) & 3]) << k;
  }
}

TEST(sincos_deg, known_values) {
  EXPECT_NEAR(sincos_deg(30).sin, 0.5, 1e-15);
  EXPECT_NEAR(sincos_deg(60).cos, 0.5, 1e-15);
  EXPECT_NEAR(sincos_deg(45).sin, std::sqrt(0.5), 1e-15);
  EXPECT_NEAR(sincos_deg(-30).sin, -0.5, 1e-15);
  EXPECT_NEAR(sincos_deg(3630).sin, 0.5, 1e-13);  // ten revolutions and 30°
}

bool odd_multiple_of_45(double deg) { return std::fabs(std::remainder(deg, 90.0)) == 45.0; }

/// Computes sine and cosine through std::remquo, which is exact.
SinCos slowly(double deg) {
  int quarter = 0;
  const double rest_deg = std::remquo(deg, 90.0, &quarter), rest = rest_deg * rad_per_deg;
  const bool middle = std::fabs(rest_deg) == 45;
  const double s = middle ? std::copysign(0.70710678118654752440, rest) : std::sin(rest),
               c = middle ? 0.70710678118654752440 : std::cos(rest);
  const SinCos turns[] = {{s, c}, {c, -s}, {-s, -c}, {-c, s}};
  return turns[quarter & 3];
}

TEST(sincos_deg, is_that_of_the_exact_rest_bit_by_bit) {
  std::mt19937_64 choose(5);
  const auto same = [](double deg) {
    const SinCos a = sincos_deg(deg), b = slowly(deg);
    EXPECT_TRUE(std::memcmp(&a, &b, sizeof a) == 0) << std::hexfloat << deg;
  };
  for (const double deg : {0.0, -0.0, 90.0, -90.0, 1e11, -1e12, 1e12, 1e13, 1e300, 5e-324, -5e-324}) same(deg);
  for (int i = 0; i < 300'000; ++i) {
    const double middle = 45.0 * static_cast<double>(static_cast<std::int64_t>(choose() % 2'000'001) - 1'000'000);
    same(middle);
    same(std::nextafter(middle, 1e300));
    same(std::nextafter(middle, -1e300));
    same(std::ldexp(static_cast<double>(static_cast<std::int64_t>(choose())), -static_cast<int>(choose() % 64) - 20));
  }
}

RC_GTEST_PROP(sincos_deg, a_quarter_turn_more_is_cos_and_minus_sin_bit_by_bit, ()) {
  const double a = exact_angle();
  RC_PRE(!odd_multiple_of_45(a));  // covered by the next test
  const SinCos here = sincos_deg(a);
  const SinCos there = sincos_deg(a + 90);
  RC_ASSERT(bits(there.sin) == bits(here.cos));
  RC_ASSERT(bits(there.cos) == bits(-here.sin));
}

TEST(sincos_deg, a_quarter_turn_more_of_odd_multiples_of_45_too) {
  for (int k = -9; k <= 9; k += 2) {
    const SinCos here = sincos_deg(45.0 * k);
    const SinCos there = sincos_deg(45.0 * k + 90);
    EXPECT_EQ(there.sin, here.cos) << 45 * k;
    EXPECT_EQ(there.cos, -here.sin) << 45 * k;
  }
}

RC_GTEST_PROP(sincos_deg, lies_on_the_unit_circle, ()) {
  const SinCos turn = sincos_deg(exact_angle());
  RC_ASSERT(std::fabs(turn.sin * turn.sin + turn.cos * turn.cos - 1) < 4e-16);
}

RC_GTEST_PROP(rotated, by_quarter_turns_is_exact, ()) {
  const Vec2 v = any_vector();
  RC_ASSERT(rotated(v, 0) == v);
  RC_ASSERT(rotated(v, 90) == (Vec2{-v.y, v.x}));
  RC_ASSERT(rotated(v, 180) == (Vec2{-v.x, -v.y}));
  RC_ASSERT(rotated(v, -90) == (Vec2{v.y, -v.x}));
}

RC_GTEST_PROP(rotated, keeps_length_and_turns_back, ()) {
  const Vec2 v = any_vector();
  const double deg = exact_angle();
  RC_ASSERT(std::fabs(length(rotated(v, deg)) - length(v)) <= 1e-12);
  RC_ASSERT(length(rotated(rotated(v, deg), -deg) - v) <= 1e-12);
}

TEST(angle_deg, exact_at_multiples_of_90) {
  EXPECT_EQ(angle_deg({3, 0}), 0);
  EXPECT_EQ(angle_deg({0, 3}), 90);
  EXPECT_EQ(angle_deg({-3, 0}), 180);
  EXPECT_EQ(angle_deg({-3, -0.0}), 180);
  EXPECT_EQ(angle_deg({0, -3}), -90);
}

TEST(angle_deg, stays_above_minus_180) {
  EXPECT_GT(angle_deg({-1, -1e-12}), -180);
  EXPECT_GT(angle_deg({-1, -1e-300}), -180);  // the angle rounds to a half turn
}

RC_GTEST_PROP(angle_deg, is_the_angle_x_was_turned_by, ()) {
  const double deg = *rc::gen::inRange(-179'999, 180'001) / 1000.0;
  RC_ASSERT(std::fabs(angle_deg(rotated({100, 0}, deg)) - deg) < 1e-12);
}

RC_GTEST_PROP(vectors, dot_and_cross_are_length_times_cosine_and_sine, ()) {
  const Vec2 a = any_vector();
  const Vec2 b = any_vector();
  const double product = length(a) * length(b);
  RC_ASSERT(std::fabs(std::hypot(dot(a, b), cross(a, b)) - product) <= 1e-9 * (1 + product));
  RC_ASSERT(cross(a, b) == -cross(b, a));
}

}  // namespace
}  // namespace kadr::vec_test
