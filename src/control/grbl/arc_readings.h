#pragma once
// An arc read twice: by exact figures, and as Grbl does in 32 bits (spec/grbl 5). What Grbl does counts; where the two part, it is said.

#include <optional>

#include "base/alarm.h"
#include "control/grbl/single_arc.h"

namespace kadr::grbl {

/// The words of an arc, in the plane, mm.
struct ArcWords {
  Vec2 from, to;                                       // programmed coordinates
  Single2 single_from{}, single_to{};                  // machine coordinates
  bool same_point = false, single_same_point = false;  // of all three axes
  bool by_radius = false;
  double radius = 0;
  float single_radius = 0;
  Vec2 offset;
  Single2 single_offset{};
  Turn turn = Turn::cw;
  float tolerance = 0;  // $12
  Span where, radius_where;
};

struct ArcReading {
  std::optional<Alarm> refused;  // by Grbl
  std::optional<PlaneArc> arc;   // none: a line
  int segments = 0;              // that Grbl makes of the arc
  std::optional<Alarm> parted;   // the warning: exact figures give something else
};

/// What Grbl makes of an arc. Where both readings agree within 0.01 mm the arc is the exact one.
///   alarms  full_circle_by_radius, radius_too_small, radius_mismatch, in `refused`
ArcReading read_arc(const ArcWords& words);

}  // namespace kadr::grbl
