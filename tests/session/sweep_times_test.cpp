// session/cutting/sweep_times: which sweeps are being executed at an instant, compared with a list of all their times.

#include "session/cutting/sweep_times.h"

#include <gtest/gtest.h>

#include <random>
#include <vector>

namespace kadr::sweep_times_test {
namespace {

TEST(SweepTimes, AreThoseOfEachSweep) {
  std::mt19937 random(5);
  const auto share = [&] { return double(random() % 10001) / 10000; };
  SweepTimes times;
  std::vector<std::pair<double, double>> wanted;  // begin and end
  double now = 0;
  for (int i = 0; i < 3000; ++i) {
    if (random() % 10 == 0) now += share() * 5;  // a dwell, a tool change
    const std::size_t sweeps = random() % 7 == 0 ? 0 : 1 + random() % 5;
    const double seconds = random() % 20 == 0 ? 0 : random() % 3 == 0 ? 0.25 : share();
    for (std::size_t s = 0; s < sweeps; ++s)
      wanted.emplace_back(now + seconds * double(s) / double(sweeps), now + seconds * double(s + 1) / double(sweeps));
    times.fill(wanted.size(), now, now + seconds);
    now += seconds;
  }
  ASSERT_EQ(times.size(), wanted.size());
  constexpr double exact = 1e-4;  // s
  for (int i = 0; i < 20'000; ++i) {
    const double instant = share() * now;
    const SweepProgress place = times.at(instant);
    ASSERT_LE(place.count, wanted.size());
    if (place.count > 0) {
      ASSERT_LE(wanted[place.count - 1].second, instant + exact);
    }
    if (place.count == wanted.size()) continue;
    const auto [begins, ends] = wanted[place.count];
    ASSERT_GE(ends, instant - exact);
    if (place.share > 0) {
      ASSERT_NEAR(begins + place.share * (ends - begins), instant, exact);
    } else {
      ASSERT_GE(begins, instant - exact);
    }
  }
}

TEST(SweepTimes, AtBothEnds) {
  SweepTimes times;
  EXPECT_EQ(times.at(1).count, 0U);
  times.fill(3, 10, 13);
  EXPECT_EQ(times.at(0).count, 0U);
  EXPECT_EQ(times.at(0).share, 0);
  EXPECT_EQ(times.at(10).count, 0U);
  EXPECT_EQ(times.at(11.5).count, 1U);
  EXPECT_NEAR(times.at(11.5).share, 0.5, 1e-6);
  EXPECT_EQ(times.at(13).count, 3U);
  EXPECT_EQ(times.at(1e300).count, 3U);
  EXPECT_EQ(times.at(1e300).share, 0);
}

TEST(SweepTimes, TakeNoRoomForChordsOfAnArc) {
  SweepTimes times;
  for (int i = 0; i < 1000; ++i) times.fill(std::size_t(i) + 1, i * 0.1, (i + 1) * 0.1);
  EXPECT_LE(times.bytes(), 200U);
}

}  // namespace
}  // namespace kadr::sweep_times_test
