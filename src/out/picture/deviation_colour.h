#pragma once
// Deviation from the part that is wanted, as colour: blue where material is left on, red where it is gouged, grey between. For
// out/picture/part_page.

#include <cstdint>
#include <vector>

#include "config/alarm_texts.h"
#include "out/picture/canvas.h"

namespace kadr {

/// mm.
struct DeviationScale {
  double within = 0, most = 0;  // up to here grey; from here the full colour
};

/// Both ways as far as the greatest deviation of the points.
DeviationScale deviation_scale(const std::vector<float>& of_point, double within);

/// 0xRRGGBB.
std::uint32_t deviation_colour(double deviation, const DeviationScale& scale);
std::uint32_t mixed_colour(std::uint32_t a, std::uint32_t b, double share);

/// The scale from left to right, with its numbers.
void draw_deviation_key(Canvas& canvas, const Area& area, const DeviationScale& scale, Lang lang);

}  // namespace kadr
