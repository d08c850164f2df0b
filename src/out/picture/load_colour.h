#pragma once
// Shows the removal rate (mm³/s) as colour, from blue to red, and numbers the program lines with the heaviest load and with collisions.
// Used by out/picture/part_page.

#include <cstdint>
#include <string>
#include <vector>

#include "config/alarm_texts.h"
#include "out/picture/canvas.h"

namespace kadr {

/// Removal rate of each sweep (one straight movement of the tool through the stock), mm³/s; 0 or a missing element: not known.
using SweepRates = std::vector<float>;

/// Returns the greatest removal rate among the sweeps whose cut is still visible on the surface.
///   made_by  index of the sweep that cut each point, as Surface::made_by
double greatest_rate(const std::vector<std::int32_t>& made_by, const SweepRates& rates);

/// Returns the colour, 0xRRGGBB, of surface that this sweep has cut.
std::uint32_t load_colour(std::int32_t sweep, const SweepRates& rates, double greatest);

/// Draws the colour scale from left to right, labelled with numbers.
void draw_load_key(Canvas& canvas, const Area& area, double greatest, Lang lang);

/// A number in a circle, drawn at a point of the page.
struct LoadMark {
  Vec2 at;
  std::string text;
  std::uint32_t rgb = 0x20262E;
};
/// Draws the marks in order; leaves out a mark that would cover an earlier one.
void draw_load_marks(Canvas& canvas, const std::vector<LoadMark>& marks);

}  // namespace kadr
