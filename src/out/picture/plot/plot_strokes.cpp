// Draws the strokes of the path in one view. This file is used by out/picture/plot/plot_page and out/picture/plot/plot_view.

#include "out/picture/plot/plot_strokes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <unordered_set>

#include "out/picture/plot/plot_differences.h"

namespace kadr {
namespace {

constexpr double same_pixel = 0.45;  // units of the page: a point closer than this to the previous point is on the same pixel
// Greatest number of segments in one path that Cairo draws. The time that Cairo needs grows faster than the length of the path.
constexpr int strokes_at_once = 400;
constexpr double plunge_radius = 3.2;
constexpr double beyond = 20'000;  // units of the page: coordinates beyond this value overflow the numbers of Cairo

Vec2 within_reach(Vec2 p) { return {std::clamp(p.x, -beyond, beyond), std::clamp(p.y, -beyond, beyond)}; }

/// Shortens a line to the part within the limits of the page. Returns false if the whole line is outside.
bool cut_to_reach(Vec2& from, Vec2& to) {
  double first = 0, last = 1;
  const Vec2 start = from, delta = to - from;
  // Limits the range of t in which the coordinate at + t·step does not exceed `beyond`. t is the location on the line, from 0 to 1.
  const auto keep = [&](double at, double step) {
    if (step > 0) last = std::min(last, (beyond - at) / step);
    else if (step < 0) first = std::max(first, (beyond - at) / step);
    else if (at > beyond) last = -1;
  };
  keep(start.x, delta.x), keep(-start.x, -delta.x), keep(start.y, delta.y), keep(-start.y, -delta.y);
  if (first > last) return false;
  if (last < 1) to = start + last * delta;
  if (first > 0) from = start + first * delta;
  return true;
}

bool is_line(Stroke point, Stroke stroke) {
  return point == stroke || (stroke == Stroke::feed && (point == Stroke::plunge || point == Stroke::probe));
}

/// Sets the program lines of the strokes that are drawn in a view.
class LineTags {
 public:
  /// Creates the object for one view. `names`: true if the first stroke of each program line gets the id by which a viewer finds that line.
  LineTags(Canvas& canvas, const PlotScene& scene, bool names)
      : canvas_(canvas), title_(scene.title), tells_(canvas.tags_lines() && lines_are_tagged(scene)), names_(names) {}
  bool tells() const { return tells_; }
  void next(ProgramLine line, bool may_name) {
    const bool first = names_ && may_name && line.line != 0 && named_.insert(std::uint64_t{line.file} << 32U | line.line).second;
    canvas_.program_line(line, title_.file_of(line), first);
  }
  void end() { canvas_.program_line({}, {}, false); }

