#pragma once
// What is left, held against the part that was wanted: what was left on it, what was cut into it, where and by which sweep.

#include <cstdint>
#include <vector>

#include "stock/blank/blank_window.h"
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
///   part    a solid, not empty, in the work system of the blank; of a window: one whose box meets it
///   law     the same bits for any number of threads
///   faces   of a stock that is a window (blank_within()): only what of the part lies in it counts, and points on its faces have no
///           deviation; nullptr: it is the whole
///   memory  4 bytes a point of the surface, 25 more while points are looked for inside it, and bytes_of_comparison()
PartComparison compare(const Stock& stock, const Surface& surface, const Mesh& part, const WindowFaces* faces = nullptr);

/// For a stock of that box, all but the stock itself and its surface; the part's own triangles are among them.
enum class HeldPart : std::uint8_t { whole, window };
double bytes_of_comparison(const Box3& stock, double cell, const Mesh& part, HeldPart held);

}  // namespace kadr
