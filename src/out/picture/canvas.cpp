// Canvas: an interface for drawing strokes, areas and texts, in the order of the calls. It is used by the rest of out.

#include "out/picture/canvas.h"

#include <cmath>

#include "out/picture/text_width.h"

namespace kadr {

void Canvas::frame(const Area& area, Colour ink, double width) {
  pen(ink, width);
  move_to({area.x, area.y});
  line_to({area.right(), area.y});
  line_to({area.right(), area.bottom()});
  line_to({area.x, area.bottom()});
  line_to({area.x, area.y});
  stroke();
}

void Canvas::line(Vec2 a, Vec2 b, Colour ink, double width) {
  pen(ink, width);
  move_to(a);
  line_to(b);
  stroke();
}

void Canvas::text(Vec2 at, std::string_view text, const TextStyle& style) {
  if (!text.empty()) put_text(at, printable(text), style);
}

/// Draws the symbol of an origin as in workshop drawings: a circle with two black quarters.
void Canvas::zero_mark(Vec2 centre, double radius, Colour ink) {
  constexpr int steps = 8;  // number of straight lines that approximate a quarter circle
  const auto sector = [&](double start, double end, Colour colour) {
    pen(colour, 1);
    move_to(centre);
    const int pieces = static_cast<int>(std::lround(steps * (end - start) / (pi / 2)));
    for (int i = 0; i <= pieces; ++i) {
      const double angle = start + (end - start) * i / pieces;
      line_to({centre.x + radius * std::cos(angle), centre.y + radius * std::sin(angle)});
    }
    fill_path();
  };
  sector(0, 2 * pi, colour(0xFFFFFF));
  for (const double start : {0.0, pi}) sector(start, start + pi / 2, ink);
  ring(centre, radius, ink, 1.2);
}

void Canvas::arrow(Vec2 from, Vec2 to, Colour ink, double width) {
  line(from, to, ink, width);
  const Vec2 delta = to - from;
  const double size = length(delta);
  if (size == 0) return;
  const Vec2 along = (1 / size) * delta, across{-along.y, along.x};
  const double head = 4 + 2 * width;
  const Vec2 base = to - head * along;
  move_to(to + 2.0 * along);
  line_to(base + 0.4 * head * across);
  line_to(base - 0.4 * head * across);
  fill_path();
}

}  // namespace kadr
