#pragma once
// Blank: the material before the first cut, in the work system, mm.

#include <memory>
#include <vector>

#include "stock/brick/lattice.h"

namespace kadr {

/// A stretch of a lattice line within the material.
struct LineRange {
  double from, to;
};

struct Mesh;

class Blank {
 public:
  virtual ~Blank() = default;
  /// Around all of it.
  virtual Box3 box() const = 0;
  /// Where a line along the axis `family` is within it, in ascending order, put into `ranges`. u, v: its places along the axes
  /// (family + 1) % 3 and (family + 2) % 3.
  virtual void cross(int family, double u, double v, std::vector<LineRange>& ranges) const = 0;
  /// Outward, at a place of its surface where a line along the axis leaves it (`out`) or enters it.
  virtual Vec3 normal(Vec3 at, int family, bool out) const = 0;
  virtual double volume() const = 0;
  /// mm³ of it in a box. By lines where a body has no better way: to some hundred thousandths.
  virtual double volume_within(const Box3& box) const;
  /// Bodies of which it is made lie partly within each other: it is their union.
  virtual bool overlaps() const { return false; }
  /// Of memory, where it takes much.
  virtual std::size_t bytes() const { return 0; }
  /// Of each brick: may the surface go through it? Empty: through any. Of the others one line tells whether they are full.
  virtual std::vector<bool> bricks_at_surface(const Lattice&) const { return {}; }
  /// Of which it is made; nullptr: of none.
  virtual const Mesh* mesh() const { return nullptr; }
};

std::shared_ptr<const Blank> box_blank(const Box3& box);
/// Round, its axis along Z.
std::shared_ptr<const Blank> cylinder_blank(Vec2 centre, double bottom, double top, double diameter);

}  // namespace kadr
