// Runs a drilling cycle one operation at a time (spec/nct/18.0, 18.1). One repetition of the cycle drills one hole. The memory needed
// depends neither on the number of repetitions (word L) nor on the depth. Used by control/fanuc/drilling/drilling.

#include "control/fanuc/drilling/drilling_run.h"

#include <algorithm>
#include <cmath>

#include "action/by_kind.h"
#include "base/code_literals.h"
#include "base/tolerance.h"
#include "config/control/drill_steps.h"
#include "control/cycles/hole_work.h"
#include "control/fanuc/fanuc.h"
#include "control/fanuc/words/coordinates.h"
#include "control/functions/functions.h"
#include "control/macro_b/dialect/blocks.h"

namespace kadr::fanuc {

namespace {

using enum DrillStep;

const DrillCycle& cycle_of(const DrillingRun::Job& job) { return *drill_cycle(job.back_boring ? back_boring : job.code); }

/// Executes M3, M4, M5 or M19 on behalf of the cycle.
Status spindle_function(Emitter& m, std::int32_t code) {
  const std::int32_t row = m.def.row_of('M', code * 10);
  if (row < 0) return {};
  return functions::spindle_code(m, {&m.def.codes[static_cast<std::size_t>(row)], nullptr, m.block->where});
}

bool is_there(const BlockContext& m, const Axes& to, AxisMask named) {
  for (std::size_t a = 0; a < m.axis_count; ++a)
    if ((named >> a & 1u) != 0 && std::fabs(to[a] - m.position.programmed[a]) > tol::level) return false;
  return true;
}

/// Moves over the hole at rapid. If setting 57 requests it, the motion ends with an exact stop (spec/haas 8.1).
Status to_hole(Emitter& m, const Axes& to, AxisMask named) {
  const std::size_t before = m.batch->size();
  KADR_TRY(m.straight(MotionKind::rapid, to, named));
  if (!fanuc_of(m).settings.holes_exact || m.batch->size() == before) return {};
  if (Motion* const motion = motion_of(m.batch->back())) motion->exact = true;
  return {};
}

}  // namespace

Status hole_position(const BlockContext& m, std::size_t drill, Axes& to, AxisMask& named) {
  Word* hidden = nullptr;
  for (std::uint32_t i = 0; i < m.block->word_count; ++i) {
    Word& w = m.block->words[i];
    if (w.address != 0 && (m.letters.axes & letter_bit(w.address)) != 0 && m.def.address(w.address).axis == drill) hidden = &w;
  }
  const char address = hidden != nullptr ? hidden->address : '\0';
  if (hidden != nullptr) hidden->address = 0;
  const Status status = m.target(to, named);
  if (hidden != nullptr) hidden->address = address;
  return status;
}

Status over_hole(Emitter& m, std::size_t drill) {
  Axes to;
  AxisMask named = 0;
  KADR_TRY(hole_position(m, drill, to, named));
  if (is_there(m, to, named) && fanuc_of(m).rolled == 0) return {};
  return to_hole(m, to, named);
}

double tapping_rpm(const BlockContext& m) { return fanuc_of(m).spindle(fanuc_of(m).state.current_spindle).rpm; }

DrillingRun::DrillingRun(Job job) : job_(std::move(job)), cycle_(cycle_of(job_)), peck_(job_.peck) {}

Status DrillingRun::check(const Emitter& m) const {
  const bool turns = is_tap() ? tapping_rpm(m) > 0 : fanuc_of(m).spindle_rpm(m) > 0;
  if (turns) return {};
  const bool dwells = job_.dwell > 0 && std::count(cycle_.steps.begin(), cycle_.steps.end(), pause) != 0;
  const bool by_unit = m.def.behaviour.dwell_unit == DwellUnit::seconds;  // elsewhere P is always a time
  const bool revolutions = by_unit && m.modal.feed_mode == FeedMode::per_revolution && !fanuc_of(m).settings.dwell_seconds;
  // Without rotation only a tap and a dwell in revolutions would never end (8), so other cycles are not checked.
  if (!is_tap() && !(dwells && revolutions)) return {};
  const std::int16_t row = m.modal.rows[fanuc_of(m).drilling_group];
  const std::string_view code = row < 0 ? std::string_view() : std::string_view(m.def.codes[static_cast<std::size_t>(row)].code);
  return fail(alarm(AlarmId::spindle_not_turning, m.block->where, code));
}

Result<bool> DrillingRun::next(Emitter& m) {
  if (pass_ == job_.passes) return false;
  if (at_ == 0) {
    KADR_TRY(emit_of_cycle(*m.batch, [&] { return begin_pass(m); }));
    ++at_;
    return true;
  }
  const DrillStep now = cycle_.steps[at_ - 1];
  if (now == end) {
    if (job_.clamp_code != 0) m.emit(MachineFunction{job_.clamp_code + 1, {}, {}, std::uint8_t{0}});
    if (job_.release_dwell > 0) m.emit(Dwell{job_.release_dwell});
    single_block(m);
    at_ = 0;
    ++pass_;
    return true;
  }
  if (now == cw || now == ccw) stands_off_ = false;
  const HoleWork work = stands_off_ ? HoleWork::clear_of_wall : taps() ? HoleWork::taps : HoleWork::none;
  KADR_TRY(emit_in_hole(*m.batch, work, [&] { return step(m, now); }));
  if (now == orient) stands_off_ = true;
  if (part_ == 0) ++at_;
  return true;
}

/// Moves over a hole of a pattern.
Status DrillingRun::over_point(Emitter& m, Vec2 point) {
  const PlaneAxes& plane = m.modal.axes;
  Axes to = m.position.programmed;
  to[plane.first] = point.x;
  to[plane.second] = point.y;
  const AxisMask named = 1U << plane.first | 1U << plane.second;
  return is_there(m, to, named) ? Status() : to_hole(m, to, named);
}

/// Executes operation 1 (the motion over the hole) of one repetition. For the first repetition without a hole pattern, operation 1 was
/// executed before the functions of the block.
Status DrillingRun::begin_pass(Emitter& m) {
  if (!job_.points.empty()) KADR_TRY(over_point(m, job_.points[pass_]));
  else if (pass_ != 0) KADR_TRY(over_hole(m, job_.axis));
  if (pass_ != 0 && job_.clamp_code != 0) m.emit(MachineFunction{job_.clamp_code, {}, {}, std::uint8_t{0}});
  hole_ = m.position.programmed;
  depth_ = job_.level;
  peck_ = job_.peck;
  cut_ = 0;
  part_ = 0;
  stands_off_ = false;
  single_block(m);
  return {};
}

Status DrillingRun::step(Emitter& m, DrillStep step) {
  switch (step) {
    case approach: return rapid(m, job_.level);
    case stop: single_block(m); return {};
    case cut:
    case cut_fixed: return feed(m, job_.bottom, 100);
    case break_chips: return pecks(m, false);
    case clear_chips: return pecks(m, true);
    case tap_down: return tap_in(m);
    case pause: return dwell(m);
    case back: return feed(m, job_.level, job_.out_percent);
    case back_fixed: return feed(m, job_.level, 100);
    case tap_up: return tap(m, job_.level, job_.out_percent);
    case retract: return rapid(m, job_.to_initial ? job_.initial : job_.level);
    case clear: return job_.to_initial ? rapid(m, job_.initial) : Status();
    case initial: return rapid(m, job_.initial);
    case shift_out: return shift(m, job_.shift);
    case shift_back: return shift(m, {});
    default: return spindle_step(m, step);
  }
}

Status DrillingRun::spindle_step(Emitter& m, DrillStep step) {
  switch (step) {
    case cw: return spindle_function(m, 3);
    case ccw: return spindle_function(m, 4);
    case halt: return spindle_function(m, 5);
    case orient: return spindle_function(m, 19);
    case catch_spindle: return close_loop(m);
    case manual: m.emit(Stop{false}); return {};
    default: return {};
  }
}

/// Executes one step of peck drilling (18.1.1, 18.1.7): the tool cuts by the depth Q, retracts at rapid by the distance E or to R, and
/// returns at rapid to the height E above the depth reached. The last peck cuts the remaining depth.
Status DrillingRun::pecks(Emitter& m, bool to_level) {
  switch (part_) {
    case 1: part_ = 2; return rapid(m, job_.level - down() * job_.rise / scale(m));
    case 2: part_ = 3; return rapid(m, back_to(m));
    default: {
      const double before = depth_;
      depth_ = next_depth(m);
      cut_ += std::fabs(depth_ - before) * scale(m);
      if (job_.less > 0) peck_ = std::max(peck_ - job_.less, job_.least);
      const bool clears = to_level || (job_.clear_after > 0 && cut_ >= job_.clear_after - tol::level);
      if (clears) cut_ = 0;
      part_ = depth_ == job_.bottom ? 0 : clears ? 1 : 2;
      return feed(m, depth_, 100);
    }
  }
}

/// Executes one step of tapping with pecks (18.1.9, 18.1.10). INFERRED: every motion is synchronised with the spindle; the feed of N1507
/// applies to the return to R, the feed of N1506 to the return by E.
Status DrillingRun::tap_in(Emitter& m) {
  if (job_.peck == 0) return tap(m, job_.bottom, 100);
  switch (part_) {
    case 1: part_ = 2; return tap(m, job_.level, job_.between_percent);
    case 2: part_ = 3; return tap(m, back_to(m), job_.pecks_to_level ? 100 : job_.out_percent);
    default:
      depth_ = next_depth(m);
      part_ = depth_ == job_.bottom ? 0 : job_.pecks_to_level ? 1 : 2;
      return tap(m, depth_, 100);
  }
}

/// Executes operation 4 of rigid tapping (18.1.9): M19, or only the closing of the spindle's position loop.
Status DrillingRun::close_loop(Emitter& m) {
  if (job_.orients_tap) return spindle_function(m, 19);
  const int number = fanuc_of(m).state.current_spindle;
  const int code = fanuc_of(m).settings.spindles[static_cast<std::size_t>(number)].closing_code;
  if (code == 0) {
    SpindleState& s = fanuc_of(m).spindle(number);
    s.loop_closed = true;
    s.referenced = false;
    s.dir = SpindleDir::stop;
    return {};
  }
  return fanuc_of(m).spindle_machine_code(m, code, m.block->where);
}

/// Executes dwell P, in seconds or (G95) in revolutions. INFERRED: in rigid tapping the spindle is in its position loop, and the time of a
/// revolution follows from the programmed speed S.
Status DrillingRun::dwell(Emitter& m) {
  if (!(job_.dwell > 0)) return {};
  if (m.def.behaviour.dwell_unit != DwellUnit::seconds) {
    m.emit(Dwell{job_.dwell});
    return {};
  }
  const bool revolutions = m.modal.feed_mode == FeedMode::per_revolution && !fanuc_of(m).settings.dwell_seconds;
  if (is_tap() && revolutions) {
    m.emit(Dwell{job_.dwell * 60 / tapping_rpm(m)});
    return {};
  }
  const auto seconds = dwell_seconds(m, job_.dwell, m.block->where);
  if (!seconds) return fail(seconds.error());
  m.emit(Dwell{*seconds});
  return {};
}

/// Shifts the tool in the plane from the hole's position by `by`, in mm of machine travel. Mirroring, rotation and scaling do not act on
/// the shift (18.0).
Status DrillingRun::shift(Emitter& m, Vec2 by) {
  const PlaneAxes& plane = m.modal.axes;
  Axes to = hole_;
  to[job_.axis] = m.position.programmed[job_.axis];
  if (!(by == Vec2{})) {
    Axes work = m.transform.to_work(to);
    work[plane.first] += by.x;
    work[plane.second] += by.y;
    to = m.transform.to_programmed(work);
  }
  const AxisMask named = 1u << plane.first | 1u << plane.second;
  return is_there(m, to, named) ? Status() : m.straight(MotionKind::rapid, to, named);
}

Status DrillingRun::rapid(Emitter& m, double level) {
  Axes to = m.position.programmed;
  if (std::fabs(to[job_.axis] - level) <= tol::level) return {};
  to[job_.axis] = level;
  return m.straight(MotionKind::rapid, to, 1u << job_.axis);
}

Status DrillingRun::feed(Emitter& m, double level, double percent) {
  Axes to = m.position.programmed;
  if (std::fabs(to[job_.axis] - level) <= tol::level) return {};
  to[job_.axis] = level;
  KADR_TRY(m.straight(MotionKind::feed, to, 1u << job_.axis));
  Motion& motion = std::get<Motion>(m.batch->back().what);
  motion.feed *= percent / 100;
  // 18.2: feed override and feed hold have no effect in a tapping motion
  if (taps() && !is_tap()) motion.own_override = motion.no_hold = true;
  return {};
}

/// Taps to a level (18.1.9). The spindle turns one revolution per thread lead, with G84.2 clockwise into the hole. The feed is emitted in
/// mm/min, because the spindle turns with the axis.
Status DrillingRun::tap(Emitter& m, double level, double percent) {
  const double travel = level - m.position.programmed[job_.axis];
  if (std::fabs(travel) <= tol::level) return {};
  const double rpm = tapping_rpm(m);
  const double lead = m.modal.feed_mode == FeedMode::per_revolution ? m.modal.feed : m.modal.feed / rpm;
  KADR_TRY(feed(m, level, percent));
  Motion& motion = std::get<Motion>(m.batch->back().what);
  motion.unit = FeedUnit::mm_per_min;
  motion.feed = lead * rpm * percent / 100;
  const double hand = job_.code == 84.2_g ? 1 : -1;
  detail_of(m, motion).turn = hand * down() * travel * scale(m) / lead * 360;
  return {};
}

void DrillingRun::single_block(Emitter& m) const {
  if (stops_each_block(m)) m.emit(Stop{false, StopReason::single_block});
}

/// Returns the machine travel in mm per programmed mm along the drilling axis.
double DrillingRun::scale(const BlockContext& m) const { return std::fabs(m.transform.scale[job_.axis]); }

double DrillingRun::next_depth(const BlockContext& m) const {
  const double next = depth_ + down() * peck_ / scale(m);
  return down() * (job_.bottom - next) <= tol::level ? job_.bottom : next;
}

/// Returns the level at the distance E above the depth reached, but not above R.
double DrillingRun::back_to(const BlockContext& m) const {
  const double back = depth_ - down() * job_.clearance / scale(m);
  return down() * (back - job_.level) < 0 ? job_.level : back;
}

}  // namespace kadr::fanuc
