// Makes bodies of chuck and tailstock. Used by cli/cut; tested by tests/run_cut.py.

#include "session/cutting/turning/work_holding.h"

#include <algorithm>
#include <cmath>

#include "base/vec.h"
#include "texts/cutting.h"

namespace kadr {
namespace {

/// Returns the greatest radius of the blank below a Z, mm; 0 if nothing of it is there.
double radius_below(const TurnedRegion& blank, double z) {
  double radius = 0;
  for (const TurnedPolygon& polygon : blank)
    for (std::size_t i = 0; i < polygon.size(); ++i) {
      const Vec2 a = polygon[i], b = polygon[(i + 1) % polygon.size()];
      if (a.y <= z) radius = std::max(radius, a.x);
      if ((a.y > z) != (b.y > z)) radius = std::max(radius, a.x + (b.x - a.x) * (z - a.y) / (b.y - a.y));
    }
  return radius;
}

}  // namespace

std::vector<HeldBody> work_holding(const MachineProfile& machine, const Setup& setup, const TurnedRegion& blank) {
  std::vector<HeldBody> bodies;
  const ChuckProfile& chuck = machine.chuck;
  if (chuck.diameter > 0 && setup.chuck_face) {
    const double face = *setup.chuck_face, grip = 2 * radius_below(blank, face);
    if (grip < chuck.diameter)
      bodies.push_back({translated(texts::cutting::chuck), cylinder_region(face - chuck.length, face, chuck.diameter, grip)});
  }
  const TailstockProfile& tail = machine.tailstock;
  if (tail.centre > 0 && setup.tailstock) {
    const double tip = *setup.tailstock, half = 0.5 * tail.angle * rad_per_deg, end = tip + 0.5 * tail.centre / std::tan(half);
    const double r = 0.5 * tail.centre, q = 0.5 * tail.diameter;
    bodies.push_back(
        {translated(texts::cutting::tailstock), {{{0, tip}, {r, end}, {q, end}, {q, end + tail.length}, {0, end + tail.length}}}});
  }
  return bodies;
}

}  // namespace kadr
