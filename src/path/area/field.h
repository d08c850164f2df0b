#pragma once
// Field: a connected area that the tool's centre may reach, for one zone. A zone (spec/correctors 4) is closed if all sides are walls,
// open if none is, else half-open or combined; the centre keeps off walls and runs over open sides.

#include "path/area/mill.h"
#include "path/area/recover.h"
#include "path/area/room.h"

namespace kadr::area {

struct Field {
  std::vector<Edges> reach;  // exact loops around the area that the centre may reach
  Polygons reach_area;
  std::vector<Edges> work;  // likewise with less overrun: what the scheme covers; the rest of `wanted` is cut along `reach`
  Polygons work_area;
  Room roomy;   // the reach, slightly enlarged: the tool's centre must stay in it
  Edges walls;  // of the zone
  Polygons zone;
  Polygons wanted;  // the part of the zone that the tool can clear: all except corners and narrow places
};

/// Returns the fields of a zone; none if the tool does not fit.
std::vector<Field> fields_of(const Zone& zone, const Job& job);

/// Returns true if the path stays within field.roomy.
bool holds(const Field& field, const Edges& path);

/// Returns true if the disk of the tool at `p` touches no material.
bool in_air(const Field& field, const Job& job, Vec2 p);

/// Returns exact loops at `by` mm inside the work area.
std::vector<Edges> rings_at(const Field& field, double by);

/// Returns the part of `wanted` that the paths leave uncut, except cusps.
Polygons uncut(const Field& field, const Job& job, const Polygons& paths);

}  // namespace kadr::area
