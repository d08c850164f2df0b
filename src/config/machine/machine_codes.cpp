// Maps M functions between two controls. Used by convert/code_match, compare/comparison; tested by tests/config/machine_codes_test.cpp.

#include "config/machine/machine_codes.h"

#include <algorithm>

namespace kadr {
namespace {

constexpr std::int32_t tenths = 10;

/// Returns a number that is greater the more specifically the row names the other control; 0 if the row does not apply to that control.
std::size_t nearness(const MachineCodeRow& row, const ControlDef& other) {
  if (row.control == other.id) return other.lineage.size() + 2;
  const auto found = std::find(other.lineage.begin(), other.lineage.end(), row.control);
  if (found != other.lineage.end()) return static_cast<std::size_t>(other.lineage.end() - found) + 1;
  return row.control == "*" ? 1 : 0;
}

}  // namespace

const CodeRow* machine_row(const ControlDef& def, std::uint32_t code) {
  const std::int32_t row = def.row_of('M', static_cast<std::int32_t>(code) * tenths);
  return row < 0 || !def.codes[static_cast<std::size_t>(row)].works ? nullptr : &def.codes[static_cast<std::size_t>(row)];
}

bool switches_coolant(Function function) {
  return function == Function::coolant_flood || function == Function::coolant_mist || function == Function::coolant_off;
}

bool is_of_machine(const CodeRow& row) { return row.function == Function::machine_function || switches_coolant(row.function); }

MachineCodes::MachineCodes(const ControlDef& from, const ControlDef& to) {
  take(from, to, true);
  take(to, from, false);
}

void MachineCodes::take(const ControlDef& own, const ControlDef& other, bool own_is_from) {
  for (const MachineCodeRow& row : own.machine_codes) {
    const std::size_t near = nearness(row, other);
    const bool is_best = std::none_of(own.machine_codes.begin(), own.machine_codes.end(),
                                      [&](const MachineCodeRow& one) { return one.code == row.code && nearness(one, other) > near; });
    if (near == 0 || !is_best) continue;
    const CodeRow* const there = machine_row(other, row.there);
    if (there == nullptr || !is_of_machine(*there)) {
      if (near > 1 && !fault_) fault_ = Fault{own.id, row.code, other.id, row.there};
      continue;  // if the row is for all controls ("*"), this is no fault, because not every control has the code of the row
    }
    const Pair pair = own_is_from ? Pair{row.code, row.there} : Pair{row.there, row.code};
    if (!this->there(pair.here) && !here(pair.there)) pairs_.push_back(pair);
  }
}

std::optional<std::uint32_t> MachineCodes::there(std::uint32_t code) const {
  const auto found = std::find_if(pairs_.begin(), pairs_.end(), [&](const Pair& pair) { return pair.here == code; });
  return found == pairs_.end() ? std::nullopt : std::optional(found->there);
}
std::optional<std::uint32_t> MachineCodes::here(std::uint32_t code) const {
  const auto found = std::find_if(pairs_.begin(), pairs_.end(), [&](const Pair& pair) { return pair.there == code; });
  return found == pairs_.end() ? std::nullopt : std::optional(found->here);
}

}  // namespace kadr
