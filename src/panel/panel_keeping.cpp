// PanelMachine, saved data and tables. Used by panel/panel_machine; tested by tests/panel/panel_tables_test.cpp and tests/panel_kills.py.

#include <algorithm>

#include "lang/expression/expression.h"
#include "panel/panel_machine.h"
#include "texts/panel.h"

namespace kadr {
namespace {

using Failed = tl::unexpected<std::string>;

constexpr double same_place = 1e-9;  // Positions whose difference is smaller than this value are equal; mm, degrees.
constexpr double off_path = 1e-6;    // An axis farther than this from the programmed position is off the programmed path; mm, degrees.

/// Returns the set-up `now` without the changes that the use of tools has caused, because these are not edits of the operator.
Setup by_hand(const Setup& before, Setup now) {
  for (auto& [number, row] : now.tool_table) {
    const auto then = before.tool_table.find(number);
    if (then == before.tool_table.end()) continue;
    ToolRow of_data = then->second;
    of_data.counter = row.counter, of_data.status = row.status, of_data.info = row.info;
    if (of_data == row) row = then->second;
  }
  return now;
}

bool are_same(const Setup& a, const Setup& b) {
  return a.offsets == b.offsets && a.work_offsets == b.work_offsets && a.parameters == b.parameters && a.tool_table == b.tool_table;
}

bool is_same(const PanelLocation& a, const PanelLocation& b) {
  if (a.mode != b.mode || a.number != b.number || a.line != b.line || a.file != b.file) return false;
  // While the program runs, the location is saved once per block, so a change of the axis positions alone is not saved.
  if (a.mode == PanelMode::running) return true;
  const auto are_near = [](const Axes& one, const Axes& other) {
    return std::equal(one.begin(), one.end(), other.begin(), [](double x, double y) { return std::abs(x - y) <= same_place; });
  };
  return are_near(a.machine, b.machine) && std::equal(a.stands.begin(), a.stands.end(), b.stands.begin(), b.stands.end(), are_near);
}

}  // namespace

void PanelMachine::notify(const char* kind, const std::string& text, std::uint32_t line) const {
  if (keeper_.event) keeper_.event(kind, text, line);
}

/// Saves the location of the machine: the block that the machine is executing, or is held before, or to which it moves for a restart.
void PanelMachine::save_location(const PanelState& now) {
  if (!keeper_.spot) return;
  const bool runs = running_ && running_->of == Run::Of::program;
  PanelLocation spot;
  spot.mode = now.mode;
  spot.machine = now.sample.machine;
  for (const PanelChannel& channel : now.channels) spot.stands.push_back(channel.sample.machine);
  // A line of the operator does not change the location in the program.
  const bool moves_elsewhere = running_ && running_->of == Run::Of::line;
  if (runs) spot.number = lane_->on.number;
  else if (stepping_->next()) spot.number = stepping_->next()->number - std::uint32_t(entered_);
  // During a line of the operator, and at a block without a motion, the saved block number does not change.
  if (moves_elsewhere || (runs && spot.number == 0)) spot.number = saved_location_.number;
  spot.line = now.line.number, spot.text = now.line.text;
  const std::uint16_t file = going_              ? going_->place->restart.at.file
                             : runs              ? lane_->on.origin.file
                             : stepping_->next() ? stepping_->next()->file
                                                 : std::uint16_t{0};
  if (file != 0) spot.file = session_->control().file_name(file);
  if (going_) spot.number = going_->place->restart.at.number, spot.line = going_->place->line.number, spot.text = going_->place->line.text;
  const bool broken = now.mode == PanelMode::alarm || now.mode == PanelMode::emergency;
  if (broken && spot.number == 0)
    spot.number = saved_location_.number, spot.line = saved_location_.line, spot.text = saved_location_.text,
    spot.file = saved_location_.file;
  if (is_same(spot, saved_location_)) return;
  if (!has_moved_) {
    saved_location_ = std::move(spot);
    return;
  }
  panel_state_.save_fault = keeper_.spot(spot);
  saved_location_ = std::move(spot);
}

/// Finds the variables that have changed since the last call, and stores `line` as the program line that set them. 0 means that no program
/// line set them.
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

/// Saves the changes that a line of the operator (G10) has made in the tables. These changes count as an edit of the tables, so neither a
/// reset nor another edit reverts them.
void PanelMachine::keep_tables(const Setup& before) {
  if (!keeper_.tables) return;
  const Setup now = by_hand(before, session_->control().tables_now());
  if (are_same(before, now)) return;
  if (const std::string fault = keeper_.tables(before, now); !fault.empty()) panel_state_.message = fault;
  begin_search();  // The search must use the changed tables, so it starts again.
}

tl::expected<PanelTables, std::string> PanelMachine::tables() {
  // The tables are in shared memory, because the request that fills them may be executed after this call has timed out.
  const auto tables = std::make_shared<PanelTables>();
  const Answer answer = ask(
      [this, tables]() -> Answer {
        if (!running_) note_variables(last_line_);
        tables->state = session_->control().run_state();
        for (const auto& [name, value] : variables_) {
          const auto by = set_by_.find(name);
          tables->variables.push_back({name, value, by == set_by_.end() ? 0 : by->second});
        }
        return {};
      },
      Wait::for_end);
  if (!answer) return Failed(answer.error());
  return std::move(*tables);
}

tl::expected<std::vector<PanelWatch>, std::string> PanelMachine::watch_values(const std::vector<std::string>& expressions) {
  const auto values = std::make_shared<std::vector<PanelWatch>>();
  const Answer answer = ask(
      [this, values, expressions]() -> Answer {
        for (const std::string& text : expressions) {
          const auto value = stepping_->value(text);
          values->push_back({text, value && !is_vacant(*value) ? std::optional(*value) : std::nullopt});
        }
        return {};
      },
      Wait::for_end);
  if (!answer) return Failed(answer.error());
  return std::move(*values);
}

/// True if the machine is not at the position that the control has reached. The motions of a compensated contour are then not executed yet,
/// or they are offset from the contour.
bool PanelMachine::is_in_contour() const {
  for (std::size_t i = 0; i < lanes_.size(); ++i) {
    const Axes stand = session_->stand(i).machine, programmed = session_->channels()[i].control->tool_position().machine;
    for (std::size_t a = 0; a < lanes_[i]->axes.size() && a < max_axes; ++a)
      if (std::abs(stand[a] - programmed[a]) > off_path) return true;
  }
  return false;
}

PanelMachine::Answer PanelMachine::may_apply_tables_now() const {
  if (const Answer may = may_begin(); !may) return may;
  const auto is_open = [](const Channel& channel) { return channel.control->in_block(); };
  if ((goes_on_ && !stepping_->next()) || std::any_of(session_->channels().begin(), session_->channels().end(), is_open))
    return Failed(translated(texts::panel::run_block_first));
  if (is_in_contour()) return Failed(translated(texts::panel::run_contour_first));
  return {};
}

PanelMachine::Answer PanelMachine::may_apply_tables() {
  return ask([this]() -> Answer { return may_apply_tables_now(); }, Wait::for_end);
}

PanelMachine::Answer PanelMachine::take_tables() {
  return ask([this]() -> Answer {
    if (const Answer may = may_apply_tables_now(); !may) return may;
    const bool has_run = stepping_->next() && stepping_->next()->number - std::uint32_t(entered_) > 1;
    if (!has_run) return open(lane_->sample().machine);
    StopPoint here;
    here.line = stepping_->next()->line;
    if (stepping_->next()->file != 0) here.file = session_->control().file_name(stepping_->next()->file);
    here.number = stepping_->next()->number - std::uint32_t(entered_);
    retables_.emplace(PanelSearch::SearchRequest{here, 0, false, {}});
    for (std::size_t i = 0; !is_alone() && i < lanes_.size(); ++i)
      retables_->blocks.push_back(session_->channels()[i].control->blocks() - lanes_[i]->entered);
    begin_search();
    return {};
  });
}

/// Applies edited tables as if the program had been executed with these tables up to the present block. The axes do not move.
void PanelMachine::apply_edited_tables() {
  const PanelSearch::Answer found = search_->find(*retables_);
  if (!found.ready) return;
  retables_.reset();
  Answer taken = found.place ? Answer() : Failed(translated(texts::panel::not_reached_with_tables));
  if (taken && !stand_as_in(*found.place)) taken = Failed(translated(texts::panel::others_elsewhere_with_tables));
  if (taken) taken = begin_session(start_);
  if (taken) taken = resume_from(*found.place);
  if (!taken) {
    panel_state_.message = taken.error();
  } else {
    for (std::size_t i = 0; i < lanes_.size(); ++i) {
      const Axes machine = lanes_[i]->sample().machine;
      if (!session_->channels()[i].control->meeting()) session_->stand_at(i, machine);
      lanes_[i]->on.work = session_->stand(i).work, lanes_[i]->on.machine = machine;
    }
    panel_state_.mode = PanelMode::standing;
  }
  show();
}

}  // namespace kadr
