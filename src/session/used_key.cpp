// used_key: returns the names of the values that a program has used. It is used by session/unstated, cli/setup_command and view/sheet, and
// tested by tests/setup_command.py.

#include "session/used_key.h"

#include <fmt/core.h>

#include "config/setup/setup_names.h"

namespace kadr {
namespace {

std::string name_of_work_offset(std::uint32_t row, const ControlDef& def) {
  for (const WorkSystem& system : work_systems(def))
    if (system.row == row && system.works) return system.name;
  return std::to_string(row);
}

/// A lathe's T word names tool and offset: T0101. The nose radius has no word of its own, so its key stands for it.
UsedKey of_turret(const Use& use) {
  const std::string row = fmt::format("offsets.{}", use.number);
  if (use.kind == UseKind::radius) return {row + ".radius", row + ".radius"};
  return {row, fmt::format("T{:02}{:02}", use.tool, use.number)};
}

}  // namespace

UsedKey used_key(const Use& use, const ControlDef& def) {
  if (has(def, SetupNeeds::lathe_offsets) && (use.kind == UseKind::length || use.kind == UseKind::radius)) return of_turret(use);
  const bool has_h = def.grammar.word('H').known && def.address('H').function != Function::repeat_word;
  switch (use.kind) {
    case UseKind::length: return {fmt::format("offsets.{}.length", use.number), fmt::format("{}{}", has_h ? 'H' : 'D', use.number)};
    case UseKind::radius: return {fmt::format("offsets.{}.radius", use.number), fmt::format("D{}", use.number)};
    case UseKind::work_zero: {
      const std::string name = name_of_work_offset(use.number, def);
      if (has(def, SetupNeeds::zeros)) return {fmt::format("zeros.{}", use.number), name};
      return {"work_offsets." + name, name};
    }
    case UseKind::corrector: return {fmt::format("correctors.{}", use.number), fmt::format("L{}", use.number)};
    case UseKind::tool: return {"", fmt::format("T{}", use.number)};
    case UseKind::variable: return {fmt::format("variables.#{}", use.number), fmt::format("#{}", use.number)};
    case UseKind::parameter: return {fmt::format("variables.R{}", use.number), fmt::format("R{}", use.number)};
    case UseKind::skip_switch: return {"skip", use.number == 1 ? "/" : fmt::format("/{}", use.number)};
    default: return {"optional_stop", "M1"};
  }
}

}  // namespace kadr
