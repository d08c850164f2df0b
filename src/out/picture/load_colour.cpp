// Converts removal rates to colours: blue, yellow and red. This file is used by out/picture/part_page and tested by
// tests/out/load_colour_test.cpp.

#include "out/picture/load_colour.h"

#include <algorithm>
#include <cmath>

#include "out/picture/deviation_colour.h"
#include "texts/picture.h"

namespace kadr {
namespace {

constexpr std::uint32_t light_load = 0x2F6FB3, middle_load = 0xF6E08A, heavy_load = 0xB71C1C, no_load = 0x9AA3AF;
constexpr int load_steps = 60;
constexpr double load_key_space = 60;  // width that the word at each end of the colour scale needs, units of the page
constexpr double mark_radius = 11;

float rate_of(std::int32_t sweep, const SweepRates& rates) {
  return sweep >= 0 && std::size_t(sweep) < rates.size() ? rates[std::size_t(sweep)] : 0;
}

std::uint32_t shade_of(double share) {
  return share < 0.5 ? mixed_colour(light_load, middle_load, 2 * share) : mixed_colour(middle_load, heavy_load, 2 * share - 1);
}

}  // namespace

double greatest_rate(const std::vector<std::int32_t>& made_by, const SweepRates& rates) {
  float most = 0;
  for (const std::int32_t sweep : made_by) most = std::max(most, rate_of(sweep, rates));
  return double(most);
}

std::uint32_t load_colour(std::int32_t sweep, const SweepRates& rates, double greatest) {
  const double rate = double(rate_of(sweep, rates));
  return rate > 0 ? shade_of(std::min(rate / greatest, 1.0)) : no_load;
}

void draw_load_key(Canvas& canvas, const Area& area, double greatest, Lang lang) {
  const double left = area.x + load_key_space, width = area.width - 4 * load_key_space, step = width / load_steps;
  for (int i = 0; i < load_steps; ++i) canvas.fill({left + i * step, area.y, step, area.height}, colour(shade_of((i + 0.5) / load_steps)));
  const double base = area.y + area.height - 2;
  canvas.text({left - 8, base}, "0", {13, colour(0x20262E), Align::right, false});
  canvas.text({left + width + 8, base}, translated_in(lang, texts::picture::removal_rate, greatest),
              {13, colour(0x20262E), Align::left, false});
}

void draw_load_marks(Canvas& canvas, const std::vector<LoadMark>& marks) {
  std::vector<Vec2> drawn;
  for (const LoadMark& mark : marks) {
    const auto covers = [&](const Vec2& other) { return std::hypot(other.x - mark.at.x, other.y - mark.at.y) < 2 * mark_radius; };
    if (std::any_of(drawn.begin(), drawn.end(), covers)) continue;
    drawn.push_back(mark.at);
    // rings of decreasing radius fill the inside of the circle with white
    for (double radius = mark_radius / 2; radius > 0.5; radius /= 2) canvas.ring(mark.at, radius, colour(0xFFFFFF), 2 * radius);
    canvas.ring(mark.at, mark_radius, colour(mark.rgb), 1.5);
    canvas.text({mark.at.x, mark.at.y + 4.5}, mark.text, {12, colour(mark.rgb), Align::centre, true});
  }
}

}  // namespace kadr
