#pragma once
// SpeedRecord: records the speed, and how near the axes are to their limits, over the time of a least-time plan. The result is the data
// of a diagram. Memory is bounded: each column covers an equal interval of time; when all columns are used, pairs of columns are merged.

#include <limits>
#include <vector>

#include "motion/least_time/axis_motion.h"
#include "motion/look_ahead/limited_by.h"

namespace kadr {

class SpeedRecord {
 public:
  /// An interval of time. If the interval contains several activities, speed, feed, line and `on` describe the cutting; without cutting,
  /// the rapid motion; else the pause.
  struct Column {
    double least = std::numeric_limits<double>::infinity();  // lowest path speed in the interval, mm/s; `most` is the highest
    double most = 0;
    // the greatest commanded feed, mm/s; 0: the axes are at rest, or the programmed time is unknown
    double feed = 0;
    LimitUsage::Share acceleration{}, jerk{};  // the greatest shares of the limits used by an axis
    Spent::On on = Spent::On::cutting;         // activity that the interval is spent on
    std::uint32_t line = 0;                    // program line that the interval is spent on
    bool seen = false;

    void take(const Column& later);
  };

  /// `most`: number of columns, even.
  explicit SpeedRecord(MotionLimits limits, std::size_t most = 1400) : limits_(std::move(limits)), most_(most) {}

  void take(const TimedCells& cells);

  const std::vector<Column>& columns() const { return columns_; }
  /// Width of each column, s.
  double width() const { return width_; }
  /// Total time, s.
  double seconds() const { return now_; }
  /// The greatest speed of rapid motion, mm/s.
  double rapid() const { return rapid_; }

 private:
  void take_cell(const TimedCells& cells, std::size_t cell);
  void halve();

  MotionLimits limits_;
  std::size_t most_;
  std::vector<Column> columns_;
  double width_ = 1e-3;
  double now_ = 0;
  double rapid_ = 0;
};

}  // namespace kadr
