// Converts the words of G73 and G81 to G89 to levels and positions of drilled holes, and checks them before the tool moves (Mach3
// 10.7.22–10.7.24).

#include <bit>
#include <cmath>

#include "base/tolerance.h"
#include "control/functions/functions.h"

namespace kadr {
namespace {

constexpr double max_pecks = 1e6;

struct CycleAxes {
  std::size_t first, second, drill;
};
/// Returns the two axes of the plane and the drilling axis; on Mach3 XY and Z, YZ and X, or XZ and Y.
CycleAxes cycle_axes(Plane plane) {
  switch (plane) {
    case Plane::zx: return {0, 2, 1};
    case Plane::yz: return {1, 2, 0};
    default: return {0, 1, 2};
  }
}

class Drilling {
 public:
  Drilling(Emitter& m, const Call& call)
      : m_(m), call_(call), cycle_(m.def.cycles[call.row->cycle - 1u]), axes_(cycle_axes(m.modal.plane)), memory_(m.cycle_memory) {}

  Status run() {
    const auto row = static_cast<std::int16_t>(call_.row - m_.def.codes.data());
    m_.modal.motion = MotionMode::cycle;
    m_.modal.motion_row = row;
    // another cycle or motion was executed since the last block of this cycle, so only the stored R remains valid (Mach3 10.7.24)
    if (memory_.row != row) {
      CycleMemory memory;
      memory.level = memory_.level;
      memory.known = memory_.known & letter_bit('R');
      memory_ = memory;
    }
    memory_.row = row;
    KADR_TRY(allowed());
    KADR_TRY(resume_from());
    CannedCycleRun::Job job;
    KADR_TRY(levels(job));
    KADR_TRY(holes(job));
    m_.canned_cycle_run.start(m_, job);
    return {};
  }

 private:
  char letter_of(std::size_t axis) const { return m_.letters.axis_letter[axis]; }

  Status allowed() {
    const Span at = call_.where;
    bool any = false;
    for (std::size_t a = 0; a < 3; ++a) any = any || m_.has(letter_of(a));
    if (!any) return fail(alarm(AlarmId::no_axis_word, at, call_.row->code));
    if (m_.modal.feed_mode == FeedMode::inverse_time) return fail(alarm(AlarmId::not_together, at, call_.row->code, "G93"));
    if (m_.modal.radius_side != 0) return fail(alarm(AlarmId::compensation_active, at, call_.row->code));
    if (m_.modal.polar && (m_.has('X') || m_.has('Y'))) return fail(alarm(AlarmId::polar_motion, at, call_.row->code));
    KADR_TRY(m_.feed_known(at));
    for (std::size_t a = 3; a < m_.axis_count; ++a) {
      const char letter = letter_of(a);
      if (letter == 0 || !m_.has(letter)) continue;
      const double to = m_.axis_target(*m_.word(letter), a);
      if (std::fabs(to - m_.position.programmed[a]) > tol::same_angle) return fail(alarm(AlarmId::rotary_motion, m_.where(letter), letter));
    }
    if (cycle_.needs_spindle_cw && m_.modal.spindle != SpindleDir::cw) return fail(alarm(AlarmId::spindle_direction, at, call_.row->code));
    if (cycle_.needs_spindle && m_.modal.spindle != SpindleDir::cw && m_.modal.spindle != SpindleDir::ccw)
      return fail(alarm(AlarmId::spindle_not_turning, at, call_.row->code));
    return {};
  }

  /// Updates the stored words, which remain valid while blocks of the same cycle follow. The word of the drilling axis, whatever its
  /// letter, is stored as Z in memory_.bottom.
  Status resume_from() {
    const char drill = letter_of(axes_.drill);
    const auto take = [&](char letter, char kept, double& to, bool is_length) {
      if (!m_.has(letter)) return;
      to = is_length ? m_.length_value(letter) : m_.value(letter);
      memory_.known |= letter_bit(kept);
    };
    take(drill, 'Z', memory_.bottom, true);
    take('R', 'R', memory_.level, true);
    take('Q', 'Q', memory_.peck, true);
    take('P', 'P', memory_.dwell, false);
    take('I', 'I', memory_.i, true);
    take('J', 'J', memory_.j, true);
    take('K', 'K', memory_.k, true);
    take_left_out();
    std::uint64_t missing = cycle_.needs & ~(memory_.known | taken_);
    if (missing != 0) {
      char letter = static_cast<char>('A' + std::countr_zero(missing));
      if (letter == 'Z') letter = drill;
      return fail(alarm(AlarmId::word_missing, call_.where, letter, call_.row->code));
    }
    if (((cycle_.needs & ~taken_) & letter_bit('Q')) != 0 && !(memory_.peck > 0))
      return fail(alarm(AlarmId::cycle_peck, m_.where('Q'), memory_.peck));
    if (memory_.dwell < 0) return fail(alarm(AlarmId::value_out_of_range, m_.where('P'), 'P', memory_.dwell));
    return {};
  }

