// Going on in mid program: the machine is led to the place, then its control remembers all as if the program had run. For
// panel/panel_machine; tested by tests/panel/panel_restart_test.cpp.

#include <fmt/core.h>

#include <cmath>
#include <utility>

#include "config/told.h"
#include "panel/panel_machine.h"

namespace kadr {
namespace {

using Failed = tl::unexpected<std::string>;

std::string no_room() { return told("a value has no room in a word of this control", "значение не помещается в слово этой системы"); }

constexpr double at_place = 1e-3;  // mm, degrees: what is led there by a way that a person has seen in thousandths

}  // namespace

std::string PanelMachine::not_for_several() {
  return told("programs of several channels cannot go on in mid program yet", "УП нескольких каналов пока нельзя продолжить с середины");
}

PanelMachine::Answer PanelMachine::may_go_there() const {
  if (const Answer may = may_begin(); !may) return may;
  if (!is_alone()) return Failed(not_for_several());
  if (session_->control().in_block()) return Failed(told("a block is not over: reset first", "кадр не закончен: сначала сброс"));
  return {};
}

tl::expected<PanelSheet, std::string> PanelMachine::sheet(const std::shared_ptr<const PanelPlace>& place, const WayRules& rules) {
  const auto sheet = std::make_shared<PanelSheet>();  // it may come when nobody waits any more
  const Answer answer = ask([sheet, this, place, rules]() -> Answer {
    if (const Answer may = may_go_there(); !may) return may;
    Control& control = session_->control();
    ToolPosition stand = session_->stand();
    stand.machine = lane_->clock.sample().machine;
    auto made = sheet_of(*place, stand, control.in_force(), rules, control, session_->def());
    if (!made) return Failed(no_room());
    *sheet = std::move(*made);
    return {};
  });
  if (!answer) return Failed(answer.error());
  return std::move(*sheet);
}

/// Within the ways of the axes.
///   returns  where it ends, or an error sentence
tl::expected<Axes, std::string> PanelMachine::end_of(const std::vector<WayPoint>& way) const {
  Axes at = lane_->clock.sample().machine;
  for (const WayPoint& point : way) {
    for (std::size_t a = 0; a < lane_->axes.size() && a < max_axes; ++a) {
      if ((point.named >> a & 1U) == 0) continue;
      const auto [least, most] = limits_of(session_->machine(), session_->channels()[session_->own()].setup, lane_->axes[a]);
      at[a] = point.machine[a];
      if (!(at[a] >= least && at[a] <= most)) return Failed(lane_->axes[a] + told(": beyond the end of its way", ": за пределом хода"));
    }
    if (!point.rapid && !(point.feed > 0 && point.feed <= 1e5)) return Failed(told("want a feed up to 100000", "нужна подача до 100000"));
  }
  return at;
}

PanelMachine::Answer PanelMachine::leads_to(const std::vector<WayPoint>& way, const PanelPlace& place) const {
  const auto end = end_of(way);
  if (!end) return Failed(end.error());
  const Axes& at = *end;
  for (std::size_t a = 0; a < lane_->axes.size() && a < max_axes; ++a)
    if (!(std::fabs(at[a] - place.restart.stand.machine[a]) <= at_place))
      return Failed(lane_->axes[a] + told(": the way does not end where the block begins", ": путь не кончается там, где начинается кадр"));
  return {};
}

PanelMachine::Answer PanelMachine::go_there(std::shared_ptr<const PanelPlace> place, const std::set<std::string>& left, std::vector<WayPoint> way) {
  return ask([this, place = std::move(place), left, way = std::move(way)]() -> Answer {
    if (const Answer may = may_go_there(); !may) return may;
    if (const Answer fits = leads_to(way, *place); !fits) return fits;
    const ControlDef& def = session_->def();
    const auto sheet = sheet_of(*place, session_->stand(), session_->control().in_force(), {}, session_->control(), def);
    if (!sheet) return Failed(no_room());
    const auto before = lines_before(*sheet, left, def), after = lines_after(*sheet, left, def);
    if (!before || !after) return Failed(no_room());
    kept_.told.clear(), kept_.why.clear();
    kept_.alarm.reset();
    tell("restart", place->line.text, place->line.number);
    going_.emplace(PanelGoing{place, {before->begin(), before->end()}, way, {after->begin(), after->end()}});
    return go_on_there();
  });
}

PanelMachine::Answer PanelMachine::lead(const std::vector<WayPoint>& way) {
  return ask([this, way]() -> Answer {
    if (const Answer may = may_begin(); !may) return may;
    const Control& control = session_->control();
    if (control.in_block() || control.meeting()) return Failed(told("a block is not over: run it to its end first", "кадр не закончен: сначала отработайте его до конца"));
    if (const auto end = end_of(way); !end) return Failed(end.error());
    if (way.empty()) return Failed(told("want a way", "нужен путь"));
    go_along(way);
    return {};
  });
}

void PanelMachine::go_along(const std::vector<WayPoint>& way) {
  std::vector<Motion> motions;
  ToolPosition at = standing_plainly(session_->own());
  for (const WayPoint& point : way) {
    Motion& motion = motions.emplace_back();
    motion.kind = point.rapid ? MotionKind::rapid : MotionKind::feed;
    motion.feed = point.feed;
    motion.named = point.named;
    motion.exact = true;
    for (std::size_t a = 0; a < max_axes; ++a) {
      if ((point.named >> a & 1U) == 0) continue;
      at.work[a] += point.machine[a] - at.machine[a];
      at.machine[a] = point.machine[a];
    }
    motion.to = at.work, motion.machine = at.machine;
  }
  begin_by_hand(*lane_, motions);
}

/// The next of what leads there. Called while the axes stand.
PanelMachine::Answer PanelMachine::go_on_there() {
  PanelGoing& going = *going_;
  if (!going.before.empty()) return carry_out(going.before);
  if (!going.way.empty()) {
    go_along(std::exchange(going.way, {}));
    return {};
  }
  if (!going.is_there) {
    if (const Answer there = arrive(*going.place); !there) return going_.reset(), there;
    going.is_there = true;
  }
  if (!going.after.empty()) return carry_out(going.after);
  going_.reset();
  kept_.mode = PanelMode::standing;
  kept_.why = "restart";
  return {};
}

PanelMachine::Answer PanelMachine::carry_out(std::deque<std::string>& lines) {
  const std::string line = std::move(lines.front());
  lines.pop_front();
  begin_line(line);
  return {};
}

/// The axes stand at the place: from here on it is as if the program had run.
PanelMachine::Answer PanelMachine::arrive(const PanelPlace& place) {
  if (const Answer there = remember(place); !there) return there;
  lane_->clock.stand_at(place.restart.stand.machine);
  return {};
}

/// The control is as the one that has come there.
PanelMachine::Answer PanelMachine::remember(const PanelPlace& place) {
  if (const Status restored = stepping_->restore(place.memory); !restored)
    return Failed(told("a file that the program had called is not as it was", "файл, который вызывала УП, изменился"));
  obey_switches();
  before_.clear();  // nothing leads back behind this
  entered_ = 0;
  last_line_ = place.restart.at.line;
  note_variables(0);
  lane_->placement = place.placement;
  lane_->start_over();
  lane_->on.origin = place.restart.at;
  lane_->on.work = place.restart.stand.work, lane_->on.machine = place.restart.stand.machine, lane_->on.placement = lane_->placement;
  lane_->on.modes = std::make_shared<PanelModes>(PanelModes{place.restart.in_force, place.calls});
  return {};
}

}  // namespace kadr
