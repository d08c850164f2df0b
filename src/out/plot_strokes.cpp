#include "out/plot_strokes.h"

#include <algorithm>
#include <cmath>

namespace kadr {
namespace {

constexpr double same_pixel = 0.45;   // of the page
constexpr int strokes_at_once = 400;  // longer paths cost Cairo more than in proportion
constexpr double plunge_radius = 3.2;
constexpr double beyond = 20'000;  // of the page: farther points overflow Cairo's numbers

Vec2 within_reach(Vec2 p) { return {std::clamp(p.x, -beyond, beyond), std::clamp(p.y, -beyond, beyond)}; }

bool is_line(Stroke point, Stroke wanted) { return point == wanted || (wanted == Stroke::feed && point == Stroke::plunge); }

/// A polyline that knows what it may leave out.
class Pencil {
 public:
  explicit Pencil(Canvas& canvas) : canvas_(canvas) {}
  void segment(Vec2 from, Vec2 to) {
    if (!down_ || ++drawn_ % strokes_at_once == 0) {
      lift();
      canvas_.move_to(from);
      at_ = from;
      down_ = true;
    }
    skipped_ = length(to - at_) < same_pixel;
    last_ = to;
    if (skipped_) return;
    canvas_.line_to(to);
    at_ = to;
  }
  void lift() {
    if (!down_) return;
    if (skipped_) canvas_.line_to(last_);
    canvas_.stroke();
    down_ = false;
  }

 private:
  Canvas& canvas_;
  Vec2 at_, last_;
  bool down_ = false, skipped_ = false;
  int drawn_ = 0;
};

/// The pieces of the path that `is_wanted` picks, with the pen as it is.
template <class Wanted>
void draw_pieces(Canvas& canvas, View view, const ViewScale& scale, const PlotPath& path, const Wanted& is_wanted) {
  Pencil pencil(canvas);
  const auto& points = path.points();
  Vec2 from;
  for (std::size_t i = 0; i < points.size() + (path.has_pending() ? 1 : 0); ++i) {
    const PlotPoint point = i < points.size() ? points[i] : path.pending();
    const Vec2 to = within_reach(scale.page(projected(view, point.at)));
    if (i > 0 && is_wanted(point)) pencil.segment(from, to);
    else pencil.lift();
    from = to;
  }
  pencil.lift();
}

void draw_lines(Canvas& canvas, View view, const ViewScale& scale, const PlotPath& path, Stroke wanted) {
  const StrokeStyle style = style_of(wanted, path.points().size());
  canvas.pen(style.ink, style.width);
  if (style.dashed) canvas.dashes(5, 4);
  draw_pieces(canvas, view, scale, path, [wanted](const PlotPoint& point) { return is_line(point.stroke, wanted); });
  canvas.solid();
}

/// All cutting, step by step of the scale.
void draw_shaded(Canvas& canvas, View view, const ViewScale& scale, const PlotScene& scene) {
  constexpr double width = 1.8;
  for (std::size_t step = 0; step < scene.shades.steps(); ++step) {
    if (!scene.shades.occurs(step)) continue;
    canvas.pen(scene.shades.ink(step), width);
    draw_pieces(canvas, view, scale, scene.path,
                [&](const PlotPoint& point) { return point.stroke != Stroke::rapid && scene.shades.step_of(point.shade) == step; });
  }
}

/// Straight down is a point when seen from above: a ring each, as long as they can be told apart.
void draw_plunges(Canvas& canvas, const ViewScale& scale, const PlotPath& path) {
  const StrokeStyle style = style_of(Stroke::plunge, 0);
  Vec2 before{-beyond, -beyond};
  for (const PlotPoint& point : path.points()) {
    if (point.stroke != Stroke::plunge) continue;
    const Vec2 at = within_reach(scale.page(projected(View::xy, point.at)));
    if (length(at - before) < plunge_radius) continue;
    canvas.ring(at, plunge_radius, style.ink, style.width);
    before = at;
  }
}

}  // namespace

void draw_strokes(Canvas& canvas, View view, const ViewScale& scale, const PlotScene& scene) {
  draw_lines(canvas, view, scale, scene.contour, Stroke::contour);
  draw_lines(canvas, view, scale, scene.path, Stroke::rapid);
  if (scene.shades.by() != PlotColour::stroke) return draw_shaded(canvas, view, scale, scene);
  for (const Stroke stroke : {Stroke::feed, Stroke::arc}) draw_lines(canvas, view, scale, scene.path, stroke);
  if (view == View::xy) draw_plunges(canvas, scale, scene.path);
}

}  // namespace kadr
