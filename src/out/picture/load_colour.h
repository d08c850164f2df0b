#pragma once
// Shows the removal rate as colour, from blue to red, and marks lines: the heaviest and those with collisions. Used by
// out/picture/part_page.

#include <cstdint>
#include <string>
#include <vector>

#include "config/alarm_texts.h"
#include "out/picture/canvas.h"

namespace kadr {

/// Removal rate of each sweep of the stock, mm³/s; 0 or missing: not known.
using SweepRates = std::vector<float>;

/// Returns the greatest rate of the sweeps that have made the surface; material that was removed above it is no longer visible.
///   made_by  the sweep of each point, as Surface::made_by
double greatest_rate(const std::vector<std::int32_t>& made_by, const SweepRates& rates);

/// Returns the colour, 0xRRGGBB, of a surface that this sweep has made.
std::uint32_t load_colour(std::int32_t sweep, const SweepRates& rates, double greatest);

/// Draws the scale from left to right, with its numbers.
void draw_load_key(Canvas& canvas, const Area& area, double greatest, Lang lang);

/// A number in a circle.
struct LoadMark {
  Vec2 at;
  std::string text;
  std::uint32_t rgb = 0x20262E;
};
/// Draws the marks in order; a mark that would cover one drawn before is left out.
void draw_load_marks(Canvas& canvas, const std::vector<LoadMark>& marks);

}  // namespace kadr
