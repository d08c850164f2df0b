// The local variables at a snapshot. Used by lsp/debug_values; tested by tests/dap.py.

#include "control/local_variables.h"

#include "control/flow/flow.h"
#include "control/snapshot_content.h"

namespace kadr {

std::vector<LocalVariables> DialectState::local_variables(const std::vector<CallFrame>&, const ControlDef&) const { return {}; }

std::vector<LocalVariables> local_variables(const Snapshot& snapshot, const ControlDef& def) {
  const Snapshot::Content& content = snapshot.content();
  if (!content.dialect) return {};
  return content.dialect->local_variables(content.flow.now.frames, def);
}

}  // namespace kadr
