// machine/rendezvous: which channel waits for which. NCT 14.5.

#include "machine/rendezvous.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <bit>

namespace kadr::rendezvous_test {
namespace {

constexpr std::uint32_t set(std::initializer_list<int> channels) {
  std::uint32_t bits = 0;
  for (const int channel : channels) bits |= 1u << channel;
  return bits;
}

/// The manual's example: channel 1 arrives first at M501, channel 3 arrives first at M502.
TEST(rendezvous, three_channels) {
  Rendezvous r;
  r.arrive(1, 501, set({1, 2}), 1);
  EXPECT_FALSE(r.next());
  r.arrive(2, 501, set({1, 2}), 3);
  auto met = r.next();
  ASSERT_TRUE(met);
  EXPECT_EQ(met->code, 501u);
  EXPECT_EQ(met->channels, (std::vector<std::uint8_t>{1, 2}));
  EXPECT_EQ(met->at, 3);
  r.arrive(3, 502, set({1, 2, 3}), 4);
  r.arrive(2, 502, set({1, 2, 3}), 5);
  EXPECT_FALSE(r.next());
  r.arrive(1, 502, set({1, 2, 3}), 8);
  met = r.next();
  ASSERT_TRUE(met);
  EXPECT_EQ(met->channels, (std::vector<std::uint8_t>{3, 2, 1}));
  EXPECT_EQ(met->at, 8);
  EXPECT_FALSE(r.next());
}

TEST(rendezvous, code_and_set_must_be_the_same) {
  Rendezvous r;
  r.arrive(1, 501, set({1, 2}), 0);
  r.arrive(2, 502, set({1, 2}), 0);
  r.arrive(3, 501, set({1, 2, 3}), 0);
  EXPECT_FALSE(r.next());
  r.leave(2);
  r.arrive(2, 501, set({1, 2}), 1);
  ASSERT_TRUE(r.next());
}

TEST(rendezvous, one_outside_the_set_goes_with_those_in_it) {
  Rendezvous r;
  r.arrive(3, 501, set({1, 2}), 0);
  r.arrive(1, 501, set({1, 2}), 1);
  EXPECT_FALSE(r.next());
  r.arrive(2, 501, set({1, 2}), 2);
  EXPECT_EQ(r.next()->channels, (std::vector<std::uint8_t>{3, 1, 2}));
}

/// Channels 1 to 8 arrive in any order; each waits for a set that contains
/// itself. A set is complete exactly when all its channels have arrived.
RC_GTEST_PROP(rendezvous, meets_when_the_last_has_come, ()) {
  Rendezvous r;
  std::vector<std::pair<std::uint32_t, std::uint32_t>> key(9);  // for each channel: code, set
  std::vector<bool> waits(9, false);
  const auto complete = [&](int channel) {
    const std::uint32_t all = key[static_cast<std::size_t>(channel)].second;
    for (std::size_t other = 1; other <= 8; ++other)
      if ((all >> other & 1u) != 0 && !(waits[other] && key[other] == key[static_cast<std::size_t>(channel)])) return false;
    return true;
  };
  std::vector<int> order = {1, 2, 3, 4, 5, 6, 7, 8};
  for (std::size_t i = order.size(); i > 1; --i) std::swap(order[i - 1], order[*rc::gen::inRange<std::size_t>(0, i)]);
  double at = 0;
  for (const int channel : order) {
    const auto n = static_cast<std::size_t>(channel);
    const std::uint32_t halves[] = {set({1, 2, 3, 4, 5, 6, 7, 8}), channel <= 4 ? set({1, 2, 3, 4}) : set({5, 6, 7, 8}),
                                    channel % 2 == 0 ? set({2, 4, 6, 8}) : set({1, 3, 5, 7})};
    key[n] = {*rc::gen::element(501u, 502u), halves[*rc::gen::inRange<std::size_t>(0, 3)]};
    waits[n] = true;
    r.arrive(channel, key[n].first, key[n].second, ++at);
    const bool meets = complete(channel);
    const auto met = r.next();
    RC_ASSERT(met.has_value() == meets);
    if (!met) continue;
    RC_ASSERT(met->at == at);
    RC_ASSERT(met->channels.back() == channel);
    RC_ASSERT(static_cast<int>(met->channels.size()) == std::popcount(key[n].second));
    for (const std::uint8_t other : met->channels) waits[other] = false;
    RC_ASSERT(!r.next());
  }
}

}  // namespace
}  // namespace kadr::rendezvous_test
