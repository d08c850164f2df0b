#pragma once
// Compares the remaining material with the wanted part: what was left on, what was cut into the part, where and by which sweep.

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
  Vec3 at;                        // position of the deepest point
  std::int32_t sweep = of_blank;  // that last cut next to it
};

struct PartComparison {
  PartOffence left_on;           // material outside the part
  PartOffence gouged;            // parts of the wanted part that are missing; cut away, or never there because the blank is too small
  std::vector<float> deviation;  // of each point of the surface, mm: positive outside the part, negative inside
};

/// Compares the stock with the part. Volumes are exact on the lattice lines: the intervals of the material and those of the part are
/// compared, in each brick along the direction that meets most of the difference. If the part extends beyond the blank by more than
/// the blank's longest side, what lies farther out is ignored.
///   part    a solid, not empty, in the work system of the blank; for a window, one whose box meets the window
///   law     the same bits for any number of threads
///   faces   of a stock that is a window (blank_within()): only the part inside it counts, and points on its faces have no deviation;
///           nullptr for a whole stock
///   memory  4 bytes per point of the surface, 25 more while points are tested for being inside, and bytes_of_comparison()
PartComparison compare(const Stock& stock, const Surface& surface, const Mesh& part, const WindowFaces* faces = nullptr);

/// Returns the memory for a stock with that box, without the stock itself and its surface, but with the part's own triangles.
enum class HeldPart : std::uint8_t { whole, window };
double bytes_of_comparison(const Box3& stock, double cell, const Mesh& part, HeldPart held);

}  // namespace kadr
