// Converts a convex body of a tilted tool to a TiltedBody: cylinders, cones and rounded ends in single precision, for which the
// intersection with lattice lines has fast formulas. Used by stock/stock.

#include "stock/cut/tilted_body.h"

#include <cmath>

namespace kadr {
namespace {

// Accepted error in mm of the swept interval, as far as an inaccurate position on the path causes the error.
constexpr double tilted_position_error = 4e-5;

Frustum larger_frustum(Frustum f, float by) {
  const float tall = f.high - f.low, widens = tall > 0 ? (f.high_radius - f.low_radius) / tall : 0.f;
  // Horizontal distance in mm that moves the side of a cone outwards by `by` mm, measured at a right angle to the side.
  const float wider = by * std::sqrt(1 + widens * widens);
  return {f.low - by, f.high + by, std::max(f.low_radius - by * widens, 0.f) + wider, std::max(f.high_radius + by * widens, 0.f) + wider};
}

}  // namespace

TiltedBody TiltedBody::larger(float by) const {
  TiltedBody body = *this;
  if (kind == Kind::cone) body.end = larger_frustum(end, by);
  if (shaft.high > shaft.low) body.shaft = larger_frustum(shaft, by);
  body.corner += corner > 0 ? by : 0.f;
  return body;
}

TiltedBody tilted_body(const ConvexBody& convex) {
  using Form = RoundSolid::Form;
  const RoundSolid& first = convex.solids.front();
  TiltedBody body;
  const auto frustum = [](const RoundSolid& s) {
    return Frustum{float(s.bottom), float(s.top), float(s.form == Form::cylinder ? s.top_radius : s.bottom_radius), float(s.top_radius)};
  };
  body.shaft = convex.solids.size() > 1 ? frustum(convex.solids[1]) : Frustum{float(first.top), float(first.top), 0, 0};
  if (first.form == Form::cylinder) {
    body.shaft = frustum(first);
    return body;
  }
  if (first.form == Form::cone) {
    body.kind = TiltedBody::Kind::cone;
    body.end = frustum(first);
    return body;
  }
  body.flat = float(first.form == Form::ball ? 0 : first.bottom_radius);
  body.middle = float(first.top), body.corner = float(first.top - first.bottom);
  body.shaft.low_radius = body.shaft.high_radius = float(first.top_radius);
  const bool holds_all = convex.top() - first.top >= first.top_radius;
  body.kind = body.flat == 0 && holds_all ? TiltedBody::Kind::ball : TiltedBody::Kind::rounded;
  body.error_at_position = float(std::sqrt(2 * tilted_position_error * double(body.corner)));
  return body;
}

}  // namespace kadr
