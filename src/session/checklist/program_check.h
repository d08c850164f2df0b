#pragma once
// ProgramCheck: reports everything that a check of a program finds, each finding once. First come the faults of all channels after which
// the run can continue, including faults of subprograms that are never called. Then follows the checklist, unless the control refused a
// block. Last come the values that the set-up does not state. ProgramCheck is used by kadr check and by the check of the page.

#include <cstdint>
#include <functional>
#include <set>
#include <string>
#include <tuple>
#include <vector>

#include "session/checklist/tool_table.h"
#include "session/session.h"

namespace kadr {

class CheckMemory;

class ProgramCheck {
 public:
  /// A function of the caller that receives the findings in this order: faults, checklist, unstated values. It returns false to receive no
  /// more findings of that channel.
  using Take = std::function<bool(std::size_t channel, const AlarmReport& report)>;

  struct CheckRequest {
    std::set<std::string> stated{};  // names of the keys that the set-up states: PlacedSetup::stated
    ChecklistBasis basis{};          // the tools file, and whether it belongs to this program only
    bool one_pass = true;  // true: a program that repeats itself (M99, M47) is run once; false: as often as the set-up or the user requests
    ProgressDisplay* progress_display = nullptr;
    StopToken stop{};
  };

  explicit ProgramCheck(CheckRequest request, Take take) : request_(std::move(request)), take_(std::move(take)) {}

  /// Runs a session that has not started, and reports the findings. If a file contains several programs, they are checked one after the
  /// other, and a finding that they have in common is reported once.
  ///   memory  what the last check of the text has stored, if the session has a single channel and reads the source that
  ///           CheckMemory::follow() returned; nullptr: the check begins at the start and stores nothing
  void check(Session& session, CheckMemory* memory = nullptr);

 private:
  struct OfChannel;
  bool take(std::size_t channel, OfChannel& of, const AlarmReport& report);
  void run(Session& session, OfChannel& of, CheckMemory& memory);

  const CheckRequest request_;
  const Take take_;
  bool only_subprograms_ = false;   // true: the file contains only subprograms, so it is not run and needs no end of program
  CheckMemory* running_ = nullptr;  // notes the findings of the run
  // findings that have already been reported, by channel: file, line, column, alarm id
  std::vector<std::set<std::tuple<std::string, std::uint32_t, std::uint32_t, AlarmId>>> seen_;
};

}  // namespace kadr
