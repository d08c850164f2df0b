#pragma once
// PartLines: the stretches of a lattice's lines that lie inside a solid. For stock/part/part_compare.
//
// Triangle by triangle: each tells the lines that go through it. That each line asks for its triangles (stock/mesh/mesh_index) takes
// several times as long where nearly all lines of a lattice are wanted.

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "stock/blank/blank.h"
#include "stock/mesh/mesh.h"

namespace kadr {

class PartLines {
 public:
  /// `window`: only what lies in it counts; nothing: all.
  ///   law  the stretches are those of mesh_blank(solid), of blank_within() it, to the bit   (tests/stock/part_lines_test)
  PartLines(const Mesh& solid, const Lattice& lattice, const std::optional<Box3>& window, int threads);

  /// Of a line in a brick, numbered as there (stock/brick/brick); ascending, from the lattice's corner to its far side.
  std::span<const LineRange> of(BrickPlace brick, int family, int line) const;

  /// At most, while it is made.
  static double bytes(const Mesh& solid, const Lattice& lattice);

 private:
  struct Hit {
    double place;
    std::uint32_t line, triangle;
    int turn;
  };
  struct Family {
    std::vector<std::size_t> first;  // of each line, into ranges; one more at the end
    std::vector<LineRange> ranges;
  };
  void find(const Mesh& solid, int family, std::size_t first, std::size_t last, std::vector<Hit>& hits) const;
  void order(int family, const std::span<std::vector<Hit>>& found, const std::optional<Box3>& window);
  std::size_t first_from(int axis, double place) const;

  double cell_;
  std::array<std::vector<double>, 3> places_;  // of lattice points along each axis
  std::array<Family, 3> families_;
};

}  // namespace kadr
