#include "base/double_lanes.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <array>
#include <bit>
#include <cstdint>

namespace kadr::double_lanes_test {
namespace {

using Eight = std::array<double, lanes>;

/// What one type of lanes computes from numbers: in each lane, and over all lanes.
struct Made {
  std::array<std::uint64_t, 4> of_all;
  bool operator==(const Made&) const = default;
};

template <class Lanes>
KADR_LANES Made made_of(const Eight& x, const Eight& y) {
  const Lanes a(x.data()), b(y.data());
  Lanes c = where_positive(a - b, root_of(a), 0.5 * b) / (1 + a * b);
  c += -a;
  const auto bits = [](double value) { return std::bit_cast<std::uint64_t>(value); };
  return {{bits(sum_of(c)), bits(product_of(c)), bits(least_of(c)), bits(greatest_of(c))}};
}

RC_GTEST_PROP(Lanes, AllKindsGiveTheSameBits, ()) {
  Eight x, y;
  for (std::size_t i = 0; i < lanes; ++i) x[i] = *rc::gen::inRange(0, 1000) * 0.37, y[i] = *rc::gen::inRange(0, 1000) * 0.11;
  const Made narrow = made_of<NarrowLanes>(x, y);
  const Made chosen = with_best_lanes([&](auto like) __attribute__((always_inline)) { return made_of<decltype(like)>(x, y); });
  RC_ASSERT(narrow == chosen);
}

TEST(Lanes, AsWrittenOut) {
  const Eight x{1, 2, 3, 4, 5, 6, 7, 8.5};
  const NarrowLanes lanes_of(x.data());
  EXPECT_EQ(sum_of(lanes_of), 36.5);
  EXPECT_EQ(product_of(lanes_of), 42840);
  EXPECT_EQ(least_of(lanes_of), 1);
  EXPECT_EQ(greatest_of(lanes_of), 8.5);
  EXPECT_EQ(least_of(where_positive(lanes_of - 4, lanes_of, 10 * lanes_of)), 5);
  EXPECT_EQ(sum_of(root_of(lanes_of * lanes_of)), 36.5);
}

}  // namespace
}  // namespace kadr::double_lanes_test
