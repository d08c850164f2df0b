#include "out/canvas.h"

#include <array>
#include <cmath>

namespace kadr {

void Canvas::pen(Colour ink, double width) {
  lib_.set_source_rgba(cairo_, ink.red, ink.green, ink.blue, ink.alpha);
  lib_.set_line_width(cairo_, width);
  lib_.set_line_join(cairo_, CAIRO_LINE_JOIN_ROUND);
  lib_.set_line_cap(cairo_, CAIRO_LINE_CAP_ROUND);
}

void Canvas::fill(const Area& area, Colour ink) {
  pen(ink, 1);
  lib_.rectangle(cairo_, area.x, area.y, area.width, area.height);
  lib_.fill(cairo_);
}

void Canvas::frame(const Area& area, Colour ink, double width) {
  pen(ink, width);
  lib_.rectangle(cairo_, area.x, area.y, area.width, area.height);
  lib_.stroke(cairo_);
}

void Canvas::line(Vec2 a, Vec2 b, Colour ink, double width) {
  pen(ink, width);
  move_to(a);
  line_to(b);
  stroke();
}

void Canvas::dashes(double on, double off) {
  const std::array<double, 2> lengths = {on, off};
  lib_.set_dash(cairo_, lengths.data(), 2, 0);
}

void Canvas::font(const TextStyle& style) {
  lib_.select_font_face(cairo_, "DejaVu Sans", CAIRO_FONT_SLANT_NORMAL, style.bold ? CAIRO_FONT_WEIGHT_BOLD : CAIRO_FONT_WEIGHT_NORMAL);
  lib_.set_font_size(cairo_, style.size);
}

double Canvas::text_width(std::string_view text, const TextStyle& style) {
  font(style);
  cairo_text_extents_t extents;
  lib_.text_extents(cairo_, std::string(text).c_str(), &extents);
  return extents.x_advance;
}

void Canvas::text(Vec2 at, std::string_view text, const TextStyle& style) {
  const double width = text_width(text, style);
  const double left = style.align == Align::left ? at.x : style.align == Align::centre ? at.x - width / 2 : at.x - width;
  lib_.set_source_rgba(cairo_, style.ink.red, style.ink.green, style.ink.blue, style.ink.alpha);
  lib_.move_to(cairo_, left, at.y);
  lib_.show_text(cairo_, std::string(text).c_str());
  lib_.new_path(cairo_);
}

void Canvas::ring(Vec2 centre, double radius, Colour ink, double width) {
  pen(ink, width);
  lib_.new_sub_path(cairo_);
  lib_.arc(cairo_, centre.x, centre.y, radius, 0, 2 * pi);
  lib_.stroke(cairo_);
}

/// The workshop's sign of a zero: a circle with two black quarters.
void Canvas::zero_mark(Vec2 centre, double radius, Colour ink) {
  pen(colour(0xFFFFFF), 1);
  lib_.arc(cairo_, centre.x, centre.y, radius, 0, 2 * pi);
  lib_.fill(cairo_);
  for (const double start : {0.0, pi}) {
    pen(ink, 1);
    lib_.move_to(cairo_, centre.x, centre.y);
    lib_.arc(cairo_, centre.x, centre.y, radius, start, start + pi / 2);
    lib_.close_path(cairo_);
    lib_.fill(cairo_);
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
  lib_.close_path(cairo_);
  lib_.fill(cairo_);
}

void Canvas::clip(const Area& area) {
  lib_.save(cairo_);
  lib_.rectangle(cairo_, area.x, area.y, area.width, area.height);
  lib_.clip(cairo_);
}

}  // namespace kadr
