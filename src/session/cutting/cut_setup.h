#pragma once
// Copies data of a session's machine and set-up into a cutting job: the tool in the spindle, tool lengths, and the chains of axes to tool
// and part. Used by cli/cut and view/part_run.

#include "session/cutting/cutting.h"
#include "session/session.h"

namespace kadr {

/// `starts_known`: the set-up states the start position of the tool.
void take_session(const Session& session, bool starts_known, CutJob& cut);

}  // namespace kadr
