#pragma once
// Field: a connected area that the tool's centre may go to, for one zone. Zone kinds (spec/correctors 4): closed where all sides are
// walls, open where none is, half-open or combined in between; the centre keeps off walls and runs over open sides.

#include "path/area/mill.h"
#include "path/area/recover.h"
#include "path/area/room.h"

namespace kadr::area {

struct Field {
  std::vector<Edges> reach;  // loops around where the centre may be, exact
  Polygons reach_area;
  std::vector<Edges> work;  // the same with less overrun: what the scheme covers; the rest of `wanted` is cut along `reach`
  Polygons work_area;
  Room roomy;   // reach, a little larger: what may be moved in
  Edges walls;  // of the zone
  Polygons zone;
  Polygons wanted;  // what the tool can clear: of the zone all but corners and necks
};

/// The fields of a zone; none where the tool does not fit.
std::vector<Field> fields_of(const Zone& zone, const Job& job);

/// The path stays within what may be moved in.
bool holds(const Field& field, const Edges& path);

/// The disk of the tool at `p` touches no material.
bool in_air(const Field& field, const Job& job, Vec2 p);

/// Loops at `by` mm inside of the work area, exact.
std::vector<Edges> rings_at(const Field& field, double by);

/// What is wanted and the paths leave uncut, cusps aside.
Polygons uncut(const Field& field, const Job& job, const Polygons& paths);

}  // namespace kadr::area
