#pragma once
// SearchRules: of a control's own block search. NCT 13.1, 12.1.

#include <utility>
#include <vector>

namespace kadr {

struct SearchRules {
  std::vector<std::pair<int, int>> groups;  // of M codes that exclude each other: least, greatest; of each only the last is carried out
  bool tool_on_m6 = false;                  // the tool is changed on M6; else on T
};

}  // namespace kadr
