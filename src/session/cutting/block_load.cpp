// BlockLoads: sums up the motions at feed by block and finds the highest removal rates. It is used by session/cutting and tested by
// tests/session/block_load_test.cpp.

#include "session/cutting/block_load.h"

#include <algorithm>
#include <cmath>

#include "base/vec.h"

namespace kadr {
namespace {

// Greatest ratio of the travel in Z to the travel in the working plane. No depth and width of cut are computed for steeper motions.
constexpr double steepest = 1;

bool of_same_line(const Origin& a, const Origin& b) { return a.line == b.line && a.file == b.file; }

bool heavier(const BlockLoad& a, const BlockLoad& b) { return *a.rate != *b.rate ? *a.rate > *b.rate : a.begins < b.begins; }

}  // namespace

void BlockLoads::Sum::add(const Sum& more) {
  seconds += more.seconds, length += more.length, flat += more.flat, volume += more.volume;
  depth = std::max(depth, more.depth);
}

void BlockLoads::add(const CutMotion& m) {
  const Sum sum{m.seconds, m.length, m.flat, m.volume, m.depth};
  if (!open_.empty() && open_.back().first.origin.number == m.origin.number && open_.back().first.tool == m.tool) {
    open_.back().sum.add(sum);
    open_.back().end_sweep = m.end_sweep;
    return;
  }
  end_block();
  if (!short_.empty() && short_.back().first.tool != m.tool) end_row();
  open_.push_back({m, sum, m.end_sweep});
}

/// Ends the current block. A block whose path is at least reach_ mm long is reported with its own values. Shorter blocks are collected and
/// get common values.
void BlockLoads::end_block() {
  if (open_.empty()) return;
  if (open_.back().sum.length >= reach_) {
    end_row();
    report_row(open_);
    return open_.clear();
  }
  short_.push_back(open_.back());
  open_.clear();
  double length = 0;
  for (const Block& b : short_) length += b.sum.length;
  if (length >= reach_ || short_.size() >= most_in_row) end_row();
}

void BlockLoads::end_row() {
  if (!short_.empty()) report_row(short_);
  short_.clear();
}

void BlockLoads::finish() {
  end_block();
  end_row();
}

/// Reports the blocks of `row`, which are successive and short. Removal rate, feed and engagement of each block are the means over all of
/// them.
void BlockLoads::report_row(const std::vector<Block>& row) {
  Sum all;
  for (const Block& b : row) all.add(b.sum);
  const CutMotion& first = row.front().first;
  const bool is_long = all.length >= reach_ && all.seconds > 0;
  const double rate = is_long ? all.volume / all.seconds : 0;
  const bool is_level = all.length * all.length <= all.flat * all.flat * (1 + steepest * steepest);
  const double width = all.depth > 0 ? all.volume / (all.flat * all.depth) : 0;
  double most_volume = -1;
  BlockLoad heaviest;
  for (const Block& b : row) {
    BlockLoad load{b.first.origin, {}, b.first.tool, b.first.begins, b.sum.seconds, b.sum.length, 0, {}, {}, {}, {}, {}, b.first.at};
    load.volume = all.volume * (b.sum.length / all.length);
    if (is_long) load.rate = rate;
    if (all.seconds > 0 && first.teeth > 0) load.feed_per_tooth = all.length / all.seconds / first.teeth;
    if (is_long && is_level && all.depth > 0) {
      load.depth = all.depth, load.width = width;
      load.angle = std::acos(std::clamp(1 - 2 * width / first.diameter, -1.0, 1.0)) / rad_per_deg;
    }
    if (on_block) on_block(load);
    if (on_rate && is_long) on_rate(b.first.first_sweep, b.end_sweep, rate);
    if (b.sum.volume > most_volume) most_volume = b.sum.volume, heaviest = load;
  }
  if (rate > 0) weigh(heaviest);
}

/// Adds a load to the list of the heaviest loads. When the list is full, the lightest load is dropped. Its line returns to the list only
/// with a higher rate.
void BlockLoads::weigh(const BlockLoad& load) {
  const auto same =
      std::find_if(heaviest_.begin(), heaviest_.end(), [&](const BlockLoad& h) { return of_same_line(h.origin, load.origin); });
  if (same != heaviest_.end()) {
    if (*load.rate > *same->rate) *same = load;
    return;
  }
  if (heaviest_.size() < max_reported) return heaviest_.push_back(load);
  const auto least = std::max_element(heaviest_.begin(), heaviest_.end(), heavier);
  if (heavier(load, *least)) *least = load;
}

std::vector<BlockLoad> BlockLoads::heaviest() const {
  std::vector<BlockLoad> sorted = heaviest_;
  std::sort(sorted.begin(), sorted.end(), heavier);
  return sorted;
}

}  // namespace kadr
