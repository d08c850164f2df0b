// Draws the numbers of the differences between two programs into one view. This file is used by out/picture/plot/plot_view.

#include "out/picture/plot/plot_differences.h"

#include <algorithm>
#include <array>
#include <optional>

#include "out/picture/text_width.h"

namespace kadr {
namespace {

constexpr double label_size = 12, label_height = 17, label_room = 5, label_gap = 2;
constexpr std::size_t max_labels = 100;  // greatest number of labels that are drawn in a view
constexpr double place_radius = 2.2, stand_radius = 6;

bool is_in(const Area& area, Vec2 p) { return p.x >= area.x && p.x <= area.right() && p.y >= area.y && p.y <= area.bottom(); }
bool holds_all(const Area& area, const Area& inner) {
  return is_in(area, Vec2{inner.x, inner.y}) && is_in(area, Vec2{inner.right(), inner.bottom()});
}
bool overlap(const Area& a, const Area& b) {
  return a.x < b.right() + label_gap && b.x < a.right() + label_gap && a.y < b.bottom() + label_gap && b.y < a.bottom() + label_gap;
}

/// Returns a free area for a label with this width. The area is next to the point of the label if possible, otherwise farther away, but
/// never over the point of another difference.
std::optional<Area> free_label_area(Vec2 place, double width, const std::vector<Area>& taken, const Area& field) {
  constexpr std::array<Vec2, 8> directions = {{{1, -1}, {1, 1}, {-1, -1}, {-1, 1}, {1.3, 0}, {-1.3, 0}, {0, -1.3}, {0, 1.3}}};
  for (const double far : {18.0, 34.0, 52.0})
    for (const Vec2 direction : directions) {
      const Area area{place.x + far * direction.x - width / 2, place.y + far * direction.y - label_height / 2, width, label_height};
      const auto hits = [&](const Area& other) { return overlap(area, other); };
      if (holds_all(field, area) && std::none_of(taken.begin(), taken.end(), hits)) return area;
    }
  return std::nullopt;
}

void draw_place(Canvas& canvas, const PlotNumber& number, Vec2 at) {
  if (number.stands) canvas.ring(at, stand_radius, colour(0xFFFFFF), 4), canvas.ring(at, stand_radius, number_ink, 2);
  else canvas.ring(at, place_radius, number_ink, 1.2);
}

}  // namespace

void draw_numbers(Canvas& canvas, View view, const ViewScale& scale, const PlotScene& scene, const Area& field) {
  if (scene.differences == nullptr) return;
  std::vector<Area> taken;
  for (const PlotNumber& number : scene.differences->numbers) {
    const Vec2 place = scale.page(projected(view, number.at));
    if (is_in(field, place)) taken.push_back({place.x - place_radius, place.y - place_radius, 2 * place_radius, 2 * place_radius});
  }
  std::size_t drawn = 0;
  canvas.kind("number");
  for (const PlotNumber& number : scene.differences->numbers) {
    const Vec2 place = scale.page(projected(view, number.at));
    if (!is_in(field, place)) continue;
    draw_place(canvas, number, place);
    const std::string text = std::to_string(number.number);
    const double width = text_width(text, label_size) + 2 * label_room;
    const auto area = drawn < max_labels ? free_label_area(place, width, taken, field) : std::nullopt;
    if (!area) continue;
    canvas.line(place, {area->x + area->width / 2, area->y + area->height / 2}, number_ink, 0.8);
    canvas.fill(*area, number_ink);
    canvas.text({area->x + area->width / 2, area->y + 13}, text, {label_size, colour(0xFFFFFF), Align::centre, true});
    taken.push_back(*area);
    ++drawn;
  }
  canvas.kind("");
}

}  // namespace kadr
