#pragma once
// One view of a plot: a projection of the path into an area of the page, with its axes.

#include "out/picture/canvas.h"
#include "out/picture/plot_page.h"

namespace kadr {

enum class View : std::uint8_t { isometric, xy, xz, yz };

/// Returns where a point is in the view's plane; v points upwards.
///   In the isometric view X points to the right and away, Y to the left and away (seen from the south-west).
Vec2 projected(View view, Vec3 p);

/// Maps mm of the view's plane to the page.
struct ViewScale {
  double per_mm = 1;
  Vec2 zero;  // position of the origin on the page
  Vec2 page(Vec2 p) const { return {zero.x + per_mm * p.x, zero.y - per_mm * p.y}; }
};

/// A rectangle in the view's plane, mm.
struct FlatBox {
  Vec2 least{1e300, 1e300}, most{-1e300, -1e300};
  void take(Vec2 p);
};

/// Returns the largest scale at which the box fits into the area, and centres it.
ViewScale fitted(View view, const Box& box, const Area& area);
ViewScale fitted(const FlatBox& flat, const Area& area);

/// Returns the smallest of 1, 2 or 5 times a power of ten that is not below `least`.
double round_step(double least);

void draw_plane(Canvas& canvas, const Area& area, View view, const PlotScene& scene, const Box& box);
/// Like draw_plane(), as a part of something else: without a name of its own.
void draw_field(Canvas& canvas, const Area& area, View view, const PlotScene& scene, const Box& box);
void draw_isometric(Canvas& canvas, const Area& area, const PlotScene& scene, const Box& box);

/// How a stroke of the path is drawn; also used by the legend.
struct StrokeStyle {
  Colour ink;
  double width;
  bool dashed;
};
inline constexpr Colour tool_ink = colour(0xCC79A7);  // for the directions of the tool
StrokeStyle style_of(Stroke stroke, std::size_t points);

}  // namespace kadr
