#pragma once
// CallTree: numbers the chains of calls through which blocks are reached, so that an Origin can hold a chain as a number. Each chain is
// stored once, however often the run uses it, so memory grows with the text of the program, not with the length of the run.

#include <cstdint>
#include <map>
#include <tuple>
#include <vector>

#include "action/action.h"
#include "control/flow/flow.h"

namespace kadr {

class CallTree {
 public:
  // Greatest number of chains. Blocks that are reached through any further chain get the number 0.
  static constexpr std::size_t most = 65535;

  /// Returns the number of the chain that the open calls form; 0 if no call is open.
  std::uint16_t chain_of(const ControlDef& def, const std::vector<CallFrame>& open);

  /// One call of a chain, with the file that contains the calling block.
  struct Call {
    AlarmReport::Call call;
    std::uint16_t file = 0;  // number of the file with the calling block, as in Origin::file
  };
  /// Returns the calls of the chain with this number, outermost first.
  std::vector<Call> calls(std::uint16_t chain) const;

 private:
  struct Chain {
    std::uint16_t outer = 0;  // number of the chain of calls that led to the caller
    Call call;
  };
  /// The data that identify a chain: the number of the caller's chain; the line and the file of the call; the kind, the name and the file
  /// of the called subprogram.
  using Key = std::tuple<std::uint16_t, std::uint32_t, std::uint16_t, std::uint8_t, std::uint32_t, std::uint16_t>;

  std::vector<Chain> chains_;  // chains of calls by number; element [0] is the chain with the number 1
  std::map<Key, std::uint16_t> known_;
  // The result of the last chain_of(), which is returned again while the innermost call is the same. The call is identified by the number
  // of its block.
  std::size_t last_depth_ = 0;
  std::uint32_t last_block_ = 0;
  Key last_key_;
  std::uint16_t last_chain_ = 0;
};

}  // namespace kadr
