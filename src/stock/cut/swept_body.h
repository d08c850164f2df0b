#pragma once
// SweptBody: a convex body of the tool as the rows need it, in single precision: an end that widens upwards, then a cylinder.

#include "stock/cut/local_sweep.h"
#include "stock/tool/round_solid.h"

namespace kadr {

enum class BodyEnd : std::uint8_t { flat, ball, cone, torus };

/// Heights mm above the tip; of a body that narrows upwards they are below it: it is taken upside down.
struct SweptBody {
  BodyEnd end = BodyEnd::flat;
  bool turned = false;
  float bottom = 0, end_top = 0, top = 0;  // of the end, of the cylinder
  float flat = 0, radius = 0;              // of the flat at the bottom; of the cylinder
  float corner = 0;                        // radius of the rounding: of ball and torus
  float widens = 0, stands = 0;            // cone: radius for each mm of height, height for each mm of radius
  float place_error = 0;                   // on the way, that is let pass, mm: sweep_search.h

  float tall() const { return end_top - bottom; }  // of the end
};

/// The body has an end and, at most, a cylinder as wide above it, as shape_of() makes them.
SweptBody swept_body(const ConvexBody& body);

inline AroundTip around_tip(const ConvexBody& body) { return {body.widest(), -body.bottom(), body.top()}; }

}  // namespace kadr