 private:
  Canvas& canvas_;
  const PlotTitle& title_;
  bool tells_, names_;
  std::unordered_set<std::uint64_t> named_;  // program lines whose first stroke already has an id; at most max_line_strokes
};

/// Draws a polyline. Points that would not be visible are omitted.
class Pencil {
 public:
  /// Draws with this canvas. `may_name`: true if the strokes belong to the tool path itself, so that they may get the id of their program
  /// line.
  Pencil(Canvas& canvas, LineTags& tags, bool may_name) : canvas_(canvas), tags_(tags), may_name_(may_name) {}
  void segment(Vec2 from, Vec2 to, ProgramLine line) {
    const Vec2 start = from;
    if (!cut_to_reach(from, to)) return lift();
    if (!(from == start)) lift();
    if (tags_.tells() && !(down_ && line == line_)) {
      lift();
      tags_.next(line_ = line, may_name_);
    }
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
  LineTags& tags_;
  bool may_name_;
  ProgramLine line_;
  Vec2 at_, last_;
  bool down_ = false, skipped_ = false;
  int drawn_ = 0;
};

/// Draws those segments of the path for which the function `is_wanted` returns true, with the present pen.
template <class Wanted>
void draw_pieces(Canvas& canvas, LineTags& tags, View view, const ViewScale& scale, const PlotPath& path, bool may_name,
                 const Wanted& is_wanted) {
  Pencil pencil(canvas, tags, may_name);
  const auto& points = path.points();
  Vec2 from;
  for (std::size_t i = 0; i < points.size() + (path.has_pending() ? 1 : 0); ++i) {
    const PlotPoint point = i < points.size() ? points[i] : path.pending();
    const Vec2 to = scale.page(projected(view, point.at));
    if (i > 0 && is_wanted(point)) pencil.segment(from, to, point.line);
    else pencil.lift();
    from = to;
  }
  pencil.lift();
  tags.end();
}

const char* name_of(Stroke stroke) {
  switch (stroke) {
    case Stroke::rapid: return "rapid";
    case Stroke::arc: return "arc";
    case Stroke::contour: return "contour";
    case Stroke::plunge: return "plunge";
    default: return "feed";
  }
}

void draw_lines(Canvas& canvas, LineTags& tags, View view, const ViewScale& scale, const PlotPath& path, Stroke stroke) {
  const StrokeStyle style = style_of(stroke, path.points().size());
  canvas.kind(name_of(stroke));
  canvas.pen(style.ink, style.width);
  if (style.dashed) canvas.dashes(5, 4);
  draw_pieces(canvas, tags, view, scale, path, stroke != Stroke::contour,
              [stroke](const PlotPoint& point) { return is_line(point.stroke, stroke); });
  canvas.solid();
  canvas.kind("");
}

/// Draws all cutting motions. Motions whose colours are in the same interval of the colour scale are drawn together.
void draw_shaded(Canvas& canvas, LineTags& tags, View view, const ViewScale& scale, const PlotScene& scene) {
  constexpr double width = 1.8;
  canvas.kind("shade");
  for (std::size_t step = 0; step < scene.shades.steps(); ++step) {
    if (!scene.shades.occurs(step)) continue;
    canvas.pen(scene.shades.ink(step), width);
    draw_pieces(canvas, tags, view, scale, scene.path, true,
                [&](const PlotPoint& point) { return cuts(point.stroke) && scene.shades.step_of(point.shade) == step; });
  }
  canvas.kind("");
}

/// Draws the path of program a, and over it that of program b. Where the two paths coincide, the wider line of a is visible on both sides
/// of the line of b.
void draw_paths(Canvas& canvas, LineTags& tags, View view, const ViewScale& scale, const PlotScene& scene) {
  const PlotDifferences& d = *scene.differences;
  struct Layer {
    const PlotPath& path;
    const char* kind;
    const PathStyle& style;
    bool names, dashed;
  };
  const std::array<Layer, 5> layers = {{{d.changed, "changed", changed_path, false, false},
                                        {d.changed, "same", same_path, true, true},
                                        {scene.path, "same", same_path, true, true},
                                        {d.a, "a", path_of_a, true, true},
                                        {d.b, "b", path_of_b, true, true}}};
  for (const Layer& layer : layers)
    for (const bool rapid : {true, false}) {
      canvas.kind(layer.kind);
      canvas.pen(layer.style.ink, layer.style.width);
      if (rapid && layer.dashed) canvas.dashes(5, 4);
      draw_pieces(canvas, tags, view, scale, layer.path, layer.names,
                  [rapid](const PlotPoint& point) { return point.stroke != Stroke::jump && (point.stroke == Stroke::rapid) == rapid; });
      canvas.solid();
    }
  canvas.kind("");
}

/// Draws a ring for each plunge, since a plunge seen from above is only a point. No rings are drawn if there are too many of them to
/// distinguish.
void draw_plunges(Canvas& canvas, const ViewScale& scale, const PlotPath& path) {
  const StrokeStyle style = style_of(Stroke::plunge, 0);
  canvas.kind(name_of(Stroke::plunge));
  Vec2 before{-beyond, -beyond};
  for (const PlotPoint& point : path.points()) {
    if (point.stroke != Stroke::plunge) continue;
    const Vec2 at = within_reach(scale.page(projected(View::xy, point.at)));
    if (length(at - before) < plunge_radius) continue;
    canvas.ring(at, plunge_radius, style.ink, style.width);
    before = at;
  }
  canvas.kind("");
}

}  // namespace

bool lines_are_tagged(const PlotScene& scene) {
  std::size_t strokes = 0;
  for (const PlotPath* const path : paths_of(scene)) {
    ProgramLine line;
    Stroke stroke = Stroke::rapid;
    for (const PlotPoint& point : path->points()) {
      if (!(point.line == line) || point.stroke != stroke) ++strokes;
      line = point.line, stroke = point.stroke;
    }
  }
  return strokes <= max_line_strokes;
}

void draw_strokes(Canvas& canvas, View view, const ViewScale& scale, const PlotScene& scene) {
  LineTags tags(canvas, scene, view == View::isometric || view == View::zx);
  if (scene.differences != nullptr) return draw_paths(canvas, tags, view, scale, scene);
  draw_lines(canvas, tags, view, scale, scene.contour, Stroke::contour);
  draw_lines(canvas, tags, view, scale, scene.path, Stroke::rapid);
  if (scene.shades.by() != PlotColour::stroke) return draw_shaded(canvas, tags, view, scale, scene);
  for (const Stroke stroke : {Stroke::feed, Stroke::arc}) draw_lines(canvas, tags, view, scale, scene.path, stroke);
  if (view == View::xy) draw_plunges(canvas, scale, scene.path);
}

}  // namespace kadr
