#pragma once
// ProgramCheck: everything that a check of a program reports, each item once: every fault of every channel after which the run can
// continue, including faults of subprograms that are never called; then the checklist, unless a block was refused; then the values that
// no set-up states. Used by kadr check and the page's check.

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
  /// Receives the findings in that order.  returns  false to get no more for that channel
  using Take = std::function<bool(std::size_t channel, const AlarmReport& report)>;

  struct Wish {
    std::set<std::string> stated{};  // PlacedSetup::stated
    ChecklistBasis basis{};          // the tools file and whether it is the program's own
    bool one_pass = true;            // run a program that repeats (M99, M47) once; else as often as its set-up or the user requests
    Onlooker* onlooker = nullptr;
    StopToken stop{};
  };

  explicit ProgramCheck(Wish wish, Take take) : wish_(std::move(wish)), take_(std::move(take)) {}

  /// Runs a session that has not started. Several programs of one file are checked one after the other; what they share is reported once.
  void check(Session& session);

 private:
  struct OfChannel;
  bool take(std::size_t channel, OfChannel& of, const AlarmReport& report);

  const Wish wish_;
  const Take take_;
  bool only_subprograms_ = false;  // the file is not run itself, so it needs no end of program
  // reported findings by channel: file, line, column, id
  std::vector<std::set<std::tuple<std::string, std::uint32_t, std::uint32_t, AlarmId>>> seen_;
};

}  // namespace kadr
