// FN 23, FN 24: the circle through points (spec/heidenhain 10.2). Used by control/heidenhain.

#include <cmath>

#include "control/heidenhain/fitted_circle.h"
#include "control/heidenhain/heidenhain.h"

namespace kadr::heidenhain {

/// The circle x² + y² - 2 a x - 2 b y = c with the least sum of squares, in coordinates from the middle of the points.
std::optional<FittedCircle> fitted_circle(const std::vector<Vec2>& points) {
  Vec2 middle;
  const double count = static_cast<double>(points.size());
  for (const Vec2 p : points) middle = middle + 1 / count * p;
  double xx = 0, xy = 0, yy = 0, xz = 0, yz = 0, zz = 0;
  for (const Vec2 each : points) {
    const Vec2 p = each - middle;
    const double z = dot(p, p);
    xx += p.x * p.x, xy += p.x * p.y, yy += p.y * p.y;
    xz += p.x * z, yz += p.y * z, zz += z;
  }
  const double whole = xx * yy - xy * xy;
  constexpr double on_a_line = 1e-12;
  if (!(std::fabs(whole) > on_a_line * (xx + yy) * (xx + yy))) return std::nullopt;
  const Vec2 centre{(xz * yy - yz * xy) / (2 * whole), (yz * xx - xz * xy) / (2 * whole)};
  return FittedCircle{middle + centre, std::sqrt(zz / count + dot(centre, centre))};
}

/// FN 23: Q20 = CDATA Q30: Q30 to Q35 are three points; FN 24 has four. Q20, Q21, Q22 become centre and radius.
Status Heidenhain::circle_data(Interpreter& m, const KlartextBlock& block) {
  const std::size_t count = block.number == 24 ? 4 : 3;
  const auto first = static_cast<std::size_t>(block.part);
  if (first + 2 * count > q_count || block.target.index + 2U >= q_count || block.target.family != ParameterFamily::q)
    return fail(alarm(AlarmId::value_out_of_range, m.block->where, "CDATA", static_cast<double>(first)));
  std::vector<Vec2> points;
  for (std::size_t i = 0; i < count; ++i) {
    const auto x = parameter(m, ParameterFamily::q, static_cast<std::uint16_t>(first + 2 * i), m.block->where);
    const auto y = parameter(m, ParameterFamily::q, static_cast<std::uint16_t>(first + 2 * i + 1), m.block->where);
    if (!x) return fail(x.error());
    if (!y) return fail(y.error());
    points.push_back({*x, *y});
  }
  const auto circle = fitted_circle(points);
  if (!circle) return fail(alarm(AlarmId::plane_degenerate, m.block->where));
  const double results[] = {circle->centre.x, circle->centre.y, circle->radius};
  for (std::size_t i = 0; i < 3; ++i) {
    KlartextStep to = block.target;
    to.index = static_cast<std::uint16_t>(block.target.index + i);
    KADR_TRY(set_parameter(to, results[i]));
  }
  return {};
}

}  // namespace kadr::heidenhain
