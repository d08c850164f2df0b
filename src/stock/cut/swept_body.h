#pragma once
// SweptBody: a convex body of an upright tool in single precision. It consists of an end that becomes wider upwards, and a cylinder above
// this end.

#include "stock/cut/local_sweep.h"
#include "stock/tool/round_solid.h"

namespace kadr {

enum class BodyEnd : std::uint8_t { flat, ball, cone, torus };

/// A convex body of an upright tool. Heights are in mm above the tip. A body that becomes narrower upwards is stored upside down, with
/// heights below the tip.
struct SweptBody {
  BodyEnd end = BodyEnd::flat;
  bool turned = false;
  float bottom = 0, end_top = 0, top = 0;  // heights in mm: bottom of the end, top of the end, top of the cylinder
  float flat = 0, radius = 0;              // radii in mm: of the flat face at the bottom, and of the cylinder
  float corner = 0;                        // radius of the rounding of a ball or torus, mm
  float widens = 0, stands = 0;            // for a cone: change of the radius in mm per mm of height; height in mm per mm of radius
  float error_at_position = 0;             // accepted error of a position on the path, mm (sweep_search.h)

  float tall() const { return end_top - bottom; }  // height of the end in mm
};

/// Converts a body that consists of an end and at most one cylinder of the same width above this end. shape_of() builds only such bodies.
SweptBody swept_body(const ConvexBody& body);

inline AroundTip around_tip(const ConvexBody& body) { return {body.widest(), -body.bottom(), body.top()}; }

}  // namespace kadr
