// Finds which lattice points are material, from the intervals of the lattice lines along Z. Used by stock/surface.

#include "stock/surface/brick_signs.h"

#include <algorithm>

namespace kadr {
namespace {

constexpr std::uint32_t whole_column = (1u << brick_edge) - 1;

float place_of(int i, float cell) { return (float(i) + 0.5f) * cell; }

/// Returns the index of the first lattice point that is beyond the position.
int first_beyond(float place, float cell) {
  int i = std::clamp(int(place / cell + 0.5f), 0, brick_edge);
  while (i > 0 && place_of(i - 1, cell) > place) --i;
  while (i < brick_edge && place_of(i, cell) <= place) ++i;
  return i;
}

/// Returns the index of the first lattice point that is at or beyond the position.
int first_not_before(float place, float cell) {
  int i = std::clamp(int(place / cell + 0.5f), 0, brick_edge);
  while (i > 0 && place_of(i - 1, cell) >= place) --i;
  while (i < brick_edge && place_of(i, cell) < place) ++i;
  return i;
}

std::uint32_t between(float from, float to, float cell) {
  if (from >= to) return 0;
  const int first = from < 0 ? 0 : first_beyond(from, cell), last = first_not_before(to, cell);
  return first >= last ? 0 : (1u << last) - (1u << first);
}

}  // namespace

BricksAround::BricksAround(const Stock& stock, BrickPlace place) : same(true) {
  const Lattice& lattice = stock.lattice();
  for (int q = 0; q < 8; ++q) {
    const BrickPlace p{place.x + (q & 1), place.y + (q >> 1 & 1), place.z + (q >> 2)};
    const std::size_t at = std::size_t(q);
    state[at] = lattice.holds(p) ? stock.state(lattice.at(p)) : Stock::State::empty;
    brick[at] = state[at] == Stock::State::mixed ? stock.brick(lattice.at(p)) : nullptr;
    same = same && state[at] == state[0] && state[at] != Stock::State::mixed;
  }
}

void BrickSigns::take(const BricksAround& around, float cell) {
  columns_.fill(0);
  for (int q = 0; q < 8; ++q) {
    const Stock::State state = around.state[std::size_t(q)];
    if (state == Stock::State::empty) continue;
    const int next_in_x = q & 1, next_in_y = q >> 1 & 1;
    const int wide = next_in_x ? 1 : brick_edge, deep = next_in_y ? 1 : brick_edge;
    const auto add = [&](int x, int y, std::uint32_t column) {
      std::uint32_t& all = columns_[std::size_t((y + next_in_y * brick_edge) * signs_edge + x + next_in_x * brick_edge)];
      all |= q >> 2 ? (column & 1) << brick_edge : column;
    };
    const BrickLines* const lines = state == Stock::State::mixed ? &around.brick[std::size_t(q)]->family[2] : nullptr;
    for (int y = 0; y < deep; ++y)
      for (int x = 0; x < wide; ++x) {
        const int line = y * brick_edge + x;
        add(x, y, lines == nullptr ? whole_column : between(lines->from[line], lines->to[line], cell));
      }
    if (lines == nullptr) continue;
    for (const FurtherInterval& f : lines->further)
      if (f.line % brick_edge < wide && f.line / brick_edge < deep)
        add(f.line % brick_edge, f.line / brick_edge, between(f.from, f.to, cell));
  }
}

bool is_material(const Stock& stock, const std::array<int, 3>& point) {
  const Lattice& lattice = stock.lattice();
  if (point[0] < 0 || point[1] < 0 || point[2] < 0) return false;
  const BrickPlace place{point[0] / brick_edge, point[1] / brick_edge, point[2] / brick_edge};
  if (!lattice.holds(place)) return false;
  const std::size_t b = lattice.at(place);
  if (stock.state(b) != Stock::State::mixed) return stock.state(b) == Stock::State::full;
  const float cell = float(lattice.cell());
  const int line = point[1] % brick_edge * brick_edge + point[0] % brick_edge, z = point[2] % brick_edge;
  const BrickLines& lines = stock.brick(b)->family[2];
  std::uint32_t column = between(lines.from[line], lines.to[line], cell);
  for (const FurtherInterval& f : lines.further)
    if (f.line == line) column |= between(f.from, f.to, cell);
  return (column >> z & 1) != 0;
}

}  // namespace kadr
