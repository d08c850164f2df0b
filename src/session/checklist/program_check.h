#pragma once
// ProgramCheck: reports everything that a check of a program finds, each item once. First every fault of every channel after which the
// run can continue, including faults of subprograms that are never called; then the checklist, unless a block was refused; then the
// values that the set-up does not state. Used by kadr check and the page's check.

#include <cstdint>
#include <functional>
#include <set>
#include <string>
#include <tuple>
#include <vector>

#include "session/checklist/tool_table.h"
#include "session/session.h"

namespace kadr {

class ProgramCheck {
 public:
  /// Receives the findings in the order described above. Returns false to receive no more findings of that channel.
  using Take = std::function<bool(std::size_t channel, const AlarmReport& report)>;

  struct CheckRequest {
    std::set<std::string> stated{};  // keys that the set-up states: PlacedSetup::stated
    ChecklistBasis basis{};          // the tools file, and whether it belongs to this program only
    bool one_pass = true;  // run a program that repeats itself (M99, M47) once; false: as often as the set-up or the user requests
    ProgressDisplay* progress_display = nullptr;
    StopToken stop{};
  };

  explicit ProgramCheck(CheckRequest request, Take take) : request_(std::move(request)), take_(std::move(take)) {}

  /// Runs a session that has not started, and reports what it finds. Several programs of one file are checked one after the other; a
  /// finding that they share is reported once.
  void check(Session& session);

 private:
  struct OfChannel;
  bool take(std::size_t channel, OfChannel& of, const AlarmReport& report);

  const CheckRequest request_;
  const Take take_;
  bool only_subprograms_ = false;  // the file contains only subprograms, so it is not run and needs no end of program
  // the findings already reported, by channel: file, line, column, id
  std::vector<std::set<std::tuple<std::string, std::uint32_t, std::uint32_t, AlarmId>>> seen_;
};

}  // namespace kadr
