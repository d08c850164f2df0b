#pragma once
// TurnedStock: a part that spins while tools cut it, as a region of the half plane through its axis. It is used by
// session/cutting/turned_cutting. Computed with the Clipper library in whole nanometres.
//
//   radius                           Turning about the axis maps the region to the part, so the volume follows from the polygons by
//     ▲   ┌────┐                     Pappus: the area times the way of its centroid. Nothing is counted in cells: a volume is as exact as
//     │ ┌─┘    └───┐                 the chords of the swept areas.
//     └─┴──────────┴──▶ Z
//
// The region is divided into rectangles, halved where they hold many corners. A sweep only concerns the rectangles that it reaches, so the
// time of a cut does not grow with the part.

#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "stock/turned/insert_sweep.h"

namespace kadr {

/// A region of the half plane: x is the radius, at least 0, y is Z, mm. Outer polygons are counter-clockwise, holes clockwise.
using TurnedRegion = std::vector<TurnedPolygon>;

/// Returns the region of a cylinder or tube about the axis. `bore`: its inner diameter; 0: no bore. Lengths in mm.
TurnedRegion cylinder_region(double bottom, double top, double diameter, double bore = 0);

/// Returns the volume of the body of revolution, mm³ (Pappus).
double volume_of(const TurnedRegion& region);

/// What a swept area meets.
struct TurnedTouch {
  double volume = 0;  // volume of the rings that the area has in common with the part, mm³
  Vec2 least, most;   // corners of the box around these rings, mm; equal if the box was not asked for or nothing is met

  /// Returns the shorter side of the box, mm.
  double depth() const;
};

class TurnedStock {
 public:
  /// The polygons of `blank` must be simple and must not overlap. Parts below radius 0 are ignored.
  explicit TurnedStock(TurnedRegion blank);
  TurnedStock(TurnedStock&&) noexcept;
  ~TurnedStock();

  /// Removes a swept area. The part spins, so what lies below radius 0 removes its mirror image above.
  ///   swept     a convex polygon, counter-clockwise
  ///   with_box  the box around the removed rings is computed too
  ///   law       the volumes of all removals and of the rest add up to that of the blank   (tests/stock/turned_stock_test)
  TurnedTouch remove(const TurnedPolygon& swept, bool with_box = false);
  /// Returns what remove() would return, and removes nothing.
  TurnedTouch touch(const TurnedPolygon& swept) const;

  double volume() const;        // mm³
  double blank_volume() const;  // mm³
  /// Returns the remaining region. Corners that deviate from their neighbours' line by less than 10 nm are left out.
  TurnedRegion region() const;
  /// Returns the area of the part's surface, mm²: of the whole surface, and of what tools have cut.
  struct Area {
    double whole = 0, machined = 0;
  };
  Area area() const;
  /// Returns the radii between which there is material at this Z, mm: the least and the greatest; nullopt if there is none.
  std::optional<Vec2> radii_at(double z) const;

 private:
  struct Cell;
  TurnedRegion blank_;
  std::unique_ptr<Cell> root_;
};

}  // namespace kadr
