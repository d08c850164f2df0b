// Executes a drilling cycle whose steps the control's file lists (CycleRow::steps). Each call executes a part of one drilled hole, so that
// a cycle of any length needs constant memory. Used by control/interpreter.

#include "control/cycles/canned_cycle_run.h"

#include <algorithm>
#include <cmath>

#include "base/tolerance.h"
#include "control/cycles/hole_work.h"
#include "control/emitter.h"

namespace kadr {

void CannedCycleRun::start(const BlockContext& m, const Job& job) {
  cycle_ = job.cycle;
  job_ = job;
  spindle_ = m.modal.spindle;
  hole_ = 0;
  in_hole_ = false;
  const auto& steps = cycle_->steps;
  taps_ = std::find(steps.begin(), steps.end(), CycleStep::spindle_reverse) != steps.end();
  plain_ = m.dialect->drills_plainly() && m.transform.identity && !m.frames.turn && !m.modal.inch &&
           m.modal.contour == CompensationPhase::off && m.modal.feeds_of_axes == 0;
}

bool CannedCycleRun::repeats(const BlockContext& m) const {
  return plain_ && job_.holes == 1 && m.modal.absolute && (cycle_->needs & ~m.cycle_memory.known) == 0;
}

void CannedCycleRun::repeat_at(const BlockContext& m, const Axes& to) {
  Job job = job_;
  job.hole = to;
  job.clear = clear_level(m, job);
  start(m, job);
}

double CannedCycleRun::clear_level(const BlockContext& m, const Job& job) {
  return m.modal.retract_initial ? std::max(m.position.programmed[job.drill], job.level) : job.level;
}

/// Executes a limited number of steps in each call, even if the steps emit no action. Between two calls the interpreter checks whether
/// Ctrl-C has been pressed.
Status CannedCycleRun::next(Emitter& m) {
  for (std::size_t i = 0; i < batch_size && active(); ++i) {
    KADR_TRY(go_on(m));
    if (m.each_block || m.batch->size() >= batch_size) break;
  }
  return {};
}

Status CannedCycleRun::go_on(Emitter& m) {
  if (!in_hole_) {
    if (hole_ == job_.holes) {
      stop();
      return {};
    }
    return begin_hole(m);
  }
  if (step_ == cycle_->steps.size()) {
    in_hole_ = false;
    work_ = HoleWork::none;
    ++hole_;
    job_.hole[job_.first] += job_.step_first;
    job_.hole[job_.second] += job_.step_second;
    return {};
  }
  return step(m);
}

/// Moves to the start of a drilled hole. The tool first rises to R if it is below R (first drilled hole only), moves over the hole, and
/// descends to R (spec/mach3 4, preliminary motion).
Status CannedCycleRun::begin_hole(Emitter& m) {
  in_hole_ = true;
  step_ = 0;
  part_ = 0;
  work_ = taps_ ? HoleWork::taps : HoleWork::none;
  depth_ = job_.level;
  if (!job_.preliminary) return {};
  const double here = m.position.programmed[job_.drill];
  if (hole_ == 0 && here < job_.level - tol::level) KADR_TRY(drill_to(m, MotionKind::rapid, job_.level));
  KADR_TRY(plane_to(m, job_.hole[job_.first], job_.hole[job_.second]));
  return drill_to(m, MotionKind::rapid, job_.level);
}

Status CannedCycleRun::step(Emitter& m) {
  const CycleStep now = cycle_->steps[step_];
  if (now == CycleStep::peck_full) return peck(m, true);
  if (now == CycleStep::peck_break) return peck(m, false);
  if (now == CycleStep::passes_by_parameter) return passes(m);
  ++step_;
  switch (now) {
    case CycleStep::feed_bottom: return drill_to(m, MotionKind::feed, job_.bottom);
    case CycleStep::rapid_bottom: return drill_to(m, MotionKind::rapid, job_.bottom);
    case CycleStep::retract: return drill_to(m, MotionKind::rapid, job_.clear);
    case CycleStep::feed_retract: return drill_to(m, MotionKind::feed, job_.clear);
    case CycleStep::feed_face: return drill_to(m, MotionKind::feed, job_.back_face);
    case CycleStep::shift_out: return plane_to(m, job_.hole[job_.first] + job_.shift_first, job_.hole[job_.second] + job_.shift_second);
    case CycleStep::shift_back: return plane_to(m, job_.hole[job_.first], job_.hole[job_.second]);
    case CycleStep::dwell:
      if (job_.dwell > 0) m.emit(Dwell{job_.dwell});
      return {};
    case CycleStep::spindle_stop: m.emit(Spindle{SpindleDir::stop, 0}); return {};
    case CycleStep::spindle_reverse: m.emit(Spindle{spindle_ == SpindleDir::cw ? SpindleDir::ccw : SpindleDir::cw, m.modal.rpm}); return {};
    case CycleStep::spindle_restore:
      m.emit(Spindle{spindle_, m.modal.rpm});
      if (!taps_) work_ = HoleWork::none;
      return {};
    case CycleStep::orient:
      m.emit(Spindle{SpindleDir::orient, 0});
      work_ = HoleWork::clear_of_wall;
      return {};
    case CycleStep::stop: m.emit(Stop{false}); return {};
    default: return {};
  }
}

/// Drills one peck. After the peck the drill retracts to R and returns to just above the bottom reached so far (`full`, G83), or retracts
/// by a short distance (G73).
Status CannedCycleRun::peck(Emitter& m, bool full) {
  switch (part_) {
    case 0:
      depth_ = std::max(job_.bottom, depth_ - job_.peck);
      part_ = depth_ <= job_.bottom + tol::level ? 0 : 1;
      if (part_ == 0) {
        depth_ = job_.bottom;
        ++step_;
      }
      return drill_to(m, MotionKind::feed, depth_);
    case 1:
      part_ = 2;
      return drill_to(m, MotionKind::rapid, full ? job_.level : std::min(job_.level, depth_ + m.def.behaviour.return_chip_break));
    default: part_ = 0; return drill_to(m, MotionKind::rapid, std::min(job_.level, depth_ + m.def.behaviour.return_near));
  }
}

/// Executes the pecks of L83 of the 2С42 (table 9). Peck i starts with a rapid motion to R2 + i·R3, drills the depth of one peck, waits 0.3
/// s, and returns at rapid to R2. The last peck ends at R1.
Status CannedCycleRun::passes(Emitter& m) {
  const double down = job_.bottom < job_.level ? -job_.peck : job_.peck;
  switch (part_) {
    case 0: part_ = 1; return drill_to(m, MotionKind::rapid, depth_);
    case 1: {
      const double next = depth_ + down;
      const bool last = down < 0 ? next <= job_.bottom + tol::level : next >= job_.bottom - tol::level;
      depth_ = last ? job_.bottom : next;
      part_ = last ? 3 : 2;
      KADR_TRY(drill_to(m, MotionKind::feed, depth_));
      m.emit(Dwell{job_.dwell});
      return {};
    }
    case 2: part_ = 0; return drill_to(m, MotionKind::rapid, job_.return_level);
    default: ++step_; return drill_to(m, MotionKind::rapid, job_.clear);
  }
}

Status CannedCycleRun::drill_to(Emitter& m, MotionKind kind, double level) {
  double& at = m.position.programmed[job_.drill];
  if (std::fabs(at - level) <= tol::level) return {};
  if (plain_) {
    at = level;
    return line(m, kind, 1u << job_.drill);
  }
  Axes to = m.position.programmed;
  to[job_.drill] = level;
  return emit_in_hole(*m.batch, work_, [&] { return m.straight(kind, to, 1u << job_.drill); });
}

Status CannedCycleRun::plane_to(Emitter& m, double first, double second) {
  Axes& at = m.position.programmed;
  const AxisMask named = 1u << job_.first | 1u << job_.second;
  if (std::fabs(at[job_.first] - first) <= tol::level && std::fabs(at[job_.second] - second) <= tol::level) return {};
  if (plain_) {
    at[job_.first] = first;
    at[job_.second] = second;
    return line(m, MotionKind::rapid, named);
  }
  Axes to = at;
  to[job_.first] = first;
  to[job_.second] = second;
  return emit_in_hole(*m.batch, work_, [&] { return m.straight(MotionKind::rapid, to, named); });
}

/// Emits a straight motion to the programmed position, as Emitter::straight() does, but without the checks of straight().
Status CannedCycleRun::line(Emitter& m, MotionKind kind, AxisMask named) {
  m.set_plain_position(named);
  Motion& motion = m.add_motion(kind, named);
  motion.in_hole = work_;
  motion.of_cycle = true;
  if (kind == MotionKind::feed) m.set_feed(motion);
  return {};
}

}  // namespace kadr
