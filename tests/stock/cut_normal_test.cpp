// stock/surface/cut_normal: the normal of a cut surface is the direction in which the distance from the swept tool increases.

#include "stock/surface/cut_normal.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <optional>

#include "stock/some_tools.h"

namespace kadr::cut_normal_test {
namespace {

/// Returns where a line along the axis enters or leaves the swept volume of the tool, near the middle of the path.
std::optional<CutPlace> place_on_surface(Chance& chance, const ToolShape& tool, const Sweep& sweep, int family) {
  const Vec3 tip = sweep.from + chance.between(0, 1) * (sweep.to - sweep.from);
  const ConvexBody& body = tool.bodies[std::size_t(chance.below(int(tool.bodies.size())))];
  const double wide = body.widest();
  Vec3 inside = tip + Vec3{chance.between(-wide, wide), chance.between(-wide, wide), chance.between(body.bottom(), body.top())};
  if (from_swept(tool, sweep, inside) > -0.01) return std::nullopt;
  Vec3 outside = inside;
  const bool up = chance.below(2) == 0;
  double step = 0.1;
  for (int i = 0; i < 400 && from_swept(tool, sweep, outside) < 0; ++i) along(outside, family) += up ? step : -step;
  if (from_swept(tool, sweep, outside) < 0) return std::nullopt;
  for (int i = 0; i < 60; ++i) {
    const Vec3 middle = 0.5 * (inside + outside);
    (from_swept(tool, sweep, middle) < 0 ? inside : outside) = middle;
  }
  return CutPlace{outside, family, !up};  // leaving the tool in the positive direction means entering the material
}

/// Returns the gradient of the distance, or nullopt at edges of the swept volume, where the distance is not smooth.
std::optional<Vec3> gradient(const ToolShape& tool, const Sweep& sweep, const Vec3& at) {
  constexpr double h = 1e-4;
  Vec3 g, forth, back;
  const double here = from_swept(tool, sweep, at);
  for (int d = 0; d < 3; ++d) {
    Vec3 a = at, b = at;
    along(a, d) += h, along(b, d) -= h;
    along(forth, d) = (from_swept(tool, sweep, a) - here) / h;
    along(back, d) = (here - from_swept(tool, sweep, b)) / h;
    along(g, d) = 0.5 * (along(forth, d) + along(back, d));
  }
  if (length(forth - back) > 0.02 || std::fabs(length(g) - 1) > 0.02) return std::nullopt;
  return (1 / length(g)) * g;
}

RC_GTEST_PROP(cut_normal, is_the_gradient_of_the_distance, (unsigned seed)) {
  Chance chance(seed);
  int compared = 0;
  for (int round = 0; round < 40; ++round) {
    const ToolShape tool = some_tool(chance, SomeTool(chance.below(some_tools)));
    if (tool.bodies.empty()) continue;
    Sweep sweep = some_move(chance);
    if (length(sweep.to - sweep.from) > 50) continue;  // a kept sweep has single precision only
    KeptSweep kept{};
    for (int d = 0; d < 3; ++d) {
      kept.from[d] = float(along(sweep.from, d)), kept.to[d] = float(along(sweep.to, d));
      along(sweep.from, d) = double(kept.from[d]), along(sweep.to, d) = double(kept.to[d]);
    }
    const auto place = place_on_surface(chance, tool, sweep, chance.below(3));
    if (!place) continue;
    const auto grows = gradient(tool, sweep, place->at);
    if (!grows || std::fabs(along(*grows, place->family)) < 0.05) continue;  // lines that only touch are found by the other families
    const Vec3 normal = cut_normal(kept, faces_of(tool), *place);
    ++compared;
    if (length(normal + *grows) > 0.03) {
      RC_LOG() << "round " << round << " " << int(tool.geometry.kind) << " at " << place->at.x << " " << place->at.y << " " << place->at.z
               << " family " << place->family << " is " << normal.x << " " << normal.y << " " << normal.z << " should be " << -grows->x
               << " " << -grows->y << " " << -grows->z << " diameter " << tool.geometry.diameter << " flutes " << tool.geometry.flutes
               << " way " << (sweep.to - sweep.from).x << " " << (sweep.to - sweep.from).y << " " << (sweep.to - sweep.from).z << " from "
               << sweep.from.x << " " << sweep.from.y << " " << sweep.from.z;
      RC_FAIL("not the gradient");
    }
  }
  RC_TAG(compared > 10 ? "many" : "few");
}

}  // namespace
}  // namespace kadr::cut_normal_test
