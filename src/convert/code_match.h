#pragma once
// CodeMatch: finds the code of one control that has the same function as a code of another control. Code numbers are never compared. The
// functions of canned cycles differ between controls, so cycles are matched by their steps or names.

#include <vector>

#include "config/control/control_def.h"

namespace kadr {

constexpr int inner_corners = 62, without_slowing = 63;  // values of CodeRow::arg in the rows of G62 and G63
// value of CodeRow::arg in the row of G64 of the NCT, whose function is Function::feed_control
constexpr int continuous_cutting = 64;

class CodeMatch {
 public:
  CodeMatch(const ControlDef& from, const ControlDef& to);

  /// Returns the target control's code for the row of the source control; nullptr if the target control has no such code, or if Kadr does
  /// not implement one of the two codes.
  ///   pre  row is one of from.codes
  const CodeRow* of(const CodeRow& row) const {
    const int index = rows_[static_cast<std::size_t>(&row - from_.codes.data())];
    return index < 0 ? nullptr : &to_.codes[static_cast<std::size_t>(index)];
  }

 private:
  const ControlDef& from_;
  const ControlDef& to_;
  std::vector<int> rows_;  // index of the row in the target control, by index of the row in `from_`; -1: no match
};

/// True for the canned cycles G73 to G89, independent of the functions that the control's table gives them.
bool is_canned_cycle(const CodeRow& row);
/// True if the code cancels canned cycles.
bool ends_cycles(const CodeRow& row);

}  // namespace kadr
