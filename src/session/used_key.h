#pragma once
// used_key: names of the values that the program has used, in the set-up and in the program.

#include <string>

#include "config/control_def.h"
#include "control/state/usage.h"

namespace kadr {

/// The set-up key that states the value ("offsets.1.length", "work_offsets.G54"), and the word that the program uses ("H1", "G54").
struct UsedKey {
  std::string key;
  std::string word;
};
UsedKey used_key(const Use& use, const ControlDef& def);

}  // namespace kadr
