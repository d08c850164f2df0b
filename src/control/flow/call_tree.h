#pragma once
// CallTree: by which calls a block came to be carried out, in a number that an Origin holds. Each way of calls that a run takes stands here
// once, however often it is taken: what is kept grows with the program's text and not with its run.

#include <cstdint>
#include <map>
#include <tuple>
#include <vector>

#include "action/action.h"
#include "control/flow/flow.h"

namespace kadr {

class CallTree {
 public:
  static constexpr std::size_t most = 65535;  // ways of calls: blocks of further ones have none

  /// Of the calls that are open.
  ///   returns  0: there are none
  std::uint16_t way_of(const ControlDef& def, const std::vector<CallFrame>& open);

  /// A call of a way, and the file that it stands in.
  struct Call {
    AlarmReport::Call call;
    std::uint16_t file = 0;  // as Origin::file
  };
  /// The outermost first.
  std::vector<Call> calls(std::uint16_t way) const;

 private:
  struct Way {
    std::uint16_t outer = 0;  // the way to the caller
    Call call;
  };
  /// The way to the caller; line and file of the call; what is called: kind, name, file.
  using Key = std::tuple<std::uint16_t, std::uint32_t, std::uint16_t, std::uint8_t, std::uint32_t, std::uint16_t>;

  std::vector<Way> ways_;  // [0] is number 1
  std::map<Key, std::uint16_t> known_;
  // The calls that were open last: a call is made by one block of the run.
  std::size_t last_depth_ = 0;
  std::uint32_t last_block_ = 0;
  Key last_key_;
  std::uint16_t last_way_ = 0;
};

}  // namespace kadr
