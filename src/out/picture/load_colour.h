#pragma once
// Shows the removal rate (mm³/s) as a colour from blue to red. Also numbers the program lines with the heaviest load, and those with
// collisions. This file is used by out/picture/part_page.

#include <cstdint>
#include <string>
#include <vector>

#include "config/alarm_texts.h"
#include "out/picture/canvas.h"

namespace kadr {

/// Removal rate, mm³/s, of each sweep (straight movement of the tool through the stock), by number of the sweep. The rate of a sweep is
/// unknown if its element is 0 or if the vector ends before it.
using SweepRates = std::vector<float>;

/// Returns the greatest removal rate, mm³/s, of the sweeps whose cut is still visible on the surface.
///   made_by  for each point of the surface, the index of the sweep that cut it, as Surface::made_by
double greatest_rate(const std::vector<std::int32_t>& made_by, const SweepRates& rates);

/// Returns the colour, 0xRRGGBB, of a surface that the sweep has cut.
std::uint32_t load_colour(std::int32_t sweep, const SweepRates& rates, double greatest);

/// Draws the colour scale from left to right, with its numbers.
void draw_load_key(Canvas& canvas, const Area& area, double greatest, Lang lang);

/// A number in a circle at a point of the page.
struct LoadMark {
  Vec2 at;
  std::string text;
  std::uint32_t rgb = 0x20262E;
};
/// Draws the marks in order. A mark that would cover an earlier mark is omitted.
void draw_load_marks(Canvas& canvas, const std::vector<LoadMark>& marks);

}  // namespace kadr
