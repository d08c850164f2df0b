// ToolWatch: compares the tools of a program with each other. It is used by session/checklist and tested by tests/checklist.py.

#include "session/checklist/tool_watch.h"

#include <algorithm>
#include <set>

#include "action/by_kind.h"

namespace kadr {
namespace {

constexpr std::size_t max_tool_periods = 2000;
constexpr std::size_t max_rows = 64;  // greatest number of offset table rows that are recorded per tool

void note_row(std::map<std::uint32_t, Origin>& rows, std::uint32_t row, const Origin& origin) {
  if (row != 0 && rows.size() < max_rows) rows.try_emplace(row, origin);
}

}  // namespace

/// Records a spindle action. A spindle action in the block of a tapping cycle is ignored, since its effect ends with the block.
void ToolWatch::take_spindle(const Spindle& spindle, const Origin& origin) {
  if (cycle_block_ && origin.number == *cycle_block_) return;
  if (spindle.dir == SpindleDir::orient || spindle.dir == SpindleDir::position) return;
  turns_ = spindle.dir;
  if (spindle.dir == SpindleDir::stop) return;
  rpm_ = spindle.rpm;
  zero_speeds_ += rpm_ == 0;
  now().started = started_since_cut_ = true;
  ++starts_;
  if (spindle.dir == SpindleDir::cw) now().clockwise = true;
  else if (!now().counter_clockwise) now().counter_clockwise = origin;
}

void ToolWatch::take_motion(const Step& step, const Motion& motion) {
  ToolPeriod& stint = now();
  if (motion.of_cycle) cycle_block_ = step.action.origin.number;
  const Ends ends(step.roles, step.from, motion);
  const bool works = is_cut(motion) && (motion.of_cycle ? ends.down() : ends.sideways()) && ends.to.z < stint.highest;
  if (motion.end_reference == EndReference::by_work && motion.kind != MotionKind::home) stint.highest = std::max(stint.highest, ends.to.z);
  if (!works) return;
  started_since_cut_ = false;
  const Origin& origin = step.action.origin;
  if (!stint.cuts) {
    stint.cuts = origin;
    if (motion.length_offset == 0) stint.without_length = origin;
  }
  stint.wet = stint.wet || coolant_;
  const bool turns = turns_ != SpindleDir::stop && (rpm_ > 0 || zero_speeds_ > 1);
  const bool turned_by_cycle = motion.in_hole == HoleWork::taps || (motion.of_cycle && taps_rigidly_);
  stint.mills = stint.mills || !turned_by_cycle;
  if (turns || turned_by_cycle) stint.turned = true;
  else if (!stint.cuts_still) stint.cuts_still = origin;
  note_row(stint.lengths, motion.length_offset, origin);
  note_row(stint.radii, motion.radius_offset, origin);
  note_row(stint.systems, motion.system, origin);
}

void ToolWatch::take(const Step& step, Advices&) {
  const Action& action = step.action;
  by_kind(
      action, [&](const Motion& motion) { take_motion(step, motion); },
      [&](const Spindle& spindle) { take_spindle(spindle, action.origin); },
      [&](const Speed& speed) {
        rpm_ = speed.surface ? std::max(speed.rpm, 1.0) : speed.value;
        asks_speed_ = asks_speed_ || rpm_ > 0;
        zero_speeds_ += rpm_ == 0;
      },
      [&](const MachineFunction& function) {
        constexpr std::uint32_t rigid_tapping = 29;  // the number of M29, which machine builders use for rigid tapping on Fanuc and Haas
        taps_rigidly_ = taps_rigidly_ || function.code == rigid_tapping;
      },
      [&](const CoolantSwitch& coolant) { coolant_ = coolant.what != Coolant::off; },
      [&](const ToolSelect& select) {
        if (first_tool_ == 0) first_tool_ = select.tool;
        if (select.tool != 0 && selected_.size() < max_rows) selected_.try_emplace(select.tool, action.origin);
      },
      [&](const ToolChange& change) {
        changes_ = true;
        selected_.erase(change.tool);
        if (change.tool == now().tool && !now().cuts) return;
        if (stints_.size() < max_tool_periods) stints_.emplace_back();
        now().tool = change.tool;
        // A spindle start before the tool change counts for the new tool, since the program may state S and M3 before the tool change.
        now().started = started_since_cut_;
      },
      ignores<Dwell, AuxiliaryFunction, Stop, Message, FrameChange, SurfaceSpeed, Sync, ZoneChange, Couple, Uncouple, CompensationBreak,
              CompensationCorner, CompensationCheck>);
}

/// Reports tools that cut with the spindle stopped, if the program starts the spindle for other tools. A program that often switches
/// between M3 and M5 controls the beam of a laser or a pen, so it is not checked.
void ToolWatch::judge_spindles(Advices& to) const {
  const auto started = std::count_if(stints_.begin(), stints_.end(), [](const ToolPeriod& s) { return s.cuts && s.started; });
  const bool switches_a_beam = starts_ > 2 * stints_.size() + 4;
  const bool turned = std::any_of(stints_.begin(), stints_.end(), [](const ToolPeriod& s) { return s.turned; });
  if (!switches_a_beam)
    for (const ToolPeriod& s : stints_) {
      if (s.cuts_still && (turned || asks_speed_)) to.add(AlarmId::cut_without_spindle, *s.cuts_still, 0);
      else if (s.cuts && s.mills && !s.started && started >= 2 && s.tool != 0) to.add(AlarmId::cut_without_spindle, *s.cuts, 0);
    }
  const auto clockwise = std::count_if(stints_.begin(), stints_.end(), [](const ToolPeriod& s) { return s.clockwise && s.cuts; });
  for (const ToolPeriod& s : stints_)
    if (s.counter_clockwise && !s.clockwise && s.cuts && clockwise >= 1)
      to.add(AlarmId::direction_of_others, *s.counter_clockwise, 'M', "M4");
}

void ToolWatch::judge_coolant(Advices& to) const {
  std::set<std::uint32_t> wet, dry;
  for (const ToolPeriod& s : stints_)
    if (s.cuts && s.tool != 0) (s.wet ? wet : dry).insert(s.tool);
  // coolant is reported as missing for a single tool only, since two or more tools without coolant are probably intended
  if (wet.size() < 2 || dry.size() > 1) return;
  for (const ToolPeriod& s : stints_)
    if (s.cuts && s.tool != 0 && !s.wet) return to.add(AlarmId::coolant_forgotten, *s.cuts, 0, double(s.tool));
}

void ToolWatch::judge_lengths(Advices& to) const {
  const bool others = std::any_of(stints_.begin(), stints_.end(), [](const ToolPeriod& s) { return s.cuts && !s.without_length; });
  if (!others) return;
  for (const ToolPeriod& s : stints_)
    if (s.without_length && s.tool != 0) to.add(AlarmId::length_not_called, *s.without_length, 0, double(s.tool));
}

/// Compares the numbers of offset table rows with tool numbers. The most frequent difference (H = T, D = T + 30) is the habit of the
/// workshop. A tool with another difference probably uses the row of another tool, so it is reported.
void ToolWatch::judge_rows(Rows ToolPeriod::*rows, AlarmId id, char address, Advices& to) const {
  struct Pair {
    std::uint32_t tool, row;
    Origin origin;
    long apart() const { return long(row) - long(tool); }
  };
  std::vector<Pair> pairs;
  std::set<std::uint32_t> tools;
  for (const ToolPeriod& s : stints_) {
    if (s.tool == 0 || !s.cuts) continue;
    tools.insert(s.tool);
    for (const auto& [number, origin] : s.*rows)
      if (const std::uint32_t row = number;
          std::none_of(pairs.begin(), pairs.end(), [&](const Pair& p) { return p.tool == s.tool && p.row == row; }))
        pairs.push_back({s.tool, row, origin});
  }
  std::map<long, std::size_t> habits;
  for (const Pair& p : pairs) ++habits[p.apart()];
  const auto habit = std::max_element(habits.begin(), habits.end(), [](const auto& a, const auto& b) {
    return a.second != b.second ? a.second < b.second : std::abs(a.first) > std::abs(b.first);
  });
  for (const Pair& p : pairs) {
    const bool usual = p.apart() == habit->first && habit->second > 1;
    if (p.apart() == 0 || usual) continue;
    const bool of_other =
        tools.contains(p.row) || std::any_of(pairs.begin(), pairs.end(), [&](const Pair& o) { return o.row == p.row && o.tool != p.tool; });
    const bool second_row =
        std::any_of(pairs.begin(), pairs.end(), [&](const Pair& o) { return o.tool == p.tool && o.apart() == habit->first && &o != &p; });
    const bool by_habit = habit->second > 1 && !second_row;
    const bool alone = pairs.size() == 1 && p.apart() % 10 != 0;
    if (of_other || by_habit || alone) to.add(id, p.origin, address, double(p.row), double(p.tool));
  }
}

void ToolWatch::judge_systems(const std::vector<std::string>& names, Advices& to) const {
  // Least number of tools that must use the same work offset, so that a tool with another work offset is reported.
  constexpr std::size_t enough = 3;
  std::map<std::uint32_t, std::set<std::uint32_t>> users;
  std::size_t several = 0;  // number of tools that use several work offsets
  std::set<std::uint32_t> tools;
  for (const ToolPeriod& s : stints_) {
    if (s.tool == 0 || !s.cuts) continue;
    tools.insert(s.tool);
    several += s.systems.size() > 1;
    for (const auto& [system, origin] : s.systems) users[system].insert(s.tool);
  }
  if (users.size() != 2 || several != 0 || tools.size() < enough + 1) return;
  for (const ToolPeriod& s : stints_)
    for (const auto& [system, origin] : s.systems)
      if (users[system].size() == 1 && users[system].contains(s.tool) && system < names.size())
        return to.add(AlarmId::work_offset_once, origin, 0, std::string_view(names[system]), double(s.tool));
}

/// Reports selected tools that are never used. The tool that was selected first is not reported: its selection at the end of the program
/// prepares the next part.
void ToolWatch::judge_selections(Advices& to) const {
  if (!changes_) return;
  for (const auto& [tool, origin] : selected_)
    if (tool != first_tool_) to.add(AlarmId::tool_unused, origin, 'T', double(tool));
}

void ToolWatch::finish(const std::vector<std::string>& systems, Advices& to) {
  judge_spindles(to);
  judge_coolant(to);
  judge_lengths(to);
  judge_rows(&ToolPeriod::lengths, AlarmId::length_of_other, 'H', to);
  judge_rows(&ToolPeriod::radii, AlarmId::radius_of_other, 'D', to);
  judge_systems(systems, to);
  judge_selections(to);
}

}  // namespace kadr