  /// Replaces words that neither this block nor an earlier block has; the manual's example G83 Z-0.6 needs this (Mach3 10.7.6). INFERRED:
  /// without R the cycle starts at the tool's position; without Q the drill reaches the bottom in one peck. The replaced values are not
  /// stored for the next drilled hole.
  void take_left_out() {
    taken_ = cycle_.left_out & cycle_.needs & ~memory_.known;
    if ((cycle_.needs & ~memory_.known & letter_bit('Z')) != 0) return;  // the word Z is missing; resume_from() reports this fault later
    if ((taken_ & letter_bit('R')) != 0) {
      memory_.level = m_.modal.absolute ? m_.position.programmed[axes_.drill] : 0;
      warn_of('R', memory_.level);
    }
    if ((taken_ & letter_bit('Q')) == 0) return;
    memory_.peck = m_.modal.absolute ? memory_.level - memory_.bottom : -memory_.bottom;
    warn_of('Q', memory_.peck);
  }

  void warn_of(char letter, double taken) {
    m_.warn(warning(AlarmId::cycle_word_taken, call_.where, letter, call_.row->code, m_.modal.inch ? taken / mm_per_inch : taken));
  }

  /// Computes the levels. In G90 R and Z are coordinates. In G91 R is the distance from the tool's position, and Z is the distance from R.
  Status levels(CannedCycleRun::Job& job) const {
    const double here = m_.position.programmed[axes_.drill];
    job.level = m_.modal.absolute ? memory_.level : here + memory_.level;
    job.bottom = m_.modal.absolute ? memory_.bottom : job.level + memory_.bottom;
    if (job.level < job.bottom - tol::level)
      return fail(alarm(AlarmId::cycle_level, m_.has('R') ? m_.where('R') : call_.where, job.level, job.bottom));
    job.drill = axes_.drill;
    job.clear = CannedCycleRun::clear_level(m_, job);
    job.peck = memory_.peck;
    job.dwell = memory_.dwell;
    job.shift_first = memory_.i;
    job.shift_second = memory_.j;
    job.back_face = m_.modal.absolute ? memory_.k : job.bottom + memory_.k;
    if (job.peck > 0 && (job.level - job.bottom) / job.peck > max_pecks) return fail(alarm(AlarmId::cycle_peck, m_.where('Q'), job.peck));
    for (const double level : {job.level, job.bottom, job.back_face})
      if (!(std::fabs(level) <= farthest)) return fail(alarm(AlarmId::position_out_of_range, call_.where, letter_of(axes_.drill), level));
    return {};
  }

  /// Checks each point that the tool reaches at a drilled hole, in programmed and work coordinates, because no motion may fail after the
  /// first one.
  Status within_reach(const CannedCycleRun::Job& job, Axes hole) const {
    for (const double level : {job.level, job.bottom, job.clear, job.back_face}) {
      hole[axes_.drill] = level;
      const Axes work = m_.transform.identity ? hole : m_.transform.to_work(hole);
      for (std::size_t a = 0; a < m_.axis_count; ++a)
        if (!(std::fabs(work[a]) <= farthest) || !(std::fabs(hole[a]) <= farthest))
          return fail(alarm(AlarmId::position_out_of_range, call_.where, letter_of(a), work[a]));
    }
    return {};
  }

  Status holes(CannedCycleRun::Job& job) const {
    job.cycle = &cycle_;
    job.first = axes_.first;
    job.second = axes_.second;
    job.drill = axes_.drill;
    job.hole = m_.position.programmed;
    for (const std::size_t a : {axes_.first, axes_.second}) {
      const char letter = letter_of(a);
      if (!m_.has(letter)) continue;
      job.hole[a] = m_.axis_target(*m_.word(letter), a);
      if (!m_.modal.absolute) (a == axes_.first ? job.step_first : job.step_second) = job.hole[a] - m_.position.programmed[a];
    }
    if (m_.has('L')) {
      const double repeats = m_.value('L');
      if (repeats != std::floor(repeats) || repeats < 1 || repeats > 1e8)
        return fail(alarm(AlarmId::cycle_repeats, m_.where('L'), repeats));
      job.holes = static_cast<std::uint32_t>(repeats);
    }
    Axes last = job.hole;
    last[axes_.first] += job.step_first * (job.holes - 1);
    last[axes_.second] += job.step_second * (job.holes - 1);
    KADR_TRY(within_reach(job, job.hole));
    return job.holes == 1 ? Status() : within_reach(job, last);
  }

  Emitter& m_;
  const Call& call_;
  const CycleRow& cycle_;
  CycleAxes axes_;
  CycleMemory& memory_;
  std::uint64_t taken_ = 0;  // letters of the missing words whose values take_left_out() has set
};

}  // namespace

Status functions::cycle(Emitter& m, const Call& call) { return Drilling(m, call).run(); }

}  // namespace kadr
