#pragma once
// Copies into a job what machine and set-up of a session state about a cut: the tool in the spindle, lengths, the chains of axes. Used by
// cli/cut and view/part_run.

#include "session/cutting/cutting.h"
#include "session/session.h"

namespace kadr {

/// `starts_known`: the set-up states the start position of the tool.
void take_session(const Session& session, bool starts_known, CutJob& cut);

}  // namespace kadr
