#pragma once
// The bodies of the machine in `kadr cut`.

#include <memory>
#include <vector>

#include "cli/command_line.h"
#include "cli/cut_body.h"
#include "cli/job.h"
#include "session/cutting/machine_watch.h"
#include "session/session.h"

namespace kadr::cli {

/// Who watches the bodies of the job's machine; nullptr: it has none, or (`failed`) they cannot be watched; complains.
///   work  blank, then fixtures, as the command line names them
std::unique_ptr<MachineWatch> watch_of(const CutOptions& options, const Job& job, const Session& session, const CutJob& cut, bool& failed);

}  // namespace kadr::cli
