// Draws the symbols on a path: its start, its end, and the position where an alarm stopped the program. This file is used by
// out/picture/plot/plot_legend and out/picture/plot/plot_view.

#include "out/picture/plot/plot_marks.h"

#include <algorithm>
#include <array>

#include "out/picture/palette.h"

namespace kadr {
namespace {

constexpr Colour red = colour(0xC8102E);

void square(Canvas& canvas, Vec2 at, double half, Colour colour, double width) {
  canvas.frame({at.x - half, at.y - half, 2 * half, 2 * half}, colour, width);
}

void cross(Canvas& canvas, Vec2 at, double arm, Colour colour, double width) {
  canvas.line({at.x - arm, at.y - arm}, {at.x + arm, at.y + arm}, colour, width);
  canvas.line({at.x - arm, at.y + arm}, {at.x + arm, at.y - arm}, colour, width);
}

/// Draws a triangle whose tip points to the right.
void triangle(Canvas& canvas, Vec2 at, double size, Colour colour) {
  canvas.pen(colour, 1);
  canvas.move_to({at.x + size, at.y});
  canvas.line_to({at.x - 0.7 * size, at.y - 0.9 * size});
  canvas.line_to({at.x - 0.7 * size, at.y + 0.9 * size});
  canvas.fill_path();
}

/// Moves a symbol away from the upper left and lower right corners of the view, which contain the names of the axes.
Vec2 away_from_labels(Vec2 at, const Area& room) {
  constexpr double label = 16, step = 26;
  if (at.x < room.x + label && at.y < room.y + label) at.x += step;
  if (at.x > room.right() - label && at.y > room.bottom() - label) at.x -= step;
  return at;
}

const char* kind_of(PlotMark::What what) { return what == PlotMark::What::start ? "start" : what == PlotMark::What::end ? "end" : "stop"; }

}  // namespace

void draw_mark(Canvas& canvas, PlotMark::What what, Vec2 at) {
  switch (what) {
    case PlotMark::What::start: triangle(canvas, at, 8.5, white); return triangle(canvas, at, 6, ink);
    case PlotMark::What::end: square(canvas, at, 8, white, 4); return square(canvas, at, 8, ink, 1.8);
    case PlotMark::What::stop: cross(canvas, at, 7, white, 6); return cross(canvas, at, 7, red, 3);
  }
}

void draw_marks(Canvas& canvas, View view, const ViewScale& scale, const PlotScene& scene, const Area& field) {
  constexpr double inset = 24, arrow = 12;
  const Area room{field.x + inset, field.y + inset, field.width - 2 * inset, field.height - 2 * inset};
  for (const PlotMark& mark : scene.marks) {
    canvas.kind(kind_of(mark.what));
    canvas.program_line(mark.line, scene.title.file_of(mark.line), false);
    const Vec2 place = scale.page(projected(view, mark.at));
    const bool inside = place.x >= field.x && place.x <= field.right() && place.y >= field.y && place.y <= field.bottom();
    const Vec2 at =
        inside ? place : away_from_labels({std::clamp(place.x, room.x, room.right()), std::clamp(place.y, room.y, room.bottom())}, room);
    if (const double far = length(place - at); far > 0) {
      const Vec2 direction = (1 / far) * (place - at);
      canvas.arrow(at + 9.0 * direction, at + (9 + arrow) * direction, mark.what == PlotMark::What::stop ? red : ink, 1.4);
    }
    draw_mark(canvas, mark.what, at);
  }
  canvas.program_line({}, {}, false);
  canvas.kind("");
}

}  // namespace kadr
