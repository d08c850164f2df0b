#pragma once
// One view of a plot: a projection of the path into an area of the page, with its axes.

#include "out/picture/canvas.h"
#include "out/picture/plot_page.h"

namespace kadr {

enum class View : std::uint8_t { isometric, xy, xz, yz };

/// Where a point of the view's plane stands; v upwards.
///   X to the right and away, Y to the left and away in the isometric view (from the south-west)
Vec2 projected(View view, Vec3 p);

/// mm of the view's plane → page.
struct ViewScale {
  double per_mm = 1;
  Vec2 zero;  // of the page
  Vec2 page(Vec2 p) const { return {zero.x + per_mm * p.x, zero.y - per_mm * p.y}; }
};

/// A rectangle of the view's plane, mm.
struct FlatBox {
  Vec2 least{1e300, 1e300}, most{-1e300, -1e300};
  void take(Vec2 p);
};

/// The largest scale at which the box fits the area, centred.
ViewScale fitted(View view, const Box& box, const Area& area);
ViewScale fitted(const FlatBox& flat, const Area& area);

/// 1, 2 or 5 times a power of ten, not below `least`.
double round_step(double least);

void draw_plane(Canvas& canvas, const Area& area, View view, const PlotScene& scene, const Box& box);
/// The same as a part of something else: without a name of its own.
void draw_field(Canvas& canvas, const Area& area, View view, const PlotScene& scene, const Box& box);
void draw_isometric(Canvas& canvas, const Area& area, const PlotScene& scene, const Box& box);

/// The strokes of the path; used by the legend too.
struct StrokeStyle {
  Colour ink;
  double width;
  bool dashed;
};
inline constexpr Colour tool_ink = colour(0xCC79A7);  // of the tool's directions
StrokeStyle style_of(Stroke stroke, std::size_t points);

}  // namespace kadr
