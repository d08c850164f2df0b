// Restores the state of the stock after an earlier sweep (class Stock).

#include <algorithm>
#include <cassert>

#include "base/thread.h"
#include "stock/stock.h"

namespace kadr {
namespace {

/// Returns the elements of a list that belong to the first `count` sweeps. The list is sorted by the number of the sweep.
template <class OfSweeps>
OfSweeps before(const OfSweeps& all, std::size_t count) {
  return OfSweeps(all.begin(), std::partition_point(all.begin(), all.end(), [&](const auto& of) { return of.sweep < count; }));
}

}  // namespace

void Stock::keep_past(std::size_t max_bytes) {
  assert(sweeps_.size() == 0);
  past_ = std::make_unique<Past>(bricks_.size(), max_bytes);
}

std::size_t Stock::bytes_of_past() const { return past_ ? past_->bytes() : 0; }

Stock::Stock(const Stock& later, std::size_t count)
    : blank_(later.blank_),
      lattice_(later.lattice_),
      own_(later.own_),
      is_portion_(later.is_portion_),
      scale_(later.scale_),
      bend_cell_(later.bend_cell_),
      threads_(later.threads_),
      bricks_(later.bricks_.size()),
      states_(later.states_),
      tools_(later.tools_),
      swept_(later.swept_),
      tilted_(later.tilted_),
      sweeps_(later.sweeps_.first(count)),
      tilted_ends_(before(later.tilted_ends_, count)),
      done_(count),
      first_(count),
      bins_(later.bins_.size()) {}

/// Restores one brick. If no later sweep has cut the brick, the brick is copied. Otherwise the last earlier copy, or a brick of the blank,
/// is cut again by the sweeps that changed the brick after that copy.
void Stock::go_back(const Stock& later, std::size_t b) {
  const BrickPast& past = later.past_->of_brick[b];
  const std::size_t made = past.cuts_before(sweeps_.size());
  const BrickNow now{bricks_[b], states_[b]};
  if (made == past.cuts.size()) {
    if (later.bricks_[b]) now.brick = std::make_unique<Brick>(*later.bricks_[b]);
    return;
  }
  const BrickCopy* copy = past.copy_before(made);
  now.state = copy == nullptr && past.was_full ? State::full : State::mixed;
  if (copy != nullptr) now.brick = std::make_unique<Brick>(*copy->brick);
  else if (!past.was_full) now.brick = fresh(b);
  for (std::size_t i = copy == nullptr ? 0 : copy->cuts; i < made; ++i) execute(past.cuts[i], b, now, nullptr);
  settle(now);
}

void Stock::keep(const KeptSweep& sweep, PathPart part) {
  if (past_ && (part.first > 0 || part.last < 1))
    shortened_.push_back({std::uint32_t(sweeps_.size()), float(part.first), float(part.last)});
  sweeps_.push_back(sweep);
}

PathPart Stock::stored_part(std::size_t sweep) const {
  const auto found = std::partition_point(shortened_.begin(), shortened_.end(), [&](const Shortened& s) { return s.sweep < sweep; });
  if (found == shortened_.end() || found->sweep != sweep) return {};
  return {double(found->first), double(found->last)};
}

/// Executes a part of the next sweep in this restored stock: the path up to the fraction `share`. The sweep is stored in `later`, the stock
/// from which this stock was restored.
void Stock::begin_sweep(const Stock& later, double share) {
  const std::size_t next = sweeps_.size();
  const PathPart stored = later.stored_part(next);
  if (!(stored.last > stored.first) || !(share > stored.first)) return;
  const double part = std::min((share - stored.first) / (stored.last - stored.first), 1.0);
  KeptSweep sweep = later.sweeps_[next];
  if (sweep.leans) {
    TiltedEnds ends = later.tilted_ends(next);
    const TiltedPath path = tilted_path_of(sweep, ends).between(0, part);
    for (int d = 0; d < 3; ++d) ends.to[d] = float(along(path.to_direction, d));
    tilted_ends_.push_back(ends);
  }
  for (std::size_t d = 0; d < 3; ++d) sweep.to[d] = float(double(sweep.from[d]) + part * (double(sweep.to[d]) - double(sweep.from[d])));
  sweeps_.push_back(sweep);
  (void)cut();
}

Stock Stock::at(std::size_t count, double share) const {
  assert(past_ && count <= done_);
  Stock then(*this, count);
  std::atomic<std::size_t> next{0};
  run_parallel(threads_, [&](int) {
    for (std::size_t i; (i = next++) < then.bricks_.size();) then.go_back(*this, i);
  });
  if (share > 0 && count < done_) then.begin_sweep(*this, share);
  return then;
}

}  // namespace kadr
