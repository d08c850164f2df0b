// Stores chains of calls, each chain only once. Used by control/interpreter.

#include "control/flow/call_tree.h"

#include <algorithm>

namespace kadr {

std::uint16_t CallTree::way_of(const ControlDef& def, const std::vector<CallFrame>& open) {
  if (open.empty()) return 0;
  const CallFrame& inner = open.back();
  const Origin& caller = inner.caller;
  const Key key{caller.calls, caller.line, caller.file, std::uint8_t(inner.kind), inner.name, inner.reader};
  if (last_way_ != 0 && last_depth_ == open.size() && last_block_ == caller.number && last_key_ == key) return last_way_;
  const auto found = known_.find(key);
  std::uint16_t way = found == known_.end() ? std::uint16_t(0) : found->second;
  if (way == 0 && ways_.size() < most) {
    ways_.push_back({caller.calls, {{Flow::name_of(def, inner), caller.line, caller.block, caller.has_block, {}}, caller.file}});
    way = std::uint16_t(ways_.size());
    known_.emplace(key, way);
  }
  last_depth_ = open.size(), last_block_ = caller.number, last_key_ = key, last_way_ = way;
  return way;
}

std::vector<CallTree::Call> CallTree::calls(std::uint16_t way) const {
  std::vector<Call> calls;
  for (; way != 0 && way <= ways_.size(); way = ways_[way - 1u].outer) calls.push_back(ways_[way - 1u].call);
  std::reverse(calls.begin(), calls.end());
  return calls;
}

}  // namespace kadr
