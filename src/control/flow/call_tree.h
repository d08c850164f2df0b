#pragma once
// CallTree: numbers the chains of calls through which blocks are reached, so that an Origin can hold one as a number. Each chain is
// stored once, however often the run uses it: memory grows with the text of the program, not with the length of the run.

#include <cstdint>
#include <map>
#include <tuple>
#include <vector>

#include "action/action.h"
#include "control/flow/flow.h"

namespace kadr {

class CallTree {
 public:
  static constexpr std::size_t most = 65535;  // chains of calls; blocks reached through further chains have number 0

  /// Returns the number of the chain of the open calls.
  ///   returns  0 if no call is open
  std::uint16_t way_of(const ControlDef& def, const std::vector<CallFrame>& open);

  /// One call of a chain, and the file that contains the call.
  struct Call {
    AlarmReport::Call call;
    std::uint16_t file = 0;  // number of the file, as in Origin::file
  };
  /// Returns the calls of a chain, outermost first.
  std::vector<Call> calls(std::uint16_t way) const;

 private:
  struct Way {
    std::uint16_t outer = 0;  // number of the caller's chain
    Call call;
  };
  /// Number of the caller's chain; line and file of the call; what is called: kind, name, file.
  using Key = std::tuple<std::uint16_t, std::uint32_t, std::uint16_t, std::uint8_t, std::uint32_t, std::uint16_t>;

  std::vector<Way> ways_;  // [0] has the number 1
  std::map<Key, std::uint16_t> known_;
  // The chain of the previous query. The block that made the call identifies it.
  std::size_t last_depth_ = 0;
  std::uint32_t last_block_ = 0;
  Key last_key_;
  std::uint16_t last_way_ = 0;
};

}  // namespace kadr
