// Records and restores the history of a brick. Used by stock/stock.

#include "stock/brick/brick_past.h"

#include <algorithm>

namespace kadr {

std::size_t bytes_of(const Brick& brick) {
  std::size_t sum = sizeof(Brick);
  for (const BrickLines& lines : brick.family) sum += lines.further.capacity() * sizeof(FurtherInterval);
  return sum;
}

std::size_t BrickPast::cuts_before(std::size_t sweeps) const {
  return std::size_t(std::lower_bound(cuts.begin(), cuts.end(), std::int32_t(sweeps)) - cuts.begin());
}

const BrickCopy* BrickPast::copy_before(std::size_t cuts_made) const {
  const auto after =
      std::upper_bound(copies.begin(), copies.end(), cuts_made, [](std::size_t c, const BrickCopy& copy) { return c < copy.cuts; });
  return after == copies.begin() ? nullptr : &*(after - 1);
}

void Past::make_room() {
  constexpr std::size_t farthest = std::size_t(1) << 24;
  while (apart < farthest && copied.load() > most_copied / 4 * 3) {
    apart *= 2;
    std::size_t bytes = 0;
    for (BrickPast& past : of_brick) {
      std::erase_if(past.copies, [&](const BrickCopy& copy) { return copy.cuts % apart != 0; });
      for (const BrickCopy& copy : past.copies) bytes += bytes_of(*copy.brick);
    }
    copied = bytes;
  }
}

void Past::add(std::size_t b, std::int32_t sweep, const Brick* after) {
  BrickPast& past = of_brick[b];
  past.cuts.push_back(sweep);
  if (after == nullptr || past.cuts.size() % apart != 0) return;
  auto copy = std::make_unique<Brick>(*after);
  const std::size_t needed = bytes_of(*copy);
  if (copied.fetch_add(needed, std::memory_order_relaxed) + needed > most_copied) copied.fetch_sub(needed, std::memory_order_relaxed);
  else past.copies.push_back({past.cuts.size(), std::move(copy)});
}

std::size_t Past::bytes() const {
  std::size_t sum = of_brick.capacity() * sizeof(BrickPast) + copied.load(std::memory_order_relaxed);
  for (const BrickPast& past : of_brick) sum += past.cuts.capacity() * sizeof(std::int32_t) + past.copies.capacity() * sizeof(BrickCopy);
  return sum;
}

}  // namespace kadr
