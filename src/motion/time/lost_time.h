#pragma once
// LostTime: finds the program lines that take longer than their feed alone would require, and the axis limit that causes the loss
// (motion/look_ahead/limited_by). Memory is bounded: a table of program lines; when the table is full, the half of the lines that lost
// least time is dropped. A line that is executed several times has one entry.

#include <unordered_map>
#include <vector>

#include "motion/look_ahead/limited_by.h"

namespace kadr {

class LostTime {
 public:
  struct Place {
    std::uint16_t file = 0;  // program file of `line`, numbered as in Origin::file
    std::uint32_t line = 0;
    std::uint64_t times = 0;  // how often the line was executed
    bool rapid = false;       // true if the last execution of the line was a rapid motion
    double seconds = 0;       // time spent on the line
    double at_feed = 0;       // time at the programmed feed or rapid rate alone, s
    LimitedBy by{};           // the limit that caused most of the lost time
    double by_part = 0;       // share of the lost time that `by` caused
    double lost() const { return seconds - at_feed; }
  };

  /// `most`: capacity of the table in program lines, at least 2.
  explicit LostTime(MotionLimits limits, std::size_t most = 1024) : limits_(std::move(limits)), most_(most) {}

  void take(const TimedCells& cells);

  /// Returns the `count` lines that lost most, the greatest loss first; lines with equal losses are in program order. Not included:
  /// pauses, motions whose time at their feed is unknown, and lines that lost less than the planner's own error.
  ///   law  exact if the program has no more lines than the table; else, for a line that lost little each time, only its last executions
  ///        may be counted
  std::vector<Place> worst(std::size_t count) const;
  /// Time lost in all lines, s.
  double all() const { return all_; }

 private:
  struct Row {
    Place place;
    std::array<double, limit_count * max_axes> by{};  // lost time, s, by limit and axis
  };
  Row& row_of(std::uint64_t tag);
  void forget_half();

  MotionLimits limits_;
  std::size_t most_;
  std::vector<Row> rows_;
  std::unordered_map<std::uint64_t, std::size_t> index_;  // key: file and line packed as a tag; value: index in rows_
  std::uint64_t last_ = ~std::uint64_t{0};
  std::size_t at_ = 0;  // index in rows_ of the tag `last_`
  double all_ = 0;
};

}  // namespace kadr
