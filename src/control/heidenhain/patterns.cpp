// The points of patterns, at which a cycle is executed: 220, 221, CYCL CALL PAT (spec/heidenhain 12.7). Used by control/heidenhain.

#include <algorithm>
#include <cmath>

#include "base/tolerance.h"
#include "control/heidenhain/cycle_steps.h"

namespace kadr::heidenhain {

/// 220: points on a circle (spec/heidenhain 12.7).
Status CycleMaker::polar_pattern() {
  const double count = std::round(q(241));
  if (!(count >= 1 && count <= 10'000)) return fail(alarm(AlarmId::value_out_of_range, where_, "Q241", count));
  const Vec2 centre{length(216), length(217)};
  const double radius = length(244) / 2, start = q(245);
  const bool whole = std::fabs(std::fabs(q(246) - start) - 360) < tol::same_angle;
  const double step = q(247) != 0 ? q(247) : whole ? 360 / count : count > 1 ? (q(246) - start) / (count - 1) : 0;
  levels(length(203), length(200), length(201));
  second_ = surface_ + length(204);
  rapid(std::max(second_, clearance_));
  for (int i = 0; i < static_cast<int>(count); ++i) {
    const SinCos turn = sincos_deg(start + i * step);
    KADR_TRY(at_point(centre + radius * Vec2{turn.cos, turn.sin}, i > 0 && q(301) == 0));
    if (q(301) == 0 && i + 1 < static_cast<int>(count)) drop_last_retract();
  }
  return {};
}

/// 221: lines and columns, to and fro (spec/heidenhain 12.7).
Status CycleMaker::cartesian_pattern() {
  const double columns = std::round(q(242)), lines = std::round(q(243));
  if (!(columns >= 1 && lines >= 1 && columns * lines <= 10'000))
    return fail(alarm(AlarmId::value_out_of_range, where_, "Q242", columns * lines));
  const Vec2 start{length(225), length(226)};
  levels(length(203), length(200), length(201));
  second_ = surface_ + length(204);
  rapid(std::max(second_, clearance_));
  int done = 0;
  for (int line = 0; line < static_cast<int>(lines); ++line)
    for (int i = 0; i < static_cast<int>(columns); ++i, ++done) {
      const int column = line % 2 == 0 ? i : static_cast<int>(columns) - 1 - i;
      KADR_TRY(at_point(start + rotated(Vec2{column * length(237), line * length(238)}, q(224)), done > 0 && q(301) == 0));
      if (q(301) == 0 && done + 1 < static_cast<int>(columns * lines)) drop_last_retract();
    }
  return {};
}

/// CYCL CALL PAT: the points of PATTERN DEF, in their order (spec/heidenhain 12.7).
Status CycleMaker::points(const std::vector<Axes>& all) {
  const double high = m_.position.programmed[plane_.normal];
  for (const Axes& point : all) {
    raised_ = point[2];
    levels(length(203) + raised_, length(200), length(201));
    second_ = surface_ + length(204);
    const double clear = std::max(high, second_);
    if (&point != &all.front()) rapid(clear);
    in_plane({point[0], point[1]});
    KADR_TRY(at_point());
  }
  return {};
}

/// The way to the second set-up clearance, which Q301 = 0 leaves out between two points.
void CycleMaker::drop_last_retract() {
  if (second_ > clearance_ + tol::same_point && !steps.empty() && steps.back().kind == CycleStep::Kind::rapid &&
      steps.back().to[plane_.normal] == second_)
    steps.pop_back();
}

}  // namespace kadr::heidenhain
