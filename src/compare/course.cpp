// Course: converts the steps of a program's run into comparable items. Used by compare/comparison; tested by
// tests/compare/comparison_test.cpp.

#include "compare/course.h"

#include <algorithm>
#include <cmath>

#include "action/by_kind.h"
#include "path/curve/machine_path.h"

namespace kadr {
namespace {

constexpr int max_pieces = 16'384;  // greatest number of straight segments into which a motion is divided

CourseMove move_of(MotionKind kind) {
  switch (kind) {
    case MotionKind::rapid:
    case MotionKind::home: return CourseMove::rapid;
    case MotionKind::probe: return CourseMove::probe;
    case MotionKind::thread: return CourseMove::thread;
    default: return CourseMove::feed;
  }
}

/// True if the path of the motion is the straight line to its end. MachinePath is then not needed, because it would compute the same line.
bool is_plain_line(const Step& step, const Motion& motion) {
  return !motion.detail && !is_arc(motion.kind) && motion.kind != MotionKind::spline && !controls_tip(step.from, motion);
}

}  // namespace

Course::Course(std::unique_ptr<Session> session, const std::vector<std::string>& frame, double chord, const StopToken& stop)
    : session_(std::move(session)),
      chord_(chord),
      stop_(stop),
      chain_(AxisRoles::of(session_->channels()[session_->own()].control->axes(), 0)) {
  const Channel& own = session_->channels()[session_->own()];
  const std::vector<std::string>& axes = own.control->axes();
  for (const std::string& name : frame) {
    const auto found = std::find(axes.begin(), axes.end(), name);
    axis_of_.push_back(found == axes.end() ? -1 : int(found - axes.begin()));
  }
  state_.tool = std::uint32_t(std::max(own.setup.tool, 0));
  rpm_ = own.setup.spindle().rpm;
  clock_ = std::make_unique<TimeEstimate>(AxisRoles::of(axes, own.control->rotary()), rates_of(session_->machine(), own.setup, axes));
  put_in_frame(start_, session_->stand().machine);
  Outlets& outlets = session_->outlets();
  outlets.step = [this](const Step& step) { take(step); };
  outlets.warning = [](const AlarmReport&) {};
  outlets.alarm = [this](const AlarmReport& report) {
    end_.fault = report.alarm.id;
    end_.origin = report.origin;
    stopped_ = report;
    return false;
  };
  outlets.clock = clock_.get();
  outlets.stop = stop_;
}

void Course::more(ItemRing& to) {
  const std::size_t before = to.size();
  ahead_ = change_ ? &unchanged_ : &to;
  while (to.size() == before && !over_) {
    over_ = stop_.requested() || session_->go_on() != Session::State::running;
    if (over_) end_.state = state_, ahead_->add() = end_;
    if (change_) change_(unchanged_, to);
  }
}

/// Copies axis positions from the order of the control's axes to the order of the frame's axes. An axis of the frame that the control lacks
/// stays at 0.
void Course::put_in_frame(Axes& to, const Axes& machine) const {
  for (std::size_t i = 0; i < axis_of_.size(); ++i) to[i] = axis_of_[i] >= 0 ? machine[std::size_t(axis_of_[i])] + shift_[i] : 0;
}

void Course::shift(const Axes& by) {
  shift_ = by;
  put_in_frame(start_, session_->stand().machine);
}

void Course::take(const Step& step) {
  // Codes that call and end programs are no items of the course. The actions that the control executes for such a code arrive separately.
  if (is_by_control(step.action)) return;
  end_.begins = end_.ends = step.begins + step.time.seconds + step.pause;
  if (const std::uint32_t block = step.action.origin.number; block != end_.origin.number) before_block_ = state_;
  end_.origin = step.action.origin;
  if (const Motion* const motion = step.motion()) return take_motion(step, *motion);
  take_switch(step);
  const bool turns = state_.spindle == SpindleDir::cw || state_.spindle == SpindleDir::ccw;
  state_.speed = turns ? rpm_ : 0;
  state_.surface = turns && surface_;
  state_.most_rpm = state_.surface ? most_rpm_ : 0;
}

void Course::take_switch(const Step& step) {
  using Kind = CourseEvent::Kind;
  by_kind(
      step.action,
      [&](const Spindle& turned) {
        if (turned.number != 1) return take_event(step, Kind::other, double(turned.dir), "spindle " + std::to_string(turned.number));
        state_.spindle = turned.dir;
        // with constant surface speed, M3 reports the spindle speed at this position, which is no commanded speed
        if (turned.rpm != 0 && !surface_) rpm_ = turned.rpm;
      },
      [&](const Speed& speed) {
        if (speed.number != 1) return take_event(step, Kind::other, speed.value, "speed " + std::to_string(speed.number));
        rpm_ = speed.value, surface_ = speed.surface;
      },
      [&](const SurfaceSpeed& law) {
        if (law.number != 1) return;
        if (law.on) rpm_ = law.metres;
        else if (surface_) rpm_ = 0;  // the spindle keeps a speed that depends on the position of the axis
        surface_ = law.on;
        most_rpm_ = law.most < SurfaceSpeed::no_limit ? law.most : 0;
      },
      [&](const CoolantSwitch& coolant) { state_.coolant = coolant.what; },
      [&](const ToolChange& change) {
        if (!tools_by_hand_) state_.tool = change.tool;
        take_event(step, Kind::tool, change.tool);
      },
      [&](const Dwell& dwell) { take_event(step, Kind::dwell, dwell.seconds); },
      [&](const Stop& stop) { take_event(step, stop.optional ? Kind::optional_stop : Kind::stop, 0); },
      [&](const Message& message) {
        if (!messages_) ++passed_messages_;
        else take_event(step, Kind::message, message.number, message.text);
      },
      [&](const MachineFunction& function) { take_function(step, function.code); },
      [&](const AuxiliaryFunction& auxiliary) { take_event(step, Kind::other, auxiliary.value, std::string(1, auxiliary.address)); },
      [&](const FrameChange& frame) { note_frame(frame); },
      [&](const Couple& couple) { take_event(step, Kind::other, couple.ratio, "couple " + couple.slave); },
      [&](const Uncouple& uncouple) { take_event(step, Kind::other, 0, "uncouple " + uncouple.slave); },
      [&](const ToolSelect& select) {
        if (all_) take_event(step, Kind::other, select.tool, selected_tool);
      },
      ignores<Motion, Sync, ZoneChange, CompensationBreak, CompensationCorner, CompensationCheck>);
}

void Course::note_frame(const FrameChange& frame) {
  frame_zero_ = work_origin_of(chain_, frame.placement);
  Placement plain = frame.placement;
  for (std::size_t a = 0; frame.shifted && a < plain.origin.size(); ++a) plain.origin[a] -= (*frame.shifted)[a];
  system_zero_ = work_origin_of(chain_, plain);
}

void Course::take_function(const Step& step, std::uint32_t code) {
  const auto meaning = codes_.find(code);
  if (meaning == codes_.end()) return take_event(step, CourseEvent::Kind::function, code);
  if (meaning->second.coolant) state_.coolant = *meaning->second.coolant;
  else take_event(step, CourseEvent::Kind::function, meaning->second.code);
}

/// Adds an exact stop to the course if the next step moves the axes. Before any other step the axes are at rest anyway, and the exact stop
/// has no effect.
void Course::stop_exactly(const Step& next) {
  static const auto act = std::make_shared<const CourseEvent>(CourseEvent{CourseEvent::Kind::exact_stop, 0, {}});
  CourseItem& item = ahead_->add();
  item.kind = CourseItem::Kind::act;
  put_in_frame(item.to, next.from.machine);
  item.state = state_;
  item.act = act;
  item.origin = *exact_end_;
  item.begins = item.ends = next.begins;
  exact_end_.reset();
}

/// True if the axes are already at the end of the motion, so that it adds nothing to the path.
bool Course::stands(const Step& step, const Motion& motion) const {
  constexpr double same_place = 1e-9;  // mm
  if (!is_plain_line(step, motion)) return false;
  for (const int axis : axis_of_)
    if (axis >= 0 && std::abs(step.from.machine[std::size_t(axis)] - motion.machine[std::size_t(axis)]) > same_place) return false;
  return true;
}

void Course::take_event(const Step& step, CourseEvent::Kind kind, double value, std::string text) {
  exact_end_.reset();
  CourseItem& item = ahead_->add();
  item.kind = CourseItem::Kind::act;
  put_in_frame(item.to, step.from.machine);
  item.state = state_;
  // At a tool change, spindle and coolant count as off, because it depends on the machine whether they stop
  if (kind == CourseEvent::Kind::tool) {
    item.state.speed = 0, item.state.surface = false, item.state.most_rpm = 0;
    if (!all_) item.state.spindle = SpindleDir::stop, item.state.coolant = Coolant::off;
    if (tools_by_hand_) kind = CourseEvent::Kind::stop, value = 0;
  }
  item.act = std::make_shared<const CourseEvent>(CourseEvent{kind, value, std::move(text)});
  item.origin = step.action.origin;
  item.begins = step.begins;
  item.ends = step.begins + step.pause;
}

void Course::take_motion(const Step& step, const Motion& motion) {
  CourseState state = state_;
  state.move = move_of(motion.kind);
  if (state.move == CourseMove::feed || state.move == CourseMove::probe) state.unit = motion.unit, state.feed = motion.feed;
  if (state.move == CourseMove::thread && motion.detail) state.lead = motion.detail->lead.value_or(0);
  if (state.move == CourseMove::feed) {
    if (modes_.tolerance) state.tolerance = motion.tolerance;
    if (modes_.speeds) state.corners = motion.corner_speed;
    if (modes_.smoothing) state.smoothing = motion.smoothing;
    state.taps = motion.in_hole == HoleWork::taps;
  }
  if (modes_.exact) {
    const bool goes = (exact_end_ || motion.exact) && !stands(step, motion);
    if (goes && exact_end_) stop_exactly(step);
    if (motion.exact && state.move == CourseMove::feed && (goes || exact_end_)) exact_end_ = step.action.origin;
  } else if (motion.exact && state.move == CourseMove::feed) {
    ++passed_exact_stops_;
  }
  if (!zero_ && state.move == CourseMove::feed) zero_ = frame_zero_;
  const auto add = [&](double begins, double ends) -> Axes& {
    CourseItem& item = ahead_->add();
    item.kind = CourseItem::Kind::move;
    item.state = state;
    item.act.reset();
    item.origin = step.action.origin;
    item.begins = begins, item.ends = ends;
    item.zero = system_zero_;
    item.named = motion.named;
    item.by_work = motion.end_reference == EndReference::by_work && motion.kind != MotionKind::home;
    return item.to;
  };
  if (is_plain_line(step, motion)) return put_in_frame(add(step.begins, step.begins + step.time.seconds), motion.machine);
  const MachinePath path(step);
  const int pieces = path.straight() ? 1 : std::clamp(path.pieces(chord_), 1, max_pieces);
  for (int i = 1; i <= pieces; ++i) {
    Axes& to = add(step.begins + step.time.seconds * (i - 1) / pieces, step.begins + step.time.seconds * i / pieces);
    put_in_frame(to, i == pieces ? path.end() : path.at(double(i) / pieces));
  }
}

}  // namespace kadr
