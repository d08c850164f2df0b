#pragma once
// Computes the vertex of a sheet (a connected part of the surface) in a lattice cell. The vertex is where the tangent planes at the sheet's
// crossings with the cell's edges meet. Used by stock/surface.

#include "stock/surface/crossings.h"

namespace kadr {

class CellVertex {
 public:
  void add(const Crossing& crossing);
  /// Returns the number of the last sweep that cut at any of the crossings.
  std::int32_t made_by() const { return made_by_; }
  /// Returns the point nearest to all tangent planes, limited to the cell with the lowest corner `low`. Where the planes do not determine
  /// the point, the result is near the mean of the crossings.
  ///   In a concave region in which the normals change little, the surface has the rounded shape of a tool: it passes between the mean of
  ///   the crossings, which is on a chord, and the point where the tangent planes meet. Ridges, where two sweeps meet, stay sharp.
  std::array<double, 3> place(const std::array<double, 3>& low, double cell) const;

 private:
  double square_[6] = {};   // sum of n nᵀ over the unit normals n, upper triangle by rows
  double right_[3] = {};    // sum of n (n · at) over the normals n and the positions `at` of the crossings
  double sum_[3] = {};      // sum of the positions of the crossings
  double normals_[3] = {};  // sum of the normals of the crossings
  int count_ = 0;
  std::int32_t made_by_ = of_blank;
};

}  // namespace kadr
