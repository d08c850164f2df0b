// Thread cycle G76.7, and the functions for thread passes that G78.7 shares with it (spec/nct/19.B).

#include <algorithm>
#include <cmath>

#include "base/tolerance.h"
#include "control/emitter.h"
#include "control/fanuc/fanuc.h"
#include "control/fanuc/turning/turning.h"
#include "control/fanuc/turning/turning_plane.h"
#include "control/fanuc/words/coordinates.h"

namespace kadr::fanuc {
namespace {

/// Adds a motion that is synchronised with the spindle. Feed override and feed hold do not act on this motion.
Status cut_thread(Emitter& m, Vec2 to, double lead, double angle) {
  const std::size_t before = m.batch->size();
  KADR_TRY(go(m, MotionKind::thread, to));
  if (m.batch->size() == before) return {};
  Motion& motion = std::get<Motion>(m.batch->back().what);
  motion.own_override = motion.no_hold = true;
  motion.unit = FeedUnit::mm_per_rev;
  motion.feed = lead;
  MotionDetail& detail = detail_of(m, motion);
  detail.lead = lead;
  if (!fanuc_of(m).state.in_thread) detail.start_angle = angle;
  fanuc_of(m).state.in_thread = true;
  return {};
}

/// Executes the passes of a compound thread. The depth of pass n is Δ1·√n, but at least `least` more than the depth of the previous pass.
/// When the depth reaches the thread's height less the finishing allowance, the finishing passes follow.
class ThreadRun final : public SteppedCycleValue<ThreadRun> {
 public:
  explicit ThreadRun(const ThreadJob& job) : job_(job) {}

  Result<bool> next(Emitter& m) override {
    const double rough = job_.height - job_.data.allowance;
    if (depth_ < rough - tol::level) {
      ++pass_;
      depth_ = std::min(rough, std::max(job_.first * (job_.even ? pass_ : std::sqrt(pass_)), depth_ + job_.data.least));
    } else {
      if (finishing_ == job_.data.finishing) return false;
      depth_ = job_.height;
      ++finishing_;
    }
    KADR_TRY(thread_pass(m, pass()));
    end_pass(m);
    return true;
  }

 private:
  /// Returns a pass at the depth `depth_` below the crest. The start point of the pass is moved along the first axis in the direction of the
  /// cut, so that only the leading flank cuts. INFERRED: the NCT manual refers to the lathe's G76, and its clone Tomatech and LinuxCNC move
  /// the start in this direction, against spec/nct 19.B.
  ThreadPass pass() const {
    const Vec2& s = job_.start;
    const Vec2& t = job_.target;
    const double away = s.y < t.y ? -1 : 1;
    const double back = s.x < t.x ? -1 : 1;
    const bool turned = job_.zigzag && static_cast<std::uint64_t>(pass_) % 2 == 0;
    const double level = t.y + away * (job_.height - depth_);
    const SinCos half = sincos_deg(job_.data.tool_angle / 2);
    const double shift = (turned ? 1 : -1) * depth_ * half.sin / half.cos;
    const double thread_length = std::fabs(s.x - t.x);
    const double taper = job_.taper * (thread_length + shift) / thread_length;
    return {{s.x + back * shift, level + taper}, {t.x, level}, s, job_.lead, job_.angle, job_.chamfer, job_.rise};
  }

  ThreadJob job_;
  double pass_ = 0;
  double depth_ = 0;
  std::uint32_t finishing_ = 0;
};

}  // namespace

Status thread_pass(Emitter& m, const ThreadPass& pass) {
  fanuc_of(m).state.in_thread = false;
  KADR_TRY(go(m, MotionKind::rapid, pass.from));
  const Vec2 delta = pass.to - pass.from;
  double out = std::min(pass.chamfer, std::fabs(delta.x));
  if (out > tol::level) {
    const Vec2 begin = pass.from + (1 - out / std::fabs(delta.x)) * delta;
    const double away = pass.start.y < begin.y ? -1 : 1;
    out = std::min(out * pass.rise, std::fabs(pass.start.y - begin.y));
    KADR_TRY(cut_thread(m, begin, pass.lead, pass.angle));
    KADR_TRY(cut_thread(m, {pass.to.x, begin.y + away * out}, pass.lead, pass.angle));
  } else {
    KADR_TRY(cut_thread(m, pass.to, pass.lead, pass.angle));
  }
  KADR_TRY(go(m, MotionKind::rapid, {pass.to.x, pass.start.y}));
  return go(m, MotionKind::rapid, pass.start);
}

Result<double> thread_lead_of(BlockContext& m, const Call& call) {
  // On a lathe the constant surface speed during a thread is left to the program (spec/fanuc-t 6)
  const bool lathe = m.def.behaviour.lathe != Lathe::none;
  if (m.modal.surface_speed && !lathe) return fail(alarm(AlarmId::not_together, call.where, "G96", call.row->code));
  if (m.has('F') && m.has('E')) return fail(alarm(AlarmId::thread_definition, call.where));
  for (const char letter : {'F', 'E'})
    if (m.has(letter) && !(m.value(letter) > 0)) return fail(alarm(AlarmId::thread_definition, m.where(letter)));
  const double lead = take_lead(m);
  if (!(lead > 0)) return fail(alarm(AlarmId::thread_definition, call.where));
  return lead;
}

/// Executes the second block of G76.7, G76.7 X_ Z_ R_ P_ Q_ F_, which starts the thread passes.
Status compound_thread(Emitter& m, const Call& call) {
  ThreadJob job;
  const auto target = plane_target(m);
  if (!target) return fail(target.error());
  for (std::size_t i = 0; i < 2; ++i)
    if (!target->given[i]) return fail(alarm(AlarmId::word_missing, call.where, letter_of(m, i), call.row->code));
  for (const char letter : {'P', 'Q'}) {
    if (!m.has(letter)) return fail(alarm(AlarmId::word_missing, call.where, letter, call.row->code));
    if (!(m.value(letter) > 0)) return fail(alarm(AlarmId::value_out_of_range, m.where(letter), letter, m.value(letter)));
  }
  const auto lead = thread_lead_of(m, call);
  if (!lead) return fail(lead.error());
  job.data = fanuc_of(m).state.turning;
  job.start = plane_point(m);
  job.target = target->to;
  job.taper = m.length_value('R');
  job.height = m.length_value('P');
  job.first = m.length_value('Q');
  job.lead = *lead;
  job.chamfer = job.data.chamfer * *lead;
  if (job.height - job.data.allowance < 0) return fail(alarm(AlarmId::value_out_of_range, m.where('P'), 'P', m.value('P')));
  return start_thread(m, job);
}

Status start_thread(Emitter& m, const ThreadJob& job) {
  constexpr double max_passes = 1e6;
  const char first = m.has('Q') ? 'Q' : 'D';
  if (std::pow((job.height - job.data.allowance) / job.first, job.even ? 1 : 2) > max_passes)
    return fail(alarm(AlarmId::value_out_of_range, m.where(first), first, m.value(first)));
  if (std::fabs(job.start.x - job.target.x) <= tol::level) {
    const char letter = letter_of(m, 0);
    return fail(alarm(AlarmId::value_out_of_range, m.where(letter), letter, m.value(letter)));
  }
  m.running = std::make_unique<ThreadRun>(job);
  return {};
}

}  // namespace kadr::fanuc
