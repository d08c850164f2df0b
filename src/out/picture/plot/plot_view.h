#pragma once
// Draws one view of a plot: a projection of the path into an area of the page, with its axes.

#include "out/picture/canvas.h"
#include "out/picture/plot/plot_page.h"

namespace kadr {

enum class View : std::uint8_t { isometric, xy, xz, yz, zx };  // zx: as lathes are drawn, Z to the right, X upwards

/// Returns the position of a point in the plane of the view; v points upwards. In the isometric view, X points to the right and away from
/// the viewer, and Y to the left and away. The part is therefore seen from the south-west.
Vec2 projected(View view, Vec3 p);

/// Converts positions in the plane of the view, mm, to units of the page.
struct ViewScale {
  double per_mm = 1;
  Vec2 zero;  // position of the origin on the page
  Vec2 page(Vec2 p) const { return {zero.x + per_mm * p.x, zero.y - per_mm * p.y}; }
};

/// A rectangle in the plane of the view, mm.
struct FlatBox {
  Vec2 least{1e300, 1e300}, most{-1e300, -1e300};
  void take(Vec2 p);
};

/// Returns the largest scale at which the box fits into the area. The box is in the middle of the area.
ViewScale fitted(View view, const Box& box, const Area& area);
ViewScale fitted(const FlatBox& flat, const Area& area);

/// Returns the smallest of the values 1, 2 and 5 × 10ⁿ that is at least `least`.
double round_step(double least);

void draw_plane(Canvas& canvas, const Area& area, View view, const PlotScene& scene, const Box& box);
/// Draws the same view as draw_plane(), but without a named SVG group, for use as a part of another picture.
void draw_field(Canvas& canvas, const Area& area, View view, const PlotScene& scene, const Box& box);
void draw_isometric(Canvas& canvas, const Area& area, const PlotScene& scene, const Box& box);

/// The style of a stroke of the path, also for the legend.
struct StrokeStyle {
  Colour ink;
  double width;
  bool dashed;
};
inline constexpr Colour tool_ink = colour(0xCC79A7);  // colour of the lines that show the directions of the tool
StrokeStyle style_of(Stroke stroke, std::size_t points);

}  // namespace kadr
