// session/cutting/sweep_lines: returns for each sweep the line with which it was stored.

#include "session/cutting/sweep_lines.h"

#include <gtest/gtest.h>

#include <random>
#include <vector>

namespace kadr::sweep_lines_test {
namespace {

using Line = SweepLines::Line;

TEST(SweepLines, KeepsEachLine) {
  std::mt19937 random(11);
  for (const unsigned kind : {1U, 2U, 5U}) {
    SweepLines kept;
    std::vector<Line> wanted;
    Line line{1, 0};
    const auto any = [&](unsigned below) { return std::uint32_t(random()) % below; };
    for (int i = 0; i < 5000; ++i) {
      line.line = any(kind) == 0 ? any(1000) : line.line + 1 + any(kind);  // a loop goes back; some lines are skipped
      if (any(50) == 0) line.file = std::uint16_t(any(3));
      wanted.resize(wanted.size() + any(4), line);  // possibly no sweep at all
      kept.fill(wanted.size(), line);
    }
    for (std::size_t i = 0; i < wanted.size(); ++i) ASSERT_EQ(kept.of(i), wanted[i]) << i;
  }
}

TEST(SweepLines, TakesNoRoomForLinesInARow) {
  SweepLines kept;
  for (std::uint32_t i = 0; i < 100'000; ++i) kept.fill(i + 1, {2 * i + 7, 3});
  EXPECT_EQ(kept.runs(), 1U);
  EXPECT_EQ(kept.of(99'999), (Line{200'005, 3}));
}

}  // namespace
}  // namespace kadr::sweep_lines_test
