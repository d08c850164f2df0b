#include "out/canvas.h"

#include <array>
#include <cmath>

namespace kadr {

void Canvas::pen(Colour ink, double width) {
  cairo_set_source_rgba(cairo_, ink.red, ink.green, ink.blue, ink.alpha);
  cairo_set_line_width(cairo_, width);
  cairo_set_line_join(cairo_, CAIRO_LINE_JOIN_ROUND);
  cairo_set_line_cap(cairo_, CAIRO_LINE_CAP_ROUND);
}

void Canvas::fill(const Area& area, Colour ink) {
  pen(ink, 1);
  cairo_rectangle(cairo_, area.x, area.y, area.width, area.height);
  cairo_fill(cairo_);
}

void Canvas::frame(const Area& area, Colour ink, double width) {
  pen(ink, width);
  cairo_rectangle(cairo_, area.x, area.y, area.width, area.height);
  cairo_stroke(cairo_);
}

void Canvas::line(Vec2 a, Vec2 b, Colour ink, double width) {
  pen(ink, width);
  move_to(a);
  line_to(b);
  stroke();
}

void Canvas::dashes(double on, double off) {
  const std::array<double, 2> lengths = {on, off};
  cairo_set_dash(cairo_, lengths.data(), 2, 0);
}

void Canvas::font(const TextStyle& style) {
  cairo_select_font_face(cairo_, "DejaVu Sans", CAIRO_FONT_SLANT_NORMAL, style.bold ? CAIRO_FONT_WEIGHT_BOLD : CAIRO_FONT_WEIGHT_NORMAL);
  cairo_set_font_size(cairo_, style.size);
}

double Canvas::text_width(std::string_view text, const TextStyle& style) {
  font(style);
  cairo_text_extents_t extents;
  cairo_text_extents(cairo_, std::string(text).c_str(), &extents);
  return extents.x_advance;
}

void Canvas::text(Vec2 at, std::string_view text, const TextStyle& style) {
  const double width = text_width(text, style);
  const double left = style.align == Align::left ? at.x : style.align == Align::centre ? at.x - width / 2 : at.x - width;
  cairo_set_source_rgba(cairo_, style.ink.red, style.ink.green, style.ink.blue, style.ink.alpha);
  cairo_move_to(cairo_, left, at.y);
  cairo_show_text(cairo_, std::string(text).c_str());
  cairo_new_path(cairo_);
}

void Canvas::ring(Vec2 centre, double radius, Colour ink, double width) {
  pen(ink, width);
  cairo_new_sub_path(cairo_);
  cairo_arc(cairo_, centre.x, centre.y, radius, 0, 2 * pi);
  cairo_stroke(cairo_);
}

/// The workshop's sign of a zero: a circle with two black quarters.
void Canvas::zero_mark(Vec2 centre, double radius, Colour ink) {
  pen(colour(0xFFFFFF), 1);
  cairo_arc(cairo_, centre.x, centre.y, radius, 0, 2 * pi);
  cairo_fill(cairo_);
  for (const double start : {0.0, pi}) {
    pen(ink, 1);
    cairo_move_to(cairo_, centre.x, centre.y);
    cairo_arc(cairo_, centre.x, centre.y, radius, start, start + pi / 2);
    cairo_close_path(cairo_);
    cairo_fill(cairo_);
  }
  ring(centre, radius, ink, 1.2);
}

void Canvas::arrow(Vec2 from, Vec2 to, Colour ink, double width) {
  line(from, to, ink, width);
  const Vec2 way = to - from;
  const double size = length(way);
  if (size == 0) return;
  const Vec2 along = (1 / size) * way, across{-along.y, along.x};
  const double head = 4 + 2 * width;
  const Vec2 base = to - head * along;
  const Vec2 left = base + 0.4 * head * across, right = base - 0.4 * head * across;
  move_to(to + 2.0 * along);
  line_to(left);
  line_to(right);
  cairo_close_path(cairo_);
  cairo_fill(cairo_);
}

void Canvas::clip(const Area& area) {
  cairo_save(cairo_);
  cairo_rectangle(cairo_, area.x, area.y, area.width, area.height);
  cairo_clip(cairo_);
}

}  // namespace kadr
