#pragma once
// SpeedRecord: speed, and how near the axes are to their limits, over the time of the planner of least time; for a picture. Bounded memory:
// columns of time; when they are full, two become one.

#include <limits>
#include <vector>

#include "motion/least_time/axis_motion.h"
#include "motion/look_ahead/limited_by.h"

namespace kadr {

class SpeedRecord {
 public:
  /// A stretch of time. Where it is spent on several things, speed, feed, line and `on` are those of the cutting; without it of the rapid
  /// motion, else of the pause.
  struct Column {
    double least = std::numeric_limits<double>::infinity();  // path speed, mm/s
    double most = 0;
    double feed = 0;                            // commanded, the greatest; 0: the axes stand, or no time is known
    LimitShares::Share acceleration{}, jerk{};  // the greatest
    Spent::On on = Spent::On::cutting;          // what it is spent on
    std::uint32_t line = 0;                     // … and for which line
    bool seen = false;

    void take(const Column& later);
  };

  /// `most`: columns, an even number.
  explicit SpeedRecord(MotionLimits limits, std::size_t most = 1400) : limits_(std::move(limits)), most_(most) {}

  void take(const TimedCells& cells);

  const std::vector<Column>& columns() const { return columns_; }
  /// s, of each column.
  double width() const { return width_; }
  /// s, of all.
  double seconds() const { return now_; }
  /// mm/s, the greatest of rapid motion.
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
