#pragma once
// LeanBody: a convex body of the tool as rows of a tool that leans need it, in single precision.

#include "stock/cut/swept_body.h"

namespace kadr {

/// From `low_radius` at the height `low` to `high_radius` at `high`: a cylinder or a cone without its point.
struct Frustum {
  float low = 0, high = 0;
  float low_radius = 0, high_radius = 0;
};

/// A body is the union of what its kind says.
struct LeanBody {
  enum class Kind : std::uint8_t {
    cylinder,  // `shaft`
    cone,      // `end` and, if it is higher than nothing, `shaft`
    ball,      // a whole ball of the radius `corner`, its middle at `middle`, and `shaft` above that
    rounded,   // all within `corner` of a shaft of the radius `flat` that begins at `middle`, up to shaft.high
  };
  Kind kind = Kind::cylinder;
  Frustum end, shaft;
  float flat = 0, corner = 0, middle = 0;
  float place_error = 0;  // as of SweptBody

  float low() const { return kind == Kind::cylinder ? shaft.low : kind == Kind::cone ? end.low : middle - corner; }
  float high() const { return kind == Kind::cone && shaft.high <= shaft.low ? end.high : shaft.high; }
  float widest() const { return std::max(shaft.low_radius, std::max(end.low_radius, end.high_radius)); }
  /// Larger all around, at least by so much.
  LeanBody larger(float by) const;
};

LeanBody lean_body(const ConvexBody& body);

}  // namespace kadr
