// Converts a convex body of an upright tool (ConvexBody) into the form SweptBody. A SweptBody consists of one flat, ball, conical or torus
// end and one cylinder, with dimensions in single precision, so that fast formulas give its intersections with lattice lines. Used by
// stock/stock.

#include "stock/cut/swept_body.h"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace kadr {
namespace {

/// Accepted error in mm of the point where the tool leaves a lattice line. This error decides how accurately the position on the path, at
/// which the tool reaches farthest, must be found.
constexpr double error_by_position = 4e-4;

BodyEnd end_of(RoundSolid::Form form) {
  switch (form) {
    case RoundSolid::Form::ball: return BodyEnd::ball;
    case RoundSolid::Form::cone: return BodyEnd::cone;
    case RoundSolid::Form::torus: return BodyEnd::torus;
    case RoundSolid::Form::cylinder: break;
  }
  return BodyEnd::flat;
}

}  // namespace

SweptBody swept_body(const ConvexBody& convex) {
  assert(convex.solids.size() == 1 || (convex.solids.size() == 2 && convex.solids[1].form == RoundSolid::Form::cylinder));
  RoundSolid end = convex.solids.front();
  double top = convex.solids.back().top;
  SweptBody body;
  body.end = end_of(end.form);
  body.turned = body.end == BodyEnd::cone && end.bottom_radius > end.top_radius;
  if (body.turned) {
    end = {end.form, -end.top, -end.bottom, end.top_radius, end.bottom_radius};
    top = end.top;
  }
  body.bottom = float(end.bottom), body.top = float(top);
  body.end_top = body.end == BodyEnd::flat ? body.bottom : float(end.top);
  body.flat = float(body.end == BodyEnd::ball ? 0 : end.bottom_radius), body.radius = float(end.top_radius);
  body.corner = float(end.top - end.bottom);
  if (body.end == BodyEnd::cone) {
    body.widens = float((end.top_radius - end.bottom_radius) / (end.top - end.bottom));
    body.stands = float((end.top - end.bottom) / (end.top_radius - end.bottom_radius));
  }
  // If the position on the path has an error of e mm, the point where a ball or torus leaves a lattice line has an error of e² / (2
  // corner). At the apex of a cone this point has an error of up to e.
  body.error_at_position = float(body.end == BodyEnd::cone ? 3e-4 : std::sqrt(2 * error_by_position * double(body.corner)));
  return body;
}

}  // namespace kadr
