#pragma once
// This file has operations on areas that are given by their corner points; they are computed with the Clipper library. Where a path must be
// exact, path/pocketing/exact_path restores its lines and arcs. Outer contours are counter-clockwise and holes clockwise.

#include "path/pocketing/edge.h"

namespace kadr::area {

using Polygon = std::vector<Vec2>;
using Polygons = std::vector<Polygon>;

/// Returns the corner points of a path. An arc becomes chords that deviate from the arc by at most `chord` mm. The start point of a closed
/// path is not repeated at the end.
Polygon flattened(const Edges& path, double chord);
Polygons flattened(const std::vector<Edges>& loops, double chord);

/// Returns the areas enlarged by `by` mm, or reduced if `by` is negative. The corners are rounded; the chords of the roundings deviate by
/// at most `chord` mm.
Polygons grown(const Polygons& areas, double by, double chord);

enum class Ends : std::uint8_t { round, cut };
/// Returns the area that a disk with the radius `radius`, mm, sweeps along open polylines. The ends of the area are round or cut off
/// square.
Polygons swept(const Polygons& lines, double radius, double chord, Ends ends = Ends::round);

Polygons joined(const Polygons& a, const Polygons& b);
Polygons less(const Polygons& a, const Polygons& b);
Polygons common(const Polygons& a, const Polygons& b);
/// lines_inside() returns the parts of the lines that lie inside the areas; lines_outside() returns the parts outside the areas.
Polygons lines_inside(const Polygons& lines, const Polygons& areas);
Polygons lines_outside(const Polygons& lines, const Polygons& areas);

double area_of(const Polygons& areas);  // mm²
bool contains(const Polygons& areas, Vec2 p);
/// Returns the separate areas; each is an outer contour with its holes.
std::vector<Polygons> parts_of(const Polygons& areas);

}  // namespace kadr::area
