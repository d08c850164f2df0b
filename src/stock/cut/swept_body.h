#pragma once
// SweptBody: a convex body of an upright tool in single precision: an end that becomes wider upwards, and a cylinder above it.

#include "stock/cut/local_sweep.h"
#include "stock/tool/round_solid.h"

namespace kadr {

enum class BodyEnd : std::uint8_t { flat, ball, cone, torus };

/// Heights in mm above the tip. A body that becomes narrower upwards is stored upside down, with heights below the tip.
struct SweptBody {
  BodyEnd end = BodyEnd::flat;
  bool turned = false;
  float bottom = 0, end_top = 0, top = 0;  // bottom and top of the end; top of the cylinder
  float flat = 0, radius = 0;              // radius of the flat at the bottom; radius of the cylinder
  float corner = 0;                        // radius of the rounding of a ball or torus
  float widens = 0, stands = 0;            // for a cone: radius per mm of height; height per mm of radius
  float error_at_position = 0;             // mm, accepted error of a position on the path (sweep_search.h)

  float tall() const { return end_top - bottom; }  // height of the end
};

/// Converts a body that consists of an end and at most one cylinder of the same width above it, as shape_of() builds them.
SweptBody swept_body(const ConvexBody& body);

inline AroundTip around_tip(const ConvexBody& body) { return {body.widest(), -body.bottom(), body.top()}; }

}  // namespace kadr
