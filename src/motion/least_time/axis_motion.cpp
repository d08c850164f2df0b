// AxisMotion converts Steps into the axes' motion in time. It computes each motion's curve in machine coordinates, the positions at which
// the axes stop, and the duration of pauses. The Planner then computes the speeds. Used by cli and motion.

#include "motion/least_time/axis_motion.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "action/by_kind.h"
#include "base/tolerance.h"

namespace kadr {
namespace {

constexpr double shortest_rise = 1e-3;  // Build-up time of the acceleration, s, if the set-up states no jerk time: one servo period.
constexpr double unlimited_acceleration = 1e6;  // mm/s²: 100 g
// Chord error of an arc, as a fraction of the tolerance. With this fraction, the length of a chord is a tenth of the width of the rounded
// corners at its ends.
constexpr double chord_of_tolerance = 0.04;

/// Returns the limits that the set-up states for this axis, or otherwise for all axes ("*"); nullptr if the set-up states neither.
const AxisLimits* of_axis(const Setup& setup, const std::string& axis) {
  for (const std::string& name : {axis, std::string("*")})
    if (const auto found = setup.machine.find(name); found != setup.machine.end()) return &found->second;
  return nullptr;
}

/// Returns true for actions during which the axes are at rest. NCT 7.0.1: the motion stops if the control executes a function after it.
/// Words that only set a value (speed, coolant, tool to be prepared, message) do not stop the motion.
bool needs_rest(const Action& action) {
  return by_kind(
      action, [](const ToolChange& change) { return !change.there; }, [](const MachineFunction& function) { return !function.by_control; },
      same<Dwell, Stop, Sync, Spindle>(true),
      same<Motion, Speed, CoolantSwitch, ToolSelect, AuxiliaryFunction, Message, FrameChange, SurfaceSpeed, ZoneChange, Couple, Uncouple,
           CompensationBreak, CompensationCorner, CompensationCheck>(false));
}

double distance(const Axes& from, const Axes& to) {
  double squares = 0;
  for (std::size_t a = 0; a < max_axes; ++a) squares += (to[a] - from[a]) * (to[a] - from[a]);
  return std::sqrt(squares);
}

/// Returns the factor that converts a tolerance in mm to the tolerance of a polar or cylindrical motion, whose rotary axis is in degrees.
/// At a radius above 180/π mm, one degree moves the tool by more than 1 mm, so the tolerance is reduced by the ratio of the two.
double degrees_for_mm(const Curve& curve, const Motion& motion) {
  if (curve.surface() == PathSurface::plane) return 1;
  const MotionDetail& detail = *motion.detail;
  const double radius =
      curve.surface() == PathSurface::cylinder ? detail.radius : std::max(length(detail.flat_from), length(detail.flat_to));
  return 1 / std::max(1.0, radius * rad_per_deg);
}

}  // namespace

MotionLimits motion_limits(const MachineProfile& profile, const Setup& setup, const std::vector<std::string>& axes) {
  constexpr double per_second = 1.0 / 60;
  MotionLimits limits;
  // The rapid override is not applied here. It lengthens the programmed time of rapid motions, but it does not change the axis limits.
  Setup at_full_rate = setup;
  at_full_rate.rapid_override = 100;
  const Rates rates = rates_of(profile, at_full_rate, axes);
  for (std::size_t i = 0; i < std::min(axes.size(), max_axes); ++i) {
    const auto found = profile.axes.find(axes[i]);
    const AxisProfile own = found == profile.axes.end() ? AxisProfile{} : found->second;
    const AxisLimits* const stated = of_axis(setup, axes[i]);
    double acceleration = own.acceleration, jerk = own.jerk;
    if (stated != nullptr && stated->acceleration) {
      acceleration = *stated->acceleration;
      const double rising = stated->jerk_time.value_or(own.acceleration / own.jerk);
      jerk = acceleration / std::max(rising, shortest_rise);
    }
    if (stated != nullptr && stated->no_acceleration) acceleration = unlimited_acceleration, jerk = acceleration / shortest_rise;
    limits.speed.push_back(rates.rapid[i] * per_second);
    limits.acceleration.push_back(acceleration);
    limits.jerk.push_back(jerk);
  }
  return limits;
}

AxisMotion::AxisMotion(const AxisRoles& roles, const MotionLimits& limits, double tolerance, const ToolPosition& start, Planner::Sink sink)
    : roles_(roles),
      tolerance_(tolerance),
      now_(limits),
      sink_(std::move(sink)),
      planner_(limits, [this](TimedCells& cells) { deliver(cells); }),
      line_([this](const Axes& to, double feed, double corner, bool on_curve, std::uint64_t tag) {
        planner_.line_to(to.data(), feed, corner, on_curve, tag);
      }) {
  for (std::size_t a = 0; a < limits.speed.size(); ++a) rapid_[a] = limits.speed[a] * 60;
  begin_at(start);
}

void AxisMotion::begin_at(const ToolPosition& start) {
  planner_.begin(start.machine.data());
  now_.threads.begin(start.machine);
}

void AxisMotion::start(const Setup& setup, const std::vector<std::string>& axes, double most_rpm) {
  now_.spindle.limit(most_rpm);
  now_.spindle.start(setup.spindle(), setup.spindle_override / 100);
  for (const auto& [number, spindle] : setup.spindles)
    now_.spindle.start(spindle, setup.spindle_override / 100, static_cast<std::size_t>(number));
  now_.smoothing = Smoothing(smoothing_rules(setup, axes));
}

/// Records the motion that is planned next. Returns the number of this record. The number is the tag of the motion's cells until these
/// cells are emitted.
std::uint64_t AxisMotion::record(Spent spent, Switches switches, const Motion& motion) {
  Record record{++now_.motions, spent.tag(), switches, now_.spindle.turning(), motion.own_override ? 1 : now_.spindle.override_part(), 0};
  SurfaceSpeed& surface = record.spindle.surface;
  if (surface.on && surface.axis < max_axes) record.shift = motion.to[surface.axis] - motion.machine[surface.axis];
  // nct 11.5.1: at the start of a rapid motion the spindle already changes to the speed for the end position.
  if (spent.on == Spent::On::rapid) {
    record.spindle.arrive(motion.to);
    surface.on = false;
  }
  now_.records.push_back(record);
  return now_.motions;
}

/// Returns the spindle speed in a cell, degrees per second. With constant surface speed it is the speed in the middle of the cell.
double AxisMotion::spindle_rate(const Record& record, const TimedCells& cells, std::size_t cell) {
  const SpindleTurning& spindle = record.spindle;
  Axes work{};
  if (spindle.surface.on && spindle.surface.axis < cells.axes) {
    Axes at{};
    cells.position(cell, cells.laws[cell].length / 2, at.data());
    work[spindle.surface.axis] = at[spindle.surface.axis] + record.shift;
  }
  return record.spindle_part * spindle.degrees(spindle.at(work));
}

/// Replaces the record number in each cell by the data of the record and emits the cells.
void AxisMotion::deliver(TimedCells& cells) {
  cells.spindle.clear();
  for (std::size_t k = 0; k < cells.laws.size(); ++k) {
    CellSource& source = cells.sources[k];
    while (now_.records.front().motion < source.tag) now_.records.pop_front();
    const Record& record = now_.records.front();
    source.tag = record.spent;
    source.motion = record.motion;
    source.switches = record.switches;
    cells.spindle.push_back(now_.spindle.turn(spindle_rate(record, cells, k), cells.laws[k]));
  }
  look_for_faults(cells);
  sink_(cells);
}

void AxisMotion::look_for_faults(const TimedCells& cells) {
  // Accepted excess of the path's deviation, as a fraction of the tolerance. An excess is possible because the deviation is checked at
  // sample positions only (docs/planner.md).
  constexpr double tolerated = 0.01;
  if (cells.unsolved && !cells.sources.empty()) {
    if (now_.faults.unsolved++ == 0) now_.faults.unsolved_at = Spent::of(cells.sources.front().tag);
    for (const TimeLaw& law : cells.laws) now_.faults.unsolved_length += law.length;
  }
  for (const CellSource& source : cells.sources) {
    if (source.beyond <= std::max(tolerated, now_.faults.beyond)) continue;
    if (now_.faults.beyond == 0) now_.faults.beyond_at = Spent::of(source.tag);
    now_.faults.beyond = source.beyond;
  }
}

void AxisMotion::stop_by(StopToken stop) {
  stop_ = stop;
  planner_.stop_by(stop);
}

AxisMotion::Refused AxisMotion::refused() const {
  const WindowTimer::Refused& refused = planner_.refused();
  for (const Record& record : now_.records)
    if (record.motion == refused.tag) return {refused.length, Spent::of(record.spent)};
  return {refused.length, {}};
}

void AxisMotion::rest() {
  now_.led.known = false;
  cut_threads();
  end_smoothing();
  planner_.stop();
}

TimedCells AxisMotion::standing(const Axes& at, double seconds, Spent spent, double spindle) {
  TimedCells still{roles_.count, {TimeLaw{seconds, 0, true, 0, 0, 0}}, {{spent.tag()}}, {}};
  for (std::size_t a = 0; a < roles_.count; ++a) still.path.insert(still.path.end(), {at[a], 0, 0, 0, 0, 0});
  still.spindle.push_back(now_.spindle.turn(spindle, still.laws[0]));
  return still;
}

void AxisMotion::stand(const Axes& at, double seconds, Spent spent) {
  if (!(seconds > 0) || ended() != PlanEnd::none) return;
  TimedCells still = standing(at, seconds, spent, now_.spindle.overridden());
  sink_(still);
}

void AxisMotion::consume(const Step& step) {
  if (ended() != PlanEnd::none) return;
  if (const Motion* const motion = step.motion()) return move(step, *motion);
  const Action& action = step.action;
  end_smoothing();
  if (step.pause > 0 || needs_rest(action)) {
    rest();
    stand(step.from.machine, step.pause,
          {std::holds_alternative<Dwell>(action.what) ? Spent::On::dwell : Spent::On::tool_change, action.origin.line, action.origin.file});
    now_.exact = true;
  } else if (std::holds_alternative<Speed>(action.what)) {
    cut_threads();
  }
  now_.spindle.take(action);
}

void AxisMotion::move(const Step& step, const Motion& motion) {
  const Origin& origin = step.action.origin;
  const bool rapid = motion.kind == MotionKind::rapid || motion.kind == MotionKind::home;
  const Spent spent{rapid ? Spent::On::rapid : Spent::On::cutting, origin.line, origin.file};
  const bool line_in_time = step.time.seconds > 0 && MachinePath(step).straight();
  const bool thread = motion.kind == MotionKind::thread && line_in_time, smooths = motion.smoothing != 0 && line_in_time;
  const bool taps = motion.detail && motion.detail->turn;
  const Switches switches{rapid || !motion.own_override, !motion.no_hold};
  if (motion.spindle != now_.spindle.leading() && (thread || taps || motion.unit == FeedUnit::mm_per_rev)) {
    rest();
    now_.spindle.select_leading(motion.spindle);
  }
  if (!thread) cut_threads();
  if (!smooths) end_smoothing();
  if (taps) couple(step, motion);
  if (thread) add_thread(step, motion, spent);
  else if (smooths) smooth(step, motion, record(spent, switches, motion));
  else cut(step, motion, record(spent, switches, motion));
  if (taps) release();
  if (on_place) on_place(now_.motions, step.from);
  now_.spindle.arrive(motion.to);
}

/// Couples the spindle's rotation to the travel of an axis for a rigid-tapping motion (nct 18.1.9).
void AxisMotion::couple(const Step& step, const Motion& motion) {
  rest();
  const double travel = distance(step.from.machine, motion.machine);
  if (travel > 0) now_.spindle.couple(*motion.detail->turn / travel);
}

void AxisMotion::release() {
  rest();
  now_.exact = true;
  now_.spindle.release();
}

void AxisMotion::smooth(const Step& step, const Motion& motion, std::uint64_t number) {
  const Axes& from = step.from.machine;
  const double travel = distance(from, motion.machine);
  if (on_motion) on_motion(number, travel);
  now_.led.known = false;
  now_.smoothing.take({from, motion.machine, travel / step.time.seconds, now_.exact ? 0 : tolerance_, number, motion.smoothing}, line_);
  now_.exact = false;
}

void AxisMotion::end_smoothing() { now_.smoothing.finish(line_); }

/// Adds a thread-cutting motion to the chain. Consecutive threads continue without a stop; only the first thread waits for the spindle (nct
/// 4.4).
void AxisMotion::add_thread(const Step& step, const Motion& motion, Spent spent) {
  const bool starts_thread = motion.detail->start_angle.has_value();
  if (starts_thread || now_.threads.full()) cut_threads();
  if (now_.threads.empty()) {
    planner_.stop();
    now_.threads.begin(step.from.machine);
    now_.thread_spent = spent;
    if (starts_thread) now_.thread_angle = *motion.detail->start_angle;
  }
  const Axes end = MachinePath(step).end();
  const std::uint64_t number = record(spent, {false, false}, motion);
  if (on_motion) on_motion(number, distance(step.from.machine, end));
  now_.threads.add(end, step.time.seconds, number);
  if (motion.exact) cut_threads();
}

/// Emits a cell in which the axes wait until the first thread may start (nct 4.4). The cell is emitted even if the waiting time is 0,
/// because Playback synchronises with the spindle in this cell if an override has delayed the axes.
void AxisMotion::wait_for_spindle() {
  const double seconds = now_.spindle.seconds_to(now_.thread_angle, now_.threads.ramp() / 2);
  TimedCells still = standing(now_.threads.start(), seconds, now_.thread_spent, now_.spindle.per_second());
  still.sources[0].switches = {false, false};
  still.spindle[0].awaited = true;
  sink_(still);
}

/// Emits the chain of threads. The chain may have to end early because of another spindle speed, a function or too many threads. The next
/// thread then starts at the spindle angle that continues the same groove.
void AxisMotion::cut_threads() {
  if (now_.threads.empty() || ended() != PlanEnd::none) return;
  const Axes end = now_.threads.end();
  wait_for_spindle();
  TimedCells cells = now_.threads.cells();
  deliver(cells);
  constexpr double turn = 360;
  now_.thread_angle = std::fmod(now_.thread_angle + std::fabs(now_.spindle.per_second()) * now_.threads.seconds(), turn);
  planner_.begin(end.data());
  now_.threads.begin(end);
  now_.exact = true;
}

AxisMotion::Feeds AxisMotion::feeds(const Pace& pace, const MachinePath& path, const MotionTime& programmed, int pieces) const {
  std::vector<double> lengths, minutes;
  double length = 0, sum = 0;
  Axes last = path.start();
  // Pace::is_even() refers to the path of the tool tip. Under tool centre point control the axes move unevenly although the tip moves
  // evenly, so path.bends() is checked too.
  const bool even = pace.is_even() && !path.bends();
  for (int i = 1; i <= pieces && !stop_.requested(); ++i) {
    const Axes to = path.at(static_cast<double>(i) / pieces);
    const double travel = distance(last, to);
    length += travel;
    last = to;
    if (even || !(programmed.seconds > 0)) continue;
    lengths.push_back(travel);
    minutes.push_back(pace.is_even() ? 1.0 : pace.minutes(static_cast<double>(i - 1) / pieces, static_cast<double>(i) / pieces));
    sum += minutes.back();
  }
  if (!(programmed.seconds > 0)) return {length, {unlimited_feed}};
  if (even || !(sum > 0)) return {length, {length / programmed.seconds}};
  for (std::size_t i = 0; i < lengths.size(); ++i) lengths[i] *= sum / (minutes[i] * programmed.seconds);
  return {length, lengths};
}

/// Returns how far, mm, the axes may deviate from the corner at the start of a piece under tool centre point control. If the previous
/// motion had no tool centre point control, the tip is assumed to swing with its full distance from the rotary axes.
double AxisMotion::corner_of(const Step& step, const TcpPiece& piece, double tolerance) const {
  if (!(tolerance > 0)) return 0;
  // Fraction of the corner tolerance that the rounding may use. The rest is a reserve for effects of higher order, because tcp_tolerance()
  // is a first-order estimate.
  constexpr double used = 0.8;
  if (now_.led.known) return tcp_tolerance(now_.led, piece, used * tolerance, step.from.space->rotary_axes());
  return tolerance / (1 + rad_per_deg * step.from.space->arm(step.from.machine));
}

void AxisMotion::cut(const Step& step, const Motion& motion, std::uint64_t number) {
  const MachinePath path(step);
  const Curve& curve = step.curve();
  const bool stops = motion.exact || motion.kind == MotionKind::home || motion.kind == MotionKind::probe;
  const double tolerance = (motion.tolerance > 0 ? motion.tolerance : tolerance_) * degrees_for_mm(curve, motion);
  // The tolerance of the corners between the chords by which a curve is replaced.
  const double rounding = stops || tolerance <= 0 ? tol::exact_path : tolerance;
  const double junction = now_.exact ? 0 : tolerance;
  const bool dry = dry_feed_ > 0 && has_override(motion);
  const SpindleTurning any;  // A default spindle, because the dry-run feed does not depend on the spindle speed.
  const Pace pace(roles_, curve, motion, dry ? dry_feed_ : step.time.feed, rapid_, dry ? any : now_.spindle.turning());
  const int pieces = std::max(path.pieces(chord_of_tolerance * rounding), pace.pieces());
  MotionTime time = step.time;
  if (dry) time.seconds = 60 * pace.minutes(0, 1);
  else if (has_override(motion)) time.seconds /= feed_factor_;
  const auto [length, speeds] = feeds(pace, path, time, pieces);
  if (on_motion) on_motion(number, length);
  Axes from = path.start();
  const bool led = path.controls_tip();
  if (!led) now_.led.known = false;
  Vec3 tip = led ? path.tip(0) : Vec3{};
  for (int i = 1; i <= pieces && ended() == PlanEnd::none; ++i) {
    const double part = static_cast<double>(i) / pieces, feed = speeds[std::min(static_cast<std::size_t>(i), speeds.size()) - 1];
    const Axes to = path.at(part);
    double corner = i == 1 ? junction : rounding;
    bool paced = false;
    if (led) {
      const Vec3 tip_to = path.tip(part);
      if (const TcpPiece piece = tcp_piece(roles_.count, from, to, tip, tip_to, feed); piece.known) {
        corner = corner_of(step, piece, corner);
        paced = feed < unlimited_feed && piece.keeps_pace(now_.led);
        now_.led = piece;
      }
      from = to;
      tip = tip_to;
    }
    planner_.line_to(to.data(), feed, corner, i > 1, number, paced);
  }
  now_.exact = stops;
  if (stops) planner_.stop();
}

}  // namespace kadr
