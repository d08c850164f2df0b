#pragma once
// MachineCodes: maps the M functions of one control's machine to those of another control's machine, by the tables [convert] of both files.

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "config/control/control_def.h"

namespace kadr {

class MachineCodes {
 public:
  /// A row with the id of the other control has priority over a row with the id of a base of this control; a row with "*" has the lowest
  /// priority. The table of `from` has priority over the table of `to`.
  MachineCodes(const ControlDef& from, const ControlDef& to);

  /// there() returns the M function of `to` for an M function of `from`; here() returns the M function of `from` for one of `to`. Both
  /// return nullopt if no table contains the function.
  std::optional<std::uint32_t> there(std::uint32_t code) const;
  std::optional<std::uint32_t> here(std::uint32_t code) const;
  /// Two corresponding M codes: `here` on the control `from`, `there` on the control `to`.
  struct Pair {
    std::uint32_t here = 0, there = 0;
  };
  const std::vector<Pair>& pairs() const { return pairs_; }
  /// A faulty row of [convert]: its code on the other control is no M function of that control's machine and does not switch coolant. The
  /// row names the other control itself, not "*".
  struct Fault {
    std::string control;  // the control whose table contains the faulty row
    std::uint32_t code = 0;
    std::string other;
    std::uint32_t there = 0;
  };
  const std::optional<Fault>& fault() const { return fault_; }

 private:
  void take(const ControlDef& own, const ControlDef& other, bool own_is_from);

  std::vector<Pair> pairs_;
  std::optional<Fault> fault_;
};

/// Returns the row of an M code; nullptr if the control has no row for it, or if Kadr does not implement the code.
const CodeRow* machine_row(const ControlDef& def, std::uint32_t code);
/// is_of_machine() returns true for functions of the machine and for functions that switch coolant; switches_coolant() only for the latter.
bool is_of_machine(const CodeRow& row);
bool switches_coolant(Function function);

}  // namespace kadr
