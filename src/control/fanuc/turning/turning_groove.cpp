// G74.7, G75.7: pecks along one axis, repeated at several positions along the other (spec/nct/19.B).

#include <algorithm>
#include <cmath>

#include "base/code_literals.h"
#include "base/tolerance.h"
#include "control/emitter.h"
#include "control/fanuc/fanuc.h"
#include "control/fanuc/turning/turning.h"
#include "control/fanuc/turning/turning_plane.h"

namespace kadr::fanuc {
namespace {

constexpr double max_steps = 1e6;

class GrooveRun final : public SteppedCycleValue<GrooveRun> {
 public:
  explicit GrooveRun(const GrooveJob& job) : job_(job), depth_(job.start.x), place_(job.start.y) {}

  Result<bool> next(Emitter& m) override {
    if (over_) return false;
    if (depth_ == job_.target.x) {
      KADR_TRY(leave(m));
      return true;
    }
    if (depth_ != job_.start.x && job_.back > 0) KADR_TRY(to(m, MotionKind::rapid, {toward(depth_, job_.start.x, job_.back), place_}));
    depth_ = toward(depth_, job_.target.x, job_.peck);
    KADR_TRY(to(m, MotionKind::feed, {depth_, place_}));
    return true;
  }

 private:
  /// Returns the coordinate in mm that a motion from `a` towards `b` reaches, if the motion is at most `step` mm long.
  static double toward(double a, double b, double step) { return std::fabs(b - a) <= step + tol::level ? b : a + (b < a ? -step : step); }

  Status to(Emitter& m, MotionKind kind, Vec2 at) const { return go(m, kind, job_.deep_first ? at : Vec2{at.y, at.x}); }

  /// Moves the tool off the wall, out of the groove and to the next position; after the last position, back to the start point.
  Status leave(Emitter& m) {
    KADR_TRY(to(m, MotionKind::rapid, {depth_, place_ + job_.relief}));
    KADR_TRY(to(m, MotionKind::rapid, {job_.start.x, place_ + job_.relief}));
    over_ = place_ == job_.target.y;
    place_ = over_ ? job_.start.y : toward(place_, job_.target.y, job_.step);
    depth_ = job_.start.x;
    KADR_TRY(to(m, MotionKind::rapid, {job_.start.x, place_}));
    end_pass(m);
    return {};
  }

  GrooveJob job_;
  double depth_, place_;
  bool over_ = false;
};

/// Reads the length of a peck, or the distance between pecking positions: P is along the second axis of the plane, Q along the first.
Result<double> distance(const Emitter& m, const Call& call, char letter) {
  if (!m.has(letter)) return fail(alarm(AlarmId::word_missing, call.where, letter, call.row->code));
  if (!(m.value(letter) > 0)) return fail(alarm(AlarmId::value_out_of_range, m.where(letter), letter, m.value(letter)));
  return m.length_value(letter);
}

}  // namespace

Status groove(Emitter& m, const Call& call) {
  GrooveJob job;
  job.deep_first = call.row->arg == 74.7_g;
  const std::size_t deep = job.deep_first ? 0 : 1;
  const auto target = plane_target(m);
  if (!target) return fail(target.error());
  if (!target->given[deep]) return fail(alarm(AlarmId::word_missing, call.where, letter_of(m, deep), call.row->code));
  const auto turned = [&](Vec2 v) { return job.deep_first ? v : Vec2{v.y, v.x}; };
  job.start = turned(plane_point(m));
  job.target = turned(target->to);
  const char peck = job.deep_first ? 'Q' : 'P', step = job.deep_first ? 'P' : 'Q';
  const auto by = distance(m, call, peck);
  if (!by) return fail(by.error());
  job.peck = *by;
  if (std::fabs(job.target.y - job.start.y) > tol::level) {
    const auto between = distance(m, call, step);
    if (!between) return fail(between.error());
    job.step = *between;
  } else {
    job.target.y = job.start.y;
  }
  if (m.has('R') && !(m.value('R') >= 0)) return fail(alarm(AlarmId::value_out_of_range, m.where('R'), 'R', m.value('R')));
  // INFERRED: in a single groove the tool has no free side, so R has no effect
  if (job.target.y != job.start.y) job.relief = (job.target.y < job.start.y ? 1 : -1) * m.length_value('R');
  job.back = fanuc_of(m).state.turning.groove_back;
  KADR_TRY(m.feed_known(call.where));
  return start_groove(m, job, peck, step);
}

Status start_groove(Emitter& m, const GrooveJob& job, char peck, char step) {
  if (job.peck > 0 && std::fabs(job.target.x - job.start.x) / job.peck > max_steps)
    return fail(alarm(AlarmId::value_out_of_range, m.where(peck), peck, m.value(peck)));
  if (job.step > 0 && std::fabs(job.target.y - job.start.y) / job.step > max_steps)
    return fail(alarm(AlarmId::value_out_of_range, m.where(step), step, m.value(step)));
  m.running = std::make_unique<GrooveRun>(job);
  return {};
}

}  // namespace kadr::fanuc
