#pragma once
// What a session's machine and set-up say of a cut: the tool in the spindle, lengths, how axes carry each other. For cli/cut and
// view/part_run.

#include "session/cutting/cutting.h"
#include "session/session.h"

namespace kadr {

/// `starts_known`: the set-up says where the tool stands at the start.
void take_session(const Session& session, bool starts_known, CutJob& cut);

}  // namespace kadr
