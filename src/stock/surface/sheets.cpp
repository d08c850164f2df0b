// Divides the surface in a lattice cell into sheets (connected parts), depending on which corners of the cell are material. Used by
// stock/surface/surface.

#include "stock/surface/sheets.h"

#include <algorithm>
#include <numeric>

namespace kadr {
namespace {

/// Returns the number of the cell edge between two corners.
int edge_between(int p, int q) {
  const int family = (p ^ q) == 1 ? 0 : (p ^ q) == 2 ? 1 : 2;
  const int u = (family + 1) % 3, v = (family + 2) % 3;
  return 4 * family + (p >> u & 1) + 2 * (p >> v & 1);
}

/// Returns the corners of a face in cyclic order.
std::array<int, 4> corners_of(int face) {
  const int axis = face / 2, u = (axis + 1) % 3, v = (axis + 2) % 3, side = (face & 1) << axis;
  return {side, side | 1 << u, side | 1 << u | 1 << v, side | 1 << v};
}

struct Joined {
  std::array<int, cell_edges> parent;

  int root(int i) const { return parent[std::size_t(i)] == i ? i : root(parent[std::size_t(i)]); }
  void join(int a, int b) {
    const int low = std::min(root(a), root(b)), high = std::max(root(a), root(b));
    parent[std::size_t(high)] = low;
  }
};

/// The pairs of crossed edges that are joined on a face: no pair, one or two.
struct Pairs {
  int count = 0;
  std::array<std::array<int, 2>, 2> pair{};
};

Pairs pairs_of(unsigned signs, int face, bool parts_air) {
  const std::array<int, 4> round = corners_of(face);
  const auto is_material = [&](int i) { return (signs >> round[std::size_t(i & 3)] & 1) != 0; };
  Pairs pairs;
  std::array<int, 4> crossed{};
  int count = 0;
  for (int i = 0; i < 4; ++i)
    if (is_material(i) != is_material(i + 1))
      crossed[std::size_t(count++)] = edge_between(round[std::size_t(i)], round[std::size_t((i + 1) & 3)]);
  if (count == 2) pairs = {1, {{{crossed[0], crossed[1]}, {}}}};
  // Edge i goes from corner i to the next corner, so a pair that separates corner i from the other corners joins the edges i - 1 and i.
  if (count == 4 && is_material(0) != parts_air) pairs = {2, {{{crossed[3], crossed[0]}, {crossed[1], crossed[2]}}}};
  else if (count == 4) pairs = {2, {{{crossed[0], crossed[1]}, {crossed[2], crossed[3]}}}};
  return pairs;
}

std::array<Sheets, 256> all_plain() {
  std::array<Sheets, 256> all{};
  for (unsigned signs = 0; signs < 256; ++signs) all[signs] = sheets_of(signs, 0);
  return all;
}

}  // namespace

Sheets sheets_of(unsigned signs, unsigned parts_air) {
  Joined joined{};
  std::iota(joined.parent.begin(), joined.parent.end(), 0);
  std::array<Pairs, cell_faces> pairs;
  std::array<bool, cell_edges> crossed{};
  for (int face = 0; face < cell_faces; ++face) {
    Pairs& p = pairs[std::size_t(face)] = pairs_of(signs, face, (parts_air >> face & 1) != 0);
    for (int i = 0; i < p.count; ++i) {
      const auto [a, b] = p.pair[std::size_t(i)];
      joined.join(a, b);
      crossed[std::size_t(a)] = crossed[std::size_t(b)] = true;
    }
  }
  Sheets sheets{};
  sheets.of_edge.fill(no_sheet);
  for (int e = 0; e < cell_edges; ++e) {
    if (!crossed[std::size_t(e)]) continue;
    const int root = joined.root(e);
    sheets.of_edge[std::size_t(e)] = root == e ? sheets.count++ : sheets.of_edge[std::size_t(root)];
  }
  for (int face = 0; face < cell_faces; ++face) {
    const Pairs& p = pairs[std::size_t(face)];
    if (p.count == 2 && joined.root(p.pair[0][0]) == joined.root(p.pair[1][0])) sheets.doubled |= std::uint8_t(1 << face);
  }
  return sheets;
}

const Sheets& plain_sheets(unsigned signs) {
  static const std::array<Sheets, 256> all = all_plain();
  return all[signs];
}

}  // namespace kadr
