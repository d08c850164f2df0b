// A stretch of a panel's machine: what the session makes of the program, in the servo clock's time. For panel/panel_machine.

#include <cmath>

#include "config/told.h"
#include "motion/time/steps.h"
#include "panel/panel_machine.h"

namespace kadr {
namespace {

using Failed = tl::unexpected<std::string>;

constexpr double enough = 3 * Playback::reserve;  // s ahead of the clock
constexpr double planned_each = 1;                // s of motion: the first long ones begin at once
constexpr double nearly_there = 1e-6;             // mm, degrees
constexpr double farthest = 1e5;                  // mm, degrees by hand at a time

}  // namespace

/// Before the planner gets it.
void PanelMachine::look(const Step& step) {
  if (looks_on_) looks_on_(step);
  const auto& what = step.action.what;
  if (const auto* const frame = std::get_if<FrameChange>(&what)) placement_ = frame->placement;
  if (const auto* const message = std::get_if<Message>(&what)) {
    kept_.told = message->text;
    if (message->asks) kept_.asks = true, stepping_->hold_next();
  }
  if (const auto* const stop = std::get_if<Stop>(&what); stop != nullptr && (!stop->optional || kept_.optional_stop)) {
    stepping_->hold_next();
    kept_.why = stop->optional ? "M1" : "M0";
  }
  const Motion* const motion = step.motion();
  if (motion == nullptr) return;
  const Origin& origin = step.action.origin;
  if (origin.number != modes_of_ || !pending_.modes) {
    const Control& control = session_->control();
    pending_.modes = std::make_shared<PanelModes>(PanelModes{control.in_force(), control.calls_of(origin)});
    modes_of_ = origin.number;
  }
  pending_.origin = origin;
  pending_.work = motion->to, pending_.machine = motion->machine;
  pending_.placement = placement_;
  pending_.entered = stretch_ && stretch_->of == Stretch::Of::line;
  pending_.by_turn = motion->unit == FeedUnit::mm_per_rev;
  pending_.number = pending_.entered ? 0 : origin.number - std::uint32_t(entered_);
  pending_.feed = motion->kind == MotionKind::rapid || motion->kind == MotionKind::home ? 0 : step.time.feed;
}

/// The planner begins where the axes stand.
void PanelMachine::set_up(Stretch& stretch) {
  blocks_.clear();
  stretch.planned->on_cells = [this](const TimedCells& cells) { stretch_->to_come.push_back(cells); };
  stretch.planned->number_motions([this](std::uint64_t motion) {
    pending_.motion = motion;
    blocks_.add(pending_);
  });
  has_moved_ = true;
  stretch.planned->plan_each(planned_each);
  stretch.playback = std::make_unique<Playback>(stretch.planned->limits(), rate);
  stretch.playback->override_to(kept_.shares.feed);
}

void PanelMachine::begin(Stretch::Of of) {
  Stretch& stretch = stretch_.emplace();
  stretch.of = of;
  session_->outlets().step = [this](const Step& step) { look(step); };  // without the planner of the stretch before
  stretch.planned = &session_->plan(session_->own());
  session_->change_outlets();
  set_up(stretch);
  stretch.planned->run_dry(kept_.shares.dry_feed);
  on_.origin = stepping_->next().value_or(Origin()), on_.entered = false;
  if (of == Stretch::Of::program) stepping_->begin(how_.value_or(kept_.single ? Stepping::How::block : Stepping::How::free));
  kept_.mode = PanelMode::running;
  provide();
  clock_->play(stretch.playback.get());
}

/// A line of the operator.
void PanelMachine::begin_line(const std::string& line) {
  note_variables(last_line_);
  entering_from_ = session_->control().blocks();
  stepping_->begin_entering(line);
  begin(Stretch::Of::line);
}

PanelMachine::Answer PanelMachine::move_by_hand(const std::string& axis, double way, double feed) {
  const auto found = std::find(axes_.begin(), axes_.end(), axis);
  if (found == axes_.end()) return Failed(axis + told(": there is no such axis", ": такой оси нет"));
  if (!(std::fabs(way) <= farthest) || !(feed >= 0 && feed <= farthest) || way == 0)
    return Failed(told("want a way and a feed up to 100000", "нужны путь и подача до 100000"));
  if (session_->control().in_block()) return Failed(told("a block is not over: run it to its end first", "кадр не закончен: сначала отработайте его до конца"));
  const std::size_t a = std::size_t(found - axes_.begin());
  const ToolPosition stand = standing_plainly();
  const auto [least, most] = limits_of(session_->machine(), session_->channels()[session_->own()].setup, axis);
  Motion motion;
  motion.kind = feed > 0 ? MotionKind::feed : MotionKind::rapid;
  motion.feed = feed;
  motion.named = AxisMask{1} << a;
  motion.exact = true;
  motion.to = stand.work, motion.machine = stand.machine;
  motion.to[a] += way, motion.machine[a] += way;
  if (motion.machine[a] < least || motion.machine[a] > most)
    return Failed(axis + told(": beyond the end of its way", ": за пределом хода"));
  begin_by_hand({motion});
  return {};
}

/// Along the axes of the machine, however the frame lies.
ToolPosition PanelMachine::standing_plainly() const {
  ToolPosition stand = session_->stand();
  stand.turn.reset(), stand.space.reset();
  return stand;
}

void PanelMachine::begin_by_hand(const std::vector<Motion>& motions) {
  const Channel& channel = session_->channels()[session_->own()];
  const ToolPosition stand = standing_plainly();
  Stretch& stretch = stretch_.emplace();
  stretch.of = Stretch::Of::hand;
  stretch.by_hand = std::make_unique<Planned>(channel, session_->machine(), stand);
  stretch.planned = stretch.by_hand.get();
  set_up(stretch);
  TimeEstimate times(roles_, rates_of(session_->machine(), channel.setup, axes_));
  Steps steps(roles_, stand, &times);
  for (const Motion& motion : motions) {
    pending_ = on_;
    pending_.work = motion.to, pending_.machine = motion.machine, pending_.feed = motion.feed;
    Action action;
    action.what = motion;
    steps.give(action, [&](const Step& step) {
      if (looks_on_) looks_on_(step);
      stretch.planned->consume(step);
    });
  }
  (void)stretch.planned->finish();
  stretch.planned_all = true;
  kept_.mode = PanelMode::running;
  provide();
  clock_->play(stretch.playback.get());
}

/// The cells that were planned next. False: not all of them have room.
bool PanelMachine::offer() {
  Stretch& s = *stretch_;
  const TimedCells& cells = s.to_come.front();
  s.offered += s.playback->offer(cells, s.offered);
  if (s.offered < cells.laws.size()) return false;
  s.to_come.pop_front();
  s.offered = 0;
  return true;
}

void PanelMachine::provide() {
  Stretch& s = *stretch_;
  const double played = clock_->sample().plays ? clock_->sample().played : 0;
  while (s.playback->offered() - played < enough) {
    if (!s.to_come.empty()) {
      if (!offer()) return;
    } else if (s.planned_all) {
      return s.playback->finish();
    } else {
      go_on();
    }
  }
}

void PanelMachine::go_on() {
  Stretch& s = *stretch_;
  s.came_to = session_->go_on();
  if (s.came_to == Session::State::running) return;
  (void)s.planned->finish();
  s.planned_all = true;
}

/// The axes stand at its end.
void PanelMachine::end_stretch() {
  clock_->play(nullptr);
  const Stretch::Of of = stretch_->of;
  const Session::State came_to = stretch_->came_to;
  if (of == Stretch::Of::line) {
    stepping_->end_entering(came_to);
    entered_ += session_->control().blocks() - entering_from_;
    note_variables(0);
  }
  if (of == Stretch::Of::hand) session_->stand_at(clock_->sample().machine);
  stretch_.reset();
  holds_ = false;
  const Axes stand = session_->stand().machine, at = clock_->sample().machine;
  bool is_there = true;
  for (std::size_t a = 0; a < axes_.size() && a < max_axes; ++a) is_there = is_there && std::fabs(stand[a] - at[a]) < nearly_there;
  if (is_there) clock_->stand_at(stand);  // what the planner's sums have left
  if (going_ && came_to != Session::State::stopped) {
    if (const Answer there = go_on_there(); !there) kept_.told = there.error(), kept_.mode = PanelMode::standing;
    return;
  }
  going_.reset();
  const bool stopped = came_to == Session::State::stopped && of == Stretch::Of::program;
  if (stopped) kept_.mode = PanelMode::alarm;
  else kept_.mode = stepping_->next() ? PanelMode::standing : PanelMode::ended;
  if (of != Stretch::Of::program) return;
  if (kept_.mode == PanelMode::ended) tell("ended");
  else if (kept_.mode == PanelMode::standing) tell("stopped", kept_.why, stepping_->line().number);
}

/// The axes stay where they are.
void PanelMachine::drop_stretch() {
  clock_->play(nullptr);
  stretch_.reset();
  going_.reset();
  holds_ = resets_ = false;
}

}  // namespace kadr
