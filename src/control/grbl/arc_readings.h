#pragma once
// Reads an arc twice: exactly, and in 32 bits as Grbl does (spec/grbl 5). Grbl's reading counts; a warning says where they differ.

#include <optional>

#include "base/alarm.h"
#include "control/grbl/single_arc.h"

namespace kadr::grbl {

/// The words of an arc, in the plane, mm.
struct ArcWords {
  Vec2 from, to;                                       // programmed coordinates
  Single2 single_from{}, single_to{};                  // machine coordinates
  bool same_point = false, single_same_point = false;  // start equals end in all three axes
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
  std::optional<PlaneArc> arc;   // nullopt: a line
  int segments = 0;              // number of segments that Grbl makes of the arc
  std::optional<Alarm> parted;   // warning: the exact reading differs
};

/// Returns what Grbl makes of an arc. Where both readings agree within 0.01 mm, the arc is the exact one.
///   alarms  full_circle_by_radius, radius_too_small, radius_mismatch, in `refused`
ArcReading read_arc(const ArcWords& words);

}  // namespace kadr::grbl
