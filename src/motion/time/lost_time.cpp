// LostTime finds the program lines that take longer than their feed alone would require, and the axis limit that causes the loss
// (motion/look_ahead/limited_by). Used by session/planned and out/text/lost_time_text.

#include "motion/time/lost_time.h"

#include <algorithm>

#include "motion/least_time/axis_motion.h"

namespace kadr {
namespace {

bool is_worse(const LostTime::Place& a, const LostTime::Place& b) {
  if (a.lost() != b.lost()) return a.lost() > b.lost();
  return a.file != b.file ? a.file < b.file : a.line < b.line;
}

std::uint64_t key_of(std::uint16_t file, std::uint32_t line) { return std::uint64_t{file} << 32 | line; }

}  // namespace

LostTime::Row& LostTime::row_of(std::uint64_t tag) {
  const Spent spent = Spent::of(tag);
  const std::uint64_t key = key_of(spent.file, spent.line);
  if (key == last_) return rows_[at_];
  last_ = key;
  auto found = index_.find(key);
  if (found == index_.end()) {
    if (rows_.size() >= most_) forget_half();
    found = index_.emplace(key, rows_.size()).first;
    rows_.emplace_back();
    rows_.back().place.file = spent.file;
    rows_.back().place.line = spent.line;
  }
  at_ = found->second;
  ++rows_[at_].place.times;
  return rows_[at_];
}

void LostTime::forget_half() {
  const auto half = rows_.begin() + static_cast<std::ptrdiff_t>(rows_.size() / 2);
  std::nth_element(rows_.begin(), half, rows_.end(), [](const Row& a, const Row& b) { return is_worse(a.place, b.place); });
  rows_.erase(half, rows_.end());
  index_.clear();
  for (std::size_t i = 0; i < rows_.size(); ++i) index_[key_of(rows_[i].place.file, rows_[i].place.line)] = i;
}

void LostTime::take(const TimedCells& cells) {
  for (std::size_t k = 0; k < cells.laws.size(); ++k) {
    const CellSource& source = cells.sources[k];
    if (source.feed <= 0 || source.feed >= unlimited_feed) continue;
    const double seconds = cells.laws[k].seconds, at_feed = cells.laws[k].length / source.feed;
    Row& row = row_of(source.tag);
    row.place.rapid = Spent::of(source.tag).on == Spent::On::rapid;
    row.place.seconds += seconds;
    row.place.at_feed += at_feed;
    all_ += seconds - at_feed;
    const LimitedBy by = limited_by(cells, k, limits_);
    row.by[static_cast<std::size_t>(by.limit) * max_axes + by.axis] += seconds - at_feed;
  }
}

std::vector<LostTime::Place> LostTime::worst(std::size_t count) const {
  // Losses below this fraction of the time are ignored. The planner's error is at most half of this fraction
  // (motion/least_time/least_time).
  constexpr double accurate = 1e-3;
  constexpr double shown = 5e-4;  // the smallest loss that is reported, s; a smaller loss would be displayed as 0
  std::vector<Place> places;
  for (const Row& row : rows_) {
    if (row.place.lost() < std::max(shown, accurate * row.place.seconds)) continue;
    Place& place = places.emplace_back(row.place);
    const auto most = static_cast<std::size_t>(std::max_element(row.by.begin(), row.by.end()) - row.by.begin());
    place.by = {static_cast<Limit>(most / max_axes), static_cast<std::uint8_t>(most % max_axes)};
    place.by_part = std::min(1.0, row.by[most] / place.lost());
  }
  std::sort(places.begin(), places.end(), is_worse);
  if (places.size() > count) places.resize(count);
  return places;
}

}  // namespace kadr
