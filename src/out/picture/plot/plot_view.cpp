// Draws one view of a plot: a projection of the path into an area of the page, with its axes. This file is used by the rest of out.

#include "out/picture/plot/plot_view.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "out/picture/palette.h"
#include "out/picture/plot/plot_differences.h"
#include "out/picture/plot/plot_marks.h"
#include "out/picture/plot/plot_strokes.h"
#include "out/picture/text_width.h"

namespace kadr {
namespace {

constexpr Colour grid_zero = colour(0xB4C0CC);
constexpr double tick_spacing = 58;  // least distance between grid lines, units of the page
constexpr double iso_cos = 0.8660254037844386, iso_sin = 0.5;

struct PlaneNames {
  const char* name;
  const char* across;
  const char* up;
};
constexpr std::array<PlaneNames, 5> plane_names = {
    {{"view-isometric", "", ""}, {"view-xy", "X", "Y"}, {"view-xz", "X", "Z"}, {"view-yz", "Y", "Z"}, {"view-zx", "Z", "X"}}};

const PlaneNames& names_of(View view) { return plane_names[static_cast<std::size_t>(view)]; }

std::array<Vec3, 8> corners(const Box& box) {
  std::array<Vec3, 8> all;
  for (std::size_t i = 0; i < 8; ++i)
    all[i] = {i & 1U ? box.most.x : box.least.x, i & 2U ? box.most.y : box.least.y, i & 4U ? box.most.z : box.least.z};
  return all;
}

/// Draws light grid lines at round values. The values are printed on the left and below; those on the left are diameters in the view of a
/// lathe whose X is programmed so.
void draw_grid(Canvas& canvas, const Area& area, View view, const ViewScale& scale, const PlotTitle& title) {
  const LengthUnit unit = title.unit;
  const double step = mm_of(unit) * round_step(tick_spacing / scale.per_mm / mm_of(unit));
  const bool diameters = view == View::zx && title.x_is_diameter;
  const double times = diameters ? 2 : 1;  // a number along `up` is so many times the height
  const double step_up = mm_of(unit) * round_step(times * tick_spacing / scale.per_mm / mm_of(unit)) / times;
  const TextStyle number{11, faint_ink, Align::centre, false};
  const TextStyle number_left{11, faint_ink, Align::right, false};
  const auto first_of = [](double least, double of_step) { return std::ceil(least / of_step - 1e-9); };
  for (double n = first_of((area.x - scale.zero.x) / scale.per_mm, step); scale.zero.x + n * step * scale.per_mm <= area.right(); ++n) {
    const double x = scale.zero.x + n * step * scale.per_mm;
    canvas.line({x, area.y}, {x, area.bottom()}, n == 0 ? grid_zero : grid, 1);
    canvas.text({x, area.bottom() + 15}, length_text(n * step, unit), number);
  }
  for (double n = first_of((scale.zero.y - area.bottom()) / scale.per_mm, step_up); scale.zero.y - n * step_up * scale.per_mm >= area.y;
       ++n) {
    const double y = scale.zero.y - n * step_up * scale.per_mm;
    canvas.line({area.x, y}, {area.right(), y}, n == 0 ? grid_zero : grid, 1);
    canvas.text({area.x - 6, y + 4}, length_text(times * n * step_up, unit), number_left);
  }
  canvas.text({area.right() - 8, area.bottom() - 8}, names_of(view).across, {14, ink, Align::right, true});
  const std::string up = names_of(view).up;
  canvas.text({area.x + 8, area.y + 18}, diameters ? up + " Ø" : up, {14, ink, Align::left, true});
}

void draw_origins(Canvas& canvas, View view, const ViewScale& scale, const std::vector<Vec3>& zeros) {
  canvas.kind("zero");
  for (const Vec3 zero : zeros) canvas.zero_mark(scale.page(projected(view, zero)), 6, ink);
  canvas.kind("");
}

/// Draws the bottom face of the path's bounding box with a grid, and those edges of the box that are farther from the viewer than the path.
void draw_floor(Canvas& canvas, const ViewScale& scale, const Box& box, LengthUnit unit) {
  const auto page = [&](double x, double y, double z) { return scale.page(projected(View::isometric, {x, y, z})); };
  const Vec3 a = box.least, b = box.most;
  const double step = mm_of(unit) * round_step(tick_spacing / 1.6 / scale.per_mm / mm_of(unit));
  for (double x = std::ceil(a.x / step) * step; x <= b.x; x += step) canvas.line(page(x, a.y, a.z), page(x, b.y, a.z), grid, 1);
  for (double y = std::ceil(a.y / step) * step; y <= b.y; y += step) canvas.line(page(a.x, y, a.z), page(b.x, y, a.z), grid, 1);
  // The front edges of the bounding box are omitted, since they would cross the path.
  const std::array<Vec3, 8> all = corners(box);
  constexpr std::array<std::array<std::size_t, 2>, 9> edges = {{{0, 1}, {0, 2}, {1, 3}, {2, 3}, {1, 5}, {2, 6}, {3, 7}, {5, 7}, {6, 7}}};
  for (const auto [from, to] : edges)
    canvas.line(scale.page(projected(View::isometric, all[from])), scale.page(projected(View::isometric, all[to])), edge, 1);
}

/// Prints the dimensions of the box along three of its edges.
void draw_sizes(Canvas& canvas, const ViewScale& scale, const Box& box, LengthUnit unit) {
  const auto page = [&](double x, double y, double z) { return scale.page(projected(View::isometric, {x, y, z})); };
  const Vec3 a = box.least, b = box.most;
  const auto range = [unit](char axis, double least, double most) {
    return fmt::format("{}  {} … {}", axis, length_text(least, unit), length_text(most, unit));
  };
  const Vec2 x = page((a.x + b.x) / 2, a.y, a.z), y = page(a.x, (a.y + b.y) / 2, a.z);
  const std::string across = range('X', a.x, b.x), up = range('Z', a.z, b.z);
  canvas.text({x.x + 12, x.y + 22}, across, {13, faint_ink, Align::left, false});
  canvas.text({y.x - 12, y.y + 22}, range('Y', a.y, b.y), {13, faint_ink, Align::right, false});
  Vec2 z = page(b.x, a.y, a.z) + Vec2{8, 22};
  constexpr double row = 18;  // height of a line of text, units of the page
  const bool overlap = std::fabs(z.y - x.y - 22) < row && z.x - text_width(up, 13) / 2 < x.x + 12 + text_width(across, 13);
  // the box is too narrow for the texts about X, Y and Z side by side, so the range of Z is printed below the other texts
  if (overlap) z = {x.x + 12 + text_width(up, 13) / 2, x.y + 22 + row};
  canvas.text(z, up, {13, faint_ink, Align::centre, false});
}

/// Draws three arrows with the directions of the axes in the lower left corner.
void draw_triad(Canvas& canvas, Vec2 at) {
  constexpr double size = 42;
  const auto arm = [&](Vec3 axis, const char* name) {
    const Vec2 direction = projected(View::isometric, axis);
    const Vec2 tip{at.x + size * direction.x, at.y - size * direction.y};
    canvas.arrow(at, tip, ink, 1.6);
    canvas.text({tip.x + 12 * direction.x, tip.y - 12 * direction.y + 5}, name, {14, ink, Align::centre, true});
  };
  arm({1, 0, 0}, "X");
  arm({0, 1, 0}, "Y");
  arm({0, 0, 1}, "Z");
}

void draw_scale_bar(Canvas& canvas, Vec2 at, const ViewScale& scale, LengthUnit unit, Lang lang) {
  const double size = round_step(90 / scale.per_mm / mm_of(unit)), width = size * mm_of(unit) * scale.per_mm;
  canvas.fill({at.x - width, at.y, width / 2, 5}, ink);
  canvas.fill({at.x - width / 2, at.y, width / 2, 5}, colour(0xFFFFFF));
  canvas.frame({at.x - width, at.y, width, 5}, ink, 1);
  canvas.text({at.x - width / 2, at.y - 7}, number_text(size, 4) + " " + unit_name(unit, lang), {12, ink, Align::centre, false});
}

/// Draws lines from the tool tip along the tool axis. They are long enough to be visible on a part of this size.
void draw_tools(Canvas& canvas, View view, const ViewScale& scale, const PlotScene& scene, const Box& room) {
  if (scene.tools.empty()) return;
  constexpr double part = 0.12, width = 0.7;
  const Vec3 size = room.most - room.least;
  const double length = part * std::max({size.x, size.y, size.z});
  canvas.begin("tool directions");
  for (const ToolDirection& tool : scene.tools)
    canvas.line(scale.page(projected(view, tool.at)), scale.page(projected(view, tool.at + length * tool.direction)), tool_ink, width);
  canvas.end();
}

/// Returns the rectangle that the isometric view must show: the projection of `room` (box of the cutting, or `box` if nothing cuts), and of
/// those parts of the path that are inside `box`. The corners of `box` are mostly empty, so they need not be visible.
FlatBox seen_of(const PlotScene& scene, const Box& room, const Box& box) {
  FlatBox flat;
  for (const Vec3 corner : corners(room)) flat.take(projected(View::isometric, corner));
  for (const PlotPath* const path : paths_of(scene))
    for (const PlotPoint& point : path->points()) {
      const auto within = [&](double Vec3::*c) { return std::clamp(point.at.*c, box.least.*c, box.most.*c); };
      flat.take(projected(View::isometric, {within(&Vec3::x), within(&Vec3::y), within(&Vec3::z)}));
    }
  return flat;
}

}  // namespace

Vec2 projected(View view, Vec3 p) {
  switch (view) {
    case View::xy: return {p.x, p.y};
    case View::xz: return {p.x, p.z};
    case View::yz: return {p.y, p.z};
    case View::zx: return {p.z, p.x};
    default: return {(p.x - p.y) * iso_cos, (p.x + p.y) * iso_sin + p.z};
  }
}

void FlatBox::take(Vec2 p) {
  least = {std::min(least.x, p.x), std::min(least.y, p.y)};
  most = {std::max(most.x, p.x), std::max(most.y, p.y)};
}

ViewScale fitted(View view, const Box& box, const Area& area) {
  FlatBox flat;
  for (const Vec3 corner : corners(box)) flat.take(projected(view, corner));
  return fitted(flat, area);
}

ViewScale fitted(const FlatBox& flat, const Area& area) {
  const auto [least, most] = flat;
  const Vec2 size = most - least;
  ViewScale scale;
  scale.per_mm = std::min(area.width / std::max(size.x, 1e-9), area.height / std::max(size.y, 1e-9));
  const Vec2 middle = 0.5 * (least + most);
  scale.zero = {area.x + area.width / 2 - scale.per_mm * middle.x, area.y + area.height / 2 + scale.per_mm * middle.y};
  return scale;
}

double round_step(double least) {
  const double power = std::pow(10, std::floor(std::log10(least)));
  for (const double part : {1.0, 2.0, 5.0})
    if (part * power >= least * (1 - 1e-9)) return part * power;
  return 10 * power;
}

void draw_plane(Canvas& canvas, const Area& area, View view, const PlotScene& scene, const Box& box) {
  canvas.begin(names_of(view).name);
  draw_field(canvas, area, view, scene, box);
  canvas.end();
}

void draw_field(Canvas& canvas, const Area& area, View view, const PlotScene& scene, const Box& box) {
  constexpr double left = 48, below = 24, inside = 16;
  const Area field{area.x + left, area.y, area.width - left, area.height - below};
  const ViewScale scale = fitted(view, box, {field.x + inside, field.y + inside, field.width - 2 * inside, field.height - 2 * inside});
  canvas.fill(field, paper);
  draw_grid(canvas, field, view, scale, scene.title);
  canvas.clip(field);
  draw_tools(canvas, view, scale, scene, box);
  draw_strokes(canvas, view, scale, scene);
  draw_origins(canvas, view, scale, scene.zeros);
  draw_marks(canvas, view, scale, scene, field);
  draw_numbers(canvas, view, scale, scene, field);
  canvas.unclip();
  canvas.frame(field, edge, 1);
}

void draw_isometric(Canvas& canvas, const Area& area, const PlotScene& scene, const Box& box) {
  constexpr double side = 72, top = 30, below = 64;
  const Box& room = scene.path.cutting_box().empty ? box : scene.path.cutting_box();
  const FlatBox seen = seen_of(scene, room, box);
  const ViewScale scale = fitted(seen, {area.x + side, area.y + top, area.width - 2 * side, area.height - top - below});
  canvas.begin(names_of(View::isometric).name);
  canvas.fill(area, paper);
  canvas.clip(area);
  draw_floor(canvas, scale, room, scene.title.unit);
  draw_tools(canvas, View::isometric, scale, scene, room);
  draw_strokes(canvas, View::isometric, scale, scene);
  draw_origins(canvas, View::isometric, scale, scene.zeros);
  draw_sizes(canvas, scale, room, scene.title.unit);
  draw_marks(canvas, View::isometric, scale, scene, area);
  draw_numbers(canvas, View::isometric, scale, scene, area);
  canvas.unclip();
  draw_triad(canvas, {area.x + 58, area.bottom() - 34});
  draw_scale_bar(canvas, {area.right() - 24, area.bottom() - 24}, scale, scene.title.unit, scene.title.lang);
  canvas.frame(area, edge, 1);
  canvas.end();
}

/// Colours from the palette of Okabe and Ito, which colour-blind people can distinguish. Rapid motion is dashed in addition.
StrokeStyle style_of(Stroke stroke, std::size_t points) {
  const double fine = std::clamp(1.7 - 0.35 * std::log10(std::max(1.0, double(points) / 300)), 0.6, 1.7);
  switch (stroke) {
    case Stroke::rapid: return {colour(0x7A8794), std::min(1.0, fine), true};
    case Stroke::arc: return {colour(0xD55E00), fine, false};
    case Stroke::contour: return {colour(0xB9C2CC), 3.2, false};
    case Stroke::plunge: return {colour(0x009E73), 1.4, false};
    default: return {colour(0x0072B2), fine, false};
  }
}

}  // namespace kadr
