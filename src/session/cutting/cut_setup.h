#pragma once
// Copies data of a session's machine and set-up into a cutting job: the tool in the spindle, the tool lengths, and the chains of axes that
// carry tool and part. It is used by cli/cut and view/part_run.

#include "session/cutting/cutting.h"
#include "session/session.h"

namespace kadr {

/// Fills `cut` with the data of the session. `starts_known`: the set-up states the start position of the tool.
void take_session(const Session& session, bool starts_known, CutJob& cut);

}  // namespace kadr
