#pragma once
// ProgramCheck: all that is told of a program that is checked: every fault of every channel past which it can go on, of the subprograms
// that nobody calls too; then, where nothing was refused, the checklist; then what no set-up states. Each once. For kadr check and the
// page's check.

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
  /// Gets what is found, in that order.  returns  false: no more of that channel
  using Take = std::function<bool(std::size_t channel, const AlarmReport& report)>;

  struct Wish {
    std::set<std::string> stated{};  // PlacedSetup::stated
    ChecklistBasis basis{};          // the tools file and whether it is the program's own
    bool one_pass = true;            // of a program that begins again (M99, M47); else its set-up or somebody wants more
    Onlooker* onlooker = nullptr;
    StopToken stop{};
  };

  explicit ProgramCheck(Wish wish, Take take) : wish_(std::move(wish)), take_(std::move(take)) {}

  /// Carries out a session that has not begun. Of several programs of a file one after the other: what they have in common is told once.
  void check(Session& session);

 private:
  struct OfChannel;
  bool take(std::size_t channel, OfChannel& of, const AlarmReport& report);

  const Wish wish_;
  const Take take_;
  bool only_subprograms_ = false;                                                               // nobody runs the file: it needs no end
  std::vector<std::set<std::tuple<std::string, std::uint32_t, std::uint32_t, AlarmId>>> seen_;  // by channel: file, line, column, which
};

}  // namespace kadr
