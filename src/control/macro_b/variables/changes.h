#pragma once
// Finds the values that have changed and must survive power-off, and returns them as rows for the state file (spec/nct/09, 12.3, 23.1.4,
// 23.1.9, 24.1).

#include <map>
#include <string>

#include "config/state/state_file.h"

namespace kadr {
class Emitter;
}

namespace kadr::macro_b {

/// The values that were saved last. A value has changed if it differs from the saved value.
class Changes {
 public:
  /// Returns the values that have changed since the last call. The first call returns all values, because the set-up may have replaced
  /// tables of the state file.
  StateChanges take(Emitter& m);

 private:
  std::map<std::pair<StateTable, std::string>, StateValue> tables_;  // rows as they were saved last, of all tables except the variables
  double parts_done_ = 0, parts_required_ = 0, cutting_ms_ = 0;
  std::uint64_t parameters_ = 0;
  bool all_ = true;  // true until the first take(), which returns all values, changed or not
};

}  // namespace kadr::macro_b
