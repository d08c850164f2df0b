#pragma once
// --state FILE: the control's memory from run to run.

#include <memory>
#include <optional>
#include <string>

#include "cli/job.h"
#include "config/state_file.h"

namespace kadr::cli {

/// Opens the file and puts what it holds under the job's set-up: what the set-up says goes before. Complains.
std::optional<StateFile> open_state(const std::string& path, Job& job);

}  // namespace kadr::cli
