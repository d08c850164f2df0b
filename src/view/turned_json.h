#pragma once
// Converts what the page draws of a turned part to JSON (docs/panel-protocol.md: cut, part, proposals). It is used by view/page/page_part
// and view/report.

#include "view/page/page_json.h"
#include "view/part_run.h"

namespace kadr {

/// Returns the polygons of a section as lists of [radius, Z], mm; Z relative to the machine's zero. `zero_z`: machine position of the zero
/// of the blank's work coordinates.
PageJson section_json(const TurnedRegion& section, double zero_z);

/// Returns the keys section, section_y and edges of a state of the part.
PageJson turned_json(const PartThen& then, double zero_z);

/// Returns a list of {tool, part, outline}; `part` is cutting, shank or holder, `outline` a list of [x, z] from the programmed point, mm.
PageJson inserts_json(const std::vector<ShownInsert>& inserts);

}  // namespace kadr
