#pragma once
// SearchRules: the rules of a control's own block search. NCT 13.1, 12.1.

#include <utility>
#include <vector>

namespace kadr {

struct SearchRules {
  std::vector<std::pair<int, int>> groups;  // M codes (least, greatest) that exclude each other: only the last is executed
  bool tool_on_m6 = false;                  // the tool is changed by M6; else by T
};

}  // namespace kadr
