#pragma once
// Field: a connected area that the tool's centre may reach in one zone. A zone (spec/correctors 4) is an area to mill, bounded by sides.
// It is closed if all sides are walls, open if no side is a wall, else half-open or combined. The tool's centre keeps its distance from
// walls and may pass over open sides.

#include "path/pocketing/exact_path.h"
#include "path/pocketing/mill.h"
#include "path/pocketing/reachable_area.h"

namespace kadr::area {

struct Field {
  std::vector<Edges> reach;  // boundary of the area that the tool's centre may reach, as exact closed loops
  Polygons reach_area;
  // boundary of the area that the passes of the scheme cover; at open sides it is smaller than `reach`. What these passes leave uncut of
  // `wanted` is cut along `reach`
  std::vector<Edges> work;
  Polygons work_area;
  Room roomy;   // `reach_area`, slightly enlarged: the tool's centre must stay inside
  Edges walls;  // walls of the zone
  Polygons zone;
  Polygons wanted;  // the part of the zone that the tool can clear: all except corners and narrow parts
};

/// Returns the fields of a zone; an empty list if the tool does not fit anywhere.
std::vector<Field> fields_of(const Zone& zone, const Job& job);

/// Returns true if the path stays within field.roomy, the area in which the tool's centre must stay.
bool holds(const Field& field, const Edges& path);

/// Returns true if a tool with its centre at `p` touches no material.
bool in_air(const Field& field, const Job& job, Vec2 p);

/// Returns exact closed loops inside the work area, `by` mm from its boundary.
std::vector<Edges> rings_at(const Field& field, double by);

/// Returns the part of `wanted` that the paths leave uncut, without the cusps between passes.
Polygons uncut(const Field& field, const Job& job, const Polygons& paths);

}  // namespace kadr::area
