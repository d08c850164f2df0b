#pragma once
// Helpers for the tests of alarms. A faulty block leaves everything as it was. If the check continues
// after it, only the modes of its motion and its end position remain (Interpreter::go_on), because
// later blocks rely on them. Once these are stated again, nothing of the faulty block remains.

#include <algorithm>
#include <string>

#include "control/run_program.h"

namespace kadr::test {

/// Blocks that build up state (`before`), blocks that show the state (`after`), and blocks between the faulty block and `after` that state
/// the modes of motions and the position again (the third string); the run without the faulty block has all of them too.
struct Scene {
  const char* control;
  std::string before, after, restart = {};
};

/// Returns what the faulty block has left behind; empty if nothing.
inline std::string differences(const Scene& scene, const std::string& fault, const kadr::Setup& setup) {
  const std::string after = scene.restart + scene.after;
  const auto plain = run(scene.control, scene.before + after, setup);
  const auto faulty = run(scene.control, scene.before + fault + "\n" + after, setup, OnAlarm::go_on);
  const auto cut = run(scene.control, scene.before, setup);
  const auto stopped = run(scene.control, scene.before + fault + "\n" + after, setup);
  if (!plain.alarms.empty()) return "the scene itself: " + plain.first_alarm() + " in line " + std::to_string(plain.alarms[0].origin.line);
  if (faulty.alarms.empty()) return "no alarm";
  const auto faulty_line = static_cast<std::uint32_t>(std::count(scene.before.begin(), scene.before.end(), '\n') + 1);
  for (const AlarmReport& r : faulty.alarms)  // once, or once per pass of a repetition
    if (r.origin.line != faulty_line) return "and then: " + std::string(name_of(r.alarm.id)) + " in line " + std::to_string(r.origin.line);
  if (exactly(stopped.actions) != exactly(cut.actions)) return "actions of the faulty block";
  if (exactly(stopped.ending) != exactly(cut.ending)) return "state:\n  " + exactly(stopped.ending) + "\n  " + exactly(cut.ending);
  if (stopped.state != cut.state) return "tables:\n  " + stopped.state + "\n  " + cut.state;
  if (exactly(faulty.actions) != exactly(plain.actions)) return "actions behind it";
  if (exactly(faulty.ending) != exactly(plain.ending)) return "state at the end";
  if (faulty.state != plain.state) return "tables at the end";
  return "";
}

}  // namespace kadr::test
