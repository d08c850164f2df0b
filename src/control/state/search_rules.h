#pragma once
// SearchRules: the rules by which a control's own block search executes M codes and tool changes (NCT 13.1, 12.1).

#include <utility>
#include <vector>

namespace kadr {

struct SearchRules {
  std::vector<std::pair<int, int>> groups;  // ranges (first, last) of M codes that replace each other: only the last is executed
  bool tool_on_m6 = false;                  // true: M6 changes the tool; false: T
};

}  // namespace kadr
