#pragma once
// CodeMatch: which code of one control does what a code of another one does. Codes are matched by what they do, never by their numbers;
// of canned cycles, whose functions are the controls' own, by their steps or names.

#include <vector>

#include "config/control_def.h"

namespace kadr {

constexpr int inner_corners = 62, without_slowing = 63;  // of G62, G63
constexpr int continuous_cutting = 64;                   // CodeRow::arg of Function::feed_control: G64 of the NCT

class CodeMatch {
 public:
  CodeMatch(const ControlDef& from, const ControlDef& to);

  /// nullptr: the other control has none that works.
  ///   pre  row is one of from.codes
  const CodeRow* of(const CodeRow& row) const {
    const int index = rows_[static_cast<std::size_t>(&row - from_.codes.data())];
    return index < 0 ? nullptr : &to_.codes[static_cast<std::size_t>(index)];
  }

 private:
  const ControlDef& from_;
  const ControlDef& to_;
  std::vector<int> rows_;  // by row of `from`; -1: none
};

/// G73 to G89: a canned cycle, of whatever kind the control has it.
bool is_canned_cycle(const CodeRow& row);
/// It ends cycles.
bool ends_cycles(const CodeRow& row);

}  // namespace kadr
