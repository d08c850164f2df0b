// Builds and searches the index of block numbers: one pass through the file, sorted table rows, binary searches. Used by
// control/flow/program_file.

#include "control/flow/block_numbers.h"

#include <algorithm>
#include <memory>
#include <tuple>

#include "base/code_literals.h"

namespace kadr {

DataLines::Step DataLines::step_of(const Block& block) {
  Step step = Step::none;
  for (std::uint32_t i = 0; i < block.word_count; ++i) {
    const Word& w = block.words[i];
    if (w.address != 'G') continue;
    const Word* const l = block.find('L');
    if (w.code == 10_g && l != nullptr && (l->value == 52 || (l->value >= 75 && l->value <= 77))) step = Step::begins;
    if (w.code == 11_g) step = Step::ends;
  }
  return step;
}

bool BlockNumbers::make(BlockReader& reader, StopToken stop) {
  reader.seek({});
  auto block = std::make_unique<Block>();
  bool in_data = false;
  for (;;) {
    const auto got = reader.next(*block);
    if (got && *got == BlockReader::Got::end) break;
    if (block->has_number) rows_.push_back({place_of(block->position) | (in_data ? 1u : 0u), block->number, block->position.line});
    const DataLines::Step step = DataLines::step_of(*block);
    if (step != DataLines::Step::none) in_data = step == DataLines::Step::begins;
    if (step == DataLines::Step::begins) openings_.push_back(place_of(block->position));
    if (rows_.size() > most || openings_.size() > most || stop.requested()) {
      *this = {};
      return false;
    }
  }
  std::sort(rows_.begin(), rows_.end(),
            [](const Row& a, const Row& b) { return std::tie(a.number, a.place) < std::tie(b.number, b.place); });
  rows_.shrink_to_fit();
  return true;
}

/// Returns true if N in this row of the index is a block number for a search that starts at `from`. N of a data line is not a block number
/// if the search reads the G10 that the line belongs to. If the search starts after this G10, N counts as a block number.
bool BlockNumbers::counts_from(const Row& row, std::uint64_t from) const {
  if ((row.place & 1u) == 0) return true;
  const auto after = std::lower_bound(openings_.begin(), openings_.end(), row.place & ~std::uint64_t{1});
  return after != openings_.begin() && *std::prev(after) < from;
}

std::optional<Position> BlockNumbers::find(std::uint32_t number, Position from) const {
  const auto first = std::lower_bound(rows_.begin(), rows_.end(), number, [](const Row& row, std::uint32_t n) { return row.number < n; });
  const auto last = std::upper_bound(first, rows_.end(), number, [](std::uint32_t n, const Row& row) { return n < row.number; });
  const std::uint64_t start = place_of(from);
  const auto middle = std::lower_bound(first, last, start, [](const Row& row, std::uint64_t place) { return row.place < place; });
  const auto position = [](const Row& row) {
    return Position{row.place >> 16, row.line, static_cast<std::uint32_t>(row.place & 0xFFFF) >> 1};
  };
  auto found = std::find_if(middle, last, [&](const Row& row) { return counts_from(row, start); });
  if (found != last) return position(*found);
  found = std::find_if(first, middle, [&](const Row& row) { return counts_from(row, 0); });
  return found == middle ? std::nullopt : std::optional(position(*found));
}

}  // namespace kadr
