#pragma once
// SpeedRecord records the path speed and the used fractions of the axis limits over the time of a least-time plan. The result is the data
// of a diagram. Memory is bounded: each column covers an equal interval of time, and when all columns are used, pairs of columns are
// merged.

#include <limits>
#include <vector>

#include "motion/least_time/axis_motion.h"
#include "motion/look_ahead/limited_by.h"

namespace kadr {

class SpeedRecord {
 public:
  /// An interval of time, one column of the diagram. An interval may contain several activities. Speed, feed, line and `on` describe the
  /// cutting; in an interval without cutting they describe the rapid motion, otherwise the pause.
  struct Column {
    // The lowest path speed in the interval, mm/s; `most` is the highest path speed.
    double least = std::numeric_limits<double>::infinity();
    double most = 0;
    // The greatest commanded feed in the interval, mm/s. It is 0 if the axes are at rest or the programmed time is unknown.
    double feed = 0;
    // the greatest fraction of an acceleration limit and of a jerk limit that an axis uses in the interval
    LimitUsage::Share acceleration{}, jerk{};
    Spent::On on = Spent::On::cutting;  // the activity in the interval: cutting, rapid motion or pause
    std::uint32_t line = 0;             // program line that is executed in the interval
    bool seen = false;

    void take(const Column& later);
  };

  /// `most` is the greatest number of columns; it must be even.
  explicit SpeedRecord(MotionLimits limits, std::size_t most = 1400) : limits_(std::move(limits)), most_(most) {}

  void take(const TimedCells& cells);

  const std::vector<Column>& columns() const { return columns_; }
  /// The interval of time that each column covers, s.
  double width() const { return width_; }
  /// Total time of the recorded plan, s.
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
