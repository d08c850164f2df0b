#pragma once
// What is left, held against the part that was wanted: what was left on it, what was cut into it, where and by which sweep.

#include <cstdint>
#include <vector>

#include "stock/mesh/mesh.h"
#include "stock/stock.h"
#include "stock/surface/surface.h"

namespace kadr {

struct PartOffence {
  double volume = 0;              // mm³
  double deepest = 0;             // mm from the part's surface
  Vec3 at;                        // there
  std::int32_t sweep = of_blank;  // that cut last next to it
};

struct PartComparison {
  PartOffence left_on;           // material outside the part
  PartOffence gouged;            // of the part, and no longer there, or never was: the blank is too small
  std::vector<float> deviation;  // of each point of the surface, mm: above 0 outside the part, below 0 in it
};

/// Volumes: the material's intervals on lattice lines and those of the part, exactly, in each brick by the direction that meets most
/// of the difference. Of a part that reaches beyond the blank by more than the blank's longest side only what is nearer counts.
///   part    a solid, not empty, in the work system of the blank
///   law     the same bits for any number of threads
///   memory  4 bytes a point of the surface, 150 bytes a triangle of the part
PartComparison compare(const Stock& stock, const Surface& surface, const Mesh& part);

}  // namespace kadr
