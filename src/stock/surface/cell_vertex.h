#pragma once
// The vertex of a sheet of a lattice cell: where the tangent planes of its crossings meet. For stock/surface.

#include "stock/surface/crossings.h"

namespace kadr {

class CellVertex {
 public:
  void add(const Crossing& crossing);
  /// The last sweep among the crossings.
  std::int32_t made_by() const { return made_by_; }
  /// The place nearest to all planes, kept within the cell at `low`; where they do not fix it, near the middle of the crossings.
  ///   In a hollow that turns little the surface is the rounding of a tool, between the middle of the crossings, which is on a chord, and
  ///   the place where the tangents meet. Ridges are sharp: two sweeps leave them where they meet.
  std::array<double, 3> place(const std::array<double, 3>& low, double cell) const;

 private:
  double square_[6] = {};   // of the normals: sum of n nᵀ, its upper half by rows
  double right_[3] = {};    // sum of n (n · at)
  double sum_[3] = {};      // of the places
  double normals_[3] = {};  // their sum
  int count_ = 0;
  std::int32_t made_by_ = of_blank;
};

}  // namespace kadr
