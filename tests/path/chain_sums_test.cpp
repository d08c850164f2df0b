// The running sums of a chain of corners, compared with sums added up corner by corner; and the rounding width that belongs to them.

#include "path/smooth/chain_sums.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <array>
#include <cmath>

#include "path/smooth/slow_width.h"
#include "path/smooth/soft_corner.h"

namespace kadr::chain_sums_test {
namespace {

struct Chain {
  std::vector<double> at{0}, bend;
  std::vector<char> is_chained{0};
  std::size_t axes = 3;

  explicit Chain(std::size_t of_axes) : bend(of_axes, 0), axes(of_axes) {}
  void add(double length, const std::vector<double>& by, bool chained = true) {
    at.push_back(at.back() + length);
    bend.insert(bend.end(), by.begin(), by.end());
    is_chained.push_back(chained ? 1 : 0);
  }
  ChainSums::Corners corners() const { return {at, bend, is_chained}; }
};

/// A single gentle corner, computed directly from its pulse as a sum of ramps.
struct Plain {
  double g, slope, pulse;
};

Plain gentle(double r) {
  constexpr double equal = SoftCorner::equal_swings, f = equal / (2 * (equal * equal / 2 - 2 * equal + 1));
  constexpr std::array<double, 5> node = {-1, -(1 - 1 / equal), 0, 1 - 1 / equal, 1}, kink = {-1, 2, -2, 2, -1};
  Plain sum{0, 0, 0};
  for (std::size_t n = 0; n < node.size(); ++n) {
    const double y = std::max(0.0, r - node[n]), k = kink[n] * equal * f;
    sum.g += k * y * y * y / 6, sum.slope += k * y * y / 2, sum.pulse += k * y;
  }
  if (r > 0) sum.g -= r, sum.slope -= 1;
  return sum;
}

TEST(ChainSums, OneCornerIsTheGentleOneOfSoftCorner) {
  const SoftCorner& corner = SoftCorner::of(0.1);
  for (double r = 0; r < 1; r += 0.01) {
    const SoftCorner::Shape shape = corner.at(r);
    const Plain plain = gentle(-r);
    EXPECT_NEAR(plain.g, shape.g, 2e-3);  // SoftCorner is divided into 32 pieces
    EXPECT_NEAR(plain.slope, shape.slope, 4e-3);
  }
  EXPECT_NEAR(gentle(-1).g, 0, 1e-12);
  EXPECT_NEAR(gentle(1).g, 0, 1e-12);
  EXPECT_NEAR(gentle(1).slope, 0, 1e-12);
}

RC_GTEST_PROP(ChainSumsProperty, AreTheSumOfTheCorners, ()) {
  const std::size_t axes = static_cast<std::size_t>(*rc::gen::inRange(1, 7));
  Chain chain(axes);
  const int count = *rc::gen::inRange(1, 200);
  for (int i = 0; i < count; ++i) {
    std::vector<double> bend(axes);
    for (double& of_axis : bend) of_axis = *rc::gen::inRange(-100, 101) * 1e-3;
    chain.add(*rc::gen::inRange(1, 2000) * 1e-3, bend, *rc::gen::inRange(0, 4) > 0);
  }
  ChainSums sums(axes);
  const double width = *rc::gen::inRange(50, 2000) * 1e-3;
  for (double s = 0; s < chain.at.back(); s += chain.at.back() / 37) {
    std::vector<double> shift(axes, 0), x(axes, 0), x1(axes, 0), x2(axes, 0), g(axes, 0), g1(axes, 0), g2(axes, 0);
    for (std::size_t i = 1; i < chain.at.size(); ++i) {
      if (chain.is_chained[i] == 0 || std::fabs(s - chain.at[i]) >= width) continue;
      const Plain plain = gentle((s - chain.at[i]) / width);
      for (std::size_t a = 0; a < axes; ++a) {
        const double bend = chain.bend[i * axes + a];
        g[a] += bend * width * plain.g, g1[a] += bend * plain.slope, g2[a] += bend * plain.pulse / width;
      }
    }
    sums.move(chain.corners(), s, width, shift.data());
    sums.move(chain.corners(), s, {width, 0, 0}, x.data(), x1.data(), x2.data());
    for (std::size_t a = 0; a < axes; ++a) {
      RC_ASSERT(std::fabs(shift[a] - g[a]) < 1e-9);
      RC_ASSERT(std::fabs(x[a] - g[a]) < 1e-9);
      RC_ASSERT(std::fabs(x1[a] - g1[a]) < 1e-9);
      RC_ASSERT(std::fabs(x2[a] - g2[a]) < 1e-8);
    }
  }
}

// x′ and x″ are the derivatives of x also while the width changes.
TEST(ChainSums, DerivativesWithAWidthThatChanges) {
  Chain chain(1);
  for (int i = 0; i < 60; ++i) chain.add(0.13, {0.02 * std::sin(i * 0.7)});
  ChainSums sums(1);
  const auto width = [](double s) { return WidthAt{0.8 + 0.1 * s - 0.004 * s * s, 0.1 - 0.008 * s, -0.008}; };
  const auto at = [&](double s) {
    std::array<double, 3> x{};
    sums.move(chain.corners(), s, width(s), &x[0], &x[1], &x[2]);
    for (std::size_t i = 1; i < chain.at.size(); ++i)  // the polyline itself has corners there
      if (chain.at[i] < s) x[0] += chain.bend[i] * (s - chain.at[i]), x[1] += chain.bend[i];
    return x;
  };
  constexpr double h = 1e-5;
  for (double s = 1; s < 6.5; s += 0.0937) {
    const auto before = at(s - h), here = at(s), after = at(s + h);
    EXPECT_NEAR((after[0] - before[0]) / (2 * h), here[1], 1e-7);
    EXPECT_NEAR((after[1] - before[1]) / (2 * h), here[2], 1e-4);
  }
}

TEST(SlowWidth, IsNowhereWiderThanAsked) {
  SlowWidth slow;
  slow.begin();
  slow.open(30);
  const std::vector<std::array<double, 2>> limits = {{3, 0.9}, {3.4, 0.5}, {9, 0.05}, {9.7, 1.2}, {20, 1.9}};
  for (const auto& [at, width] : limits) slow.limit(at, width);
  slow.close();
  for (const auto& [at, width] : limits) EXPECT_LE(slow.at(at).w, width + 0.04) << at;  // the slope over one and a half parts
  for (double s = 0; s < 30; s += 0.01) {
    EXPECT_LE(std::fabs(slow.at(s).w1), 0.151) << s;
    EXPECT_GT(slow.at(s).w, 0.04);
    EXPECT_NEAR(slow.at(s + 1e-7).w1, slow.at(s).w1, 1e-5) << s;
    EXPECT_NEAR(slow.at(s + 1e-9).w2, slow.at(s).w2, 1e-5) << s;
  }
  EXPECT_EQ(slow.at(29.5).w, SoftCorner::widest);
}

TEST(SlowWidth, WhatIsSettledStays) {
  SlowWidth slow;
  slow.begin();
  slow.open(40);
  slow.limit(12, 0.7);
  slow.close();
  slow.settle(20);
  std::vector<double> before;
  for (double s = 0; s < 20; s += 0.05) before.push_back(slow.at(s).w);
  slow.open(80);
  slow.limit(19, 0.1);  // too late: this part is settled
  slow.limit(20 + SlowWidth::felt(), 0.1);
  slow.close();
  std::size_t i = 0;
  for (double s = 0; s < 20; s += 0.05) EXPECT_EQ(slow.at(s).w, before[i++]) << s;
  EXPECT_LT(slow.at(20 + SlowWidth::felt()).w, 0.15);
  slow.forget(60);
  EXPECT_EQ(slow.at(75).w, SoftCorner::widest);
}

}  // namespace
}  // namespace kadr::chain_sums_test
