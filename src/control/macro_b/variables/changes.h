#pragma once
// What must survive power-off and has changed: rows for the state file (spec/nct/09, 12.3, 23.1.4, 23.1.9, 24.1).

#include <map>
#include <string>

#include "config/state_file.h"

namespace kadr {
class Emitter;
}

namespace kadr::macro_b {

/// Remembers what was saved last, so that a block's changes are the difference.
class Changes {
 public:
  /// What has changed since the last call; empty where nothing may have. The first call gives everything: a set-up may have
  /// put its tables over what the file holds.
  StateChanges take(Emitter& m);

 private:
  std::map<std::pair<StateTable, std::string>, StateValue> tables_;  // saved rows of all tables but the variables
  double parts_done_ = 0, parts_required_ = 0, cutting_ms_ = 0;
  std::uint64_t parameters_ = 0;
  bool all_ = true;  // the first time
};

}  // namespace kadr::macro_b
