#pragma once
// LostTime: finds the lines of a program that take longer than at their feed alone, and the limit of the axes that causes it
// (motion/look_ahead/limited_by). Bounded memory: a table of lines; when it is full, the half that lost least is dropped. A line that is
// executed several times is one entry.

#include <unordered_map>
#include <vector>

#include "motion/look_ahead/limited_by.h"

namespace kadr {

class LostTime {
 public:
  struct Place {
    std::uint16_t file = 0;  // Origin::file
    std::uint32_t line = 0;
    std::uint64_t times = 0;  // how often it was executed
    bool rapid = false;       // of its last execution
    double seconds = 0;       // spent
    double at_feed = 0;       // s at the programmed feed or rapid rate alone
    LimitedBy by{};           // the limit that caused most of the lost time
    double by_part = 0;       // its share of the lost time
    double lost() const { return seconds - at_feed; }
  };

  /// `most`: lines in the table, at least 2.
  explicit LostTime(MotionLimits limits, std::size_t most = 1024) : limits_(std::move(limits)), most_(most) {}

  void take(const TimedCells& cells);

  /// Returns the `count` lines that lost most, the worst first; of equal ones the first line. Not included: pauses, motions whose time at
  /// their feed is unknown, and lines that lost less than the planner's own error.
  ///   law  exact if the program has no more lines than the table; else a line that lost little each time may count its last executions
  ///        only
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
  std::unordered_map<std::uint64_t, std::size_t> index_;  // index in rows_, by file and line
  std::uint64_t last_ = ~std::uint64_t{0};
  std::size_t at_ = 0;  // the row of `last_`
  double all_ = 0;
};

}  // namespace kadr
