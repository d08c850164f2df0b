// SpeedRecord records the path speed and the used fractions of the axis limits over the time of a least-time plan. Used by
// out/picture/speed_page; tested by tests/motion/speed_record_test.cpp.

#include "motion/time/speed_record.h"

#include <algorithm>

namespace kadr {

void SpeedRecord::Column::take(const Column& later) {
  if (!later.seen) return;
  if (later.acceleration.part > acceleration.part) acceleration = later.acceleration;
  if (later.jerk.part > jerk.part) jerk = later.jerk;
  if (seen && later.on > on) return;
  if (!seen || later.on < on) least = later.least, most = later.most, feed = later.feed;
  seen = true;
  least = std::min(least, later.least);
  most = std::max(most, later.most);
  feed = std::max(feed, later.feed);
  on = later.on;
  line = later.line;
}

void SpeedRecord::halve() {
  for (std::size_t i = 0; i < columns_.size(); i += 2) {
    columns_[i / 2] = columns_[i];
    if (i + 1 < columns_.size()) columns_[i / 2].take(columns_[i + 1]);
  }
  columns_.resize((columns_.size() + 1) / 2);
  width_ *= 2;
}

void SpeedRecord::take_cell(const TimedCells& cells, std::size_t cell) {
  const TimeLaw& law = cells.laws[cell];
  const CellSource& source = cells.sources[cell];
  const Spent spent = Spent::of(source.tag);
  while ((now_ + law.seconds) / width_ >= static_cast<double>(most_)) halve();
  const auto last = static_cast<std::size_t>((now_ + law.seconds) / width_);
  if (columns_.size() <= last) columns_.resize(last + 1);
  for (auto i = static_cast<std::size_t>(now_ / width_); i <= last; ++i) {
    const double from = std::clamp(static_cast<double>(i) * width_ - now_, 0.0, law.seconds);
    const double to = std::clamp(static_cast<double>(i + 1) * width_ - now_, 0.0, law.seconds);
    for (const double t : {from, (from + to) / 2, to}) {
      if (!(law.seconds > 0)) continue;
      const double part = law.by_time ? t / law.seconds : std::min(1.0, law.distance(t) / law.length);
      const LimitUsage shares = shares_at(cells, cell, part, limits_);
      if (spent.on == Spent::On::rapid) rapid_ = std::max(rapid_, shares.speed);
      columns_[i].take({shares.speed, shares.speed, source.feed < unlimited_feed ? source.feed : 0, shares.of_acceleration, shares.of_jerk,
                        spent.on, spent.line, true});
    }
  }
  now_ += law.seconds;
}

void SpeedRecord::take(const TimedCells& cells) {
  for (std::size_t k = 0; k < cells.laws.size(); ++k) take_cell(cells, k);
}

}  // namespace kadr
