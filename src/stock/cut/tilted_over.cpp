// Finds lattice lines that nearly lie in the surface of a tilted tool, so that the turning tool may sweep two separate intervals of them.
// Used by stock/cut/tilted_cut; tested by tests/stock/tilted_graze_test.

#include "stock/cut/tilted_over.h"

#include <algorithm>
#include <cmath>

#include "stock/cut/tilted_division.h"

namespace kadr {
namespace {

/// Returns true if a lattice line may touch the side of the frustum at a point where the side, measured along the line, has a curvature of
/// less than `bent` (1/mm). `least` and `most` are the limits of the cosine of the angle between the line and the tool's axis.
bool is_flat_along(const Frustum& f, float least, float most, float bent) {
  if (!(f.high > f.low)) return false;
  const float tall = f.high - f.low, wide = f.high_radius - f.low_radius, cosine = tall / std::sqrt(tall * tall + wide * wide);
  if (least > cosine) return false;  // the angle between the line and the axis is too small: the line cannot touch the side
  const float along = std::min(most / cosine, 1.f);
  return (1 - along * along) * cosine < bent * std::max(f.low_radius, f.high_radius);
}

}  // namespace

TiltedOver::TiltedOver(const TiltedSweep& s, const TiltedBody& body, float edge) {
  const float turn = 2 * s.half_turn;
  if (turn * edge <= 2 * over_allowed) return;
  apart = 4 * over_allowed / turn;
  const bool faces = has_flat_face(s, body);
  const float bent = turn * turn / (8 * over_allowed);
  // The corner radius is flat enough for a line to lie in its surface only below the height edge_below. This height follows from the sine
  // of the angle along the corner radius, measured from the lower face; 0.01 mm is a margin for the error of an interval's end.
  const float sine = std::min(bent * (body.flat + body.corner), 1.f);
  edge_below = body.low() + body.corner * (1 - std::sqrt(1 - sine * sine)) + 0.01f;
  for (int d = 0; d < 3; ++d) {
    const float cosine = std::fabs(s.axes[d][2]), least = std::max(cosine - s.half_turn, 0.f), most = std::min(cosine + s.half_turn, 1.f);
    family[d].by_end = body.kind == TiltedBody::Kind::cone && is_flat_along(body.end, least, most, bent);
    family[d].by_shaft = is_flat_along(body.shaft, least, most, bent);
    // Where a line touches the corner radius, the surface is at least as steep as the line. The curvature of the surface at this point is
    // its slope divided by the distance of the point from the axis.
    family[d].by_edge = body.kind == TiltedBody::Kind::rounded && body.flat > 0 && least < bent * (body.flat + body.corner);
    family[d].by_face = faces && least < turn;
  }
}

}  // namespace kadr
