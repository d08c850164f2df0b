#pragma once
// Field is a connected area of one zone that the tool's centre may reach. A zone (spec/correctors 4) is an area to mill that is bounded by
// sides. The zone is closed if all sides are walls, and open if no side is a wall; otherwise it is half-open or combined. The tool's centre
// keeps its distance from walls and may cross open sides.

#include "path/pocketing/exact_path.h"
#include "path/pocketing/mill.h"
#include "path/pocketing/reachable_area.h"

namespace kadr::area {

struct Field {
  std::vector<Edges> reach;  // Boundary of the area that the tool's centre may reach, as exact closed loops.
  Polygons reach_area;
  // Boundary of the area that the passes of the scheme cover. At open sides it is smaller than `reach`. The parts of `required` that these
  // passes leave uncut are cut along `reach`.
  std::vector<Edges> work;
  Polygons work_area;
  Room roomy;   // the area `reach_area`, enlarged by a half of the tolerance tol::area_wall; the tool's centre must stay inside it
  Edges walls;  // walls of the zone
  Polygons zone;
  Polygons required;  // The part of the zone that the tool can clear: the zone without corners and narrow parts.
};

/// Returns the fields of a zone. The list is empty if the tool does not fit anywhere.
std::vector<Field> fields_of(const Zone& zone, const Job& job);

/// Returns true if the path stays within field.roomy, the area in which the tool's centre must stay.
bool holds(const Field& field, const Edges& path);

/// Returns true if a tool whose centre is at `p` does not touch material.
bool in_air(const Field& field, const Job& job, Vec2 p);

/// Returns exact closed loops inside the work area at the distance `by`, mm, from its boundary.
std::vector<Edges> rings_at(const Field& field, double by);

/// Returns the part of `required` that the paths leave uncut. The cusps between passes are not included.
Polygons uncut(const Field& field, const Job& job, const Polygons& paths);

}  // namespace kadr::area
