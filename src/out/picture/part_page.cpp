// Draws the page of a cut part. This file is used by cli/cut and tested by tests/run_cut.py.

#include "out/picture/part_page.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "base/matrix.h"
#include "out/picture/deviation_colour.h"
#include "out/picture/part_view.h"
#include "out/picture/plot/plot_page.h"
#include "out/text/page_file.h"
#include "texts/picture.h"

namespace kadr {
namespace {

constexpr double part_page_width = 1600, part_page_height = 1060, part_margin = 28, part_gap = 14;
constexpr double heading = 80, large_width = 900, caption_height = 60;
constexpr double sharpness = 1.5;  // number of pixels per unit of the page
constexpr double name_height = 24;
constexpr double room = 0.92;  // greatest fraction (0 to 1) of the width and height of a view that the part fills

constexpr std::array<std::uint32_t, 8> tool_colours = {0x6FA8DC, 0xE69F56, 0x7BB661, 0xC27BA0, 0xD9C04F, 0x8E7CC3, 0x5FB8B0, 0xCC6666};
constexpr std::uint32_t blank_colour = 0xC9CED6;
constexpr std::uint32_t collision_colour = 0xC00000;
constexpr std::uint32_t oldest = 0x3B5B92, newest = 0xF2A65A;

constexpr std::array<PlainText, 6> side_names = {texts::picture::from_above, texts::picture::from_front,  texts::picture::from_right,
                                                 texts::picture::from_below, texts::picture::from_behind, texts::picture::from_left};

ViewDirection seen_from(Vec3 towards, Vec3 up) { return {cross(up, towards), up, towards}; }

std::array<ViewDirection, 6> sides() {
  return {seen_from({0, 0, 1}, {0, 1, 0}),   seen_from({0, -1, 0}, {0, 0, 1}), seen_from({1, 0, 0}, {0, 0, 1}),
          seen_from({0, 0, -1}, {0, -1, 0}), seen_from({0, 1, 0}, {0, 0, 1}),  seen_from({-1, 0, 0}, {0, 0, 1})};
}

ViewDirection isometric() {
  const Vec3 towards = unit({1, -1, 1});
  const Vec3 right = unit(cross({0, 0, 1}, towards));
  return {right, cross(towards, right), towards};
}

/// The colour scales of deviation and of load (removal rate).
struct ColourScales {
  DeviationScale deviation;
  double rate = 0;
};

ColourScales scales_of(const PartScene& scene) {
  return {deviation_scale(scene.deviation.of_point, scene.deviation.within), greatest_rate(scene.surface.made_by, scene.load.rates)};
}

/// Returns the colour of a triangle. It depends on the deviation of the triangle, or on the sweep that cut it last.
std::uint32_t colour_of_triangle(const PartScene& scene, const ColourScales& scales, std::size_t triangle) {
  if (scene.colour == PartColour::deviation) {
    double sum = 0;
    for (std::size_t k = 0; k < 3; ++k) sum += double(scene.deviation.of_point[scene.surface.triangles[triangle * 3 + k]]);
    return deviation_colour(sum / 3, scales.deviation);
  }
  std::int32_t by = of_blank;
  for (std::size_t k = 0; k < 3; ++k) by = std::max(by, scene.surface.made_by[scene.surface.triangles[triangle * 3 + k]]);
  if (by == of_blank) return blank_colour;
  if (scene.colour == PartColour::load) return load_colour(by, scene.load.rates, scales.rate);
  if (scene.colour == PartColour::age)
    return mixed_colour(oldest, newest, scene.colours.empty() ? 0 : double(by) / double(scene.colours.size()));
  return tool_colours[scene.colours[std::size_t(by)] % tool_colours.size()];
}

/// Returns the scale, pixels per mm, at which the whole part fits into the area.
double scale_for(const Box3& box, const ViewDirection& view, const Area& area) {
  const Vec3 size = box.most - box.least;
  const auto reach = [&](const Vec3& axis) { return std::abs(axis.x) * size.x + std::abs(axis.y) * size.y + std::abs(axis.z) * size.z; };
  return room * sharpness * std::min(area.width / std::max(reach(view.right), 1e-9), area.height / std::max(reach(view.up), 1e-9));
}

/// Returns the area without its upper border, which contains the name of the view.
Area below_name(const Area& area) { return {area.x, area.y + name_height, area.width, area.height - name_height}; }

void draw_view(Canvas& canvas, const PartScene& scene, const ViewDirection& view, const Area& area, double scale, const char* name) {
  const Area inner = below_name(area);
  const ColourScales scales = scales_of(scene);
  const ViewFrame frame{0.5 * (scene.box.least + scene.box.most), scale, int(inner.width * sharpness), int(inner.height * sharpness)};
  canvas.pixels(inner, part_view(scene.surface, view, frame, [&](std::size_t t) { return colour_of_triangle(scene, scales, t); }));
  canvas.frame(area, colour(0xD5DAE1));
  canvas.text({area.x + 8, area.y + 18}, name, {13, colour(0x5B6775), Align::left, false});
}

/// Draws line numbers at collisions. If the surface is coloured by load, also draws the ranks of the program lines with the heaviest load.
void draw_marks(Canvas& canvas, const PartScene& scene, const ViewDirection& view, const Area& area, double scale) {
  const Area inner = below_name(area);
  const Vec3 centre = 0.5 * (scene.box.least + scene.box.most);
  const auto place = [&](const Vec3& at) {
    const Vec3 from = at - centre;
    return Vec2{inner.x + inner.width / 2 + dot(from, view.right) * scale / sharpness,
                inner.y + inner.height / 2 - dot(from, view.up) * scale / sharpness};
  };
  std::vector<LoadMark> marks;
  for (const CollisionMark& c : scene.collisions) marks.push_back({place(c.at), std::to_string(c.line), collision_colour});
  std::size_t number = 0;
  if (scene.colour == PartColour::load)
    for (const Vec3& at : scene.load.heaviest) marks.push_back({place(at), std::to_string(++number)});
  draw_load_marks(canvas, marks);
}

void draw_key(Canvas& canvas, const PartScene& scene) {
  const Lang lang = scene.title.lang;
  const double y = part_page_height - 24;
  double x = part_margin;
  if (scene.colour == PartColour::deviation)
    return draw_deviation_key(canvas, {x, y - 11, part_page_width / 2, 14},
                              deviation_scale(scene.deviation.of_point, scene.deviation.within), lang);
  if (scene.colour == PartColour::load) return draw_load_key(canvas, {x, y - 11, part_page_width / 2, 14}, scales_of(scene).rate, lang);
  const auto entry = [&](std::uint32_t rgb, const std::string& text) {
    canvas.fill({x, y - 11, 14, 14}, colour(rgb));
    canvas.text({x + 20, y + 1}, text, {13, colour(0x20262E), Align::left, false});
    x += 40 + 9.0 * double(text.size());
  };
  entry(blank_colour, plain_text(texts::picture::uncut, lang));
  if (scene.colour == PartColour::age) {
    entry(oldest, plain_text(texts::picture::by_age_first, lang));
    entry(newest, plain_text(texts::picture::by_age_last, lang));
    return;
  }
  for (std::size_t i = 0; i < scene.title.legend.size() && x < part_page_width - 120; ++i)
    entry(tool_colours[i % tool_colours.size()], scene.title.legend[i]);
}

void draw_page(Canvas& canvas, const PartScene& scene) {
  canvas.fill({0, 0, part_page_width, part_page_height}, colour(0xFFFFFF));
  canvas.text({part_margin, 42}, name_of_file(scene.title.file), {24, colour(0x20262E), Align::left, true});
  canvas.text({part_margin, 66},
              translated_in(scene.title.lang, texts::picture::control, scene.title.control) + "     " + scene.title.caption,
              {14, colour(0x5B6775), Align::left, false});
  canvas.text({part_page_width - part_margin, 42}, "Kadr", {20, colour(0xA9B4C0), Align::right, true});
  const double bottom = part_page_height - caption_height;
  const Area large{part_margin, heading, large_width, bottom - heading};
  const ViewDirection view = isometric();
  const double large_scale = scale_for(scene.box, view, below_name(large));
  draw_view(canvas, scene, view, large, large_scale, "");
  draw_marks(canvas, scene, view, large, large_scale);
  const double width = (part_page_width - 2 * part_margin - large_width - 2 * part_gap) / 2, height = (bottom - heading - 2 * part_gap) / 3;
  const auto directions = sides();
  double scale = 1e30;
  for (const ViewDirection& d : directions) scale = std::min(scale, scale_for(scene.box, d, below_name({0, 0, width, height})));
  for (std::size_t i = 0; i < directions.size(); ++i) {
    const Area area{part_margin + large_width + part_gap + double(i / 3) * (width + part_gap),
                    heading + double(i % 3) * (height + part_gap), width, height};
    draw_view(canvas, scene, directions[i], area, scale, plain_text(side_names[i], scene.title.lang));
  }
  draw_key(canvas, scene);
}

}  // namespace

tl::expected<void, std::string> draw_part_page(const ResultFile& file, const PartScene& scene) {
  return write_page(file, part_page_width, part_page_height, {name_of_file(scene.title.file), scene.title.caption, scene.title.lang},
                    [&](Canvas& canvas) { draw_page(canvas, scene); });
}

}  // namespace kadr
