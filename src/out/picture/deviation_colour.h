#pragma once
// Shows the deviation from the target part as colour: blue where material remains, red where the part is gouged, grey in between. Used by
// out/picture/part_page.

#include <cstdint>
#include <vector>

#include "config/alarm_texts.h"
#include "out/picture/canvas.h"

namespace kadr {

/// Limits of the scale, mm.
struct DeviationScale {
  double within = 0, most = 0;  // grey up to here; the full colour from here
};

/// Returns a scale that reaches the greatest deviation of the points in both directions.
DeviationScale deviation_scale(const std::vector<float>& of_point, double within);

/// Returns 0xRRGGBB.
std::uint32_t deviation_colour(double deviation, const DeviationScale& scale);
std::uint32_t mixed_colour(std::uint32_t a, std::uint32_t b, double share);

/// Draws the scale from left to right, with its numbers.
void draw_deviation_key(Canvas& canvas, const Area& area, const DeviationScale& scale, Lang lang);

}  // namespace kadr
