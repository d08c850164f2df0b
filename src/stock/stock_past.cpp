// The stock as it was at an earlier sweep.

#include <cassert>

#include "stock/stock.h"

namespace kadr {

void Stock::keep_past(std::size_t most_bytes) {
  assert(done_ == 0);
  past_ = std::make_unique<Past>(bricks_.size(), most_bytes);
}

std::size_t Stock::bytes_of_past() const { return past_ ? past_->bytes() : 0; }

Stock::Stock(const Stock& later, std::size_t count)
    : blank_(later.blank_),
      lattice_(later.lattice_),
      scale_(later.scale_),
      bend_cell_(later.bend_cell_),
      threads_(later.threads_),
      bricks_(later.bricks_.size()),
      states_(later.states_),
      tools_(later.tools_),
      swept_(later.swept_),
      leaning_(later.leaning_),
      sweeps_(later.sweeps_.first(count)),
      lean_ends_(later.lean_ends_),
      done_(count),
      first_(count),
      bins_(later.bins_.size()) {}

/// A brick that nothing has cut since is as it is now; otherwise its last copy before, or the blank, is cut once more by what changed it.
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
  for (std::size_t i = copy == nullptr ? 0 : copy->cuts; i < made; ++i) carry_out(past.cuts[i], b, now, nullptr);
  settle(now);
}

Stock Stock::at(std::size_t count) const {
  assert(past_ && count <= done_);
  Stock then(*this, count);
  std::atomic<std::size_t> next{0};
  side_by_side(threads_, [&](int) {
    for (std::size_t i; (i = next++) < then.bricks_.size();) then.go_back(*this, i);
  });
  return then;
}

}  // namespace kadr
