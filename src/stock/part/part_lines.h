#pragma once
// PartLines: the segments of a lattice's lines that lie inside a solid. Used by stock/part/part_compare.
//
// Each triangle in turn finds the lines that cross it. The opposite, where each line looks up its triangles (stock/mesh/mesh_index),
// takes several times as long when nearly all lines of a lattice are needed.

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
  /// `window` limits the segments to a box; nullopt: no limit.
  ///   law  the segments equal those of mesh_blank(solid), or of its blank_within(), to the bit   (tests/stock/part_lines_test)
  PartLines(const Mesh& solid, const Lattice& lattice, const std::optional<Box3>& window, int threads);

  /// Returns the segments of a line in a brick, numbered as in stock/brick/brick; ascending, over the whole line through the lattice.
  std::span<const LineRange> of(BrickPlace brick, int family, int line) const;

  /// Upper bound of the memory during construction.
  static double bytes(const Mesh& solid, const Lattice& lattice);

 private:
  struct Hit {
    double place;
    std::uint32_t line, triangle;
    int turn;
  };
  struct Family {
    std::vector<std::size_t> first;  // index into ranges where each line begins; one more at the end
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
