#pragma once
// Blank: the material before the first cut, in the work system, mm.

#include <memory>
#include <vector>

#include "stock/brick/lattice.h"

namespace kadr {

/// A segment of a lattice line within the material.
struct LineRange {
  double from, to;
};

struct Mesh;

class Blank {
 public:
  virtual ~Blank() = default;
  /// The box around the whole blank.
  virtual Box3 box() const = 0;
  /// Appends the segments of a line along the axis `family` that lie within the blank to `ranges`, in ascending order. u, v:
  /// positions of the line along the axes (family + 1) % 3 and (family + 2) % 3.
  virtual void cross(int family, double u, double v, std::vector<LineRange>& ranges) const = 0;
  /// Returns the outward normal at a point of the surface where a line along the axis leaves the blank (`out`) or enters it.
  virtual Vec3 normal(Vec3 at, int family, bool out) const = 0;
  virtual double volume() const = 0;
  /// Returns the volume in mm³ inside a box. Bodies without a better method sum it over lines, to some hundred-thousandths.
  virtual double volume_within(const Box3& box) const;
  /// True if bodies of the blank overlap; the blank is then their union.
  virtual bool overlaps() const { return false; }
  /// Memory in bytes; 0 if it is small.
  virtual std::size_t bytes() const { return 0; }
  /// Returns for each brick whether the surface may cross it; empty if it may cross any. Whether another brick is full is decided by
  /// one line through it.
  virtual std::vector<bool> bricks_at_surface(const Lattice&) const { return {}; }
  /// Returns the mesh that defines the blank; nullptr if there is none.
  virtual const Mesh* mesh() const { return nullptr; }
};

std::shared_ptr<const Blank> box_blank(const Box3& box);
/// A cylinder with its axis along Z.
std::shared_ptr<const Blank> cylinder_blank(Vec2 centre, double bottom, double top, double diameter);

}  // namespace kadr
