#pragma once
// The part of Cutter that handles eight lattice lines at once (stock/cut/float_lanes.h). Only stock/cut/brick_cut includes this file, and
// compiles it for each type of processor.

#include "stock/cut/cutter.h"
#include "stock/cut/level_rows.h"

namespace kadr {

using namespace lanes;

namespace lanes {
template <class V>
struct Taken {
  V gone, depth, longest;
  V tip;  // height of the tool's tip where the body is lowest over each of the eight lines, mm
};
}  // namespace lanes

/// Returns the least height above the body's bottom at which the body's radius is `radius`.
template <class V>
KADR_IN_LANES V lowest_height(const SweptBody& b, const V& radius) {
  if (b.turned || b.end == BodyEnd::flat) return spread<V>(0.f);
  const V beyond = most(radius - b.flat, spread<V>(0.f));
  if (b.end == BodyEnd::cone) return beyond * b.stands;
  return spread<V>(b.corner) - root(spread<V>(b.corner * b.corner) - beyond * beyond);
}

/// Excludes squares of 4 × 4 lattice lines along Z in which the sweep removes nothing: the material ends below the sweep, or the sweep does
/// not reach the square.
template <class V>
KADR_IN_LANES void Cutter::narrow_by_squares(float least_place[3], float most_place[3]) const {
  static constexpr float middle_x[16] = {2, 6, 10, 14, 2, 6, 10, 14, 2, 6, 10, 14, 2, 6, 10, 14};
  static constexpr float middle_y[16] = {2, 2, 2, 2, 6, 6, 6, 6, 10, 10, 10, 10, 14, 14, 14, 14};
  const LocalSweep& s = sweep_;
  const float wx = s.flat_direction[0], wy = s.flat_direction[1], per_square = s.per_flat * s.per_flat;
  const float lowest = lowest_over_brick() - margin();
  const float diagonal = 2 * scale_.cell * 1.41422f + margin();
  float most_top = -1;
  unsigned columns = 0, rows = 0;
  for (int part = 0; part < 16; part += lane_count) {
    alignas(32) float x_of[lane_count], y_of[lane_count];
    alignas(32) std::int32_t reached_of[lane_count];
    for (int i = 0; i < lane_count; ++i) x_of[i] = middle_x[part + i] * scale_.cell, y_of[i] = middle_y[part + i] * scale_.cell;
    const V x = lanes_at<V>(x_of) - s.from[0], y = lanes_at<V>(y_of) - s.from[1];
    const V at = within((x * wx + y * wy) * per_square, spread<V>(0.f), spread<V>(s.length));
    const V dx = x - at * wx, dy = y - at * wy, near = most(square_root(dx * dx + dy * dy) - diagonal, spread<V>(0.f));
    const V height = lowest_height(body_, near);
    const V top = lanes_at<V>(brick_.top_of_square.data() + part);
    const MarksOf<V> reached = (near < body_.radius) & (height + lowest < top);
    store(reached_of, reached);
    for (int i = 0; i < lane_count; ++i) {
      if (reached_of[i] == 0) continue;
      columns |= 1u << (i % 4), rows |= 1u << ((part + i) / 4);
      most_top = std::max(most_top, brick_.top_of_square[std::size_t(part + i)]);
    }
  }
  const auto lowest_bit = [](unsigned bits) { return bits == 0 ? 4 : __builtin_ctz(bits); };
  const auto after_bits = [](unsigned bits) { return bits == 0 ? 0 : 32 - __builtin_clz(bits); };
  const float square = 4 * scale_.cell;
  least_place[0] = std::max(least_place[0], float(lowest_bit(columns)) * square);
  most_place[0] = std::min(most_place[0], float(after_bits(columns)) * square);
  least_place[1] = std::max(least_place[1], float(lowest_bit(rows)) * square);
  most_place[1] = std::min(most_place[1], float(after_bits(rows)) * square);
  most_place[2] = std::min(most_place[2], most_top);
}

template <class V>
KADR_IN_LANES PointRange Cutter::range() const {
  float low[3], high[3];
  for (int d = 0; d < 3; ++d) {
    const float moved = d == 2 ? sweep_.rise : sweep_.direction[d] * sweep_.length;
    low[d] = sweep_.from[d] + std::min(moved, 0.f) + (d == 2 ? below_ : -body_.radius);
    high[d] = sweep_.from[d] + std::max(moved, 0.f) + (d == 2 ? above_ : body_.radius);
  }
  PointRange range{};
  range.none = low[0] > scale_.edge || low[1] > scale_.edge || high[0] < 0 || high[1] < 0 || high[2] < 0;
  if (range.none) return range;
  narrow_by_squares<V>(low, high);
  const float per_cell = 1 / scale_.cell;
  for (int d = 0; d < 3; ++d) {
    range.first[d] = std::max(0, int(std::floor(low[d] * per_cell - 0.5f)));
    range.last[d] = std::min(brick_edge, int(std::ceil(high[d] * per_cell + 0.5f)));
    range.none = range.none || range.first[d] >= range.last[d];
  }
  return range;
}

template <class V>
KADR_IN_LANES void Cutter::cut() {
  const PointRange all = range<V>();
  if (all.none) return;
  switch (body_.end) {
    case BodyEnd::flat: return cut_families<V, BodyEnd::flat>(all);
    case BodyEnd::ball: return cut_families<V, BodyEnd::ball>(all);
    case BodyEnd::cone: return cut_families<V, BodyEnd::cone>(all);
    case BodyEnd::torus: return cut_families<V, BodyEnd::torus>(all);
  }
}

template <class V, BodyEnd end>
KADR_IN_LANES void Cutter::cut_families(const PointRange& range) {
  cut_family<V, end, 2>(range);
  cut_family<V, end, 1>(range);
  cut_family<V, end, 0>(range);
}

template <class V, BodyEnd end, int family>
KADR_IN_LANES void Cutter::cut_family(const PointRange& range) {
  constexpr int u = (family + 1) % 3, v = (family + 2) % 3;
  BrickLines& lines = brick_.family[std::size_t(family)];
  const LocalSweep sweep = body_.turned ? upside_down(sweep_) : sweep_;
  const LevelPath path(sweep, family == 2 ? 0 : family);
  // Whether a line has further intervals of material is tested before this cut. A further interval that this cut itself splits off is
  // outside the swept volume, so nothing must be removed from it.
  const bool several = !lines.further.empty();
  alignas(32) float all_from[brick_lines], all_to[brick_lines], all_tips[brick_lines];
  if (several) std::fill(all_from, all_from + brick_lines, missed), std::fill(all_to, all_to + brick_lines, -missed);
  const V none = spread<V>(0.f);
  Taken<V> taken{none, none, none, none};
  for (int row = range.first[v]; row < range.last[v]; ++row)
    for (int lane = range.first[u] / lane_count * lane_count; lane < range.last[u]; lane += lane_count) {
      const int at = row * brick_edge + lane;
      if (!several && !any(lanes_at<V>(lines.from + at) < lanes_at<V>(lines.to + at))) continue;
      const V lane_places = lanes_at<V>(scale_.place + lane);
      const float row_position = scale_.place[row];
      Swept<V> swept;
      if constexpr (family == 2) {
        swept = upright_lines<V, end>(sweep, body_, lane_places, row_position, taken.tip);
        if (end == BodyEnd::cone && body_.turned) swept = {-swept.to, -swept.from}, taken.tip = -taken.tip;
        if (several) store(all_tips + at, taken.tip);
      } else {
        const V z = family == 0 ? spread<V>(row_position) : lane_places;
        swept = level_lines<V, end>(sweep, path, body_, family == 0 ? lane_places : spread<V>(row_position), body_.turned ? -z : z);
      }
      if (several) store(all_from + at, swept.from), store(all_to + at, swept.to);
      take<V, family>(lines, at, swept, taken);
    }
  if (several) take_further(lines, family, all_from, all_to, all_tips);
  add_taken<V, family>(taken);
}

template <class V, int family>
KADR_IN_LANES void Cutter::add_taken(const Taken<V>& taken) {
  alignas(32) float gone_of[lane_count], depth_of[lane_count], longest_of[lane_count];
  store(gone_of, taken.gone), store(depth_of, taken.depth), store(longest_of, taken.longest);
  for (int i = 0; i < lane_count; ++i) {
    outcome_.longest = std::max(outcome_.longest, longest_of[i]);
    if (family == 2) outcome_.length += double(gone_of[i]), outcome_.depth = std::max(outcome_.depth, depth_of[i]);
  }
}

/// Removes the swept intervals from the first interval of each of eight lines.
template <class V, int family>
KADR_IN_LANES void Cutter::take(BrickLines& lines, int at, const Swept<V>& swept, Taken<V>& taken) {
  using Marks = MarksOf<V>;
  const V low = lanes_at<V>(lines.from + at), high = lanes_at<V>(lines.to + at), none = spread<V>(-1.f), zero = spread<V>(0.f);
  const Marks meets = (low < high) & (swept.from < swept.to) & (swept.from < high) & (swept.to > low);
  if (!any(meets)) return;
  outcome_.changed = true;
  alignas(32) float from_of[lane_count], to_of[lane_count];
  store(from_of, swept.from), store(to_of, swept.to);
  if (outcome_.watched != nullptr) watch_lanes(lines, family, at, from_of, to_of);
  const Marks takes_low = meets & (swept.from <= low), takes_high = meets & (swept.to >= high), takes_all = takes_low & takes_high;
  const V new_low = choose(takes_all, none, choose(takes_low, swept.to, low));
  const V new_high = choose(takes_all, none, choose(takes_high, swept.from, high));
  const V lost = most(high - low, zero) - most(new_high - new_low, zero);
  taken.gone = taken.gone + lost, taken.longest = most(taken.longest, lost);
  if constexpr (family == 2) taken.depth = most(taken.depth, choose(meets, least(swept.to, high) - taken.tip, zero));
  store(lines.from + at, new_low), store(lines.to + at, new_high);
  const Marks by = spread<Marks>(by_);
  store(lines.from_by + at, choose(takes_low, by, lanes_at<Marks>(lines.from_by + at)));
  store(lines.to_by + at, choose(takes_high, by, lanes_at<Marks>(lines.to_by + at)));
  const Marks splits = meets & (swept.from > low) & (swept.to < high);
  if (!any(splits)) return;
  const V between = choose(splits, swept.to - swept.from, zero);
  taken.gone = taken.gone + between, taken.longest = most(taken.longest, between);
  split(lines, at, from_of, to_of);
}

}  // namespace kadr
