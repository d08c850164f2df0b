#pragma once
// The path itself, in one view.

#include "out/picture/plot_view.h"

namespace kadr {

/// An SVG tells the line of each stroke, if they are no more than that.
inline constexpr std::size_t most_line_strokes = 10'000;
/// The strokes of the scene, counted by their lines, are no more.
bool lines_are_told(const PlotScene& scene);

/// Draws all strokes, the programmed contour below them; points that fall on the pixel of the one before are passed over.
void draw_strokes(Canvas& canvas, View view, const ViewScale& scale, const PlotScene& scene);

}  // namespace kadr
