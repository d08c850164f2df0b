#pragma once
// The part of TiltedCutter for tools with a ball end: removes what the ball sweeps, then what the shaft sweeps of the remaining material.
// Only stock/cut/tilted_cut includes this file.

#include "stock/cut/tilted_cutter.h"

namespace kadr {

template <class V>
KADR_IN_LANES bool TiltedCutter::sweeps_ball(const TiltedFamily<V>& all, int family, const BallTube& tube, int row, int lane,
                                             const Swept<V>& material, Swept<V>& swept) {
  swept = in_ball_tube(tube, lanes_at<V>(scale_.place + lane) - half_, scale_.place[row] - half_);
  swept = {swept.from + half_, swept.to + half_};
  const bool meets = any(meet(swept, material));
  if (below_shaft_) return meets;
  const Swept<V> left = left_by(swept, material);
  if (!any(left.from < left.to)) return meets;
  Swept<V> shaft;
  if (!sweeps<V, TiltedBody::Kind::cylinder>(all, family, row, lane, left, shaft)) return meets;
  shaft = where(meet(shaft, left), shaft.from, shaft.to);
  // A line that nearly lies in the surface of ball and shaft may be met by the ball at one end of the path, and by the shaft at the other.
  // If the two swept intervals do not overlap, the line is cut with the two halves of the path instead.
  const V between = most(swept.from, shaft.from) - least(swept.to, shaft.to);
  const MarksOf<V> apart = (swept.from <= swept.to) & (shaft.from <= shaft.to) & (between > (over_.apart > 0 ? over_.apart : missed)),
                   ball_takes = meet(swept, material);
  if (any(apart & ball_takes)) leave_for_later<V>(apart & ball_takes, family, row, lane);
  swept = either(where(~apart, swept.from, swept.to), where(~(apart & ball_takes), shaft.from, shaft.to));
  if (!over_.family[family].any()) return true;
  const MarksOf<V> now = ~for_later<V, TiltedBody::Kind::cylinder>(all, family, row, lane, shaft, left);
  swept = where(now, swept.from, swept.to);
  return true;
}

}  // namespace kadr
