// Converts deviations to colours: blue, grey and red. This file is used by out/picture/part_page.

#include "out/picture/deviation_colour.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "texts/picture.h"

namespace kadr {
namespace {

constexpr std::uint32_t within_tolerance = 0xC9CED6, little_left = 0x9DBBE8, much_left = 0x1B4FB0, little_gouged = 0xF0A8A0,
                        much_gouged = 0xB01818;
constexpr int scale_steps = 60;
constexpr double label_space = 150;  // width that the word at each end of the colour scale needs, units of the page

}  // namespace

std::uint32_t mixed_colour(std::uint32_t a, std::uint32_t b, double share) {
  const auto part = [&](int shift) {
    return std::uint32_t(std::lround((1 - share) * double(a >> shift & 0xFF) + share * double(b >> shift & 0xFF))) << shift;
  };
  return part(16) | part(8) | part(0);
}

DeviationScale deviation_scale(const std::vector<float>& of_point, double within) {
  double most = 2 * within;
  for (const float d : of_point) most = std::max(most, std::abs(double(d)));
  return {within, most};
}

std::uint32_t deviation_colour(double deviation, const DeviationScale& scale) {
  const double off = std::abs(deviation);
  if (off <= scale.within) return within_tolerance;
  const double share = std::clamp((off - scale.within) / std::max(scale.most - scale.within, 1e-9), 0.0, 1.0);
  return deviation > 0 ? mixed_colour(little_left, much_left, share) : mixed_colour(little_gouged, much_gouged, share);
}

void draw_deviation_key(Canvas& canvas, const Area& area, const DeviationScale& scale, Lang lang) {
  const double left = area.x + label_space, width = area.width - 2 * label_space, step = width / scale_steps;
  for (int i = 0; i < scale_steps; ++i)
    canvas.fill({left + i * step, area.y, step, area.height},
                colour(deviation_colour(scale.most * ((2 * i + 1.0) / scale_steps - 1), scale)));
  const auto text = [&](double x, double y, const std::string& words, Align align) {
    canvas.text({x, y}, words, {13, colour(0x20262E), align, false});
  };
  const double base = area.y + area.height - 2, below = area.y + area.height + 15;
  text(left - 8, base, translated_in(lang, texts::picture::gouged, scale.most), Align::right);
  text(left + width + 8, base, translated_in(lang, texts::picture::left_on, scale.most), Align::left);
  text(left + width / 2, below, fmt::format("±{:g}", scale.within), Align::centre);
}

}  // namespace kadr
