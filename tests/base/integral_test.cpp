// base/integral, base/extremes: compared with integrals and extremes known by formula.

#include "base/integral.h"

#include <gtest/gtest.h>

#include <cmath>

#include "base/extremes.h"

namespace kadr::integral_test {
namespace {

TEST(integral, of_smooth_functions) {
  EXPECT_NEAR(integral([](double x) { return std::sin(x); }, 0, 3, 1e-10), 1 - std::cos(3), 1e-10);
  EXPECT_NEAR(integral([](double x) { return x * x * x; }, 2, -1, 1e-10), (1 - 16) / 4.0, 1e-10);
  EXPECT_EQ(integral([](double) { return 0.0; }, 0, 1, 1e-9), 0);
}

TEST(integral, of_a_narrow_peak_at_an_end) {
  for (const double width : {1e-2, 1e-5, 1e-8}) {
    const auto peak = [&](double x) { return width / (x * x + width * width); };
    const double exact = std::atan(1 / width);
    EXPECT_NEAR(integral(peak, 0, 1, 1e-9), exact, 1e-8 * exact) << width;
  }
}

TEST(integral, of_a_kink) {
  EXPECT_NEAR(integral([](double x) { return std::max(0.3, x); }, 0, 1, 1e-9), 0.3 * 0.3 + (1 - 0.09) / 2, 1e-9);
}

TEST(integral, of_nothing_is_nothing) {
  EXPECT_TRUE(std::isnan(integral([](double) { return std::nan(""); }, 0, 1, 1e-9)));
  EXPECT_FALSE(std::isfinite(integral([](double x) { return x < 0.5 ? 1 / 0.0 : 1.0; }, 0, 1, 1e-9)));
}

TEST(extremes, of_several_waves) {
  const Range range = range_of([](double x) { return std::sin(18 * x) + x; }, 64);
  // cos(18x) = −1/18 at the last crest and at the first trough.
  const double phase = std::acos(-1 / 18.0), crest = (phase + 4 * 3.14159265358979323846) / 18,
               trough = (2 * 3.14159265358979323846 - phase) / 18;
  EXPECT_NEAR(range.most, std::sin(18 * crest) + crest, 1e-12);
  EXPECT_NEAR(range.least, std::sin(18 * trough) + trough, 1e-12);
}

TEST(extremes, of_a_kink_and_of_the_ends) {
  const Range kink = range_of([](double x) { return std::abs(x - 0.123456); }, 16);
  EXPECT_NEAR(kink.least, 0, 1e-10);
  EXPECT_EQ(kink.most, 1 - 0.123456);
  const Range level = range_of([](double) { return 4.0; }, 16);
  EXPECT_EQ(level.least, 4);
  EXPECT_EQ(level.most, 4);
}

}  // namespace
}  // namespace kadr::integral_test
