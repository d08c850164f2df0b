// guess_trial: compares possible controls by running the beginning of the program on each. It is used by session/folder_guess and tested by
// tests/guess.py.

#include "session/guess_trial.h"

#include <algorithm>
#include <memory>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "config/control/control_file.h"
#include "session/session.h"

namespace kadr {
namespace {

constexpr std::size_t lines_tried = 200;
constexpr std::uint64_t blocks_tried = 1000;  // greatest number of blocks that are executed, including repetitions in loops and subprograms
constexpr std::size_t max_bytes = 16384;

std::string beginning_of(std::string_view sample) {
  std::size_t end = 0;
  for (std::size_t lines = 0; end < sample.size() && lines < lines_tried; ++lines) {
    const std::size_t next = std::min(sample.find('\n', end), sample.size() - 1) + 1;
    if (next > max_bytes) break;
    end = next;
  }
  return std::string(sample.substr(0, end));
}

/// True if the alarm shows that the program is for another control, that is, if it concerns characters, codes or words. Other alarms depend
/// on the machine, the set-up or files that are not available here, so they are ignored.
bool is_of_language(const Alarm& alarm) {
  if (alarm.severity != Severity::alarm) return false;
  return alarm.id <= AlarmId::not_together && alarm.id != AlarmId::program_start_missing && alarm.id != AlarmId::end_of_block_missing;
}

/// Executes the text on the control `control`. Returns the number of different alarms that show that the text is for another control.
std::size_t faults_of(const std::string& control, const std::string& text) {
  auto def = load_control(control);
  auto machine = load_machine("generic");
  if (!def || !machine) return 1;
  RunLimits limits;
  limits.restarts = 0;
  limits.repeated_blocks = blocks_tried;
  Program program{{}, text_source(text), Encoding::utf8};
  auto session = Session::open({std::make_shared<const ControlDef>(std::move(*def)), std::move(*machine), {}, std::move(program), limits});
  if (!session) return 1;
  std::set<AlarmId> kinds;
  std::size_t alarms = 0;
  (*session)->outlets().warning = [](const AlarmReport&) {};
  (*session)->outlets().alarm = [&](const AlarmReport& report) {
    constexpr std::size_t enough = 50;
    if (is_of_language(report.alarm)) kinds.insert(report.alarm.id);
    return ++alarms < enough;
  };
  while ((*session)->blocks() < blocks_tried && (*session)->go_on() == Session::State::running) {
  }
  return kinds.size();
}

}  // namespace

void try_guess(Guess& guess, std::string_view sample) {
  const std::vector<std::string> candidates = candidates_of(guess);
  if (candidates.size() < 2) return;
  const std::string text = beginning_of(sample);
  std::vector<std::pair<std::string, std::size_t>> faults;
  for (const std::string& control : candidates) faults.emplace_back(control, faults_of(control, text));
  take_trial(guess, faults);
}

}  // namespace kadr
