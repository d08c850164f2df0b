#pragma once
// used_key: returns the names of a value that a program has used: the key in the set-up and the word in the program.

#include <string>

#include "config/control/control_def.h"
#include "control/state/usage.h"

namespace kadr {

/// The key of the value in the set-up ("offsets.1.length", "work_offsets.G54"), and the word that uses it in the program ("H1", "G54"). On
/// a lathe the key is the row with all lengths of the offset, and the word has tool and offset: "offsets.1", "T0101".
struct UsedKey {
  std::string key;
  std::string word;
};
UsedKey used_key(const Use& use, const ControlDef& def);

}  // namespace kadr
