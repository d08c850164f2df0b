// The record of speeds keeps a bounded number of columns, each with the highest speeds reached in it.

#include "motion/time/speed_record.h"

#include <gtest/gtest.h>

#include "motion/least_time/rest_to_rest.h"

namespace kadr::speed_record_test {
namespace {

const MotionLimits limits{{200, 200}, {1000, 500}, {20000, 20000}};

/// Returns a straight line along Y from rest to rest, at 100 mm/s.
TimedCells line(double length, Spent::On on = Spent::On::cutting) {
  TimedCells cells{2, {}, {}, {}};
  rest_to_rest(length, {100, 500, 20000}, cells.laws);
  double s = 0;
  for (const TimeLaw& law : cells.laws) {
    cells.sources.push_back({Spent{on, 7}.tag(), 100, Bend::none});
    cells.path.insert(cells.path.end(), {0, 0, 0, 0, 0, 0, s, 1, 0, 0, 0, 0});
    s += law.length;
  }
  return cells;
}

TEST(SpeedRecord, KeepsWhatWasReached) {
  SpeedRecord record(limits);
  record.take(line(100));
  double most = 0, acceleration = 0, jerk = 0;
  for (const SpeedRecord::Column& column : record.columns()) {
    ASSERT_TRUE(column.seen);
    EXPECT_LE(column.least, column.most);
    EXPECT_EQ(column.feed, 100);
    EXPECT_EQ(column.line, 7U);
    most = std::max(most, column.most);
    acceleration = std::max(acceleration, column.acceleration.part);
    jerk = std::max(jerk, column.jerk.part);
    EXPECT_EQ(column.jerk.axis, column.jerk.part > 0 ? 1 : 0);
  }
  EXPECT_NEAR(most, 100, 1e-9);
  EXPECT_NEAR(acceleration, 1, 1e-9);
  EXPECT_NEAR(jerk, 1, 1e-9);
  EXPECT_NEAR(record.seconds(), 1.225, 1e-9);
  EXPECT_EQ(record.columns().front().least, 0);
}

TEST(SpeedRecord, NeverHasMoreColumnsThanItMay) {
  SpeedRecord record(limits, 64);
  double seconds = 0;
  for (int i = 0; i < 200; ++i) {
    const TimedCells cells = line(1 + i % 7 * 40);
    seconds += cells.seconds();
    record.take(cells);
    ASSERT_LE(record.columns().size(), 64U);
    ASSERT_NEAR(record.seconds(), seconds, 1e-9 * seconds);
    ASSERT_GE(static_cast<double>(record.columns().size()) * record.width(), record.seconds());
  }
  EXPECT_GE(record.columns().size(), 32U);
  for (const SpeedRecord::Column& column : record.columns()) EXPECT_NEAR(column.most, 100, 1e-6);
}

TEST(SpeedRecord, ALongPauseFits) {
  SpeedRecord record(limits, 64);
  TimedCells still{2, {TimeLaw{1e7, 0, true, 0, 0, 0}}, {{Spent{Spent::On::dwell, 1}.tag()}}, std::vector<double>(2 * TimedCells::terms)};
  record.take(still);
  record.take(line(10));
  EXPECT_LE(record.columns().size(), 64U);
  EXPECT_EQ(record.columns().front().on, Spent::On::dwell);
}

// Rapid motion in the same column does not hide the speed of cutting.
TEST(SpeedRecord, CuttingComesBeforeRapid) {
  SpeedRecord record(limits, 2);
  record.take(line(400, Spent::On::rapid));
  TimedCells slow{2, {TimeLaw::of_jerk(1, 5, 0, 0)}, {{Spent{Spent::On::cutting, 9}.tag(), 5, Bend::none}}, {}};
  slow.path = {0, 0, 0, 0, 0, 0, 0, 1, 0, 0, 0, 0};
  record.take(slow);
  record.take(line(400, Spent::On::rapid));
  const bool found = std::any_of(record.columns().begin(), record.columns().end(), [](const SpeedRecord::Column& c) {
    return c.on == Spent::On::cutting && c.line == 9 && c.most == 5 && c.feed == 5 && c.jerk.part > 0.99;
  });
  EXPECT_TRUE(found);
  EXPECT_NEAR(record.rapid(), 100, 1e-9);
}

}  // namespace
}  // namespace kadr::speed_record_test
