#pragma once
// Helpers for the tests of `control`: execute a program, and turn its motions into a comparable form.

#include <gtest/gtest.h>

#include <map>
#include <memory>
#include <string>

#include "config/control/control_file.h"
#include "config/state/state_json.h"
#include "control/control.h"

namespace kadr::test {

inline const ControlDef& control(const std::string& id) {
  static std::map<std::string, std::unique_ptr<ControlDef>> read;
  auto& def = read[id];
  if (!def) def = std::make_unique<ControlDef>(load_control(id).value());
  return *def;
}

/// The result of a run: all actions, the alarms (with `checking` each one is skipped by go_on), and the state after it.
struct Run {
  std::vector<Action> actions;
  std::vector<AlarmReport> alarms;
  std::vector<std::size_t> actions_at_alarm;
  std::vector<AlarmReport> warnings;
  FinalState ending;
  std::string state;  // tables and switches as JSON, of a control that has some

  std::vector<Motion> motions() const {
    std::vector<Motion> all;
    for (const Action& a : actions)
      if (const auto* m = std::get_if<Motion>(&a.what)) all.push_back(*m);
    return all;
  }
  std::string first_alarm() const { return alarms.empty() ? "" : std::string(name_of(alarms[0].alarm.id)); }
};

enum class OnAlarm { stop, go_on };

inline Run run(const std::string& id, const std::string& program, const Setup& setup = {}, OnAlarm on_alarm = OnAlarm::stop,
               std::optional<Encoding> encoding = {}) {
  Run result;
  Control machine(control(id), setup, Program{"test", text_source(program), encoding}, RunLimits{100'000, 10});
  machine.on_warning = [&](const AlarmReport& w) { result.warnings.push_back(w); };
  ActionBatch batch;
  for (;;) {
    const Control::State state = machine.run(batch);
    result.actions.insert(result.actions.end(), batch.begin(), batch.end());
    if (state == Control::State::ended) break;
    if (state == Control::State::needs_probe) machine.answer({true, result.motions().back().to});
    if (state != Control::State::stopped) continue;
    result.alarms.push_back(machine.report());
    result.actions_at_alarm.push_back(result.actions.size());
    if (on_alarm == OnAlarm::stop || result.alarms.size() > 1000) break;
    machine.go_on();
  }
  result.ending = machine.ending();
  if (const auto tables = machine.run_state()) result.state = state_json(*tables);
  return result;
}

/// Returns the action as text with bit-exact numbers, without its position in the program.
inline std::string exactly(const Action& action) {
  char text[1200];
  int size = std::snprintf(text, sizeof text, "%zu:", action.what.index());
  const auto add = [&](double x) { size += std::snprintf(text + size, sizeof text - static_cast<std::size_t>(size), " %a", x); };
  if (const auto* m = std::get_if<Motion>(&action.what)) {
    for (const double x : {double(m->kind), double(m->first), double(m->second), double(m->unit), double(m->exact), double(m->named),
                           m->turns, m->feed, m->tolerance, m->center.x, m->center.y})
      add(x);
    for (std::size_t a = 0; a < 9; ++a) add(m->to[a]), add(m->machine[a]);
  } else if (const auto* d = std::get_if<Dwell>(&action.what)) {
    add(d->seconds);
  } else if (const auto* s = std::get_if<Spindle>(&action.what)) {
    add(double(s->dir)), add(s->rpm);
  } else if (const auto* f = std::get_if<FrameChange>(&action.what)) {
    for (std::size_t a = 0; a < 9; ++a) add(f->placement.origin[a]), add(f->placement.length[a]), add(f->work[a]);
  } else if (const auto* t = std::get_if<ToolSelect>(&action.what)) {
    add(t->tool), add(t->corrector);
  } else if (const auto* k = std::get_if<MachineFunction>(&action.what)) {
    add(k->code);
  }
  return text;
}

inline std::vector<std::string> exactly(const std::vector<Action>& actions) {
  std::vector<std::string> all;
  for (const Action& a : actions) all.push_back(exactly(a));
  return all;
}

/// Returns true if the control executes the code itself and only reports it to the machine (nct 13.1).
inline bool is_report(const Action& action) {
  const auto* const function = std::get_if<MachineFunction>(&action.what);
  return function != nullptr && function->by_control;
}

inline std::vector<Action> untold(std::vector<Action> actions) {
  std::erase_if(actions, is_report);
  return actions;
}

/// Returns the state that an alarm must not change as one text: position, variables, codes in force.
inline std::string exactly(const FinalState& e) {
  std::string text;
  char number[40];
  const auto add = [&](double x) { std::snprintf(number, sizeof number, "%a ", x), text += number; };
  for (std::size_t a = 0; a < 9; ++a) add(e.position[a]), add(e.machine_position[a]);
  for (const auto& [name, value] : e.variables) text += name + "=", add(value);
  for (const std::string& code : e.modal) text += code + " ";
  return text;
}

/// Returns the length of a motion from `from`, arcs and helices included.
inline double path_length(const Motion& m, const Axes& from) {
  const Vec3 delta{m.to[0] - from[0], m.to[1] - from[1], m.to[2] - from[2]};
  if (m.turns == 0) return length(delta);
  const double along[] = {delta.x, delta.y, delta.z};
  const Vec2 arm = Vec2{from[m.first], from[m.second]} - m.center;
  return std::hypot(length(arm) * m.turns * 2 * pi, along[3 - m.first - m.second]);
}

}  // namespace kadr::test
