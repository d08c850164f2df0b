#pragma once
// The vertex of a sheet in a lattice cell, where the tangent planes of its crossings meet. Used by stock/surface.

#include "stock/surface/crossings.h"

namespace kadr {

class CellVertex {
 public:
  void add(const Crossing& crossing);
  /// The last sweep among the crossings.
  std::int32_t made_by() const { return made_by_; }
  /// Returns the point nearest to all planes, kept within the cell at `low`; where the planes leave it undetermined, it is near the
  /// middle of the crossings.
  ///   In a concave region with little change of the normals the surface is the rounding of a tool, between the middle of the
  ///   crossings, which is on a chord, and the point where the tangents meet. Ridges are sharp, as they are where two sweeps meet.
  std::array<double, 3> place(const std::array<double, 3>& low, double cell) const;

 private:
  double square_[6] = {};   // sum of n nᵀ over the normals, upper triangle by rows
  double right_[3] = {};    // sum of n (n · at)
  double sum_[3] = {};      // of the positions
  double normals_[3] = {};  // sum of the normals
  int count_ = 0;
  std::int32_t made_by_ = of_blank;
};

}  // namespace kadr
