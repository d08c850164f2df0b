#pragma once
// LostTime: which lines of a program take longer than their feed alone would, and by which limit of the axes
// (motion/look_ahead/limited_by). Bounded memory: a table of lines; when it is full, the half that lost least is forgotten. Lines that come
// again are one place.

#include <unordered_map>
#include <vector>

#include "motion/look_ahead/limited_by.h"

namespace kadr {

class LostTime {
 public:
  struct Place {
    std::uint16_t file = 0;  // Origin::file
    std::uint32_t line = 0;
    std::uint64_t times = 0;  // that it was come to
    bool rapid = false;       // the last time
    double seconds = 0;       // spent
    double at_feed = 0;       // by the programmed feed or rapid rate alone
    LimitedBy by{};           // the limit that took most of what was lost
    double by_part = 0;       // of what was lost
    double lost() const { return seconds - at_feed; }
  };

  /// `most`: lines in the table, at least 2.
  explicit LostTime(MotionLimits limits, std::size_t most = 1024) : limits_(std::move(limits)), most_(most) {}

  void take(const TimedCells& cells);

  /// The `count` places that lost most, the worst first; of equal ones the first line. Pauses lose nothing, nor do motions whose time by
  /// feed is unknown, nor places that lost less than the planner itself is off.
  ///   law  exact where the program has no more lines than the table; else a line that lost little each time may count its last times only
  std::vector<Place> worst(std::size_t count) const;
  /// s lost in all lines.
  double all() const { return all_; }

 private:
  struct Row {
    Place place;
    std::array<double, limit_count * max_axes> by{};  // s lost, by limit and axis
  };
  Row& row_of(std::uint64_t tag);
  void forget_half();

  MotionLimits limits_;
  std::size_t most_;
  std::vector<Row> rows_;
  std::unordered_map<std::uint64_t, std::size_t> index_;  // by file and line
  std::uint64_t last_ = ~std::uint64_t{0};
  std::size_t at_ = 0;  // the row of the last
  double all_ = 0;
};

}  // namespace kadr
