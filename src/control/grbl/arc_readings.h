#pragma once
// Computes an arc from its words twice: exactly, and in 32-bit numbers as Grbl does (spec/grbl 5). Kadr executes Grbl's arc, and warns if
// the exact arc differs from Grbl's arc.

#include <optional>

#include "base/alarm.h"
#include "control/grbl/float32_arc.h"

namespace kadr::grbl {

/// The words of an arc in the active plane, in mm. Members whose names begin with `single` are Grbl's 32-bit values.
struct ArcWords {
  Vec2 from, to;                                       // exact start and end in programmed coordinates
  Float32Pair single_from{}, single_to{};              // start and end as Grbl computes them, in machine coordinates
  bool same_point = false, single_same_point = false;  // start and end are equal on all three axes, by exact numbers and by 32-bit numbers
  bool by_radius = false;
  double radius = 0;
  float single_radius = 0;
  Vec2 offset;
  Float32Pair single_offset{};
  Turn turn = Turn::cw;
  float tolerance = 0;  // setting $12, arc tolerance in mm
  Span where, radius_where;
};

struct ArcReading {
  std::optional<Alarm> refused;  // alarm with which Grbl refuses the arc; nullopt: Grbl executes the arc
  std::optional<PlaneArc> arc;   // arc that Grbl executes; nullopt: Grbl moves on a straight line
  int segments = 0;              // number of straight segments into which Grbl divides the arc
  std::optional<Alarm> parted;   // warning that the arc of Grbl differs from the exact arc by more than 0.01 mm; nullopt: no warning
};

/// Returns the arc that Grbl executes. If Grbl's arc agrees with the exact arc within 0.01 mm, the result is the exact arc.
///   alarms  full_circle_by_radius, radius_too_small, radius_mismatch; in ArcReading::refused
ArcReading read_arc(const ArcWords& words);

}  // namespace kadr::grbl
