#pragma once
// Comments that a control executes, such as (MSG, …) and (DEBUG, …) of RS274/NGC (spec/linuxcnc 3.4): they are no remarks.

#include <algorithm>
#include <string_view>

#include "base/ascii.h"

namespace kadr {

/// Returns true for such a comment, without its brackets. Whether the control at hand executes it is not asked.
inline bool is_executed_comment(std::string_view comment) {
  while (comment.starts_with(' ')) comment.remove_prefix(1);
  for (const std::string_view word : {"MSG", "DEBUG", "PRINT", "LOG", "PROBE", "AXIS", "PREVIEW", "ABORT", "PY"}) {
    if (comment.size() <= word.size()) continue;
    if (std::equal(word.begin(), word.end(), comment.begin(), [](char a, char b) { return a == to_upper(b); })) return true;
  }
  return false;
}

}  // namespace kadr
