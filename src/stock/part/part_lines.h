#pragma once
// PartLines: the segments in which the lines of a lattice are inside a solid. Used by stock/part/part_compare.
//
// PartLines visits the triangles, and finds for each triangle the lines that cross it. The opposite order (stock/mesh/mesh_index) finds for
// each line the triangles that the line crosses. That order takes several times as long if nearly all lines of a lattice are needed.

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
  /// `window` limits the segments to a box; nullopt means no limit.
  ///   law  the segments equal those of mesh_blank(solid), or of its blank_within(), bit for bit   (tests/stock/part_lines_test)
  PartLines(const Mesh& solid, const Lattice& lattice, const std::optional<Box3>& window, int threads);

  /// Returns the segments of the whole lattice line that contains line `line` of a brick, in ascending order. The lines of a brick are
  /// numbered as in stock/brick/brick.
  std::span<const LineRange> of(BrickPlace brick, int family, int line) const;

  /// Returns an upper bound, in bytes, of the memory that the constructor needs.
  static double bytes(const Mesh& solid, const Lattice& lattice);

 private:
  struct Hit {
    double place;
    std::uint32_t line, triangle;
    int turn;
  };
  struct Family {
    std::vector<std::size_t> first;  // index in `ranges` of the first segment of each line; the last element is the number of all segments
    std::vector<LineRange> ranges;
  };
  void find(const Mesh& solid, int family, std::size_t first, std::size_t last, std::vector<Hit>& hits) const;
  void order(int family, const std::span<std::vector<Hit>>& found, const std::optional<Box3>& window);
  std::size_t first_from(int axis, double place) const;

  double cell_;
  std::array<int, 3> first_;                   // place of the lattice's first held brick
  std::array<std::vector<double>, 3> places_;  // coordinates of the lattice points in held bricks along each axis, mm
  std::array<Family, 3> families_;
};

}  // namespace kadr
