#pragma once
// SearchRules: the rules by which a control's own block search executes M codes and tool changes (NCT 13.1, 12.1).

#include <utility>
#include <vector>

namespace kadr {

struct SearchRules {
  // ranges (first, last) of M codes that replace each other: the block search executes only the last code of each range
  std::vector<std::pair<int, int>> groups;
  bool tool_on_m6 = false;  // true: in the block search M6 changes the tool; false: T changes the tool
};

}  // namespace kadr
