#pragma once
// Computes an arc from its words twice: exactly, and with 32-bit numbers as Grbl does (spec/grbl 5). Kadr executes the arc that Grbl would
// execute; a warning reports if the exact arc differs.

#include <optional>

#include "base/alarm.h"
#include "control/grbl/float32_arc.h"

namespace kadr::grbl {

/// The words of an arc in the active plane, mm. Members named `single…` are the 32-bit values that Grbl has.
struct ArcWords {
  Vec2 from, to;                                       // exact start and end, programmed coordinates
  Float32Pair single_from{}, single_to{};              // start and end in Grbl, machine coordinates
  bool same_point = false, single_same_point = false;  // start equals end in all three axes
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
  std::optional<Alarm> refused;  // the alarm with which Grbl refuses the arc
  std::optional<PlaneArc> arc;   // nullopt: a line
  int segments = 0;              // number of straight segments into which Grbl divides the arc
  std::optional<Alarm> parted;   // warning that the exact arc differs from Grbl's arc
};

/// Returns the arc as Grbl executes it. If the exact arc and Grbl's 32-bit arc agree within 0.01 mm, the result is the exact arc.
///   alarms  full_circle_by_radius, radius_too_small, radius_mismatch, in `refused`
ArcReading read_arc(const ArcWords& words);

}  // namespace kadr::grbl
