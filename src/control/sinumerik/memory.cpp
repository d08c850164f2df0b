// Copies of what a Sinumerik remembers, for snapshots. Used by control/sinumerik.

#include "control/sinumerik/memory.h"

#include <unordered_map>

namespace kadr::sinumerik {

Memory separate_copy(const Memory& memory) {
  Memory copy = memory;
  std::unordered_map<const Variable*, std::shared_ptr<Variable>> copies;
  const auto copied = [&](std::shared_ptr<Variable>& shared) {
    if (shared == nullptr) return;
    std::shared_ptr<Variable>& own = copies[shared.get()];
    if (own == nullptr) own = std::make_shared<Variable>(*shared);
    shared = own;
  };
  for (auto& [name, variable] : copy.globals) copied(variable);
  for (Level& level : copy.levels) {
    for (auto& [name, variable] : level.variables) copied(variable);
    for (auto& reference : level.references) copied(reference);
  }
  return copy;
}

}  // namespace kadr::sinumerik
