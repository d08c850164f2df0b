#pragma once
// What the program has used of a set-up, by the names that a set-up and the program have for it.

#include <string>

#include "config/control_def.h"
#include "control/state/usage.h"

namespace kadr {

/// The key of a set-up that states it ("offsets.1.length", "work_offsets.G54"), and how the program calls it ("H1", "G54").
struct UsedKey {
  std::string key;
  std::string word;
};
UsedKey used_key(const Use& use, const ControlDef& def);

}  // namespace kadr
