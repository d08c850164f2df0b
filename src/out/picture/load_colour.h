#pragma once
// Removal rate as colour, from blue to red, and marks of lines: the heaviest, those of collisions. For out/picture/part_page.

#include <cstdint>
#include <string>
#include <vector>

#include "config/alarm_texts.h"
#include "out/picture/canvas.h"

namespace kadr {

/// By sweep of the stock, mm³/s; 0 or missing: none is told.
using SweepRates = std::vector<float>;

/// The greatest rate of those that have made the surface: what was taken away over it is not to be seen.
///   made_by  of its points, as Surface::made_by
double greatest_rate(const std::vector<std::int32_t>& made_by, const SweepRates& rates);

/// 0xRRGGBB of what a sweep has made.
std::uint32_t load_colour(std::int32_t sweep, const SweepRates& rates, double greatest);

/// The scale from left to right, with its numbers.
void draw_load_key(Canvas& canvas, const Area& area, double greatest, Lang lang);

/// A number in a circle.
struct LoadMark {
  Vec2 at;
  std::string text;
  std::uint32_t rgb = 0x20262E;
};
/// In order; one that would cover another drawn before is left out.
void draw_load_marks(Canvas& canvas, const std::vector<LoadMark>& marks);

}  // namespace kadr
