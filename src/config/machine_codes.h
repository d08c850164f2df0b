#pragma once
// MachineCodes: which M function of one control's machine is which of another's, by the tables [convert] of both files.

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "config/control_def.h"

namespace kadr {

class MachineCodes {
 public:
  /// Rows for another control come first by its id, then by what it extends, then "*"; the table of `from` before that of `to`.
  MachineCodes(const ControlDef& from, const ControlDef& to);

  /// What an M function of `from` is on the other one, what one of `to` is on this one; nothing: no table says so.
  std::optional<std::uint32_t> there(std::uint32_t code) const;
  std::optional<std::uint32_t> here(std::uint32_t code) const;
  /// Pairs of codes, of `from` and of `to`.
  struct Pair {
    std::uint32_t here = 0, there = 0;
  };
  const std::vector<Pair>& pairs() const { return pairs_; }
  /// A row that names the other control, but a code that is no M function of its machine and no coolant; nothing: all do.
  struct Fault {
    std::string control;  // whose table
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

/// The row of an M code; nullptr: the control has none that works.
const CodeRow* machine_row(const ControlDef& def, std::uint32_t code);
/// It is a function of the machine, or switches coolant.
bool is_of_machine(const CodeRow& row);
bool switches_coolant(Function function);

}  // namespace kadr
