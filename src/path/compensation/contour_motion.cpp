// This file answers questions about the contour data (CornerData) of a motion in the plane: whether the motion is a contour element, and on
// which line or circle the motion lies. Used by path/compensation/corner_resolver.

#include "path/compensation/contour_motion.h"

#include <cmath>

#include "action/by_kind.h"
#include "base/tolerance.h"

namespace kadr {

bool ends_look_ahead(const Action& action) {
  return by_kind(
      action, [](const Stop& stop) { return stop.reason != StopReason::single_block; },
      same<FrameChange, CompensationBreak, CompensationCorner, ZoneChange, Sync>(true),
      same<Motion, Dwell, Spindle, Speed, CoolantSwitch, ToolSelect, ToolChange, MachineFunction, AuxiliaryFunction, Message, SurfaceSpeed,
           Couple, Uncouple, CompensationCheck>(false));
}

std::optional<Support> support_of(const Motion& m, Vec2 from, Vec2 end) {
  const CornerData* const c = contour_of(m);
  Support s;
  s.point = from;
  if (is_arc(m.kind)) {
    s.is_circle = true;
    s.center = m.center;
    s.radius = is_over_determined(c) ? c->radius : length(from - m.center);
    return s;
  }
  if (is_over_determined(c)) s.point = end;
  if (c != nullptr && c->on != SupportingCurve::none) {
    s.direction = c->direction;
    return s;
  }
  const double path_length = length(end - from);
  if (!(path_length > tol::same_point)) return std::nullopt;
  s.direction = 1 / path_length * (end - from);
  return s;
}

double calculated_turns(Vec2 from, Vec2 to, Vec2 center, double sense) {
  return length(to - from) <= tol::same_point ? 1 : swept_turns(from - center, to - center, sense);
}

bool is_circular(const ContourElement& e) {
  return !e.is_arc || (std::fabs(e.start_radius - e.end_radius) <= tol::circular && e.start_radius > tol::same_point);
}

/// Removes only the contour data. The other details of the motion remain: entry and exit direction, rollover axes, slave axes and parked
/// axes.
void without_corner_data(Motion& m) {
  if (contour_of(m) == nullptr) return;
  if (m.detail->rolled == 0 && !m.detail->direction_vector && m.detail->followers.empty() && m.detail->parked == 0) return m.detail.reset();
  auto detail = std::make_shared<MotionDetail>(*m.detail);
  detail->contour.reset();
  m.detail = std::move(detail);
}

}  // namespace kadr
