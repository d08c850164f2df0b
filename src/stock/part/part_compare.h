#pragma once
// Compares the remaining material with the wanted part: finds the material that was left on and the material that was gouged, their
// positions, and the sweeps that caused them.

#include <cstdint>
#include <optional>
#include <vector>

#include "stock/blank/blank_window.h"
#include "stock/mesh/mesh.h"
#include "stock/stock.h"
#include "stock/surface/surface.h"

namespace kadr {

struct PartOffence {
  double volume = 0;              // volume of the difference, mm³
  double deepest = 0;             // greatest distance of the difference from the surface of the wanted part, mm
  Vec3 at;                        // position of this greatest distance, mm
  std::int32_t sweep = of_blank;  // number of the sweep that last cut next to `at`; of_blank if no sweep did
  // Decides between equal depths of several portions: the place with the least number is the deepest. Only of a portion.
  std::uint64_t order = ~std::uint64_t{0};

  /// Takes the deepest place of another portion, if that is deeper.
  void take(const PartOffence& other);
};

/// The volumes of the differences in one brick, mm³.
struct BrickVolumes {
  std::uint64_t number;  // number of the brick, in the order in which volumes are added
  float left_on, gouged;
};

struct PartComparison {
  PartOffence left_on;  // material that was left outside the wanted part
  PartOffence gouged;   // regions of the wanted part without material: cut away, or missing because the blank is too small
  // Deviation of each point of the material's surface from the wanted part in mm: positive outside the wanted part, negative inside.
  std::vector<float> deviation;
  // Only of a portion: the volumes of its own bricks, in their order. The portions' volumes are added brick by brick (join_comparisons()).
  std::vector<BrickVolumes> bricks;
};

/// Returns the comparison of the whole stock, without deviations, from those of all its portions.
///   law  the result is that of the whole stock, bit for bit   (tests/stock/portion_test)
PartComparison join_comparisons(std::vector<PartComparison> portions);

/// Compares the stock with the wanted part. Volumes are exact on the lattice lines: in each brick the intervals of the material and
/// those of the part are compared along the direction whose lines contain most of the difference. If the part extends beyond the blank
/// by more than the blank's longest side, the region farther out is ignored.
///   part    a closed mesh, not empty, in the work coordinates of the blank; for a window, its box must meet the window
///   law     the result is the same, bit for bit, for any number of threads
///   faces   for a stock that is a window (blank_within()), the window's faces: only the wanted part inside the window counts, and
///           points on the faces get no deviation; nullptr for a whole stock
///   memory  4 bytes per point of the surface, 25 more per point while the points are classified as inside or outside, and
///           bytes_of_comparison()
PartComparison compare(const Stock& stock, const Surface& surface, const Mesh& part, const WindowFaces* faces = nullptr);

/// Returns the memory in bytes that a comparison with a stock of this box needs. The result includes the triangles of the wanted part, but
/// neither the stock nor its surface.
enum class ComparedPart : std::uint8_t { whole, window };
double bytes_of_comparison(const Box3& stock, double cell, const Mesh& part, ComparedPart held,
                           const std::optional<BrickBox>& portion = std::nullopt);

}  // namespace kadr
