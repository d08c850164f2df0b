#pragma once
// LostTime finds the program lines that take longer than their feed alone would require, and the axis limit that causes the loss
// (motion/look_ahead/limited_by). The table of program lines is bounded: when the table is full, the half of the lines that lost the least
// time is removed. A line that is executed several times has one entry.

#include <unordered_map>
#include <vector>

#include "motion/look_ahead/limited_by.h"

namespace kadr {

class LostTime {
 public:
  struct Place {
    std::uint16_t file = 0;  // the program file that contains `line`, numbered as in Origin::file
    std::uint32_t line = 0;
    std::uint64_t times = 0;  // number of executions of the program line
    bool rapid = false;       // true if the last execution of the line was a rapid motion
    double seconds = 0;       // time spent on the program line in all its executions, s
    double at_feed = 0;       // time that the executions of the line would take at the programmed feed or rapid rate alone, s
    LimitedBy by{};           // the limit that caused most of the lost time on the line
    double by_part = 0;       // fraction (0 to 1) of the lost time that the limit `by` caused
    double lost() const { return seconds - at_feed; }
  };

  /// `most` is the greatest number of program lines in the table, at least 2.
  explicit LostTime(MotionLimits limits, std::size_t most = 1024) : limits_(std::move(limits)), most_(most) {}

  void take(const TimedCells& cells);

  /// Returns the `count` lines that lost the most time, the greatest loss first. Lines with equal losses are in program order. The result
  /// does not include pauses, motions whose time at their feed is unknown, and lines that lost less time than the planner's own error.
  ///   law  the result is exact if the program has no more lines than the table; otherwise only the last executions may count for a line
  ///        that lost little time in each execution
  std::vector<Place> worst(std::size_t count) const;
  /// Time lost in all lines of the program together, s.
  double all() const { return all_; }

 private:
  struct Row {
    Place place;
    std::array<double, limit_count * max_axes> by{};  // lost time in s for each pair of limit and axis
  };
  Row& row_of(std::uint64_t tag);
  void forget_half();

  MotionLimits limits_;
  std::size_t most_;
  std::vector<Row> rows_;
  // The key is the file and the line, packed into one number; the value is the index in rows_.
  std::unordered_map<std::uint64_t, std::size_t> index_;
  std::uint64_t last_ = ~std::uint64_t{0};
  std::size_t at_ = 0;  // index in rows_ of the program line that was looked up last
  double all_ = 0;
};

}  // namespace kadr
