// stock/kept_sweeps: returns each sweep as it was added, bit by bit.

#include "stock/kept_sweeps.h"

#include <gtest/gtest.h>

#include <cstring>
#include <random>

namespace kadr::kept_sweeps_test {
namespace {

bool same(const KeptSweep& a, const KeptSweep& b) {
  return std::memcmp(a.from, b.from, sizeof a.from) == 0 && std::memcmp(a.to, b.to, sizeof a.to) == 0 && a.tool == b.tool &&
         a.watched == b.watched && a.leans == b.leans;
}

/// Returns chains of sweeps that break off, change from 0 to -0, or change their tool.
std::vector<KeptSweep> some_sweeps(std::size_t count, unsigned seldom) {
  std::mt19937 random(5);
  std::vector<KeptSweep> all;
  KeptSweep last{{0, 0, 0}, {0, 0, 0}, 0, false, false};
  for (std::size_t i = 0; i < count; ++i) {
    for (int d = 0; d < 3; ++d) last.from[d] = last.to[d], last.to[d] = float(random() % 5) - 2;
    if (random() % seldom == 0) last.from[random() % 3] = -0.f;
    if (random() % seldom == 0) last.tool = std::uint16_t(random() % 3);
    if (random() % seldom == 0) last.watched = !last.watched;
    if (random() % seldom == 0) last.leans = !last.leans;
    all.push_back(last);
  }
  return all;
}

void expect_same(const KeptSweeps& kept, const std::vector<KeptSweep>& wanted) {
  ASSERT_EQ(kept.size(), wanted.size());
  for (std::size_t i = 0; i < wanted.size(); ++i) ASSERT_TRUE(same(kept[i], wanted[i])) << i;
  for (const std::size_t first : {std::size_t{0}, wanted.size() / 3, wanted.size()}) {
    std::size_t next = first;
    kept.each(first, wanted.size(), [&](std::size_t i, const KeptSweep& s) {
      EXPECT_EQ(i, next++);
      EXPECT_TRUE(same(s, wanted[i])) << i;
    });
    EXPECT_EQ(next, wanted.size());
  }
}

TEST(kept_sweeps, are_as_they_were_added) {
  for (const unsigned seldom : {1U, 3U, 40U, 100'000U})
    for (const std::size_t count : {0U, 1U, 1023U, 1024U, 1025U, 5000U}) {
      const std::vector<KeptSweep> wanted = some_sweeps(count, seldom);
      KeptSweeps kept;
      for (const KeptSweep& s : wanted) kept.push_back(s);
      expect_same(kept, wanted);
      for (const std::size_t part : {count, count / 2, std::size_t{0}}) {
        KeptSweeps then = kept.first(part);
        expect_same(then, {wanted.begin(), wanted.begin() + std::ptrdiff_t(part)});
        if (count == 0) continue;
        then.push_back(wanted[0]);  // the copy continues on its own
        EXPECT_TRUE(same(then[part], wanted[0]));
      }
    }
}

TEST(kept_sweeps, take_12_bytes_where_they_go_on) {
  KeptSweeps kept;
  constexpr std::size_t count = 100'000;
  for (std::size_t i = 0; i < count; ++i) kept.push_back({{float(i), 0, 0}, {float(i + 1), 0, 0}, 1, false, false});
  EXPECT_LT(kept.bytes(), 13 * count);
}

}  // namespace
}  // namespace kadr::kept_sweeps_test
