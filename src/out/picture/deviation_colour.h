#pragma once
// Shows the deviation from the target part as colour: blue where material remains, red where the part is gouged, grey in between. Used by
// out/picture/part_page.

#include <cstdint>
#include <vector>

#include "config/alarm_texts.h"
#include "out/picture/canvas.h"

namespace kadr {

/// The limits of the colour scale for deviations, mm.
struct DeviationScale {
  double within = 0, most = 0;  // the colour is grey up to a deviation of `within`, and full from `most` on
};

/// Returns a colour scale that ends on both sides at the greatest deviation among the points, outwards or inwards.
///   of_point  deviation of each point, mm
///   within    mm; smaller deviations are grey
DeviationScale deviation_scale(const std::vector<float>& of_point, double within);

/// Returns the colour of a deviation, 0xRRGGBB.
std::uint32_t deviation_colour(double deviation, const DeviationScale& scale);
std::uint32_t mixed_colour(std::uint32_t a, std::uint32_t b, double share);

/// Draws the colour scale from left to right, labelled with numbers.
void draw_deviation_key(Canvas& canvas, const Area& area, const DeviationScale& scale, Lang lang);

}  // namespace kadr
