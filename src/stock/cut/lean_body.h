#pragma once
// LeanBody: a convex body of the tool, in single precision, as needed for lines and a tilted tool.

#include "stock/cut/swept_body.h"

namespace kadr {

/// From `low_radius` at the height `low` to `high_radius` at `high`: a cylinder, or a cone without its point.
struct Frustum {
  float low = 0, high = 0;
  float low_radius = 0, high_radius = 0;
};

/// The body is the union of the parts that its kind names.
struct LeanBody {
  enum class Kind : std::uint8_t {
    cylinder,  // `shaft`
    cone,      // `end`, and `shaft` if that has a height
    ball,      // a whole ball of radius `corner` about `middle`, and `shaft` above its centre
    rounded,   // everything within `corner` of a shaft of radius `flat` from `middle` up, below shaft.high
  };
  Kind kind = Kind::cylinder;
  Frustum end, shaft;
  float flat = 0, corner = 0, middle = 0;
  float place_error = 0;  // as in SweptBody

  float low() const { return kind == Kind::cylinder ? shaft.low : kind == Kind::cone ? end.low : middle - corner; }
  float high() const { return kind == Kind::cone && shaft.high <= shaft.low ? end.high : shaft.high; }
  float widest() const { return std::max(shaft.low_radius, std::max(end.low_radius, end.high_radius)); }
  /// Returns the body enlarged on all sides by at least this amount.
  LeanBody larger(float by) const;
};

LeanBody lean_body(const ConvexBody& body);

}  // namespace kadr
