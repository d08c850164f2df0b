#pragma once
// One view of a plot: a projection of the path into an area of the page, with its axes.

#include "out/picture/canvas.h"
#include "out/picture/plot/plot_page.h"

namespace kadr {

enum class View : std::uint8_t { isometric, xy, xz, yz };

/// Returns the position of a point in the plane of the view; v points upwards.
///   In the isometric view X points right and away from the viewer, Y left and away (the part is seen from the south-west).
Vec2 projected(View view, Vec3 p);

/// Maps mm in the plane of the view to units of the page.
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

/// Returns the largest scale at which the box fits into the area; the box is centred.
ViewScale fitted(View view, const Box& box, const Area& area);
ViewScale fitted(const FlatBox& flat, const Area& area);

/// Returns the smallest value 1, 2 or 5 × 10ⁿ that is at least `least`.
double round_step(double least);

void draw_plane(Canvas& canvas, const Area& area, View view, const PlotScene& scene, const Box& box);
/// Like draw_plane(), for a view inside another drawing: begins no named group.
void draw_field(Canvas& canvas, const Area& area, View view, const PlotScene& scene, const Box& box);
void draw_isometric(Canvas& canvas, const Area& area, const PlotScene& scene, const Box& box);

/// How a stroke of the path is drawn; also used by the legend.
struct StrokeStyle {
  Colour ink;
  double width;
  bool dashed;
};
inline constexpr Colour tool_ink = colour(0xCC79A7);  // colour of the lines that show tool directions
StrokeStyle style_of(Stroke stroke, std::size_t points);

}  // namespace kadr
