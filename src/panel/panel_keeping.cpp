// What of a machine is kept, and its tables. For panel/panel_machine; tested by tests/panel/panel_tables_test.cpp, tests/panel_kills.py.

#include <algorithm>

#include "config/told.h"
#include "lang/expression/expression.h"
#include "panel/panel_machine.h"

namespace kadr {
namespace {

using Failed = tl::unexpected<std::string>;

constexpr double same_place = 1e-9;  // mm, degrees
constexpr double beside = 1e-6;      // mm, degrees: of what is programmed

bool is_same(const PanelSpot& a, const PanelSpot& b) {
  if (a.mode != b.mode || a.number != b.number || a.line != b.line || a.file != b.file) return false;
  if (a.mode == PanelMode::running) return true;  // at each block is enough
  for (std::size_t i = 0; i < max_axes; ++i)
    if (std::abs(a.machine[i] - b.machine[i]) > same_place) return false;
  return true;
}

}  // namespace

void PanelMachine::tell(const char* kind, const std::string& text, std::uint32_t line) const {
  if (keeper_.event) keeper_.event(kind, text, line);
}

/// The block that the machine is on, or stands before, or is led to.
void PanelMachine::keep_spot(const PanelState& now) {
  if (!keeper_.spot) return;
  const bool runs = stretch_ && stretch_->of == Stretch::Of::program;
  PanelSpot spot;
  spot.mode = now.mode;
  spot.machine = now.sample.machine;
  const bool leads_elsewhere = stretch_ && stretch_->of == Stretch::Of::line;  // it stands where it stood
  if (runs) spot.number = lane_->on.number;
  else if (stepping_->next()) spot.number = stepping_->next()->number - std::uint32_t(entered_);
  if (leads_elsewhere || (runs && spot.number == 0)) spot.number = kept_spot_.number;  // a block without a motion
  spot.line = now.line.number, spot.text = now.line.text;
  const std::uint16_t file = going_ ? going_->place->restart.at.file : runs ? lane_->on.origin.file : stepping_->next() ? stepping_->next()->file : std::uint16_t{0};
  if (file != 0) spot.file = session_->control().file_name(file);
  if (going_) spot.number = going_->place->restart.at.number, spot.line = going_->place->line.number, spot.text = going_->place->line.text;
  const bool broken = now.mode == PanelMode::alarm || now.mode == PanelMode::emergency;
  if (broken && spot.number == 0) spot.number = kept_spot_.number, spot.line = kept_spot_.line, spot.text = kept_spot_.text, spot.file = kept_spot_.file;
  if (is_same(spot, kept_spot_)) return;
  if (!has_moved_) return kept_spot_ = std::move(spot), void();
  kept_.not_kept = keeper_.spot(spot);
  kept_spot_ = std::move(spot);
}

/// What has changed since the last time has been changed by that line; 0: not by the program.
void PanelMachine::note_variables(std::uint32_t line) {
  std::map<std::string, double> now;
  for (auto& [name, value] : session_->control().ending().variables) now.emplace(std::move(name), value);
  for (const auto& [name, value] : now) {
    const auto before = variables_.find(name);
    if (before != variables_.end() && before->second == value) continue;
    if (line != 0) set_by_[name] = line;
    else set_by_.erase(name);
  }
  variables_ = std::move(now);
}

tl::expected<PanelTables, std::string> PanelMachine::tables() {
  const auto tables = std::make_shared<PanelTables>();  // it may come when nobody waits any more
  const Answer answer = ask([this, tables]() -> Answer {
    if (!stretch_) note_variables(last_line_);
    tables->state = session_->control().run_state();
    for (const auto& [name, value] : variables_) {
      const auto by = set_by_.find(name);
      tables->variables.push_back({name, value, by == set_by_.end() ? 0 : by->second});
    }
    return {};
  });
  if (!answer) return Failed(answer.error());
  return std::move(*tables);
}

tl::expected<std::vector<PanelWatch>, std::string> PanelMachine::watch_values(const std::vector<std::string>& expressions) {
  const auto values = std::make_shared<std::vector<PanelWatch>>();
  const Answer answer = ask([this, values, expressions]() -> Answer {
    for (const std::string& text : expressions) {
      const auto value = stepping_->value(text);
      values->push_back({text, value && !is_vacant(*value) ? std::optional(*value) : std::nullopt});
    }
    return {};
  });
  if (!answer) return Failed(answer.error());
  return std::move(*values);
}

/// The machine is where the control is: motions of a contour that is being compensated are held back, or lie beside it.
bool PanelMachine::is_in_contour() const {
  const Axes stand = session_->stand().machine, programmed = session_->control().tool_position().machine;
  for (std::size_t a = 0; a < lane_->axes.size() && a < max_axes; ++a)
    if (std::abs(stand[a] - programmed[a]) > beside) return true;
  return false;
}

PanelMachine::Answer PanelMachine::may_take_tables_now() const {
  if (const Answer may = may_begin(); !may) return may;
  if (session_->control().in_block()) return Failed(told("a block is not over: run it to its end first", "кадр не закончен: сначала отработайте его до конца"));
  if (is_in_contour()) return Failed(told("a contour is being compensated: run it to its end first", "идёт контур с коррекцией: сначала отработайте его до конца"));
  return {};
}

PanelMachine::Answer PanelMachine::may_take_tables() {
  return ask([this]() -> Answer { return may_take_tables_now(); });
}

PanelMachine::Answer PanelMachine::take_tables() {
  return ask([this]() -> Answer {
    if (const Answer may = may_take_tables_now(); !may) return may;
    const bool has_run = stepping_->next() && stepping_->next()->number - std::uint32_t(entered_) > 1;
    if (!has_run) return open(lane_->clock.sample().machine);
    if (!is_alone()) return Failed(told("in mid program of several channels tables stay as they are: reset", "посреди УП нескольких каналов таблицы не меняются: нужен сброс"));
    StopPoint here;
    here.line = stepping_->next()->line;
    if (stepping_->next()->file != 0) here.file = session_->control().file_name(stepping_->next()->file);
    here.number = stepping_->next()->number - std::uint32_t(entered_);
    retables_.emplace(PanelSearch::Wish{here, 0, false});
    begin_search();
    return {};
  });
}

/// As if the program had run to here with these tables; the axes stay where they are.
void PanelMachine::look_after_tables() {
  const PanelSearch::Answer found = search_->find(*retables_);
  if (!found.ready) return;
  retables_.reset();
  const Axes machine = lane_->clock.sample().machine;
  Answer taken = found.place ? Answer() : Failed(told("with these tables the program does not come here: reset", "с этими таблицами УП сюда не приходит: нужен сброс"));
  if (taken) taken = begin_session(start_);
  if (taken) taken = remember(*found.place);
  if (!taken) {
    kept_.told = taken.error();
  } else {
    session_->stand_at(machine);
    lane_->on.work = session_->stand().work, lane_->on.machine = machine;
    kept_.mode = PanelMode::standing;
  }
  show();
}

}  // namespace kadr
