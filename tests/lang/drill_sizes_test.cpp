// lang/text/drill_sizes: sizes of drills named by number or letter, and of threads.

#include "lang/text/drill_sizes.h"

#include <gtest/gtest.h>

namespace kadr::drill_sizes_test {
namespace {

constexpr double mm = 25.4;  // per inch

// Sizes of ASME B94.11M, compared with three independent tables.
TEST(DrillSizes, ByNumberAndLetter) {
  EXPECT_DOUBLE_EQ(numbered_drill(1).value_or(0), 0.228 * mm);
  EXPECT_DOUBLE_EQ(numbered_drill(7).value_or(0), 0.201 * mm);
  EXPECT_DOUBLE_EQ(numbered_drill(29).value_or(0), 0.136 * mm);
  EXPECT_DOUBLE_EQ(numbered_drill(43).value_or(0), 0.089 * mm);
  EXPECT_DOUBLE_EQ(numbered_drill(80).value_or(0), 0.0135 * mm);
  EXPECT_FALSE(numbered_drill(0) || numbered_drill(81));
  EXPECT_DOUBLE_EQ(lettered_drill('A').value_or(0), 0.234 * mm);
  EXPECT_DOUBLE_EQ(lettered_drill('E').value_or(0), 0.25 * mm);
  EXPECT_DOUBLE_EQ(lettered_drill('Q').value_or(0), 0.332 * mm);
  EXPECT_DOUBLE_EQ(lettered_drill('Z').value_or(0), 0.413 * mm);
  EXPECT_FALSE(lettered_drill('a') || lettered_drill('@') || lettered_drill('['));
}

TEST(DrillSizes, NumbersFallAndLettersRise) {
  for (std::uint32_t n = 2; n <= 80; ++n) EXPECT_LT(*numbered_drill(n), *numbered_drill(n - 1)) << n;
  for (char c = 'B'; c <= 'Z'; ++c) EXPECT_GT(*lettered_drill(c), *lettered_drill(static_cast<char>(c - 1))) << c;
  EXPECT_LT(*numbered_drill(1), *lettered_drill('A'));
}

TEST(DrillSizes, Threads) {
  EXPECT_DOUBLE_EQ(inch_thread(0.25, 20).value_or(0), 0.25 * mm);
  EXPECT_DOUBLE_EQ(inch_thread(1, 8).value_or(0), mm);
  EXPECT_DOUBLE_EQ(inch_thread(2, 4.5).value_or(0), 2 * mm);
  EXPECT_DOUBLE_EQ(inch_thread(8, 32).value_or(0), 0.164 * mm) << "a screw";
  EXPECT_DOUBLE_EQ(inch_thread(2, 56).value_or(0), 0.086 * mm) << "a screw";
  EXPECT_DOUBLE_EQ(inch_thread(0, 80).value_or(0), 0.06 * mm) << "a screw";
  EXPECT_DOUBLE_EQ(inch_thread(1, 64).value_or(0), 0.073 * mm) << "a screw, not an inch";
  for (const auto& [size, threads] : {std::pair{0.125, 27.0}, {0.25, 18.0}, {0.5, 14.0}, {1.0, 11.5}})
    EXPECT_FALSE(inch_thread(size, threads)) << size;
  EXPECT_FALSE(inch_thread(10, 3) || inch_thread(7, 32) || inch_thread(0.25, 0.7) || inch_thread(4, 64));
  EXPECT_TRUE(is_metric_thread(8) && is_metric_thread(2.5));
  EXPECT_FALSE(is_metric_thread(29) || is_metric_thread(97) || is_metric_thread(0));
}

}  // namespace
}  // namespace kadr::drill_sizes_test
