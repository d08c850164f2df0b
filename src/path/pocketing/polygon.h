#pragma once
// Polygons: areas given by their corner points, and operations on them with the Clipper library. Where a path must be exact,
// path/pocketing/exact_path restores its lines and arcs. Orientation: outer contours counter-clockwise, holes clockwise.

#include "path/pocketing/edge.h"

namespace kadr::area {

using Polygon = std::vector<Vec2>;
using Polygons = std::vector<Polygon>;

/// Returns a path as corner points. Arcs become chords that deviate by at most `chord` mm. For a closed path, the start point is not
/// repeated at the end.
Polygon flattened(const Edges& path, double chord);
Polygons flattened(const std::vector<Edges>& loops, double chord);

/// Returns the areas enlarged by `by` mm (reduced if negative), with rounded corners, whose chords deviate by at most `chord` mm.
Polygons grown(const Polygons& areas, double by, double chord);

enum class Ends : std::uint8_t { round, cut };
/// Returns the area that a disk of `radius` sweeps along open polylines, with ends that are round or cut off square.
Polygons swept(const Polygons& lines, double radius, double chord, Ends ends = Ends::round);

Polygons joined(const Polygons& a, const Polygons& b);
Polygons less(const Polygons& a, const Polygons& b);
Polygons common(const Polygons& a, const Polygons& b);
/// These two return the parts of the lines that lie inside, or outside, of the areas.
Polygons lines_inside(const Polygons& lines, const Polygons& areas);
Polygons lines_outside(const Polygons& lines, const Polygons& areas);

double area_of(const Polygons& areas);  // mm²
bool contains(const Polygons& areas, Vec2 p);
/// Returns each outer contour with its holes.
std::vector<Polygons> parts_of(const Polygons& areas);

}  // namespace kadr::area
