#pragma once
// Shows the deviation from the target part as a colour: blue where material remains, red where the tool has cut into the part, grey in
// between. This file is used by out/picture/part_page.

#include <cstdint>
#include <vector>

#include "config/alarm_texts.h"
#include "out/picture/canvas.h"

namespace kadr {

/// The limits of the colour scale for deviations, mm.
struct DeviationScale {
  double within = 0, most = 0;  // mm: up to the deviation `within` the colour is grey; from the deviation `most` on it is fully blue or red
};

/// Returns a colour scale that extends, in both directions, to the greatest deviation of all points.
///   of_point  deviation of each point, mm
///   within    greatest deviation that is shown in grey, mm
DeviationScale deviation_scale(const std::vector<float>& of_point, double within);

/// Returns the colour of a deviation (mm) as 0xRRGGBB.
std::uint32_t deviation_colour(double deviation, const DeviationScale& scale);
std::uint32_t mixed_colour(std::uint32_t a, std::uint32_t b, double share);

/// Draws the colour scale from left to right, with its numbers.
void draw_deviation_key(Canvas& canvas, const Area& area, const DeviationScale& scale, Lang lang);

}  // namespace kadr
