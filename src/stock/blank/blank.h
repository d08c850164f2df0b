#pragma once
// Blank: the material before the first cut. Lengths are in mm, in the work coordinates of the blank.

#include <memory>
#include <vector>

#include "stock/brick/lattice.h"

namespace kadr {

/// An interval of a lattice line that is inside the material.
struct LineRange {
  double from, to;
};

struct Mesh;

class Blank {
 public:
  virtual ~Blank() = default;
  /// Returns the box around the whole blank.
  virtual Box3 box() const = 0;
  /// Appends to `ranges`, in ascending order, the intervals in which a line along the axis `family` is inside the blank. u, v: positions
  /// of the line along the axes (family + 1) % 3 and (family + 2) % 3.
  virtual void cross(int family, double u, double v, std::vector<LineRange>& ranges) const = 0;
  /// Returns the outward normal at a point of the blank's surface. At this point a line along the axis `family` leaves the blank if `out`
  /// is true, else the line enters the blank.
  virtual Vec3 normal(Vec3 at, int family, bool out) const = 0;
  virtual double volume() const = 0;
  /// Returns the volume in mm³ inside a box. This default adds up intervals of lattice lines, with a relative error of about 1e-5; a blank
  /// whose volume has an exact formula overrides it.
  virtual double volume_within(const Box3& box) const;
  /// Returns true if solid bodies of the blank overlap; the blank is then the union of these bodies.
  virtual bool overlaps() const { return false; }
  /// Returns the memory of the blank in bytes; 0 if the blank needs almost no memory.
  virtual std::size_t bytes() const { return 0; }
  /// Returns for each brick of the lattice whether the blank's surface may cross it; an empty vector means that it may cross any brick.
  /// For a brick that the surface does not cross, one line through the brick shows whether the brick is full or empty.
  virtual std::vector<bool> bricks_at_surface(const Lattice&) const { return {}; }
  /// Returns the mesh that defines the blank; nullptr if the blank is not a mesh.
  virtual const Mesh* mesh() const { return nullptr; }
};

std::shared_ptr<const Blank> box_blank(const Box3& box);
/// Returns a cylinder with its axis parallel to Z.
std::shared_ptr<const Blank> cylinder_blank(Vec2 centre, double bottom, double top, double diameter);

}  // namespace kadr
