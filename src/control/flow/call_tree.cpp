// Stores chains of calls, each chain only once. Used by control/interpreter.

#include "control/flow/call_tree.h"

#include <algorithm>

namespace kadr {

std::uint16_t CallTree::chain_of(const ControlDef& def, const std::vector<CallFrame>& open) {
  if (open.empty()) return 0;
  const CallFrame& inner = open.back();
  const Origin& caller = inner.caller;
  const Key key{caller.calls, caller.line, caller.file, std::uint8_t(inner.kind), inner.name, inner.reader};
  if (last_chain_ != 0 && last_depth_ == open.size() && last_block_ == caller.number && last_key_ == key) return last_chain_;
  const auto found = known_.find(key);
  std::uint16_t chain = found == known_.end() ? std::uint16_t(0) : found->second;
  if (chain == 0 && chains_.size() < most) {
    chains_.push_back({caller.calls, {{Flow::name_of(def, inner), caller.line, caller.block, caller.has_block, {}}, caller.file}});
    chain = std::uint16_t(chains_.size());
    known_.emplace(key, chain);
  }
  last_depth_ = open.size(), last_block_ = caller.number, last_key_ = key, last_chain_ = chain;
  return chain;
}

std::vector<CallTree::Call> CallTree::calls(std::uint16_t chain) const {
  std::vector<Call> calls;
  for (; chain != 0 && chain <= chains_.size(); chain = chains_[chain - 1u].outer) calls.push_back(chains_[chain - 1u].call);
  std::reverse(calls.begin(), calls.end());
  return calls;
}

}  // namespace kadr
