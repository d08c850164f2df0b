// Executes an arc under unequal scale factors, which is part of an ellipse (Mach3 10.7.15). The arc becomes short straight motions. They
// are emitted one at a time, so that an arc of any length needs constant memory. Used by control/interpreter.

#include "control/cycles/ellipse_run.h"

#include <algorithm>
#include <cmath>

#include "base/tolerance.h"
#include "control/emitter.h"

namespace kadr {
namespace {

constexpr double max_chords = 1e6;

}  // namespace

void EllipseRun::start(const Job& job) {
  job_ = job;
  done_ = 0;
  const Vec2 arm = Vec2{job.from[job.first], job.from[job.second]} - job.center;
  const double radius = length(arm) * job.greatest_scale;
  // A chord over the angle a deviates from a circle of radius r by r·(1 − cos a/2). With the largest scaled radius as r, the chord deviates
  // from the ellipse by at most this length.
  const double ratio = std::min(tol::ellipse_chord / std::max(radius, tol::ellipse_chord), 1.0);
  const double step_deg = 2 * std::acos(1 - ratio) / rad_per_deg;
  pieces_ = static_cast<std::uint32_t>(std::clamp(std::ceil(std::fabs(job.sweep_deg) / step_deg), 1.0, max_chords));
}

Status EllipseRun::next(Emitter& m) {
  const double part = static_cast<double>(++done_) / pieces_;
  const bool last = done_ == pieces_;
  Axes to = job_.to;
  if (!last) {
    const Vec2 first_arm = Vec2{job_.from[job_.first], job_.from[job_.second]} - job_.center;
    const Vec2 last_arm = Vec2{job_.to[job_.first], job_.to[job_.second]} - job_.center;
    const double grown = 1 + part * (length(last_arm) / std::max(length(first_arm), tol::same_point) - 1);
    const Vec2 point = job_.center + grown * rotated(first_arm, part * job_.sweep_deg);
    for (std::size_t a = 0; a < max_axes; ++a) to[a] = job_.from[a] + part * (job_.to[a] - job_.from[a]);
    to[job_.first] = point.x;
    to[job_.second] = point.y;
  }
  if (last) stop();
  return m.straight(MotionKind::feed, to, job_.named);
}

}  // namespace kadr
