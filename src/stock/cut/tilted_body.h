#pragma once
// TiltedBody: a convex body of a tool in single precision, with the numbers that intersect lattice lines with a tilted tool.

#include "stock/cut/swept_body.h"

namespace kadr {

/// A cylinder, or a cone without its apex, about the tool's axis, in mm. The radius is `low_radius` at the height `low`, and `high_radius`
/// at the height `high`.
struct Frustum {
  float low = 0, high = 0;
  float low_radius = 0, high_radius = 0;
};

/// A convex body of a tilted tool. `kind` decides of which of the members `end`, `shaft`, `flat`, `corner` and `middle` the body consists.
struct TiltedBody {
  enum class Kind : std::uint8_t {
    cylinder,  // the cylinder `shaft`
    cone,      // the cone `end`, and the cylinder `shaft` above the cone if the height of the cylinder is not 0
    // A whole ball of radius `corner`, whose centre is on the tool's axis at the height `middle`; and the cylinder `shaft` above the
    // centre.
    ball,
    // Bull nose: all points at most `corner` mm away from a cylinder of radius `flat` that begins at the height `middle`, below shaft.high.
    rounded,
  };
  Kind kind = Kind::cylinder;
  Frustum end, shaft;
  float flat = 0, corner = 0, middle = 0;
  float error_at_position = 0;  // accepted error of a position on the path, mm; the same number as SweptBody::error_at_position

  float low() const { return kind == Kind::cylinder ? shaft.low : kind == Kind::cone ? end.low : middle - corner; }
  float high() const { return kind == Kind::cone && shaft.high <= shaft.low ? end.high : shaft.high; }
  float widest() const { return std::max(shaft.low_radius, std::max(end.low_radius, end.high_radius)); }
  /// Returns a body that is at least `by` mm larger on all sides.
  TiltedBody larger(float by) const;
};

TiltedBody tilted_body(const ConvexBody& body);

}  // namespace kadr
